//! Ties beside the options of pairs.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::list::Room;
use crate::capi::boundary::pointer::{Output, reference};
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, read, write};
use crate::capi::structs::tie::fmc_tie;
use crate::capi::structs::view::fmc_coords;

/// Ties two parts of the surface (`fmc_context_add_surface`), each of one body, of two bodies or of one: x_A - x_B = `period` + jump for points that
/// face one another without deformation once `period`, `dim` numbers, has brought part B to part A. `tie` becomes the number of the tie, 1, 2, ...;
/// the jump is 0 at first (`fmc_context_set_tie_jump`). A body may have several.
///
/// What is tied, and within which `reach` (0: the default), is as of `FMC_INTERFACE_TIED`, with the stiffness of the pair's law and with
/// multipliers. It changes no contact. With a period the named facets alone can hide one another. Heat does not pass it.
///
/// With the period of a periodic cell and the jump H period the cell has the macroscopic displacement gradient H; its stress is the sum of
/// F period^T / V over the ties with their forces F (`fmc_context_tie_force`). In a bolt that is cut across, the jump along its axis is the
/// length that pretension takes out of it.
///
/// Errors: `FMC_ERROR_NULL_POINTER`; `FMC_ERROR_BAD_VALUE` for a surface that does not exist; `FMC_ERROR_UNTIED`; `FMC_ERROR_NOT_POSITIVE` for a
/// reach; `FMC_ERROR_NON_FINITE_STIFFNESS` for a period that is not finite; `FMC_ERROR_UNSUPPORTED` for a surface of several bodies, for two with a
/// facet in common, for two bodies in contact whose faces lie on one another, by the law "volume", without cells, in parts, and for a period
/// along the radius; `FMC_ERROR_BUSY`. Nothing changes then. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_add_tie(
    context: *mut fmc_context,
    surface_a: i32,
    surface_b: i32,
    period: *const f64,
    reach: f64,
    tie: *mut i32,
) -> fmc_status {
    entry(|| {
        let output = Output::required("tie", tie)?;
        let surfaces = [surface_a, surface_b].map(number);
        // SAFETY: the host passes a context and `dim` numbers.
        let number = unsafe {
            write(context, |state| in_either!(&mut state.session, one => one.add_tie(surfaces, period, reach)))
        }?;
        // SAFETY: the host passes an output that may be written.
        unsafe { output.write(i32::try_from(number).unwrap_or(i32::MAX)) };
        Ok(())
    })
}

/// Removes a tie of `fmc_context_add_tie`. Numbers of others stay.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BAD_VALUE` if there is no such tie, `FMC_ERROR_BUSY`. Threads: one call at a time on a
/// context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_remove_tie(context: *mut fmc_context, tie: i32) -> fmc_status {
    // SAFETY: the host passes a context.
    entry(|| unsafe { write(context, |state| in_either!(&mut state.session, one => one.remove_tie(number(tie)))) })
}

/// Has the first part of a tie of `fmc_context_add_tie` lie so far from the second, beside its period: `jump` are `dim` numbers. No face is looked
/// for anew, and multipliers stay.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BAD_VALUE` if there is no such tie, `FMC_ERROR_NON_FINITE_STIFFNESS` for a jump that is not finite,
/// `FMC_ERROR_UNSUPPORTED` for one along the radius, `FMC_ERROR_BUSY`; the old jump then stays. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_tie_jump(context: *mut fmc_context, tie: i32, jump: *const f64) -> fmc_status {
    // SAFETY: the host passes a context and `dim` numbers.
    entry(|| unsafe {
        write(context, |state| in_either!(&mut state.session, one => one.set_tie_jump(number(tie), jump)))
    })
}

/// What a tie of `fmc_context_add_tie` holds.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BAD_VALUE` if there is no such tie, `FMC_ERROR_UNTIED` as `fmc_context_tie`, `FMC_ERROR_BUSY`. Threads:
/// several at once on one context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_added_tie(
    context: *const fmc_context,
    tie: i32,
    found: *mut fmc_tie,
) -> fmc_status {
    entry(|| {
        let output = Output::required("found", found)?;
        // SAFETY: the host passes a context.
        let summary = in_either!(&unsafe { read(context) }?.session, one => one.added_tie(number(tie)))?;
        // SAFETY: the host passes an output that may be written.
        unsafe { output.write(Some(summary).into()) };
        Ok(())
    })
}

/// Force of a tie of `fmc_context_add_tie` on its first part at `coords`: the derivative of the energy by the jump. That on the second part is
/// its negative. `count` becomes `dim`; `force` has room for `capacity` numbers.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BAD_VALUE` if there is no such tie, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_LENGTH`,
/// `FMC_ERROR_NON_FINITE_COORDINATE`, `FMC_ERROR_NO_STIFFNESS`, `FMC_ERROR_UNTIED` as `fmc_context_tie`, `FMC_ERROR_BUSY`. Threads: one call at a
/// time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_tie_force(
    context: *mut fmc_context,
    coords: *const fmc_coords,
    tie: i32,
    force: *mut f64,
    capacity: usize,
    count: *mut usize,
) -> fmc_status {
    entry(|| {
        let room = Room::new(capacity, count)?;
        // SAFETY: the host passes a context, a view, and room for `capacity` numbers.
        unsafe {
            write(context, |state| {
                let coords = reference("coords", coords)?;
                let base = state.index_base;
                let found = in_either!(&mut state.session, one => one.tie_force(number(tie), coords, base))?;
                room.write("entries of a force", "force", &found, force)
            })
        }
    })
}

/// A number that no tie and no surface has, where it is negative.
fn number(given: i32) -> usize {
    usize::try_from(given).unwrap_or(0)
}
