//! Damage of cohesive interfaces and what else they have been through, for a restart, and how long a step takes.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::list::Room;
use crate::capi::boundary::pointer::slice;
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, read, write};

/// What all points of cohesive interfaces have been through in the steps that were accepted (`fmc_context_commit_step`), in the order of
/// `fmc_context_cohesive_points`: two numbers for each, its damage, 0 to 1, and the energy by area that it has dissipated. With the
/// coordinates it is all that a restart needs of them, but for friction and viscosity (`fmc_context_cohesive_history`).
///
/// `count` becomes their number; `damage` has room for `capacity`. NULL with capacity 0: only the number is returned.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_UNTIED` as `fmc_context_cohesive`, `FMC_ERROR_BUSY`; nothing
/// is written then. Threads: several at once on one context, as long as no call changes it.
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

/// Sets it: `count` numbers, as `fmc_context_damage` writes them, for a restart, or where an interface is damaged at first. A damage of 1 is a
/// crack.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_LENGTH` for another number of them, `FMC_ERROR_NOT_POSITIVE` for a damage outside 0 to 1 or a
/// negative energy, `FMC_ERROR_UNTIED`, `FMC_ERROR_BUSY`; the old damage then stays. Threads: one call at a time on a context.
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

/// What else these points have been through, five numbers for each: two of the slip of what is broken, as multiples of the edges of the facet of
/// `partner` that leave its first corner; the energies by area that friction and the viscosity have dissipated; and where the point was when the
/// step began, which is more than its damage says while viscosity holds damage back. All are 0 without friction and viscosity. A restart sets
/// them with the damage.
///
/// `count` becomes their number; `history` has room for `capacity`. NULL with capacity 0: only the number is returned.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_UNTIED` as `fmc_context_cohesive`, `FMC_ERROR_BUSY`; nothing
/// is written then. Threads: several at once on one context, as long as no call changes it.
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

/// Sets it: `count` numbers, as `fmc_context_cohesive_history` writes them, for a restart.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_LENGTH` for another number of them, `FMC_ERROR_NOT_POSITIVE` for what is not finite or a
/// negative energy of the viscosity, `FMC_ERROR_UNTIED`, `FMC_ERROR_BUSY`; the old one then stays. Threads: one call at a time on a context.
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

/// How long the step takes that is under way, and each later one until this is called again: what the viscosity of cohesive interfaces goes
/// by. An evaluation with a viscosity fails as long as this was not called.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_NOT_POSITIVE`, `FMC_ERROR_BUSY`. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_time_step(context: *mut fmc_context, time_step: f64) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context.
        unsafe { write(context, |state| in_either!(&mut state.session, one => one.set_time_step(time_step))) }
    })
}
