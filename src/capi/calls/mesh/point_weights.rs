//! The points of which a context tells, as combinations of the host's nodes.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::list::{MatrixRoom, Room};
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, read};
use std::ffi::c_void;

/// The matrix P that takes nodes to points, X = P x, in compressed rows: point p has the entries from `row_offsets[p]` to
/// `row_offsets[p + 1]`, `nodes` with their `weights`. Offsets and nodes count from the option `index_base`.
///
/// Cells of second order are divided into straight ones, whose points are fixed linear combinations of the nodes.
/// `fmc_boundary_facet`, `fmc_contact_side` and `fmc_gap_constraint` refer to points: their numbers, minus the option
/// `index_base`, are rows. P takes nodal values to points; its transpose takes forces and other derivatives from points to nodes.
/// A point that is a node, or represents a node in the middle of an edge, face or cell, has the node's number. Middles of faces
/// without a node come after the nodes. The weights of a row add up to 1, and some are negative. Without cells of second order
/// and hanging nodes P is the identity. With a basis (`fmc_context_set_basis`) its columns are unknowns, and its rows have the
/// row sums of the basis.
///
/// There are at least as many points as nodes; numbers change with a basis only. `offset_count` becomes the number of offsets, one
/// more than there are points, and `count` the number of entries. `row_offsets` has room for `offset_capacity`, `nodes` and
/// `weights` for `capacity`. An array that is NULL with capacity 0 is not written: only its number is returned.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_BUSY`; no output is then written.
/// Threads: several at once on one context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_point_weights(
    context: *const fmc_context,
    row_offsets: *mut c_void,
    offset_capacity: usize,
    offset_count: *mut usize,
    nodes: *mut c_void,
    weights: *mut f64,
    capacity: usize,
    count: *mut usize,
) -> fmc_status {
    entry(|| {
        let (offsets, entries) = (Room::new(offset_capacity, offset_count)?, Room::new(capacity, count)?);
        // SAFETY: the host passes a context.
        let state = unsafe { read(context) }?;
        let found = in_either!(&state.session, one => one.point_weights());
        let size = state.index_size;
        let room = MatrixRoom { row_offsets, offsets, cols: nodes, values: weights, entries, size };
        let (cols, col_count) =
            (found.nodes.iter().map(|&node| node as usize), in_either!(&state.session, one => one.counts()).unknowns);
        // SAFETY: the host guarantees the room that it says.
        unsafe { room.write(&found.starts, cols, col_count, &found.weights, state.index_base) }
    })
}
