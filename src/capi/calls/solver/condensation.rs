//! Bodies factorised once, down to the degrees of freedom that feel contact.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::pointer::{Output, check, copy_list, reference, slice};
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::{
    FMC_ERROR_BUFFER_TOO_SMALL, FMC_ERROR_BUSY, FMC_ERROR_DOF_OUT_OF_RANGE,
};
use crate::sparse::{Compressed, Condensation};
use std::sync::{Mutex, MutexGuard, TryLockError};

/// Factors of the stiffness K of bodies, with the equations that feel contact kept for the end. Opaque.
///
/// For hosts whose solver has no Schur complements: from K, which the host assembles without contact and without what is held, come
/// the dense matrix and the right side for `fmc_context_contact_step`, and from the displacement of what is kept that of all.
/// With c the equations that are kept and r the others, `S = K_cc - K_cr inv(K_rr) K_rc`.
///
/// One thread works on it, so the same matrix has the same bits everywhere. Concurrent calls on one return `FMC_ERROR_BUSY`.
pub struct fmc_condensation {
    state: Mutex<Condensation>,
}

/// # Safety
/// The host guarantees a living condensation that is not freed during the call.
unsafe fn locked<'a>(condensation: *const fmc_condensation) -> Result<MutexGuard<'a, Condensation>, Failure> {
    // SAFETY: passed on to the caller.
    match unsafe { reference("condensation", condensation) }?.state.try_lock() {
        Ok(state) => Ok(state),
        // Only a factorisation writes; one that panics has said before that there are no factors.
        Err(TryLockError::Poisoned(state)) => Ok(state.into_inner()),
        Err(TryLockError::WouldBlock) => {
            Err(Failure::new(FMC_ERROR_BUSY, "the condensation is in use by another call"))
        }
    }
}

fn has_room(name: &str, needed: usize, capacity: usize) -> Result<(), Failure> {
    if capacity < needed {
        let text = format!("'{name}' has room for {capacity} numbers, {needed} are needed");
        return Err(Failure::new(FMC_ERROR_BUFFER_TOO_SMALL, text));
    }
    Ok(())
}

/// Makes a condensation without factors, to be freed by `fmc_condensation_free`.
///
/// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_condensation_new(condensation: *mut *mut fmc_condensation) -> fmc_status {
    entry(|| {
        let output = Output::required("condensation", condensation)?;
        let made = Box::new(fmc_condensation { state: Mutex::default() });
        // SAFETY: the host passes a pointer that may be written.
        unsafe { output.write(Box::into_raw(made)) };
        Ok(())
    })
}

/// Frees a condensation and sets the host's pointer to NULL. Does nothing for a NULL pointer, or a pointer to NULL.
///
/// Errors: none. Threads: no other call on it may be running or follow.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_condensation_free(condensation: *mut *mut fmc_condensation) -> fmc_status {
    entry(|| {
        if condensation.is_null() {
            return Ok(());
        }
        // SAFETY: the host passes its pointer to what came from `fmc_condensation_new`, or to NULL; it is taken out, so
        // that a second call finds NULL.
        let taken = unsafe { condensation.replace(std::ptr::null_mut()) };
        if !taken.is_null() {
            // SAFETY: made by `Box::into_raw`, and not freed yet, or the pointer would have been NULL.
            drop(unsafe { Box::from_raw(taken) });
        }
        Ok(())
    })
}

/// Factorises a symmetric matrix of `count` equations in compressed rows, with `kept_count` of them, `kept`, for the end.
///
/// `row_offsets`: `count + 1` numbers from 0; `cols` and `values`: column and value of every entry, in any order in a row; those at
/// one place add up. All entries, or none above the diagonal. Equations count from 0; `kept` ascends. The other
/// equations have to be positive definite: bodies that are held, or are so by what is kept. What depends on the pattern alone is
/// kept for the next matrix of the same pattern, and factorising that takes less.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_MISALIGNED_POINTER`, `FMC_ERROR_LENGTH`, `FMC_ERROR_DOF_OUT_OF_RANGE`,
/// `FMC_ERROR_REPEATED_DOF`, `FMC_ERROR_NON_FINITE_STIFFNESS`, `FMC_ERROR_UNSYMMETRIC`, which all leave the factors that there
/// were; `FMC_ERROR_NOT_POSITIVE_DEFINITE` and `FMC_ERROR_OVERFLOW`, after which there are none; `FMC_ERROR_UNSUPPORTED` if the
/// library lacks the feature "solver"; `FMC_ERROR_BUSY`. Threads: one call at a time on a condensation.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_condensation_factorise(
    condensation: *mut fmc_condensation,
    count: usize,
    row_offsets: *const i64,
    cols: *const i64,
    values: *const f64,
    kept: *const i64,
    kept_count: usize,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a condensation and arrays of the lengths given; the last offset is their length.
        unsafe {
            let mut state = locked(condensation)?;
            let offsets = match count {
                0 => &[0],
                _ => slice("row_offsets", row_offsets, count.saturating_add(1), 1)?,
            };
            let entries = usize::try_from(offsets[count]).unwrap_or(usize::MAX);
            let (columns, values) = (slice("cols", cols, entries, 1)?, slice("values", values, entries, 1)?);
            let kept = equations(slice("kept", kept, kept_count, 1)?)?;
            Ok(state.factorise(&Compressed { offsets, columns, values }, &kept)?)
        }
    })
}

