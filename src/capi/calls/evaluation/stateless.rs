//! Forces in one call.

use crate::capi::boundary::dimension::checked_dimension;
use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::pointer::{Output, check, optional, reference, slice};
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::FMC_ERROR_NO_STEP;
use crate::capi::calls::evaluation::friction_step::{fmc_friction_step, in_step};
use crate::capi::calls::mesh::creation::session_of_cells;
use crate::capi::context::session::in_either;
use crate::capi::structs::mesh::fmc_cell_block;
use crate::capi::structs::options::fmc_options;
use crate::capi::structs::view::{fmc_coords, fmc_forces};
use std::ffi::c_void;

/// Contact forces between the bodies of a mesh, in one call.
///
/// `dim` is 2 or 3; `coords`, (node_count, dim), are the coordinates of all nodes; `blocks` are the cells, in one block for each
/// type. `body_ids`, one for every cell counted over the blocks, may be NULL: bodies are the connected components by faces. `options`
/// must have been initialised and have `stiffness` set. `step` may be NULL; with friction it gives the start of the step that ends at
/// `coords`, and receives the elastic slip for the next step.
///
/// `forces`, (node_count, dim), receives the force on every node, which pushes bodies apart; `volume`, which may be NULL, the
/// overlap volume (2D: area), summed over the pairs. All are written only on success. The result is bit-for-bit identical to a
/// context. With a step this is a context made at `step->reference`, followed by `fmc_context_begin_step`, `fmc_context_set_slip`,
/// `fmc_context_evaluate` and `fmc_context_commit_step`. A context finds the boundary facets once for many evaluations, accepts
/// strides and obstacles, and reports forces per body, pairs and warnings.
///
/// Errors: as `fmc_context_new_from_cells`, `fmc_context_evaluate`, and with a step the calls above; with friction and without a step
/// `FMC_ERROR_NO_STEP`. `fmc_last_error` returns the text, with the offending indices. Threads: any, also at once.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_contact_force(
    dim: i32,
    coords: *const f64,
    node_count: usize,
    blocks: *const fmc_cell_block,
    block_count: usize,
    body_ids: *const c_void,
    options: *const fmc_options,
    step: *const fmc_friction_step,
    forces: *mut f64,
    volume: *mut f64,
) -> fmc_status {
    entry(|| {
        let dim = checked_dimension(dim)?;
        let output = Output::optional("volume", volume)?;
        if node_count > 0 {
            check("forces", forces)?;
        }
        let coords = fmc_coords { data: coords, node_count, node_stride: 0, axis_stride: 0 };
        let forces = fmc_forces { data: forces, node_count, node_stride: 0, axis_stride: 0 };
        // SAFETY: the host passes structs, and arrays as long as they are said to be.
        unsafe {
            let (options, step) = (reference("options", options)?, optional("step", step)?);
            step.map_or(Ok(()), fmc_friction_step::check)?;
            let blocks = slice("blocks", blocks, block_count, 1)?;
            let at_rest = step.map_or(coords, |step| step.at_rest(node_count));
            let (mut session, _) = match dim {
                2 => session_of_cells::<2>(&at_rest, blocks, body_ids, options),
                _ => session_of_cells::<3>(&at_rest, blocks, body_ids, options),
            }?;
            let base = options.index_base;
            let found = match step {
                Some(step) => in_step(step, &mut session, &coords, &forces, base)?,
                None => in_either!(&mut session, one => one.evaluate(&coords, Some(&forces), false, base))
                    .map_err(for_one_call)?,
            };
            output.write(found.result.volume);
        }
        Ok(())
    })
}

/// Whoever has no context cannot begin a step of it.
fn for_one_call(failure: Failure) -> Failure {
    match failure.status {
        FMC_ERROR_NO_STEP => {
            let text = "friction needs the coordinates at which the step began: give fmc_contact_force a step";
            Failure::new(FMC_ERROR_NO_STEP, text)
        }
        _ => failure,
    }
}
