//! How a context begins and ends.

use crate::capi::boundary::dimension::checked_dimension;
use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::pointer::{Output, reference, slice};
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::resident::Resident;
use crate::capi::context::session::Session;
use crate::capi::context::state::{State, fmc_context};
use crate::capi::structs::mesh::{Block, fmc_cell_block, fmc_cell_block_i64, surface_of_cells, surface_of_facets};
use crate::capi::structs::options::fmc_options;
use crate::capi::structs::view::fmc_coords;

/// Makes a context once its mesh is a surface.
///
/// # Safety
/// The host guarantees the options, and that `context` may be written.
pub(crate) unsafe fn create(
    options: *const fmc_options,
    context: *mut *mut fmc_context,
    session: impl FnOnce(&fmc_options) -> Result<Box<dyn Session>, Failure>,
) -> fmc_status {
    entry(|| {
        let output = Output::required("context", context)?;
        // SAFETY: passed on to the caller.
        let options = unsafe { reference("options", options) }?;
        options.checked_index_base()?;
        let state = State::new(session(options)?, options);
        let made = Box::into_raw(Box::new(fmc_context::new(state)));
        // SAFETY: passed on to the caller.
        unsafe { output.write(made) };
        Ok(())
    })
}

/// The session of a mesh of cells.
///
/// # Safety
/// The host guarantees the coordinates, the blocks and what they point to, and one body id per cell if any.
pub(crate) unsafe fn session_of_cells<B: Block, const D: usize>(
    coords: &fmc_coords,
    blocks: &[B],
    body_ids: *const B::Id,
    options: &fmc_options,
) -> Result<Box<dyn Session>, Failure> {
    let (checked, mut scratch) = (options.to_options()?, Vec::new());
    // SAFETY: passed on to the caller.
    let surface = unsafe {
        let rows = coords.rows::<D>("coords", &mut scratch)?;
        surface_of_cells(rows, blocks, body_ids, options.index_base)?
    };
    Ok(Box::new(Resident::new(surface, checked)?))
}

/// The session of a mesh of facets.
///
/// # Safety
/// The host guarantees the coordinates, the facets, and one body id per facet if any.
unsafe fn session_of_facets<Id: Copy + Into<i64>, const D: usize>(
    coords: &fmc_coords,
    facets: *const Id,
    facet_count: usize,
    body_ids: *const Id,
    options: &fmc_options,
) -> Result<Box<dyn Session>, Failure> {
    let (checked, mut scratch) = (options.to_options()?, Vec::new());
    // SAFETY: passed on to the caller.
    let surface = unsafe {
        let rows = coords.rows::<D>("coords", &mut scratch)?;
        surface_of_facets(rows, facets, facet_count, body_ids, options.index_base)?
    };
    Ok(Box::new(Resident::new(surface, checked)?))
}

/// Makes a context from the cells of a mesh, in one block for each type; the boundary facets are found from them.
///
/// `dim` is 2 or 3. `coords` are the coordinates of all nodes of the host, used or not: forces are returned for all of
/// them. Cells may be numbered in either orientation. `body_ids`, one for every cell counted over the blocks, say which
/// body a cell belongs to; NULL: bodies are the connected components by faces. Everything is read during the call and
/// not kept (topology is copied). `options`, with `stiffness` set, must have been initialised.
///
/// `context` receives the new context, to be freed by `fmc_context_free`.
///
/// Errors, all with the offending indices in `fmc_last_error`: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_LENGTH`,
/// `FMC_ERROR_STRIDE`, `FMC_ERROR_DIMENSION`, `FMC_ERROR_UNKNOWN_CELL_TYPE`, `FMC_ERROR_NODE_OUT_OF_RANGE`,
/// `FMC_ERROR_NON_FINITE_COORDINATE`, `FMC_ERROR_REPEATED_NODE`, `FMC_ERROR_INVERTED_CELL`, `FMC_ERROR_ZERO_MEASURE`,
/// `FMC_ERROR_NON_MANIFOLD`, `FMC_ERROR_EMPTY`, `FMC_ERROR_NOT_POSITIVE`, `FMC_ERROR_BAD_VALUE`, `FMC_ERROR_OPTIONS_CONFLICT`,
/// `FMC_ERROR_RESERVED_FIELD`,
/// `FMC_ERROR_STRUCT_SIZE`, `FMC_ERROR_THREADS`. Threads: any, also at once.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_new_from_cells(
    dim: i32,
    coords: *const fmc_coords,
    blocks: *const fmc_cell_block,
    block_count: usize,
    body_ids: *const i32,
    options: *const fmc_options,
    context: *mut *mut fmc_context,
) -> fmc_status {
    // SAFETY: the host passes what the parameters say.
    unsafe { new_from_cells(dim, coords, blocks, block_count, body_ids, options, context) }
}

