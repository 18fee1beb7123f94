//! What the contact allows an explicit host.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::pointer::{Output, reference, slice};
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, write};
use crate::capi::structs::view::fmc_coords;

/// Largest time step of central differences (leapfrog) for the contact alone, from the tangent at `coords`: 2/sqrt(q).
/// Here q is an upper bound of the largest eigenvalue of M^-1 K, including terms of rank one, a few per cent above it.
/// Infinite without contact. `masses` are lumped masses, one for every node of the mesh, positive where a node feels
/// contact, and infinite for nodes that the host holds. Obstacles are held.
///
/// A host whose limit without contact is h is stable with the step s, 1/s^2 = 1/h^2 + 1/step^2. The limit holds for the
/// motion linearised at `coords`. It includes neither contact that begins within a step, nor the force of the law
/// "volume" with an exponent below 2, which jumps. The stored tangent and results are kept. Unit: sqrt(mass * length /
/// force).
///
/// Errors: as `fmc_context_tangent`, and `FMC_ERROR_NOT_POSITIVE_MASS`. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_stable_step(
    context: *mut fmc_context,
    coords: *const fmc_coords,
    masses: *const f64,
    step: *mut f64,
) -> fmc_status {
    entry(|| {
        let output = Output::required("step", step)?;
        // SAFETY: the host passes a context, a view, and one mass for every node.
        let found = unsafe {
            write(context, |state| {
                let coords = reference("coords", coords)?;
                let masses = slice("masses", masses, in_either!(&state.session, one => one.counts()).unknowns, 1)?;
                in_either!(&mut state.session, one => one.stable_step(coords, masses, state.index_base))
            })
        }?;
        // SAFETY: the output may be written.
        unsafe { output.write(found) };
        Ok(())
    })
}

/// Finds the stiffness of every pair without a separate law from the nodes' masses and `limit`, the largest time step of the bodies
/// without contact in central differences. Contact of whole faces then makes the step a tenth shorter. For hosts without a matrix, with
/// the option `stiffness` 0. `masses` as for `fmc_context_stable_step`.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_LENGTH`, `FMC_ERROR_NOT_POSITIVE` for the limit, `FMC_ERROR_NOT_POSITIVE_MASS`,
/// `FMC_ERROR_UNSUPPORTED` where the host holds every surface or the option `stiffness` is given, `FMC_ERROR_BUSY`; the earlier stiffness
/// is then kept. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_stiffness_from_masses(
    context: *mut fmc_context,
    coords: *const fmc_coords,
    masses: *const f64,
    limit: f64,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context, a view, and one mass for every node.
        unsafe {
            write(context, |state| {
                let coords = reference("coords", coords)?;
                let masses = slice("masses", masses, in_either!(&state.session, one => one.counts()).unknowns, 1)?;
                in_either!(&mut state.session, one => one.stiffness_from_masses(coords, masses, limit, state.index_base))
            })
        }
    })
}
