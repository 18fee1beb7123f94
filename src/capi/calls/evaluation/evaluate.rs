//! Forces at coordinates.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::pointer::{optional, reference};
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::FMC_ERROR_UNKNOWN_FLAG;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{evaluated, fmc_context};
use crate::capi::structs::evaluation::fmc_result;
use crate::capi::structs::view::{fmc_coords, fmc_forces};

/// Flag of `fmc_context_evaluate` and `fmc_context_evaluate_tangent`: add the forces to the host's array instead of
/// overwriting it.
pub const FMC_EVALUATE_ADD: u32 = 1;

/// Contact forces at `coords`, the current coordinates of all nodes of the mesh.
///
/// `forces`, which may be NULL, receives the nodal forces in the order of the nodes: the negative derivative of the
/// contact energy, which pushes bodies apart. They overwrite the array, or are added to it with the flag `FMC_EVALUATE_ADD`.
/// Nodes that are not in contact get 0. `result`, which may be NULL too, receives the overlap volume and the other
/// totals; forces per body, pairs and warnings are kept in the context until the next evaluation that succeeds.
///
/// Both are written only on success. The arrays may overlap one another. Units as in `fmc_result`.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_LENGTH`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_STRIDE`,
/// `FMC_ERROR_NON_FINITE_COORDINATE`, `FMC_ERROR_INVERTED_CELL`, `FMC_ERROR_ZERO_MEASURE`, `FMC_ERROR_UNSUPPORTED`,
/// `FMC_ERROR_SIGNED_DISTANCE`, `FMC_ERROR_UNFINISHED_LINES`, `FMC_ERROR_TOO_MANY_FIBERS`, `FMC_ERROR_TOO_MANY_PIECES`,
/// `FMC_ERROR_UNKNOWN_FLAG`, `FMC_ERROR_OVERFLOW`, `FMC_ERROR_BUSY`. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_evaluate(
    context: *mut fmc_context,
    coords: *const fmc_coords,
    forces: *const fmc_forces,
    flags: u32,
    result: *mut fmc_result,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context, both views and an output, or NULL where it may.
        unsafe {
            evaluated(context, result, |state| {
                if flags & !FMC_EVALUATE_ADD != 0 {
                    return Err(Failure::new(FMC_ERROR_UNKNOWN_FLAG, format!("unknown flag in {flags:#x}")));
                }
                let (coords, forces) = (reference("coords", coords)?, optional("forces", forces)?);
                in_either!(&mut state.session, one => one.evaluate(coords, forces, flags & FMC_EVALUATE_ADD != 0, state.index_base))
            })
        }
    })
}
