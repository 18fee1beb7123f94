//! Patches of the fiber law that are kept during a solve.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::pointer::{Output, optional};
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, write};
use crate::capi::structs::view::fmc_coords;

/// Finds the patches of the law "fiber" at `coords` and keeps the direction and the spacing of their lines for all
/// later evaluations: a solver's forces are then the gradient of one energy. `coords` NULL releases them: every
/// evaluation then finds its patches, which is the default.
///
/// Call it at the start of a load step. Patches of pairs that do not overlap at `coords` are not kept, but found at
/// every evaluation. `direction_count`, which may be NULL, receives the number of directions kept: 0 with other laws.
///
/// Errors: as `fmc_context_evaluate`; earlier patches are then kept. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_keep_patches(
    context: *mut fmc_context,
    coords: *const fmc_coords,
    direction_count: *mut usize,
) -> fmc_status {
    entry(|| {
        let output = Output::optional("direction_count", direction_count)?;
        // SAFETY: the host passes a context, and a view or NULL.
        let count = unsafe {
            write(
                context,
                |state| in_either!(&mut state.session, one => one.keep_patches(optional("coords", coords)?, state.index_base)),
            )
        }?;
        // SAFETY: the output, where given, may be written.
        unsafe { output.write(count) };
        Ok(())
    })
}
