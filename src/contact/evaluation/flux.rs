//! What flows through all pairs.

use super::layer::layer;
use super::parts::Contact;
use super::points::Points;
use super::walk::for_each_pair_within;
use crate::Error;
use crate::contact::flux::{
    Conductance, FluxRequest, HeldSurfaces, of_bodies, of_cohesion, of_glide, of_governed, of_obstacle, of_tie,
};
use crate::overlap::{Block, Partner, merged};

/// The derivative of the flux out of nodes and obstacles by a field, by points of the mesh.
pub(super) fn flux_in<const D: usize>(
    contact: &Contact<D>,
    coords: &Points<D>,
    request: &FluxRequest,
) -> Result<Vec<Block<1>>, Error> {
    contact.mesh.surface.refuse_submesh("the flux through contact of a mesh in parts")?;
    contact.check_stiffness()?;
    let conductance = request.conductance;
    let rounding = 128.0 * f64::EPSILON * coords.as_flattened().iter().fold(0.0f64, |most, x| most.max(x.abs()));
    let reach = conductance.reach().max(rounding) + layer(contact);
    let mut parts = for_each_pair_within(contact, coords, reach, |measured| match measured.pair.partners[1] {
        Partner::Body(_) => of_bodies(measured, conductance).map(Some),
        Partner::Obstacle(_) if request.of_obstacles.is_some() => of_obstacle(measured, conductance).map(Some),
        Partner::Obstacle(_) => Ok(None),
    })?;
    parts.extend(through_interfaces(contact, coords.unshifted, conductance)?);
    Ok(merged(parts))
}

/// Of pairs that are held together, at these points of the mesh.
fn through_interfaces<const D: usize>(
    contact: &Contact<D>,
    points: &[[f64; D]],
    conductance: &Conductance,
) -> Result<Vec<Vec<Block<1>>>, Error> {
    let Contact { mesh, method, ties, glides, cohesions, governed, .. } = contact;
    let mut parts = Vec::new();
    if !contact.has_held() {
        return Ok(parts);
    }
    let reference = mesh.surface.points(&mesh.placed(mesh.surface.reference().into()));
    let now = mesh.surface.points(points);
    let surfaces =
        HeldSurfaces { surface: &mesh.surface, reference: &reference, now: &now, weighting: method.weighting() };
    // Nothing flows through ties that were added.
    for (tie, at, _) in contact.at_points(points, |at| ties.there(at))?.into_iter().filter(|(.., added)| *added == 0) {
        parts.push(of_tie(tie, &at.tractions, &surfaces, conductance));
    }
    for (glide, at, _) in contact.at_points(points, |at| glides.there(at))? {
        parts.push(of_glide(glide, &at, &surfaces, conductance));
    }
    for (cohesion, at, _) in contact.at_points(points, |at| cohesions.there(at))? {
        parts.push(of_cohesion(cohesion, &at, conductance));
    }
    for (held, at, _) in contact.at_points(points, |at| governed.there(at))? {
        parts.push(of_governed(held, &at, conductance));
    }
    Ok(parts)
}
