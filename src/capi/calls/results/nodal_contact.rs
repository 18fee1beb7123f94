//! The contact at the nodes, for output and for the host's own use.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::pointer::{Output, reference};
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::FMC_ERROR_LENGTH;
use crate::capi::context::state::{fmc_context, write};
use crate::capi::structs::view::fmc_coords;

/// The contact at every node of the mesh at `coords`, in the order of the coordinates; zero where nothing touches.
/// Every output may be NULL. All but `normal` and `friction` have one entry per node, `node_count` of them, which is that of
/// the mesh; those two have `dim` per node, in dense rows.
///
/// `pressure` is the mean of the law's over the part of the facets at the node that is in contact, weighted with the
/// node's shape function, int N p dA / int N dA; with the law "volume" that of the pair. `gap` is minus the penetration,
/// the mean over the same part, and never positive: distances of what is apart are not measured. `area` (2D: length) is
/// int N dA, up to the curvature of the surface. `normal` is a unit vector, outwards of the node's body. The nodal force
/// without its friction is -pressure * area * normal, to rounding. `friction` is the traction of friction on the node's
/// body, the mean over the same part, and `sliding` the part of the contact at the node that slides, of its area,
/// between 0 and 1. `status` has values of `fmc_node_status`.
///
/// With cells of second order a node has what is at the point of their division that stands for it, with the straight shape
/// function of that point: shape functions of second order are negative in places, and have no mean at a corner. Forces
/// at points, -pressure * area * normal, are then not those of the nodes, nor do they add up to the resultant where
/// faces have no node in their middle, whose points are not told.
///
/// It measures the contact anew, with the current pressure even where friction is frozen, and changes no other result of
/// the context. Errors: as `fmc_context_evaluate`; nothing is written then. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_nodal_contact(
    context: *mut fmc_context,
    coords: *const fmc_coords,
    pressure: *mut f64,
    gap: *mut f64,
    area: *mut f64,
    normal: *mut f64,
    friction: *mut f64,
    sliding: *mut f64,
    status: *mut i32,
    node_count: usize,
) -> fmc_status {
    entry(|| {
        let numbers = [("pressure", pressure), ("gap", gap), ("area", area), ("normal", normal)];
        for (name, output) in numbers.into_iter().chain([("friction", friction), ("sliding", sliding)]) {
            Output::optional(name, output)?;
        }
        Output::optional("status", status)?;
        // SAFETY: the host passes a context and a view.
        let lists = unsafe {
            write(context, |state| {
                let expected = state.session.counts().nodes;
                if node_count != expected {
                    let text = format!("the outputs have room for {node_count} nodes, the mesh has {expected}");
                    return Err(Failure::new(FMC_ERROR_LENGTH, text));
                }
                state.session.nodal_contact(reference("coords", coords)?, state.index_base)
            })
        }?;
        // SAFETY: the outputs, where given, have room for the nodes of the mesh, whose number was checked.
        unsafe {
            copy(&lists.pressure, pressure);
            copy(&lists.gap, gap);
            copy(&lists.area, area);
            copy(&lists.normal, normal);
            copy(&lists.friction, friction);
            copy(&lists.sliding, sliding);
            copy(&lists.status, status);
        }
        Ok(())
    })
}

/// Writes a list, unless the host declined it.
///
/// # Safety
/// The host guarantees that `output`, if it is not NULL, has room for the list.
unsafe fn copy<T: Copy>(list: &[T], output: *mut T) {
    if !output.is_null() {
        // SAFETY: passed on to the caller; the list is our own and cannot overlap it.
        unsafe { std::ptr::copy_nonoverlapping(list.as_ptr(), output, list.len()) };
    }
}
