//! Contact of some cells of a larger mesh: refused where some may be missing.

use super::needed::needed;
use super::parts::Contact;
use crate::Error;
use crate::configuration::Configuration;
use crate::geometry::boundary::submesh::hash_of;
use crate::geometry::primitives::aabb::Aabb;

/// Refuses coordinates and obstacles at which cells of a mesh in parts may be missing.
pub(crate) fn check_gathered<const D: usize>(
    contact: &Contact<D>,
    configuration: &Configuration<D>,
    coords: &[[f64; D]],
) -> Result<(), Error> {
    let surface = &contact.mesh.surface;
    let Some(submesh) = surface.submesh.as_ref() else { return Ok(()) };
    // There nothing that was not gathered has come near, though obstacles may have.
    let is_brought = submesh.brought == hash_of(coords);
    let boxes: Vec<Aabb<D>> = (0..surface.body_count()).map(|body| configuration.body_box(body)).collect();
    for (body, needed) in needed(contact, &boxes, 0.0)?.iter().enumerate() {
        let complete_in = &submesh.complete_in[body];
        let is_complete = needed.iter().all(|needed| complete_in.iter().any(|aabb| aabb.contains(&needed.aabb)));
        let side = configuration.body(surface, body);
        let first = surface.ranges[body].start;
        let mut ends = (0..side.facets.len()).filter(|facet| submesh.is_cut(first + facet));
        let reaches = |facet: usize| needed.iter().any(|needed| needed.aabb.meets(&side.facet_box(facet)));
        if !is_complete || !is_brought && ends.any(reaches) {
            return Err(Error::NotGathered { body });
        }
    }
    Ok(())
}
