//! What flows through all pairs.

use super::layer::layer;
use super::parts::Contact;
use super::points::Points;
use super::walk::for_each_pair_within;
use crate::Error;
use crate::contact::flux::{FluxRequest, TiedSurfaces, of_bodies, of_obstacle, of_tie};
use crate::overlap::{Block, Partner, merged};

/// The derivative of the flux out of nodes and obstacles by a field, by points of the mesh.
pub(super) fn flux_in<const D: usize>(
    contact: &Contact<D>,
    coords: &Points<D>,
    request: &FluxRequest,
) -> Result<Vec<Block<1>>, Error> {
    contact.mesh.surface.refuse_submesh("the flux through contact of a mesh in parts")?;
    contact.partners.check_stiffness(contact.method.options())?;
    if !contact.glides.is_empty() {
        return Err(Error::Unsupported { what: "the flux through bodies that do not separate" });
    }
    let conductance = request.conductance;
    let rounding = 128.0 * f64::EPSILON * coords.as_flattened().iter().fold(0.0f64, |most, x| most.max(x.abs()));
    let reach = conductance.reach().max(rounding) + layer(contact);
    let mut parts = for_each_pair_within(contact, coords, reach, |measured| match measured.pair.partners[1] {
        Partner::Body(_) => of_bodies(measured, conductance).map(Some),
        Partner::Obstacle(_) if request.of_obstacles.is_some() => of_obstacle(measured, conductance).map(Some),
        Partner::Obstacle(_) => Ok(None),
    })?;
    if !contact.ties.is_empty() {
        let Contact { mesh, method, .. } = contact;
        let reference = mesh.surface.points(&mesh.placed(mesh.surface.reference().into()));
        let now = mesh.surface.points(coords.unshifted);
        let (surface, weighting) = (&mesh.surface, method.weighting());
        let surfaces = TiedSurfaces { surface, reference: &reference, now: &now, weighting };
        for held in contact.ties.all() {
            let (tie, multipliers) = held?;
            let stiffness = contact.stiffness_of_pair(tie.bodies.map(Partner::Body));
            let tractions = tie.at(coords.unshifted, stiffness, multipliers).tractions;
            parts.push(of_tie(tie, &tractions, &surfaces, conductance));
        }
    }
    Ok(merged(parts))
}
