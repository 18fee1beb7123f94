//! Contact points.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::list::Room;
use crate::capi::boundary::pointer::reference;
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::state::{fmc_context, write};
use crate::capi::structs::contact_point::fmc_contact_point;
use crate::capi::structs::view::fmc_coords;

/// The contact points at `coords`, where the laws "fiber" and "depth" press, in the order of the pairs; none with the law "volume",
/// which has one pressure for a whole pair, unless friction acts. With friction the points have its traction and their slip, with
/// the current pressure even where friction is frozen.
///
/// `count` becomes their number; `points` has room for `capacity`. NULL with capacity 0: only the number is returned, and the next
/// call at the same coordinates does not search again.
///
/// Errors: as `fmc_context_evaluate`, and `FMC_ERROR_BUFFER_TOO_SMALL`; no output is then written. Threads: one call at a time on
/// a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_contact_points(
    context: *mut fmc_context,
    coords: *const fmc_coords,
    points: *mut fmc_contact_point,
    capacity: usize,
    count: *mut usize,
) -> fmc_status {
    entry(|| {
        let room = Room::new(capacity, count)?;
        // SAFETY: the host passes a context, a view, and room for `capacity` points.
        unsafe {
            write(context, |state| {
                let found = state.contact_points(reference("coords", coords)?)?;
                room.write("contact points", "points", found, points)
            })
        }
    })
}
