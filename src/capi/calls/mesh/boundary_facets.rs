//! The boundary facets, copied into the host's array.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::pointer::copy_list;
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::FMC_ERROR_BUFFER_TOO_SMALL;
use crate::capi::context::state::{fmc_context, read};
use crate::capi::structs::boundary_facet::fmc_boundary_facet;

/// Writes the boundary facets to the host's array, with room for `capacity`: as many as `fmc_context_counts` says, in the
/// order in which `fmc_context_slip` has them, body after body.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_BUSY`. Threads: several at once on one
/// context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_boundary_facets(
    context: *const fmc_context,
    facets: *mut fmc_boundary_facet,
    capacity: usize,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context.
        let state = unsafe { read(context) }?;
        let found = state.session.boundary_facets(state.index_base);
        if capacity < found.len() {
            let text = format!("there is room for {capacity} boundary facets, and there are {}", found.len());
            return Err(Failure::new(FMC_ERROR_BUFFER_TOO_SMALL, text));
        }
        // SAFETY: the host guarantees `capacity` entries, of which there are no more than that.
        unsafe { copy_list("facets", &found, facets) }
    })
}