/// S of the last matrix, `kept_count * kept_count` numbers row by row: the stiffness for `fmc_context_contact_step`.
///
/// `capacity`: numbers that fit into `complement`.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_MISALIGNED_POINTER`, `FMC_ERROR_NOT_FACTORISED`, `FMC_ERROR_BUFFER_TOO_SMALL`,
/// `FMC_ERROR_BUSY`. Threads: one call at a time on a condensation.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_condensation_complement(
    condensation: *const fmc_condensation,
    complement: *mut f64,
    capacity: usize,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a condensation, and room for so many numbers.
        unsafe {
            let state = locked(condensation)?;
            let needed = state.kept()?.len().pow(2);
            has_room("complement", needed, capacity)?;
            if needed > 0 {
                check("complement", complement.cast_const())?;
            }
            copy_list("complement", &state.complement()?, complement)
        }
    })
}

/// What the other equations leave of a right side b on those that are kept: `b_c - K_cr inv(K_rr) b_r`.
///
/// `right`: `count` numbers, as many as there are equations. `condensed` has room for `capacity`, at least as many as are kept.
/// For `fmc_context_contact_step` its negative is the residual, where b are the external less the internal forces.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_MISALIGNED_POINTER`, `FMC_ERROR_NOT_FACTORISED`, `FMC_ERROR_LENGTH`,
/// `FMC_ERROR_NON_FINITE_STIFFNESS`, `FMC_ERROR_OVERFLOW`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_BUSY`. Threads: one call at a
/// time on a condensation.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_condensation_condense(
    condensation: *const fmc_condensation,
    right: *const f64,
    count: usize,
    condensed: *mut f64,
    capacity: usize,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a condensation, so many numbers, and room for so many.
        unsafe {
            let state = locked(condensation)?;
            has_room("condensed", state.kept()?.len(), capacity)?;
            let found = state.condense(slice("right", right, count, 1)?)?;
            copy_list("condensed", &found, condensed)
        }
    })
}

/// Solution of `K x = b` in the equations that are not kept, with those that are as given: `x_r = inv(K_rr) (b_r - K_rc x_c)`.
///
/// `right` and `kept` are b and x_c, `count` and `kept_count` numbers, as many as there are equations and as are kept; `solution` has
/// room for `capacity`, at least `count`, and may not overlap them. With the displacement of `fmc_context_contact_step` as x_c it is
/// the change of all displacements.
///
/// Errors: as `fmc_condensation_condense`. Threads: one call at a time on a condensation.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_condensation_expand(
    condensation: *const fmc_condensation,
    right: *const f64,
    count: usize,
    kept: *const f64,
    kept_count: usize,
    solution: *mut f64,
    capacity: usize,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a condensation, so many numbers, and room for so many.
        unsafe {
            let state = locked(condensation)?;
            has_room("solution", state.size()?, capacity)?;
            let (right, kept) = (slice("right", right, count, 1)?, slice("kept", kept, kept_count, 1)?);
            copy_list("solution", &state.expand(right, kept)?, solution)
        }
    })
}

/// Equations as the core counts them; that they are too large it finds itself.
fn equations(given: &[i64]) -> Result<Vec<usize>, Failure> {
    let number = |&equation: &i64| {
        let text = || format!("'kept' names equation {equation}");
        usize::try_from(equation).map_err(|_| Failure::new(FMC_ERROR_DOF_OUT_OF_RANGE, text()))
    };
    given.iter().map(number).collect()
}
