//! The equilibrium at the end of a load step, by reverse communication.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::{Failure, c_text};
use crate::capi::boundary::pointer::{Output, optional, reference};
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::{FMC_ERROR_BUSY, FMC_ERROR_NO_STEP};
use crate::capi::context::search::Search;
use crate::capi::context::state::{fmc_context, write};
use crate::capi::structs::equilibrium::{
    fmc_equilibrium_answer, fmc_equilibrium_options, fmc_equilibrium_problem, fmc_equilibrium_request,
};
use crate::capi::structs::equilibrium_result::fmc_equilibrium_result;
use std::ffi::{CString, c_char};
use std::sync::{Mutex, MutexGuard, TryLockError};

/// A search for the equilibrium of a host's bodies in contact at the end of one load step. Opaque.
///
/// Where the option `stiffness` is 0, it finds the stiffness of the contact from the host's matrix. It moves unsupported bodies until
/// contact balances their loads, or names a body that no contact stops. It keeps steps so short that no body passes through another, and
/// tries several ways to the equilibrium from the same start. The host keeps its vectors, matrices and solvers, and answers requests.
/// Concurrent calls on one return `FMC_ERROR_BUSY`.
pub struct fmc_equilibrium {
    state: Mutex<State>,
}

struct State {
    search: Search,
    unknown_count: usize,
    /// What is said of its end.
    texts: Vec<CString>,
}

/// # Safety
/// The host guarantees a living search that is not freed during the call.
unsafe fn locked<'a>(equilibrium: *const fmc_equilibrium) -> Result<MutexGuard<'a, State>, Failure> {
    // SAFETY: passed on to the caller.
    match unsafe { reference("equilibrium", equilibrium) }?.state.try_lock() {
        Ok(state) => Ok(state),
        Err(TryLockError::Poisoned(state)) => Ok(state.into_inner()),
        Err(TryLockError::WouldBlock) => Err(Failure::new(FMC_ERROR_BUSY, "the equilibrium is in use by another call")),
    }
}

/// Sets all options of a search to their defaults.
///
/// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_equilibrium_options_init(options: *mut fmc_equilibrium_options) -> fmc_status {
    entry(|| {
        let output = Output::required("options", options)?;
        // SAFETY: the host passes a struct of the header's size, which may be written.
        unsafe { output.write(fmc_equilibrium_options::default()) };
        Ok(())
    })
}

/// Sets a problem to zero, and its size.
///
/// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_equilibrium_problem_init(problem: *mut fmc_equilibrium_problem) -> fmc_status {
    entry(|| {
        let output = Output::required("problem", problem)?;
        // SAFETY: the host passes a struct of the header's size, which may be written.
        unsafe { output.write(fmc_equilibrium_problem::default()) };
        Ok(())
    })
}

/// Sets an answer to zero, and its size.
///
/// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_equilibrium_answer_init(answer: *mut fmc_equilibrium_answer) -> fmc_status {
    entry(|| {
        let output = Output::required("answer", answer)?;
        // SAFETY: the host passes a struct of the header's size, which may be written.
        unsafe { output.write(fmc_equilibrium_answer::default()) };
        Ok(())
    })
}

/// Makes a search, to be freed by `fmc_equilibrium_free`. `options` may be NULL: the defaults.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_STRUCT_SIZE`, `FMC_ERROR_RESERVED_FIELD`, `FMC_ERROR_BAD_VALUE`, `FMC_ERROR_LENGTH`,
/// `FMC_ERROR_INDEX_OUT_OF_RANGE`, `FMC_ERROR_NON_FINITE_COORDINATE`, `FMC_ERROR_NON_FINITE_STIFFNESS`, `FMC_ERROR_NOT_POSITIVE`,
/// `FMC_ERROR_UNSUPPORTED` for a mesh in parts, `FMC_ERROR_BUSY`. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_equilibrium_new(
    context: *mut fmc_context,
    problem: *const fmc_equilibrium_problem,
    options: *const fmc_equilibrium_options,
    equilibrium: *mut *mut fmc_equilibrium,
) -> fmc_status {
    entry(|| {
        let output = Output::required("equilibrium", equilibrium)?;
        // SAFETY: the host passes a context, a problem with its arrays, options or NULL, and a pointer that may be written.
        unsafe {
            let search = write(context, |state| {
                let problem = reference("problem", problem)?;
                let options = optional("options", options)?.copied().unwrap_or_default().to_options()?;
                let (size, base) = (state.index_size, state.index_base);
                Search::new(&mut state.session, problem, options, size, base)
            })?;
            let unknown_count = reference("problem", problem)?.unknown_count;
            let state = Mutex::new(State { search, unknown_count, texts: Vec::new() });
            output.write(Box::into_raw(Box::new(fmc_equilibrium { state })));
        }
        Ok(())
    })
}

