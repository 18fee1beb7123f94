//! One figure of the table.

use super::bounds::ROUNDOFF;
use super::case::{Case, Form};
use super::closed_form::ClosedForm;
use super::method::Method;
use super::scene::Scene;
use fmc_contact::{Contact, Error, Resolution};
use serde::Serialize;

/// A computed figure beside its closed form.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// Name of the case.
    pub case: &'static str,
    /// `mesh` or `shape`.
    pub form: &'static str,
    /// Cells of both bodies.
    pub cells: usize,
    /// Parameter of the case.
    pub theta: f64,
    /// `isotropic`, `lines` or `exact`.
    pub estimator: &'static str,
    /// `value` or `derivative`.
    pub quantity: &'static str,
    /// What was computed.
    pub computed: f64,
    /// What smooth bodies have.
    pub reference: f64,
    /// |computed − reference| / |reference|; where the reference is zero, divided by the scale below instead.
    pub relative_error: f64,
    /// What the bodies as meshed have; the same where their sides are straight.
    pub mesh_reference: f64,
    /// The error that is compared with the bound: against `reference` for fibers, against `mesh_reference` for `exact`;
    /// divided by a scale, which is the largest over θ of the value, or of the flux ([`ClosedForm::flux`]).
    pub scaled_error: f64,
    /// Bound on `scaled_error`; none for `isotropic`.
    pub bound: Option<f64>,
    /// Whether the bound holds.
    pub ok: bool,
    /// Fibers laid.
    pub fibers: usize,
    /// Crossings that bound the overlap (for `exact`: clipped pieces).
    pub crossings: usize,
    /// Wall time of the evaluation that gave value and derivative, s.
    pub seconds: f64,
}

/// How a scene is to be measured.
#[derive(Clone, Copy, Debug)]
pub(super) struct Setting {
    pub method: Method,
    pub resolution: Resolution,
    pub seed: u64,
}

/// Value and derivative of a scene, the one of `form` at `theta`, as two rows.
pub(super) fn rows<const D: usize>(
    case: &Case<D>,
    form: &Form<D>,
    theta: f64,
    scene: &Scene<D>,
    contact: &mut Contact<D>,
    setting: Setting,
) -> Result<[Row; 2], Error> {
    let Setting { method, resolution, seed } = setting;
    let measured = scene.measure(contact, method.estimator(resolution, seed, case.fiber_length))?;
    let smooth = (case.closed_form)(theta);
    let meshed = form.of_the_mesh.map_or(smooth, |closed_form| closed_form(theta));
    let largest = |of: fn(&ClosedForm) -> f64| {
        case.thetas.iter().map(|&theta| of(&(case.closed_form)(theta))).fold(0.0, f64::max)
    };
    let row = |index: usize, computed: f64, of: fn(&ClosedForm) -> f64, scale: f64| {
        let (reference, mesh_reference) = (of(&smooth), of(&meshed));
        let error = (computed - reference).abs();
        let (bound, checked_error) = match method {
            Method::Isotropic => (None, error),
            Method::Lines => (Some(case.bounds[index]), error),
            Method::Exact => (Some(ROUNDOFF), (computed - mesh_reference).abs()),
        };
        let scaled_error = checked_error / scale;
        Row {
            case: case.name,
            form: form.name,
            cells: scene.cell_count(),
            theta,
            estimator: method.name(),
            quantity: ["value", "derivative"][index],
            computed,
            reference,
            relative_error: error / if reference == 0.0 { scale } else { reference.abs() },
            mesh_reference,
            scaled_error,
            bound,
            ok: bound.is_none_or(|bound| scaled_error <= bound),
            fibers: measured.fibers,
            crossings: measured.crossings,
            seconds: measured.seconds,
        }
    };
    Ok([
        row(0, measured.value, |c| c.value, largest(|c| c.value)),
        row(1, measured.derivative, |c| c.derivative, largest(|c| c.flux)),
    ])
}
