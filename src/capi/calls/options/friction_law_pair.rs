//! Options of a pair that slides by a law of the host, and a check of such a law.

use super::own_law_pair::tell_report;
use super::pair_options::{fmc_pair_options, named};
use crate::capi::boundary::entry::entry;
use crate::capi::boundary::pointer::{Output, reference};
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, fmc_log_callback, write};
use crate::capi::structs::friction_law::fmc_friction_law;
use crate::contact::{FrictionLawCheck, check_friction_law};
use std::ffi::c_void;
use std::sync::Arc;

/// Sets a law of friction without a function and without history.
///
/// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_friction_law_init(law: *mut fmc_friction_law) -> fmc_status {
    entry(|| {
        let output = Output::required("law", law)?;
        let empty = fmc_friction_law {
            struct_size: size_of::<fmc_friction_law>(),
            history_count: 0,
            limit: None,
            user: std::ptr::null_mut(),
            reserved: [0; 4],
        };
        // SAFETY: the host passes a struct of the header's size, which may be written.
        unsafe { output.write(empty) };
        Ok(())
    })
}

/// Checks a law of friction without a context: whether the same input has the same answer, for each facet alone and among other facets. It
/// also compares the derivatives with differences of the limit, to 1e-6. Corners of a law are recognised.
///
/// It calls the law at 60 pressures up to `pressure`, and slips of a step up to `slip`, a length, along every axis; differences have steps
/// of 1e-6 of these. The history is 0, and then the result of other facets. `time_step` 0: not set. There are no fields.
///
/// `tell` may be NULL; else it receives a sentence for each check, with level `FMC_LOG_WARNING` for a fault, else 0.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_STRUCT_SIZE`, `FMC_ERROR_RESERVED_FIELD`, `FMC_ERROR_BAD_VALUE` for a `history_count` above
/// 1048576, `FMC_ERROR_DIMENSION`, `FMC_ERROR_NOT_POSITIVE`. `FMC_ERROR_INTERFACE_LAW` for a law that fails, returns an invalid limit, or
/// is wrong; the text lists all faults. Threads: any.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_friction_law_check(
    law: *const fmc_friction_law,
    dim: usize,
    pressure: f64,
    slip: f64,
    time_step: f64,
    tell: fmc_log_callback,
    user: *mut c_void,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a law.
        let law = unsafe { reference("law", law)?.to_law()? };
        let report =
            check_friction_law(&law, &FrictionLawCheck { time_step, ..FrictionLawCheck::new(dim, pressure, slip) })?;
        // SAFETY: the host guarantees a function that keeps to its contract.
        unsafe { tell_report(&report.sentences, &report.faults().collect::<Vec<_>>(), tell, user) }
    })
}

/// Sets the options of a pair (two bodies, a body and an obstacle, or a body with itself) as `fmc_context_set_pair_options` does, and its
/// law of sliding, which replaces coefficient, cohesion and shear limit. The history of the law begins with zeros.
/// `fmc_context_set_pair_options` removes the law. As with any friction the tangent is unsymmetric, and a step must have begun.
///
/// Errors: as `fmc_context_set_pair_options`; the errors of `fmc_friction_law_check` for an invalid struct; `FMC_ERROR_UNSUPPORTED` with a
/// coefficient of friction or a wear coefficient of the pair, with another interface than contact, and for a mesh in parts. The earlier
/// options are then kept. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_friction_law_pair(
    context: *mut fmc_context,
    a_kind: i32,
    a: usize,
    b_kind: i32,
    b: usize,
    options: *const fmc_pair_options,
    law: *const fmc_friction_law,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context, options, and a law.
        unsafe {
            write(context, |state| {
                let partners = named([(a_kind, a), (b_kind, b)])?;
                let options = reference("options", options)?.to_pair_options()?;
                let law = Arc::new(reference("law", law)?.to_law()?);
                in_either!(&mut state.session, one => one.set_friction_law_pair(partners, options, law))
            })
        }
    })
}
