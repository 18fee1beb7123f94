//! What the last evaluation of a context found, handed out piece by piece.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::pointer::Output;
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::FMC_ERROR_INDEX_OUT_OF_RANGE;
use crate::capi::context::state::{fmc_context, read};
use crate::capi::structs::evaluation::{Evaluation, fmc_pair_result, fmc_resultant};
use std::ffi::c_char;

/// Writes the entry of a list of the last evaluation.
///
/// # Safety
/// The host guarantees the context, and that `output` may be written.
unsafe fn hand_out<T: Copy>(
    context: *const fmc_context,
    what: &str,
    index: usize,
    output: *mut T,
    list: impl FnOnce(&Evaluation) -> &[T],
) -> fmc_status {
    entry(|| {
        let output = Output::required(what, output)?;
        // SAFETY: passed on to the caller.
        let state = unsafe { read(context) }?;
        let list = list(&state.evaluation);
        let found = *list.get(index).ok_or_else(|| out_of_range(what, index, list.len()))?;
        // SAFETY: passed on to the caller.
        unsafe { output.write(found) };
        Ok(())
    })
}

fn out_of_range(what: &str, index: usize, count: usize) -> Failure {
    let text = format!("there is no {what} {index} in the last evaluation, only {count}");
    Failure::new(FMC_ERROR_INDEX_OUT_OF_RANGE, text)
}

/// Contact force and moment on a body of the mesh, from the last successful evaluation. Bodies are ordered by id.
///
/// `index` counts from 0 to `body_count` of `fmc_result`.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_INDEX_OUT_OF_RANGE`, `FMC_ERROR_BUSY`. Threads: several at once on one
/// context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_body_resultant(
    context: *const fmc_context,
    index: usize,
    body: *mut fmc_resultant,
) -> fmc_status {
    // SAFETY: the host passes a context and an output.
    unsafe { hand_out(context, "body", index, body, |evaluation| &evaluation.bodies) }
}

/// Contact force and moment on an obstacle, from the last successful evaluation. Otherwise as `fmc_context_body_resultant`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_obstacle_resultant(
    context: *const fmc_context,
    index: usize,
    obstacle: *mut fmc_resultant,
) -> fmc_status {
    // SAFETY: the host passes a context and an output.
    unsafe { hand_out(context, "obstacle", index, obstacle, |evaluation| &evaluation.obstacles) }
}

/// One overlapping pair of the last successful evaluation. Otherwise as `fmc_context_body_resultant`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_pair_result(
    context: *const fmc_context,
    index: usize,
    pair: *mut fmc_pair_result,
) -> fmc_status {
    // SAFETY: the host passes a context and an output.
    unsafe { hand_out(context, "pair", index, pair, |evaluation| &evaluation.pairs) }
}

/// One warning of the last successful evaluation: a value of `fmc_warning`, and a sentence that is valid until the next
/// evaluation of the context or its end. Either output may be NULL. Otherwise as `fmc_context_body_resultant`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_warning(
    context: *const fmc_context,
    index: usize,
    code: *mut i32,
    text: *mut *const c_char,
) -> fmc_status {
    entry(|| {
        let (code, text) = (Output::optional("code", code)?, Output::optional("text", text)?);
        // SAFETY: the host passes a context.
        let state = unsafe { read(context) }?;
        let warnings = &state.evaluation.warnings;
        let found = warnings.get(index).ok_or_else(|| out_of_range("warning", index, warnings.len()))?;
        // SAFETY: the outputs, where given, may be written.
        unsafe {
            code.write(found.0);
            text.write(found.1.as_ptr());
        }
        Ok(())
    })
}
