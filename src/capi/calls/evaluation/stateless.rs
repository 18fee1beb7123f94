//! Forces in one call.

use crate::capi::boundary::dimension::checked_dimension;
use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::pointer::{Output, check, reference};
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::FMC_ERROR_NO_STEP;
use crate::capi::calls::mesh::creation::session_of_cells;
use crate::capi::structs::mesh::{Block, fmc_cell_block, fmc_cell_block_i64};
use crate::capi::structs::options::fmc_options;
use crate::capi::structs::view::{fmc_coords, fmc_forces};

/// Contact forces between the bodies of a mesh of one cell type, in one call.
///
/// `dim` is 2 or 3; `coords`, (node_count, dim), are the coordinates of all nodes; `cell_type` is a value of
/// `fmc_cell_type`; `conn`, (cell_count, nodes per cell), are node numbers counted from the option `index_base`;
/// `body_ids`, (cell_count), may be NULL: bodies are the connected components by faces. `options` must have been
/// initialised and have `stiffness` set.
///
/// `forces`, (node_count, dim), receives the force on every node, which pushes bodies apart; `volume`, which may be
/// NULL, the overlap volume (2D: area), summed over the pairs. Both are written only on success. The result is that of
/// a context, bit for bit; a context finds the boundary facets once for many evaluations, accepts mixed meshes, strides
/// and obstacles, and reports forces per body, pairs and warnings.
///
/// Errors: those of `fmc_context_new_from_cells` and `fmc_context_evaluate`; with friction `FMC_ERROR_NO_STEP`, as that takes
/// `fmc_contact_force_step`; the text, with the offending indices, is given by `fmc_last_error`. Threads: any, also at once.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_contact_force(
    dim: i32,
    coords: *const f64,
    node_count: usize,
    cell_type: i32,
    conn: *const i32,
    cell_count: usize,
    body_ids: *const i32,
    options: *const fmc_options,
    forces: *mut f64,
    volume: *mut f64,
) -> fmc_status {
    let block = fmc_cell_block { cell_type, conn, cell_count };
    // SAFETY: the host passes what the parameters say.
    unsafe { contact_force(dim, coords, node_count, block, body_ids, options, forces, volume) }
}

/// `fmc_contact_force` with 64-bit node numbers and body ids.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_contact_force_i64(
    dim: i32,
    coords: *const f64,
    node_count: usize,
    cell_type: i32,
    conn: *const i64,
    cell_count: usize,
    body_ids: *const i64,
    options: *const fmc_options,
    forces: *mut f64,
    volume: *mut f64,
) -> fmc_status {
    let block = fmc_cell_block_i64 { cell_type, conn, cell_count };
    // SAFETY: the host passes what the parameters say.
    unsafe { contact_force(dim, coords, node_count, block, body_ids, options, forces, volume) }
}

/// # Safety
/// As `fmc_contact_force`.
#[allow(clippy::too_many_arguments)]
unsafe fn contact_force<B: Block>(
    dim: i32,
    coords: *const f64,
    node_count: usize,
    block: B,
    body_ids: *const B::Id,
    options: *const fmc_options,
    forces: *mut f64,
    volume: *mut f64,
) -> fmc_status {
    let evaluate = || -> Result<(), Failure> {
        let dim = checked_dimension(dim)?;
        let output = Output::optional("volume", volume)?;
        if node_count > 0 {
            check("forces", forces)?;
        }
        let coords = fmc_coords { data: coords, node_count, node_stride: 0, axis_stride: 0 };
        let forces = fmc_forces { data: forces, node_count, node_stride: 0, axis_stride: 0 };
        // SAFETY: passed on to the caller.
        unsafe {
            let options = reference("options", options)?;
            let mut session = match dim {
                2 => session_of_cells::<B, 2>(&coords, &[block], body_ids, options),
                _ => session_of_cells::<B, 3>(&coords, &[block], body_ids, options),
            }?;
            let evaluation =
                session.evaluate(&coords, Some(&forces), false, options.index_base).map_err(for_one_call)?;
            output.write(evaluation.result.volume);
        }
        Ok(())
    };
    entry(evaluate)
}

/// Whoever has no context cannot begin a step of it.
fn for_one_call(failure: Failure) -> Failure {
    match failure.status {
        FMC_ERROR_NO_STEP => {
            let text =
                "friction needs the coordinates at which the step began: call fmc_contact_force_step, which takes them";
            Failure::new(FMC_ERROR_NO_STEP, text)
        }
        _ => failure,
    }
}
