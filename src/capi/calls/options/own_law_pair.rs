//! Options of a pair whose interface follows a law of the host, and a check of such a law.

use super::pair_options::{fmc_pair_options, named};
use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::pointer::{Output, reference, slice};
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::{FMC_ERROR_INTERFACE_LAW, FMC_ERROR_OPTIONS_CONFLICT};
use crate::capi::context::session::in_either;
use crate::capi::context::state::{FMC_LOG_WARNING, fmc_context, fmc_log_callback, write};
use crate::capi::structs::own_law::fmc_own_law;
use crate::contact::{Interface, LawCheck, check_law};
use std::ffi::{CString, c_void};
use std::sync::Arc;

/// Sets a law without a function and without history.
///
/// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_own_law_init(law: *mut fmc_own_law) -> fmc_status {
    entry(|| {
        let output = Output::required("law", law)?;
        let empty = fmc_own_law {
            struct_size: size_of::<fmc_own_law>(),
            history_count: 0,
            respond: None,
            user: std::ptr::null_mut(),
            reserved: [0; 4],
        };
        // SAFETY: the host passes a struct of the header's size, which may be written.
        unsafe { output.write(empty) };
        Ok(())
    })
}

/// Checks a law without a context: whether the same input has the same answer, for each point alone and among other points. It also
/// compares the tangents with differences of the tractions, to 1e-6 of the largest entry. Corners of a law, where damage begins, are
/// recognised.
///
/// `scale` is a jump over which the tractions change, such as the opening at which damage begins, a length; differences have steps of 1e-6
/// of it. `jump` has `jump_count` jumps of `dim` numbers at which to check; NULL with 0: 60 that the library spreads over -scale/4 ...
/// scale along the normal and -scale ... scale across it. The history is 0, and then the result of other jumps. `time_step` 0: not set.
///
/// `tell` may be NULL; else it receives a sentence for each check, with level `FMC_LOG_WARNING` for a fault, else 0.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_STRUCT_SIZE`, `FMC_ERROR_RESERVED_FIELD`, `FMC_ERROR_BAD_VALUE` for a `history_count` above
/// 1048576, `FMC_ERROR_DIMENSION`, `FMC_ERROR_LENGTH`, `FMC_ERROR_NOT_POSITIVE`. `FMC_ERROR_INTERFACE_LAW` for a law that fails, returns a
/// number that is not finite, or is wrong; the text lists all faults. Threads: any.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_own_law_check(
    law: *const fmc_own_law,
    dim: usize,
    scale: f64,
    jump: *const f64,
    jump_count: usize,
    time_step: f64,
    tell: fmc_log_callback,
    user: *mut c_void,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a law and `jump_count` jumps.
        let (law, jumps) = unsafe {
            (reference("law", law)?.to_law()?, slice("jump", jump, jump_count, if dim == 2 { 2 } else { 3 })?)
        };
        let report = check_law(&law, &LawCheck { jumps: jumps.to_vec(), time_step, ..LawCheck::new(dim, scale) })?;
        // SAFETY: the host guarantees a function that keeps to its contract.
        unsafe { tell_report(&report.sentences, &report.faults().collect::<Vec<_>>(), tell, user) }
    })
}

/// Tells the sentences of a report, and fails with those on what is wrong.
pub(super) unsafe fn tell_report(
    sentences: &[String],
    faults: &[&str],
    tell: fmc_log_callback,
    user: *mut c_void,
) -> Result<(), Failure> {
    if let Some(tell) = tell {
        for text in sentences {
            let level = if faults.contains(&text.as_str()) { FMC_LOG_WARNING } else { 0 };
            let text = CString::new(text.as_str()).unwrap_or_default();
            // SAFETY: the text lives during the call; passed on to the caller.
            unsafe { tell(user, level, text.as_ptr()) };
        }
    }
    match faults.is_empty() {
        true => Ok(()),
        false => Err(Failure::new(FMC_ERROR_INTERFACE_LAW, faults.join("; "))),
    }
}

/// Sets fields that laws of the host receive at their points, such as a temperature: `field_count` numbers for each of `row_count` rows
/// of the coordinates, all of a row together, (row_count, field_count). They stay until others are set; `field_count` 0: none.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_LENGTH` for another number of rows than coordinates have, `FMC_ERROR_NOT_POSITIVE` for a
/// number that is not finite, `FMC_ERROR_BUSY`; the old fields are then kept. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_law_fields(
    context: *mut fmc_context,
    values: *const f64,
    row_count: usize,
    field_count: usize,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context and `row_count` times `field_count` numbers.
        unsafe {
            write(context, |state| {
                let values = slice("values", values, row_count, field_count)?;
                in_either!(&mut state.session, one => one.set_law_fields(field_count, values))
            })
        }
    })
}

/// Sets the options of a pair as `fmc_context_set_pair_options` does, whose interface is `FMC_INTERFACE_LAW`, with the law. The history of
/// its points begins with zeros. `fmc_context_set_pair_options` with the same interface keeps law and history.
///
/// The tangent is symmetric only if the tangent of the law is. Unless the law has a potential, take the full tangent and an
/// unsymmetric solver.
///
/// Errors: as `fmc_context_set_pair_options`; the errors of `fmc_own_law_check` for an invalid struct; `FMC_ERROR_OPTIONS_CONFLICT` for
/// another interface. The earlier options are then kept. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_law_pair(
    context: *mut fmc_context,
    a_kind: i32,
    a: usize,
    b_kind: i32,
    b: usize,
    options: *const fmc_pair_options,
    law: *const fmc_own_law,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context, options, and a law.
        unsafe {
            write(context, |state| {
                let partners = named([(a_kind, a), (b_kind, b)])?;
                let options = reference("options", options)?.to_pair_options()?;
                if !matches!(options.interface, Interface::Law { .. }) {
                    let text = "your own law belongs to the interface 'law'";
                    return Err(Failure::new(FMC_ERROR_OPTIONS_CONFLICT, text));
                }
                let law = Arc::new(reference("law", law)?.to_law()?);
                in_either!(&mut state.session, one => one.set_law_pair(partners, options, law))
            })
        }
    })
}
