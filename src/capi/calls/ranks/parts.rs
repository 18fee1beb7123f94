//! A mesh that ranks hold in parts, at coordinates.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::pointer::{Output, reference, slice};
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, write};
use crate::capi::structs::in_parts::{fmc_carried_slip, no_parts};
use crate::capi::structs::view::fmc_coords;

/// Sets the coordinates of a mesh in parts: `coords` are the coordinates of this rank's own nodes, as many as were given to
/// `fmc_context_new_from_part`. Every rank calls it before it evaluates at these coordinates, after its options and obstacles
/// were set. The context then has the gathered nodes, facets and cells: all that may be in contact, the same on all ranks.
/// `fmc_context_gathered_nodes` returns their numbers and coordinates.
///
/// `renumbered`, which may be NULL, becomes 1 where other cells were gathered than before, so that their numbers have changed,
/// else 0. Slip, kept patches and frozen friction are transferred; tangents, patterns and points of the last evaluation are not.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_LENGTH`, `FMC_ERROR_STRIDE`, `FMC_ERROR_UNSUPPORTED`; naming own nodes and cells
/// `FMC_ERROR_NON_FINITE_COORDINATE`, `FMC_ERROR_INVERTED_CELL`, `FMC_ERROR_ZERO_MEASURE`; `FMC_ERROR_RANKS_DIFFER` for a node in two
/// places, `FMC_ERROR_ON_OTHER_RANK`, `FMC_ERROR_COMMUNICATION`, `FMC_ERROR_BUSY`. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_coords(
    context: *mut fmc_context,
    coords: *const fmc_coords,
    renumbered: *mut i32,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context, a view and an output or NULL.
        unsafe {
            write(context, |state| {
                let index_base = state.index_base;
                let parts = in_either!(&mut state.session, one => one.parts_mut()).ok_or_else(no_parts)?;
                let arguments = Output::optional("renumbered", renumbered)
                    .and_then(|output| Ok((output, reference("coords", coords)?)));
                let (output, coords) = arguments.inspect_err(|_| parts.fail_elsewhere())?;
                let has_changed = parts.set_coords(coords, index_base)?;
                if has_changed {
                    state.renumber();
                }
                output.write(i32::from(has_changed));
                Ok(())
            })
        }
    })
}

/// Sets the elastic slip carried into the current step, for a mesh in parts: `count` facets, as
/// `fmc_context_carried_slip` writes them; all other facets have zero slip. All ranks pass the same list, after
/// `fmc_context_begin_step`.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_NO_STEP`, `FMC_ERROR_NON_FINITE_SLIP`, `FMC_ERROR_UNSUPPORTED` for a facet that was not
/// gathered, `FMC_ERROR_BUSY`; the old slip is then kept. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_carried_slip(
    context: *mut fmc_context,
    carried: *const fmc_carried_slip,
    count: usize,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context and `count` structs.
        unsafe {
            write(context, |state| {
                let carried = slice("carried", carried, count, 1)?;
                let base = state.index_base;
                in_either!(&mut state.session, one => one.parts_mut())
                    .ok_or_else(no_parts)?
                    .set_carried_slip(carried, base)
            })
        }
    })
}
