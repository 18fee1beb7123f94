//! Bodies that are held together by interfaces that break.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::list::Room;
use crate::capi::boundary::pointer::{Output, reference};
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, write};
use crate::capi::structs::cohesive::{fmc_cohesive, fmc_cohesive_point};
use crate::capi::structs::view::fmc_coords;

/// The cohesive interface of two bodies at `coords`, indices for `fmc_context_body_resultant`.
/// `fmc_context_set_pair_options` makes it. For bodies without an interface all numbers are zero.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BODY_OUT_OF_RANGE`, `FMC_ERROR_LENGTH`, `FMC_ERROR_NON_FINITE_COORDINATE`;
/// `FMC_ERROR_UNTIED` if other reference coordinates leave no face of the interface; `FMC_ERROR_BUSY`. Threads: one call at a time on a
/// context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_cohesive(
    context: *mut fmc_context,
    a: usize,
    b: usize,
    coords: *const fmc_coords,
    cohesive: *mut fmc_cohesive,
) -> fmc_status {
    entry(|| {
        let output = Output::required("cohesive", cohesive)?;
        // SAFETY: the host passes a context, a view, and an output that may be written.
        unsafe {
            write(context, |state| {
                let coords = reference("coords", coords)?;
                let found = in_either!(&mut state.session, one => one.cohesive([a, b], coords, state.index_base))?;
                output.write(found.into());
                Ok(())
            })
        }
    })
}

/// All points of cohesive interfaces at `coords`, by pair, in the order of `fmc_context_damage`.
///
/// `count` becomes their number; `rows` has room for `capacity`. NULL with capacity 0: only the number is returned.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_LENGTH`, `FMC_ERROR_NON_FINITE_COORDINATE`,
/// `FMC_ERROR_UNTIED` as `fmc_context_cohesive`, `FMC_ERROR_BUSY`. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_cohesive_points(
    context: *mut fmc_context,
    coords: *const fmc_coords,
    rows: *mut fmc_cohesive_point,
    capacity: usize,
    count: *mut usize,
) -> fmc_status {
    entry(|| {
        let room = Room::new(capacity, count)?;
        // SAFETY: the host passes a context, a view, and room for `capacity` rows.
        unsafe {
            write(context, |state| {
                let coords = reference("coords", coords)?;
                let found = in_either!(&mut state.session, one => one.cohesive_points(coords, state.index_base))?;
                room.write("points of cohesive interfaces", "rows", &found, rows)
            })
        }
    })
}
