//! The options of a context, replaced and asked for.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::pointer::{Output, reference};
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::FMC_ERROR_OPTIONS_CONFLICT;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, read, write};
use crate::capi::structs::options::fmc_options;

/// Replaces the options. They apply from the next evaluation on; results of the last one are kept.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_NOT_POSITIVE`, `FMC_ERROR_BAD_VALUE`, `FMC_ERROR_OPTIONS_CONFLICT`,
/// `FMC_ERROR_RESERVED_FIELD`, `FMC_ERROR_STRUCT_SIZE`, `FMC_ERROR_THREADS`, `FMC_ERROR_BUSY`. Threads: one call at a time on a
/// context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_options(context: *mut fmc_context, options: *const fmc_options) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context and options.
        unsafe {
            write(context, |state| {
                let options = reference("options", options)?;
                if options.weld.to_bits() != state.options.weld.to_bits() {
                    let text = "option 'weld' belongs to the mesh and cannot change: make another context";
                    return Err(Failure::new(FMC_ERROR_OPTIONS_CONFLICT, text));
                }
                in_either!(&mut state.session, one => one.set_options(options.to_options()?))?;
                (state.index_base, state.options) = (options.index_base, *options);
                Ok(())
            })
        }
    })
}

/// The options in force, as given at creation or to the last `fmc_context_set_options`. Their stiffness includes the
/// factors of `fmc_context_stiffen`.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUSY`. Threads: several at once on one context, as long as no call
/// changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_options(context: *const fmc_context, options: *mut fmc_options) -> fmc_status {
    entry(|| {
        let output = Output::required("options", options)?;
        // SAFETY: the host passes a context, and an output that may be written.
        unsafe {
            let state = read(context)?;
            output
                .write(fmc_options { stiffness: in_either!(&state.session, one => one.stiffness()), ..state.options });
        }
        Ok(())
    })
}
