//! How a context begins.

use crate::capi::boundary::dimension::checked_dimension;
use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::index::IndexSize;
use crate::capi::boundary::pointer::{Output, reference, slice};
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::resident::Resident;
use crate::capi::context::session::Session;
use crate::capi::context::state::{State, fmc_context};
use crate::capi::structs::mesh::{fmc_cell_block, index_size, surface_of_cells};
use crate::capi::structs::options::fmc_options;
use crate::capi::structs::view::fmc_coords;
use std::ffi::c_void;

/// Makes a context once its mesh is a surface.
///
/// # Safety
/// The host guarantees the options, and that `context` may be written.
pub(crate) unsafe fn create(
    options: *const fmc_options,
    context: *mut *mut fmc_context,
    session: impl FnOnce(&fmc_options) -> Result<(Session, IndexSize), Failure>,
) -> fmc_status {
    entry(|| {
        let output = Output::required("context", context)?;
        // SAFETY: passed on to the caller.
        let options = unsafe { reference("options", options) }?;
        options.checked_index_base()?;
        let (session, index_size) = session(options)?;
        let state = State::new(session, index_size, options);
        let made = Box::into_raw(Box::new(fmc_context::new(state)));
        // SAFETY: passed on to the caller.
        unsafe { output.write(made) };
        Ok(())
    })
}

/// The session of a mesh of cells, and the width of its numbers.
///
/// # Safety
/// The host guarantees the coordinates, the blocks and what they point to, and one body id per cell if any.
pub(crate) unsafe fn session_of_cells<const D: usize>(
    coords: &fmc_coords,
    blocks: &[fmc_cell_block],
    body_ids: *const c_void,
    options: &fmc_options,
) -> Result<(Session, IndexSize), Failure>
where
    Session: From<Resident<D>>,
{
    let (checked, size, mut scratch) = (options.to_options()?, index_size(blocks)?, Vec::new());
    // SAFETY: passed on to the caller.
    let surface = unsafe {
        let rows = coords.rows::<D>("coords", &mut scratch)?;
        surface_of_cells(rows, blocks, size, body_ids, options)?
    };
    Ok((Resident::new(surface, checked)?.into(), size))
}

/// Makes a context from the cells of a mesh, in one block for each type; the boundary facets are found from them.
///
/// `dim` is 2 or 3. `coords` are the coordinates of all nodes of the host, used or not: forces are returned for all of them. Cells may
/// be numbered in either orientation. `body_ids`, one for every cell counted over the blocks, of the same width as node numbers, say
/// which body a cell belongs to; NULL: bodies are the connected components by faces. Everything is read during the call and not kept
/// (topology is copied). `options`, with `stiffness` set, must have been initialised.
///
/// `context` receives the new context, to be freed by `fmc_context_free`.
///
/// Errors, all with the offending indices in `fmc_last_error`: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_LENGTH`,
/// `FMC_ERROR_STRIDE`, `FMC_ERROR_DIMENSION`, `FMC_ERROR_UNKNOWN_CELL_TYPE`, `FMC_ERROR_INDEX_SIZE`, `FMC_ERROR_NODE_OUT_OF_RANGE`,
/// `FMC_ERROR_NON_FINITE_COORDINATE`, `FMC_ERROR_REPEATED_NODE`, `FMC_ERROR_INVERTED_CELL`, `FMC_ERROR_ZERO_MEASURE`,
/// `FMC_ERROR_NON_MANIFOLD`, `FMC_ERROR_EMPTY`, `FMC_ERROR_NOT_POSITIVE`, `FMC_ERROR_BAD_VALUE`, `FMC_ERROR_OPTIONS_CONFLICT`,
/// `FMC_ERROR_RESERVED_FIELD`, `FMC_ERROR_STRUCT_SIZE`, `FMC_ERROR_THREADS`. Threads: any, also at once.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_new_from_cells(
    dim: i32,
    coords: *const fmc_coords,
    blocks: *const fmc_cell_block,
    block_count: usize,
    body_ids: *const c_void,
    options: *const fmc_options,
    context: *mut *mut fmc_context,
) -> fmc_status {
    // SAFETY: the host passes what the parameters say.
    unsafe {
        create(options, context, |options| {
            let dim = checked_dimension(dim)?;
            let (coords, blocks) = (reference("coords", coords)?, slice("blocks", blocks, block_count, 1)?);
            match dim {
                2 => session_of_cells::<2>(coords, blocks, body_ids, options),
                _ => session_of_cells::<3>(coords, blocks, body_ids, options),
            }
        })
    }
}
