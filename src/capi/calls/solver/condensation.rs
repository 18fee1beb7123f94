//! Bodies factorised once, down to the degrees of freedom that feel contact.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::list::Room;
use crate::capi::boundary::pointer::{Output, check, reference, slice};
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::{FMC_ERROR_BUSY, FMC_ERROR_DOF_OUT_OF_RANGE};
use crate::capi::structs::csr::fmc_csr;
use crate::sparse::{Compressed, Condensation};
use std::ffi::c_void;
use std::sync::{Mutex, MutexGuard, TryLockError};

/// Factors of the stiffness K of bodies, with the equations that feel contact retained for the end. Opaque.
///
/// For hosts whose solver has no Schur complements. The host assembles K without contact and without fixed degrees of freedom. The
/// condensation gives the dense matrix and the right side for `fmc_context_contact_step`, and all displacements from the retained
/// ones. With c the retained equations and r the rest, `S = K_cc - K_cr inv(K_rr) K_rc`.
///
/// It works with one thread, so the same matrix gives bit-for-bit identical results everywhere. Concurrent calls on one
/// return `FMC_ERROR_BUSY`.
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

/// Factorises a symmetric matrix, with `retained_count` of its equations, `retained`, for the end.
///
/// `matrix`: all entries, or none above the diagonal. `retained` counts equations as the matrix does, with numbers of the same width,
/// and ascends. The other equations have to be positive definite: bodies are supported, or would be if the retained equations were
/// fixed. The symbolic factorisation is kept for the next matrix of the same pattern, which then takes less time.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_MISALIGNED_POINTER`, `FMC_ERROR_STRUCT_SIZE`, `FMC_ERROR_RESERVED_FIELD`,
/// `FMC_ERROR_INDEX_SIZE`, `FMC_ERROR_LENGTH`, `FMC_ERROR_DOF_OUT_OF_RANGE`, `FMC_ERROR_REPEATED_DOF`, `FMC_ERROR_NON_FINITE_STIFFNESS`,
/// `FMC_ERROR_UNSYMMETRIC`, which all keep the earlier factors. `FMC_ERROR_NOT_POSITIVE_DEFINITE` and `FMC_ERROR_OVERFLOW`, which discard
/// them. `FMC_ERROR_UNSUPPORTED` if the library lacks the feature "solver"; `FMC_ERROR_BUSY`. Threads: one call at a time on a
/// condensation.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_condensation_factorise(
    condensation: *mut fmc_condensation,
    matrix: *const fmc_csr,
    retained: *const c_void,
    retained_count: usize,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a condensation, a matrix, and as many equations as it says.
        unsafe {
            let mut state = locked(condensation)?;
            let given = reference("matrix", matrix)?;
            let (size, base) = (given.checked_size()?, given.index_base);
            let rows = given.read(given.row_count)?;
            let retained = equations(&size.list("retained", retained, retained_count, 1)?, base)?;
            let compressed = Compressed { offsets: &rows.offsets, columns: &rows.cols, values: rows.values };
            state.factorise(&compressed, &retained).map_err(Failure::counted_from(base))
        }
    })
}

/// S of the last matrix, row by row: the stiffness for `fmc_context_contact_step`.
///
/// `count` becomes the number of entries, the square of the number of retained equations; `complement` has room for `capacity`. NULL
/// with capacity 0: only the number is returned.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_MISALIGNED_POINTER`, `FMC_ERROR_NOT_FACTORISED`, `FMC_ERROR_BUFFER_TOO_SMALL`,
/// `FMC_ERROR_BUSY`. Threads: one call at a time on a condensation.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_condensation_complement(
    condensation: *const fmc_condensation,
    complement: *mut f64,
    capacity: usize,
    count: *mut usize,
) -> fmc_status {
    entry(|| {
        let room = Room::new(capacity, count)?;
        // SAFETY: the host passes a condensation, and room for so many numbers.
        unsafe {
            let state = locked(condensation)?;
            let needed = state.kept()?.len().pow(2);
            if !room.is_asked("numbers", &[complement.is_null()], needed)? {
                room.tell(needed);
                return Ok(());
            }
            if needed > 0 {
                check("complement", complement.cast_const())?;
            }
            room.write("numbers", "complement", &state.complement()?, complement)
        }
    })
}

/// Condenses a right side b on the retained equations: `b_c - K_cr inv(K_rr) b_r`.
///
/// `right`: `right_count` numbers, as many as there are equations. `count` becomes the number of retained equations; `condensed` has
/// room for `capacity`. With b the external minus the internal forces, its negative is the residual for `fmc_context_contact_step`.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_MISALIGNED_POINTER`, `FMC_ERROR_NOT_FACTORISED`, `FMC_ERROR_LENGTH`,
/// `FMC_ERROR_NON_FINITE_STIFFNESS`, `FMC_ERROR_OVERFLOW`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_BUSY`. Threads: one call at a
/// time on a condensation.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_condensation_condense(
    condensation: *const fmc_condensation,
    right: *const f64,
    right_count: usize,
    condensed: *mut f64,
    capacity: usize,
    count: *mut usize,
) -> fmc_status {
    entry(|| {
        let room = Room::new(capacity, count)?;
        // SAFETY: the host passes a condensation, so many numbers, and room for so many.
        unsafe {
            let state = locked(condensation)?;
            room.is_asked("numbers", &[condensed.is_null()], state.kept()?.len())?;
            let found = state.condense(slice("right", right, right_count, 1)?)?;
            room.write("numbers", "condensed", &found, condensed)
        }
    })
}

/// Solution of `K x = b` in the equations that are not retained, with given values of the retained unknowns:
/// `x_r = inv(K_rr) (b_r - K_rc x_c)`.
///
/// `right` is b, as many numbers as there are equations, and `retained` is x_c, one for every retained equation. `count` becomes the
/// number of equations; `solution` has room for `capacity`, and may not overlap them. With the displacement of
/// `fmc_context_contact_step` as x_c it is the change of all displacements.
///
/// Errors: as `fmc_condensation_condense`. Threads: one call at a time on a condensation.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_condensation_expand(
    condensation: *const fmc_condensation,
    right: *const f64,
    right_count: usize,
    retained: *const f64,
    retained_count: usize,
    solution: *mut f64,
    capacity: usize,
    count: *mut usize,
) -> fmc_status {
    entry(|| {
        let room = Room::new(capacity, count)?;
        // SAFETY: the host passes a condensation, so many numbers, and room for so many.
        unsafe {
            let state = locked(condensation)?;
            room.is_asked("numbers", &[solution.is_null()], state.size()?)?;
            let right = slice("right", right, right_count, 1)?;
            let retained = slice("retained", retained, retained_count, 1)?;
            room.write("numbers", "solution", &state.expand(right, retained)?, solution)
        }
    })
}

/// Equations as the core counts them; that they are too large it finds itself.
fn equations(given: &[i64], base: i32) -> Result<Vec<usize>, Failure> {
    let number = |&equation: &i64| {
        let text = || format!("'retained' names equation {equation}");
        let zero_based = equation.checked_sub(base.into()).and_then(|equation| usize::try_from(equation).ok());
        zero_based.ok_or_else(|| Failure::new(FMC_ERROR_DOF_OUT_OF_RANGE, text()))
    };
    given.iter().map(number).collect()
}
