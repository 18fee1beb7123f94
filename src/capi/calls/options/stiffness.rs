//! Where a stiffness comes from when the user has none.

use crate::capi::boundary::dimension::checked_dimension;
use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::pointer::Output;
use crate::capi::boundary::status::fmc_status;
use crate::contact::{StiffnessFrom, suggest_fiber_stiffness, suggest_stiffness};

fn suggest(dim: i32, exponent: f64, from: StiffnessFrom, stiffness: *mut f64) -> fmc_status {
    entry(|| {
        let output = Output::required("stiffness", stiffness)?;
        let suggested = suggest_stiffness(from, checked_dimension(dim)?, exponent).map_err(Failure::from)?;
        // SAFETY: the host passes a number that may be written.
        unsafe { output.write(suggested) };
        Ok(())
    })
}

/// Stiffness k of the quadratic law "fiber" (Pa/length) from the largest contact pressure expected (Pa) and the
/// acceptable penetration at that pressure (length): their ratio. From a modulus E and facets of size h, take E and h /
/// 10.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_NOT_POSITIVE`. Threads: any.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_suggest_fiber_stiffness(
    pressure: f64,
    penetration: f64,
    stiffness: *mut f64,
) -> fmc_status {
    entry(|| {
        let output = Output::required("stiffness", stiffness)?;
        let from = StiffnessFrom::PeakPressure { pressure, overlap: penetration };
        let suggested = suggest_fiber_stiffness(from).map_err(Failure::from)?;
        // SAFETY: the host passes a number that may be written.
        unsafe { output.write(suggested) };
        Ok(())
    })
}

/// Stiffness k of w = k V^m from Young's modulus of the softer body (Pa) and the size of its facets in contact
/// (length): an overlap a tenth of a facet deep over a patch one facet wide gives the traction E. `exponent` is m.
///
/// Units of k: Pa / (length^dim)^(m - 1); for m = 1 a pressure, in 2D and in 3D.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_DIMENSION`, `FMC_ERROR_NOT_POSITIVE`. Threads: any.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_suggest_stiffness_from_modulus(
    dim: i32,
    exponent: f64,
    modulus: f64,
    facet_size: f64,
    stiffness: *mut f64,
) -> fmc_status {
    suggest(dim, exponent, StiffnessFrom::Modulus { modulus, facet_size }, stiffness)
}

/// Stiffness k of w = k V^m from the largest contact pressure expected (Pa) and the acceptable overlap of one pair at
/// that pressure (length^dim; not used for m = 1): 1.2 times the stiffness that gives this pressure. `exponent` is m.
///
/// Otherwise as `fmc_suggest_stiffness_from_modulus`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_suggest_stiffness_from_pressure(
    dim: i32,
    exponent: f64,
    pressure: f64,
    overlap: f64,
    stiffness: *mut f64,
) -> fmc_status {
    suggest(dim, exponent, StiffnessFrom::PeakPressure { pressure, overlap }, stiffness)
}