/// `fmc_context_new_from_cells` with 64-bit node numbers and body ids.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_new_from_cells_i64(
    dim: i32,
    coords: *const fmc_coords,
    blocks: *const fmc_cell_block_i64,
    block_count: usize,
    body_ids: *const i64,
    options: *const fmc_options,
    context: *mut *mut fmc_context,
) -> fmc_status {
    // SAFETY: the host passes what the parameters say.
    unsafe { new_from_cells(dim, coords, blocks, block_count, body_ids, options, context) }
}

/// # Safety
/// As `fmc_context_new_from_cells`.
unsafe fn new_from_cells<B: Block>(
    dim: i32,
    coords: *const fmc_coords,
    blocks: *const B,
    block_count: usize,
    body_ids: *const B::Id,
    options: *const fmc_options,
    context: *mut *mut fmc_context,
) -> fmc_status {
    // SAFETY: passed on to the caller.
    unsafe {
        create(options, context, |options| {
            let dim = checked_dimension(dim)?;
            let (coords, blocks) = (reference("coords", coords)?, slice("blocks", blocks, block_count, 1)?);
            match dim {
                2 => session_of_cells::<B, 2>(coords, blocks, body_ids, options),
                _ => session_of_cells::<B, 3>(coords, blocks, body_ids, options),
            }
        })
    }
}

/// Makes a context from a surface: the boundary facets of closed bodies, edges in 2D and triangles in 3D.
///
/// `facets`, (facet_count, dim), are node numbers counted from the option `index_base`: in 2D the body lies left of an
/// edge, in 3D a triangle runs counter-clockwise seen from outside. `body_ids`, one for every facet, may be NULL:
/// bodies are the connected components by nodes. Otherwise as `fmc_context_new_from_cells`; also
/// `FMC_ERROR_OPEN_SURFACE`, `FMC_ERROR_INCONSISTENT_ORIENTATION`, `FMC_ERROR_INVERTED_SURFACE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_new_from_facets(
    dim: i32,
    coords: *const fmc_coords,
    facets: *const i32,
    facet_count: usize,
    body_ids: *const i32,
    options: *const fmc_options,
    context: *mut *mut fmc_context,
) -> fmc_status {
    // SAFETY: the host passes what the parameters say.
    unsafe { new_from_facets(dim, coords, facets, facet_count, body_ids, options, context) }
}

/// `fmc_context_new_from_facets` with 64-bit node numbers and body ids.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_new_from_facets_i64(
    dim: i32,
    coords: *const fmc_coords,
    facets: *const i64,
    facet_count: usize,
    body_ids: *const i64,
    options: *const fmc_options,
    context: *mut *mut fmc_context,
) -> fmc_status {
    // SAFETY: the host passes what the parameters say.
    unsafe { new_from_facets(dim, coords, facets, facet_count, body_ids, options, context) }
}

/// # Safety
/// As `fmc_context_new_from_facets`.
unsafe fn new_from_facets<Id: Copy + Into<i64>>(
    dim: i32,
    coords: *const fmc_coords,
    facets: *const Id,
    facet_count: usize,
    body_ids: *const Id,
    options: *const fmc_options,
    context: *mut *mut fmc_context,
) -> fmc_status {
    // SAFETY: passed on to the caller.
    unsafe {
        create(options, context, |options| {
            let dim = checked_dimension(dim)?;
            let coords = reference("coords", coords)?;
            match dim {
                2 => session_of_facets::<Id, 2>(coords, facets, facet_count, body_ids, options),
                _ => session_of_facets::<Id, 3>(coords, facets, facet_count, body_ids, options),
            }
        })
    }
}

/// Frees a context and sets the host's pointer to NULL. Does nothing for a NULL pointer, or a pointer to NULL.
///
/// Errors: none. Threads: no other call on the context may be running or follow.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_free(context: *mut *mut fmc_context) -> fmc_status {
    entry(|| {
        if context.is_null() {
            return Ok(());
        }
        // SAFETY: the host passes its pointer to a context that came from `create`, or to NULL; it is taken out, so
        // that a second call finds NULL.
        let taken = unsafe { context.replace(std::ptr::null_mut()) };
        if !taken.is_null() {
            // SAFETY: made by `Box::into_raw` in `create`, and not freed yet, or the pointer would have been NULL.
            drop(unsafe { Box::from_raw(taken) });
        }
        Ok(())
    })
}
