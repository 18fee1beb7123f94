//! What was begun, kept or frozen, carried over to other cells.

use crate::Error;
use crate::contact::{Contact, Poses};
use crate::geometry::Surface;
use crate::geometry::boundary::submesh::hash_of;
use crate::geometry::boundary::symmetry::Symmetry;
use crate::geometry::primitives::aabb::Aabb;

/// Something that was done at coordinates of an earlier epoch, and would be needed again for other cells.
#[derive(Clone, Debug)]
pub(super) struct Earlier<const D: usize> {
    pub(super) epoch: u64,
    pub(super) poses: Poses<D>,
}

/// What was done at earlier coordinates: where the step began, where friction was frozen, where patches were kept.
pub(super) fn earlier<const D: usize>(contact: &Contact<D>) -> [Option<Earlier<D>>; 3] {
    let history = &contact.history;
    let at = |epoch: u64, poses: &Poses<D>| Earlier { epoch, poses: poses.clone() };
    let patches = Some(&history.patches).filter(|patches| !patches.is_empty());
    [
        history.step.as_ref().map(|step| at(step.epoch, &step.poses)),
        history.frozen.as_ref().map(|frozen| at(frozen.epoch, &frozen.poses)),
        patches.map(|patches| at(patches.epoch, &patches.poses)),
    ]
}

/// Takes other cells of the same mesh. `started` are the coordinates of their nodes at which the step began; `facet` is
/// the new number of a facet, if it is still there. What was kept and frozen is released.
pub(super) fn take_cells<const D: usize>(
    contact: &mut Contact<D>,
    surface: Surface<D>,
    started: Option<&[[f64; D]]>,
    facet: impl Fn(usize) -> Option<usize>,
    symmetry: Option<Symmetry<D>>,
) -> Result<(), Error> {
    let Contact { mesh, history, state, .. } = contact;
    mesh.take_cells(surface, symmetry);
    state.forget();
    let started = started.map(|coords| mesh.surface.mesh_points(coords)).transpose()?;
    history.take_cells(&mesh.surface, started.as_deref(), facet);
    Ok(())
}

/// Brings the mesh to coordinates of the nodes gathered; nothing is missing in `complete_in`.
pub(super) fn set_gathered<const D: usize>(
    contact: &mut Contact<D>,
    coords: &[[f64; D]],
    boxes: &[Aabb<D>],
    complete_in: Vec<Vec<Aabb<D>>>,
    (epoch, reach): (u64, f64),
) {
    if let Some(submesh) = &mut contact.mesh.surface.submesh {
        (submesh.epoch, submesh.brought, submesh.reach) = (epoch, hash_of(coords), reach);
        (submesh.body_boxes, submesh.complete_in) = (boxes.to_vec(), complete_in);
    }
}
