//! Contact points: found first, and copied into the host's array then.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::pointer::{Output, copy_list, reference};
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::FMC_ERROR_BUFFER_TOO_SMALL;
use crate::capi::context::state::{fmc_context, read, write};
use crate::capi::structs::contact_point::fmc_contact_point;
use crate::capi::structs::view::fmc_coords;

/// Finds the contact points at `coords`, where the laws "fiber" and "depth" press, and keeps them in the context until
/// the next call, for `fmc_context_contact_points`. `count` receives their number, 0 with the law "volume", which has one
/// pressure for a whole pair, unless friction acts; it may be NULL. With friction the points have its traction and their
/// slip, with the current pressure even where friction is frozen.
///
/// Errors: as `fmc_context_evaluate`; what was kept then stays. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_find_contact_points(
    context: *mut fmc_context,
    coords: *const fmc_coords,
    count: *mut usize,
) -> fmc_status {
    entry(|| {
        let output = Output::optional("count", count)?;
        // SAFETY: the host passes a context and a view.
        let found = unsafe {
            write(context, |state| {
                state.points = state.session.contact_points(reference("coords", coords)?, state.index_base)?;
                Ok(state.points.len())
            })
        }?;
        // SAFETY: the output, where given, may be written.
        unsafe { output.write(found) };
        Ok(())
    })
}

/// Writes the contact points that were found to the host's array, with room for `capacity`, in the order of the pairs.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_BUSY`. Threads: several at once on one
/// context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_contact_points(
    context: *const fmc_context,
    points: *mut fmc_contact_point,
    capacity: usize,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context.
        let state = unsafe { read(context) }?;
        if capacity < state.points.len() {
            let text = format!("there is room for {capacity} contact points, and there are {}", state.points.len());
            return Err(Failure::new(FMC_ERROR_BUFFER_TOO_SMALL, text));
        }
        // SAFETY: the host guarantees `capacity` entries, of which there are no more than that.
        unsafe { copy_list("points", &state.points, points) }
    })
}
