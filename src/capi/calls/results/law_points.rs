//! Bodies that are held together by laws of the host.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::list::Room;
use crate::capi::boundary::pointer::reference;
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, write};
use crate::capi::structs::law_point::fmc_law_point;
use crate::capi::structs::view::fmc_coords;

/// All points of interfaces by laws of the host at `coords`, by pair, in the order of `fmc_context_law_history`. The sums of area times
/// energy are the energies of the interfaces.
///
/// `count` becomes their number; `rows` has room for `capacity`. NULL with capacity 0: only the number is returned.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_LENGTH`, `FMC_ERROR_NON_FINITE_COORDINATE`,
/// `FMC_ERROR_INTERFACE_LAW`; `FMC_ERROR_UNTIED` if other reference coordinates leave no face of an interface; `FMC_ERROR_BUSY`. Threads:
/// one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_law_points(
    context: *mut fmc_context,
    coords: *const fmc_coords,
    rows: *mut fmc_law_point,
    capacity: usize,
    count: *mut usize,
) -> fmc_status {
    entry(|| {
        let room = Room::new(capacity, count)?;
        // SAFETY: the host passes a context, a view, and room for `capacity` rows.
        unsafe {
            write(context, |state| {
                let coords = reference("coords", coords)?;
                let found = in_either!(&mut state.session, one => one.law_points(coords, state.index_base))?;
                room.write("points of interfaces by laws of the host", "rows", &found, rows)
            })
        }
    })
}
