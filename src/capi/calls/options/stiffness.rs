//! A stiffness for hosts that have none.

use crate::capi::boundary::dimension::checked_dimension;
use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::pointer::Output;
use crate::capi::boundary::status::fmc_status;
use crate::capi::structs::law::LAW;
use crate::contact::{StiffnessFrom, suggest_fiber_stiffness, suggest_stiffness};

/// Suggests an initial stiffness k, from Young's modulus E of the softer body (Pa) and the size h of its cells in
/// contact (length). `law` is a value of `fmc_law`.
///
/// For the laws "depth" and "fiber" k = 10 E / h, a pressure per length: a penetration of a tenth of a cell presses with E.
/// `dim` and `exponent` have no effect. For the law "volume" with the exponent m an overlap a tenth of a cell deep over a
/// patch one cell wide presses with E: k = E / (m V^(m - 1)), V = h^dim / 10. Its unit is Pa / (length^dim)^(m - 1); for m = 1
/// it is E.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BAD_VALUE` for an unknown law, `FMC_ERROR_DIMENSION`,
/// `FMC_ERROR_NOT_POSITIVE`. Threads: any.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_suggest_stiffness(
    law: i32,
    dim: i32,
    exponent: f64,
    modulus: f64,
    cell_size: f64,
    stiffness: *mut f64,
) -> fmc_status {
    entry(|| {
        let output = Output::required("stiffness", stiffness)?;
        let dim = checked_dimension(dim)?;
        let from = StiffnessFrom::Modulus { modulus, facet_size: cell_size };
        let suggested = match LAW.name(law)? {
            "volume" => suggest_stiffness(from, dim, exponent),
            _ => suggest_fiber_stiffness(from),
        };
        // SAFETY: the host passes a number that may be written.
        unsafe { output.write(suggested.map_err(Failure::from)?) };
        Ok(())
    })
}