/// Takes the answer to the last request, and writes the next request, or the end of the search.
///
/// `answer`: NULL for the first call; later a call without an answer repeats the request. Between the calls the host may call the
/// context, for example to get the tangent. It must not change obstacles, options or friction before the search has ended. A refusal
/// restores friction and multipliers of the context.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_MISALIGNED_POINTER`, `FMC_ERROR_STRUCT_SIZE`, `FMC_ERROR_UNSUPPORTED` for a context of
/// another dimension, `FMC_ERROR_BUSY`; the request then remains. Threads: one call at a time on a search and its context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_equilibrium_next(
    context: *mut fmc_context,
    equilibrium: *mut fmc_equilibrium,
    answer: *const fmc_equilibrium_answer,
    request: *mut fmc_equilibrium_request,
) -> fmc_status {
    entry(|| {
        let output = Output::required("request", request)?;
        // SAFETY: the host passes a context, a search, an answer with its arrays or NULL, and a struct that may be written.
        unsafe {
            let mut state = locked(equilibrium)?;
            let count = state.unknown_count;
            let answer = match (optional("answer", answer)?, state.search.asked()) {
                (Some(answer), Some(asked)) => Some(answer.read(asked, count)?),
                _ => None,
            };
            write(context, |context| state.search.next(&mut context.session, answer))?;
            output.write(state.search.request());
        }
        Ok(())
    })
}

/// Gives up a search that has not ended, for example because the host cannot answer. It restores friction and multipliers of the context,
/// and the search ends with a refusal. Does nothing if the search has ended.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_UNSUPPORTED` for a context of another dimension, `FMC_ERROR_BUSY`. Threads: one call at a
/// time on a search and its context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_equilibrium_abandon(
    context: *mut fmc_context,
    equilibrium: *mut fmc_equilibrium,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context and a search.
        unsafe {
            let mut state = locked(equilibrium)?;
            write(context, |context| state.search.abandon(&mut context.session))
        }
    })
}

/// Result of an ended search.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_NO_STEP` before its end, `FMC_ERROR_BUSY`. Threads: one call at a time on a search.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_equilibrium_found(
    equilibrium: *mut fmc_equilibrium,
    result: *mut fmc_equilibrium_result,
) -> fmc_status {
    entry(|| {
        let output = Output::required("result", result)?;
        // SAFETY: the host passes a search, and a struct that may be written.
        unsafe {
            let mut state = locked(equilibrium)?;
            let Some((result, texts)) = state.search.result() else {
                return Err(Failure::new(FMC_ERROR_NO_STEP, "the search for the equilibrium has not ended"));
            };
            if state.texts.is_empty() {
                state.texts = texts.iter().map(|text| c_text(text)).collect();
            }
            output.write(result);
        }
        Ok(())
    })
}

/// A sentence of a search that has ended: its warnings, or why there is no equilibrium; after `fmc_equilibrium_found`. NULL for a number
/// that is too large. Valid until the search is freed.
///
/// Errors: none. Threads: one call at a time on a search.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_equilibrium_text(equilibrium: *const fmc_equilibrium, number: usize) -> *const c_char {
    // SAFETY: the host passes a search.
    let state = unsafe { locked(equilibrium) };
    state.ok().and_then(|state| state.texts.get(number).map(|text| text.as_ptr())).unwrap_or(std::ptr::null())
}

/// Frees a search and sets the host's pointer to NULL. Does nothing for a NULL pointer, or a pointer to NULL. Freeing a search before
/// its end does not restore the context, which keeps frozen or softened friction, and multipliers: call `fmc_equilibrium_abandon`
/// first.
///
/// Errors: none. Threads: no other call on it may be running or follow.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_equilibrium_free(equilibrium: *mut *mut fmc_equilibrium) -> fmc_status {
    entry(|| {
        if equilibrium.is_null() {
            return Ok(());
        }
        // SAFETY: the host passes its pointer to what came from `fmc_equilibrium_new`, or to NULL; it is taken out, so that a
        // second call finds NULL.
        let taken = unsafe { equilibrium.replace(std::ptr::null_mut()) };
        if !taken.is_null() {
            // SAFETY: made by `Box::into_raw`, and not freed yet, or the pointer would have been NULL.
            drop(unsafe { Box::from_raw(taken) });
        }
        Ok(())
    })
}
