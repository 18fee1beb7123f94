//! What the law "depth" takes a body for without deformation.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::pointer::reference;
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, write};
use crate::capi::structs::view::fmc_coords;
use std::ffi::c_void;

/// Sets the coordinates of all nodes without deformation, from which the law "depth" has its depths; those at which the
/// context was created are the default.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_UNSUPPORTED` for a surface without cells, `FMC_ERROR_LENGTH`,
/// `FMC_ERROR_NON_FINITE_COORDINATE`, `FMC_ERROR_INVERTED_CELL`, `FMC_ERROR_ZERO_MEASURE`; the old coordinates then stay. Threads:
/// one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_reference(context: *mut fmc_context, coords: *const fmc_coords) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context and a view.
        unsafe {
            write(
                context,
                |state| in_either!(&mut state.session, one => one.set_reference(reference("coords", coords)?, state.index_base)),
            )
        }
    })
}

/// Names `count` nodes, counted from the option `index_base`, that lie in planes of symmetry: for the law "depth" a face all of whose nodes are named is no
/// surface, since the body goes on behind it; of second order those in the middle of its edges, and its own, are named too.
/// The host holds such nodes in their plane. Replaces what was named before;
/// `count` 0 names none: all of the surface is surface, and flush faces are not warned of.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_NODE_OUT_OF_RANGE` naming the entry, `FMC_ERROR_UNSUPPORTED` for a body
/// that would have no surface left; what was named before then stays. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_symmetry_nodes(
    context: *mut fmc_context,
    nodes: *const c_void,
    count: usize,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context and `count` numbers.
        unsafe {
            write(context, |state| {
                let nodes = state.index_size.list("nodes", nodes, count, 1)?;
                in_either!(&mut state.session, one => one.set_symmetry_nodes(&nodes, state.index_base))
            })
        }
    })
}
