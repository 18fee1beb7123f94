//! Damage of cohesive interfaces and what else they have been through, for a restart, and how long a step takes.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::list::Room;
use crate::capi::boundary::pointer::slice;
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, read, write};

/// State of all points of cohesive interfaces after the accepted steps (`fmc_context_commit_step`), in the order of
/// `fmc_context_cohesive_points`. Each point has two numbers: its damage, 0 to 1, and its dissipated energy per area. A restart needs
/// it and the coordinates, and with friction or viscosity also `fmc_context_cohesive_history`.
///
/// `count` becomes their number; `damage` has room for `capacity`. NULL with capacity 0: only the number is returned.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_UNTIED` as `fmc_context_cohesive`, `FMC_ERROR_BUSY`; no
/// output is then written. Threads: several at once on one context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_damage(
    context: *const fmc_context,
    damage: *mut f64,
    capacity: usize,
    count: *mut usize,
) -> fmc_status {
    entry(|| {
        let room = Room::new(capacity, count)?;
        // SAFETY: the host passes a context, and room for `capacity` numbers.
        unsafe {
            let state = read(context)?;
            room.write("numbers of the damage", "damage", &in_either!(&state.session, one => one.damage())?, damage)
        }
    })
}

/// Sets this state: `count` numbers, as `fmc_context_damage` writes them, for a restart, or for an initially damaged interface. A damage of
/// 1 is a crack.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_LENGTH` for a wrong `count`, `FMC_ERROR_NOT_POSITIVE` for a damage outside 0 to 1 or a
/// negative energy, `FMC_ERROR_UNTIED`, `FMC_ERROR_BUSY`; the old damage is then kept. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_damage(
    context: *mut fmc_context,
    damage: *const f64,
    count: usize,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context and `count` numbers.
        unsafe {
            write(context, |state| {
                let damage = slice("damage", damage, count, 1)?;
                in_either!(&mut state.session, one => one.set_damage(damage))
            })
        }
    })
}

/// Further state of these points, five numbers for each. Two are the slip of the broken part, as multiples of the two edges at the first
/// corner of the facet of `partner`. Two are the energies per area that friction and the viscosity have dissipated. The last is the
/// loading of the point when the step began, sqrt(Y / Y0), which corresponds to more than its damage while the viscosity delays damage.
/// All are 0 without friction and viscosity. A restart sets them with the damage.
///
/// `count` becomes their number; `history` has room for `capacity`. NULL with capacity 0: only the number is returned.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_UNTIED` as `fmc_context_cohesive`, `FMC_ERROR_BUSY`; no
/// output is then written. Threads: several at once on one context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_cohesive_history(
    context: *const fmc_context,
    history: *mut f64,
    capacity: usize,
    count: *mut usize,
) -> fmc_status {
    entry(|| {
        let room = Room::new(capacity, count)?;
        // SAFETY: the host passes a context, and room for `capacity` numbers.
        unsafe {
            let state = read(context)?;
            let found = in_either!(&state.session, one => one.cohesive_history())?;
            room.write("numbers of the history", "history", &found, history)
        }
    })
}

/// Sets this state: `count` numbers, as `fmc_context_cohesive_history` writes them, for a restart.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_LENGTH` for a wrong `count`, `FMC_ERROR_NOT_POSITIVE` for a number that is not finite or a
/// negative energy of the viscosity, `FMC_ERROR_UNTIED`, `FMC_ERROR_BUSY`; the old history is then kept. Threads: one call at a time on a
/// context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_cohesive_history(
    context: *mut fmc_context,
    history: *const f64,
    count: usize,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context and `count` numbers.
        unsafe {
            write(context, |state| {
                let history = slice("history", history, count, 1)?;
                in_either!(&mut state.session, one => one.set_cohesive_history(history))
            })
        }
    })
}

/// Sets the duration of the current step and of all later ones, for the viscosity of cohesive interfaces. Without this call an evaluation
/// with a viscosity fails.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_NOT_POSITIVE`, `FMC_ERROR_BUSY`. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_time_step(context: *mut fmc_context, time_step: f64) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context.
        unsafe { write(context, |state| in_either!(&mut state.session, one => one.set_time_step(time_step))) }
    })
}
