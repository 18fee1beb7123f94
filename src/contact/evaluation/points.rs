//! Where surfaces are measured, and where they are.

use super::parts::Contact;
use crate::contact::friction::Material;
use crate::contact::history::History;
use crate::geometry::Vector;
use std::ops::Deref;

/// Points of the straight mesh.
pub(super) struct Points<'a, const D: usize> {
    /// As surfaces are measured.
    pub(super) measured: &'a [[f64; D]],
    /// Where they are.
    pub(super) unshifted: &'a [[f64; D]],
    /// The vertices of the surface where they are, for friction; empty where surfaces are measured there.
    pub(super) vertices: Vec<Vector<D>>,
}

impl<const D: usize> Points<'_, D> {
    /// Where the material lies whose slip friction counts; `None` where surfaces are measured there.
    pub(super) fn material(&self) -> Option<Material<'_, D>> {
        (!self.vertices.is_empty()).then_some(Material { points: self.unshifted, vertices: &self.vertices })
    }
}

impl<const D: usize> Deref for Points<'_, D> {
    type Target = [[f64; D]];

    fn deref(&self) -> &[[f64; D]] {
        self.measured
    }
}

/// The points of the straight mesh as surfaces are measured that are worn, and that the multipliers move out; `None` where none are.
pub(crate) fn moved_out<const D: usize>(contact: &Contact<D>, points: &[[f64; D]]) -> Option<Vec<[f64; D]>> {
    measured_at(contact, points, true)
}

/// The same, or of surfaces that are worn alone.
pub(super) fn measured_at<const D: usize>(
    contact: &Contact<D>,
    points: &[[f64; D]],
    with_multipliers: bool,
) -> Option<Vec<[f64; D]>> {
    let History { worn, multipliers, .. } = &contact.history;
    let multipliers = Some(multipliers).filter(|all| with_multipliers && !all.is_empty());
    if worn.is_empty() && multipliers.is_none() {
        return None;
    }
    let mut moved = points.to_vec();
    worn.add_to(&mut moved);
    if let Some(multipliers) = multipliers {
        multipliers.add_to(&mut moved);
    }
    if !contact.method.weighting().is_plain() {
        // A surface is moved out no farther than to the axis, and along it there: normals of its facets alone do not know of it.
        moved.iter_mut().zip(points).for_each(|(point, at)| point[0] = point[0].max(at[0].min(0.0)));
    }
    Some(moved)
}
