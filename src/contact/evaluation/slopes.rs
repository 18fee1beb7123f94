//! Rates of energy and forces along a direction.

use super::gradients::{check_known, state_of};
use super::measured::measured_pairs;
use super::parts::Contact;
use super::points::Points;
use super::sliding::check_ready;
use super::slip_facets::slip_facets_in;
use crate::Error;
use crate::contact::derivatives::{Along, Slopes, add_slider_slopes, add_slopes};
use crate::contact::laws::Asked;
use crate::contact::tangents::TangentPart;

/// The rates at points of the straight mesh.
pub(super) fn slopes_in<const D: usize>(
    contact: &Contact<D>,
    coords: &Points<D>,
    along: &Along,
) -> Result<Slopes<D>, Error> {
    check_ready(contact)?;
    let request = along.request();
    check_known(contact, &request, false)?;
    let Contact { mesh, partners, method, .. } = contact;
    let obstacles = partners.obstacles.count();
    let rows: Vec<[f64; D]> =
        along.coords.unwrap_or(&[]).chunks_exact(D).map(|row| std::array::from_fn(|i| row[i])).collect();
    let points = if along.coords.is_some() { Some(mesh.surface.mesh_points(&rows)?) } else { None };
    let moved = along.motion(points.as_deref(), [coords.len(), obstacles]);
    let mut found = Slopes { energy: 0.0, forces: vec![[0.0; D]; coords.len()] };
    if request.needs_answers() {
        let tangent = request.needs_tangent().then_some(TangentPart::Full);
        let rotations = request.rotations && obstacles > 0;
        let asked = Asked { energy: true, tangent, rotations, limited: request.friction, ..Asked::default() };
        let (answers, tractions) = measured_pairs(contact, coords, &asked)?;
        let is_kept = |pair: &_| contact.history.patches.of(pair).is_some();
        let state = state_of(contact, &is_kept);
        add_slopes((partners, method), (&answers, &tractions), (along, &moved, &state), &mut found)?;
    }
    if request.slip || request.stiffness {
        add_slider_slopes((partners, method), &slip_facets_in(contact, coords)?, along, &mut found.forces)?;
    }
    found.checked()
}
