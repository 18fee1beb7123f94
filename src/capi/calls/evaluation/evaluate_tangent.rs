//! Forces and tangent in one call.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::pointer::{Output, optional, reference};
use crate::capi::boundary::status::fmc_status;
use crate::capi::calls::evaluation::evaluate::FMC_EVALUATE_ADD;
use crate::capi::calls::tangent::entries::{FMC_TANGENT_SEMIDEFINITE, FMC_TANGENT_SYMMETRIC, part_of};
use crate::capi::context::session::in_either;
use crate::capi::context::state::{evaluated, fmc_context};
use crate::capi::structs::evaluation::fmc_result;
use crate::capi::structs::view::{fmc_coords, fmc_forces};

/// `fmc_context_evaluate` and `fmc_context_tangent` at the same coordinates, in little more than the time of the second:
/// bodies are measured once. All results are bit-for-bit identical to the two calls, and are kept in the same way.
///
/// `flags`: `FMC_EVALUATE_ADD`, `FMC_TANGENT_SEMIDEFINITE` and `FMC_TANGENT_SYMMETRIC`. All outputs may be NULL, and are written only on
/// success.
///
/// Errors: as both calls. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_evaluate_tangent(
    context: *mut fmc_context,
    coords: *const fmc_coords,
    flags: u32,
    forces: *const fmc_forces,
    result: *mut fmc_result,
    rank_one_count: *mut usize,
) -> fmc_status {
    entry(|| {
        let parts = Output::optional("rank_one_count", rank_one_count)?;
        let part = part_of(flags, FMC_EVALUATE_ADD | FMC_TANGENT_SEMIDEFINITE | FMC_TANGENT_SYMMETRIC)?;
        // SAFETY: the host passes a context, both views and outputs, or NULL where it may.
        unsafe {
            evaluated(context, result, |state| {
                let (coords, forces) = (reference("coords", coords)?, optional("forces", forces)?);
                let is_added = flags & FMC_EVALUATE_ADD != 0;
                let (found, tangent) = in_either!(&mut state.session, one => one.evaluate_tangent(coords, part, forces, is_added, state.index_base))?;
                parts.write(tangent.rank_one.len());
                state.keep_tangent(tangent);
                Ok(found)
            })
        }
    })
}
