//! As little penetration as is wanted, whatever iterates the bodies.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::pointer::{Output, reference};
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, write};
use crate::capi::structs::multiplier::fmc_augmentation;
use crate::capi::structs::view::fmc_coords;

/// Updates the multipliers, which shift surfaces outwards so that they press with less penetration at the next equilibrium. A
/// node shifts by its mean gap (`fmc_context_gap_constraints`) at `coords`. It shifts up to four times as far where the last
/// update of a series has closed less than its shift, and back where the contact has opened. This is the method of multipliers:
/// shift times the law's stiffness is a pressure without penetration.
///
/// Call it where the bodies are in equilibrium, or nearly, solve again, and repeat until `is_converged`. Any stiffness of the law
/// works, but a low one takes more updates. All later results of the context (forces, tangents, steps) refer to the shifted surfaces,
/// whose penetration is pressure / stiffness; weighted gaps refer to the true surfaces. Multipliers stay for the next load step;
/// `fmc_context_set_multipliers` without multipliers removes them. Of two bodies the one with more nodes near the other has the
/// multipliers; with equal numbers the first.
///
/// `reach`: largest distance from a partner at which gaps are measured, a length; 0: a twentieth of the bodies' extent. `tolerance`:
/// penetration and change below which nothing is updated, a length. `result` receives both as they were before the update.
///
/// Errors: `FMC_ERROR_NOT_POSITIVE` for `reach` and `tolerance` that are negative or NaN; `FMC_ERROR_UNSUPPORTED` with self-contact, a law
/// whose pressure is not a stiffness times the penetration, and a mesh in parts; else as `fmc_context_evaluate`. The multipliers are then
/// unchanged. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_augment(
    context: *mut fmc_context,
    coords: *const fmc_coords,
    reach: f64,
    tolerance: f64,
    result: *mut fmc_augmentation,
) -> fmc_status {
    entry(|| {
        let output = Output::required("result", result)?;
        // SAFETY: the host passes a context and a view, and an output that may be written.
        unsafe {
            let found = write(
                context,
                |state| in_either!(&mut state.session, one => one.augment(reference("coords", coords)?, reach, tolerance, state.index_base)),
            )?;
            output.write(found.into());
        }
        Ok(())
    })
}

/// Multiplies the stiffness of the law, and of the separate laws of pairs, by `factor`. The pressure of the multipliers does not
/// change. Call it instead of another update if the last update reduced the penetration too little, say to more than a quarter. The
/// options of the context have the new stiffness.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_NOT_POSITIVE`, `FMC_ERROR_BUSY`; the context is then unchanged. Threads: one call at a
/// time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_stiffen(context: *mut fmc_context, factor: f64) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context.
        unsafe { write(context, |state| in_either!(&mut state.session, one => one.stiffen(factor))) }
    })
}
