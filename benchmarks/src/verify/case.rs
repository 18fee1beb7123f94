//! One benchmark of the paper's section 2.4.

use super::closed_form::ClosedForm;
use super::scene::Scene;

/// A geometry that depends on one parameter θ, and the overlap that it should have.
pub(super) struct Case<const D: usize> {
    /// Name in the table and in JSON.
    pub name: &'static str,
    /// Title of its picture.
    pub title: &'static str,
    /// θ at which it is measured.
    pub thetas: Vec<f64>,
    /// Range of θ drawn.
    pub range: [f64; 2],
    /// The overlap for smooth bodies.
    pub closed_form: fn(f64) -> ClosedForm,
    /// Largest errors allowed to `lines`: of the value relative to the largest over `thetas`, of the derivative relative
    /// to the largest flux ([`ClosedForm::flux`]).
    pub bounds: [f64; 2],
    /// Length of an isotropic fiber: some tenths of the overlap.
    pub fiber_length: f64,
    /// The forms in which the bodies are given.
    pub forms: Vec<Form<D>>,
}

/// How the bodies of a case are given.
pub(super) struct Form<const D: usize> {
    /// `mesh` if both are meshed, `shape` if one is an implicit shape.
    pub name: &'static str,
    /// The bodies at θ.
    pub scene: fn(f64) -> Scene<D>,
    /// The overlap of these very bodies, polygons and polyhedra, where it differs from that of smooth ones.
    pub of_the_mesh: Option<fn(f64) -> ClosedForm>,
    /// Whether all sides are straight, which `exact` needs.
    pub straight: bool,
}
