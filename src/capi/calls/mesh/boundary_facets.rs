//! The boundary facets.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::list::Room;
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, read};
use crate::capi::structs::boundary_facet::fmc_boundary_facet;

/// The boundary facets in the order in which `fmc_context_slip` has them, body after body.
///
/// `count` becomes their number; `facets` has room for `capacity`. NULL with capacity 0: only the number is returned.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_BUSY`; no output is then written. Threads: several
/// at once on one context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_boundary_facets(
    context: *const fmc_context,
    facets: *mut fmc_boundary_facet,
    capacity: usize,
    count: *mut usize,
) -> fmc_status {
    entry(|| {
        let room = Room::new(capacity, count)?;
        // SAFETY: the host passes a context, and room for `capacity` facets.
        unsafe {
            let state = read(context)?;
            room.write(
                "boundary facets",
                "facets",
                &in_either!(&state.session, one => one.boundary_facets(state.index_base)),
                facets,
            )
        }
    })
}
