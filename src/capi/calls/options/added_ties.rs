//! Ties beside the options of pairs.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::list::Room;
use crate::capi::boundary::pointer::{Output, reference};
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, read, write};
use crate::capi::structs::tie::fmc_tie;
use crate::capi::structs::view::fmc_coords;

/// Ties two parts of the surface (`fmc_context_add_surface`), each on one body, on two bodies or on one. It holds x_A - x_B = `period` +
/// jump for points that face one another without deformation, after a shift of part B by `period`, `dim` numbers. `tie` becomes the number
/// of the tie, 1, 2, ...; the jump is 0 at first (`fmc_context_set_tie_jump`). A body may have several.
///
/// The rules of `FMC_INTERFACE_TIED` give the tied faces and the default of `reach` (0), with the stiffness of the pair's law and with
/// multipliers. It changes no contact. With a period only the named facets can hide one another. No heat flows through it.
///
/// With the period of a periodic cell and the jump H period the cell has the macroscopic displacement gradient H. Its stress is the sum of
/// F period^T / V over the ties, with their forces F (`fmc_context_tie_force`). In a bolt with a cut across it, the jump along the axis is
/// the pretension length.
///
/// Errors: `FMC_ERROR_NULL_POINTER`; `FMC_ERROR_BAD_VALUE` for a surface that does not exist; `FMC_ERROR_UNTIED`; `FMC_ERROR_NOT_POSITIVE`
/// for a reach; `FMC_ERROR_NON_FINITE_STIFFNESS` for a period that is not finite; `FMC_ERROR_BUSY`. `FMC_ERROR_UNSUPPORTED` for a surface
/// of several bodies, for two surfaces with a common facet, for two bodies in contact whose faces coincide, and for a period along the
/// radius. The same by the law "volume", without cells, and in parts. The context is then unchanged. Threads: one call at a time on a
/// context.
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

/// Removes a tie of `fmc_context_add_tie`. Other ties keep their numbers.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BAD_VALUE` if there is no such tie, `FMC_ERROR_BUSY`. Threads: one call at a time on a
/// context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_remove_tie(context: *mut fmc_context, tie: i32) -> fmc_status {
    // SAFETY: the host passes a context.
    entry(|| unsafe { write(context, |state| in_either!(&mut state.session, one => one.remove_tie(number(tie)))) })
}

/// Sets the jump of a tie of `fmc_context_add_tie`, the distance of the first part from the second in addition to the period: `dim`
/// numbers. It does not search for faces, and multipliers stay.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BAD_VALUE` if there is no such tie, `FMC_ERROR_NON_FINITE_STIFFNESS` for a jump that is not
/// finite, `FMC_ERROR_UNSUPPORTED` for one along the radius, `FMC_ERROR_BUSY`; the old jump is then kept. Threads: one call at a time on a
/// context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_tie_jump(context: *mut fmc_context, tie: i32, jump: *const f64) -> fmc_status {
    // SAFETY: the host passes a context and `dim` numbers.
    entry(|| unsafe {
        write(context, |state| in_either!(&mut state.session, one => one.set_tie_jump(number(tie), jump)))
    })
}

/// Area, gap and reach of a tie of `fmc_context_add_tie`, as `fmc_context_tie`.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BAD_VALUE` if there is no such tie, `FMC_ERROR_UNTIED` as `fmc_context_tie`,
/// `FMC_ERROR_BUSY`. Threads: several at once on one context, as long as no call changes it.
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

/// Force of a tie of `fmc_context_add_tie` on its first part at `coords`: the derivative of the energy by the jump. The force on the second
/// part is its negative. `count` becomes `dim`; `force` has room for `capacity` numbers.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BAD_VALUE` if there is no such tie, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_LENGTH`,
/// `FMC_ERROR_NON_FINITE_COORDINATE`, `FMC_ERROR_NO_STIFFNESS`, `FMC_ERROR_UNTIED` as `fmc_context_tie`, `FMC_ERROR_BUSY`. Threads: one
/// call at a time on a context.
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
