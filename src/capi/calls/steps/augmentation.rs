//! As little penetration as is wanted, whatever iterates the bodies.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::pointer::{Output, reference};
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, write};
use crate::capi::structs::multiplier::fmc_augmentation;
use crate::capi::structs::view::fmc_coords;

/// Moves surfaces out so that at the next equilibrium they press with less penetration: at every node by its mean gap
/// (`fmc_context_gap_constraints`) at `coords`, up to four times as far where the last update of a series has closed less than it
/// moved out, and back where it has opened. It is the method of multipliers: by the law's stiffness a shift is a pressure without
/// penetration.
///
/// Call it where the bodies are in equilibrium, or nearly, solve again, and so on until `is_converged`. The law's stiffness may be any,
/// but a low one takes more updates. All that is asked of the context afterwards, forces, tangents, steps, is that of the surfaces
/// moved out, whose penetration is pressure by stiffness; weighted gaps are those of the true ones. What is moved out stays for the
/// next load step; `fmc_context_set_multipliers` with none moves it back. Of two bodies the one with more nodes near the other has the
/// multipliers, of equals the first.
///
/// `reach`: how far from a partner gaps are measured, a length; 0: a twentieth of the bodies' extent. `tolerance`: the penetration and
/// the change that are left alone, a length. `result` receives what there was.
///
/// Errors: `FMC_ERROR_NOT_POSITIVE` for `reach` and `tolerance` that are negative or no number; `FMC_ERROR_UNSUPPORTED` with self-contact,
/// a law whose pressure is not a stiffness times the penetration, and a mesh in parts; else as
/// `fmc_context_evaluate`. The multipliers have then stayed. Threads: one call at a time on a context.
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

/// Multiplies the stiffness of the law, and of those that pairs have of their own, by `factor`; what surfaces that are moved out press
/// with where they just touch stays. Where an update of the multipliers leaves more than a part of the penetration, a quarter say,
/// this helps more than another one. The options of the context have the new stiffness.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_NOT_POSITIVE`, `FMC_ERROR_BUSY`; nothing has changed then. Threads: one call at a time
/// on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_stiffen(context: *mut fmc_context, factor: f64) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context.
        unsafe { write(context, |state| in_either!(&mut state.session, one => one.stiffen(factor))) }
    })
}
