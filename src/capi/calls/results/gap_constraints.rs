//! Weighted gaps as constraints: found first, and copied into the host's arrays then.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::pointer::{Output, check, copy_list, reference};
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::FMC_ERROR_BUFFER_TOO_SMALL;
use crate::capi::context::state::{fmc_context, read, write};
use crate::capi::structs::gap_constraint::fmc_gap_constraint;
use crate::capi::structs::view::fmc_coords;

/// Finds the weighted gaps at `coords` of all nodes that have a facet within `reach` of a partner, apart or overlapping,
/// and keeps them in the context until the next call: what an augmented Lagrangian, an interior point method or a
/// preconditioner asks for. They depend on no law and no estimator. `count` receives the number of rows, `entry_count`
/// that of the entries of their derivative; both may be NULL.
///
/// Both bodies of a pair have rows, ordered by pair, side and node; a host that wants one side only takes the rows of one
/// body. A body has no gaps over itself. With cells of second order rows are points, columns nodes. Errors: as `fmc_context_evaluate`, and `FMC_ERROR_NOT_POSITIVE` for `reach`; what
/// was kept then stays. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_find_gap_constraints(
    context: *mut fmc_context,
    coords: *const fmc_coords,
    reach: f64,
    count: *mut usize,
    entry_count: *mut usize,
) -> fmc_status {
    entry(|| {
        let rows = Output::optional("count", count)?;
        let entries = Output::optional("entry_count", entry_count)?;
        // SAFETY: the host passes a context and a view.
        let found = unsafe {
            write(context, |state| {
                state.gaps = state.session.gap_constraints(reference("coords", coords)?, reach, state.index_base)?;
                Ok((state.gaps.rows.len(), state.gaps.cols.len()))
            })
        }?;
        // SAFETY: the outputs, where given, may be written.
        unsafe {
            rows.write(found.0);
            entries.write(found.1);
        }
        Ok(())
    })
}

/// Writes the rows that were found to the host's array, with room for `capacity`.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_BUSY`. Threads: several at once on one
/// context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_gap_constraints(
    context: *const fmc_context,
    rows: *mut fmc_gap_constraint,
    capacity: usize,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context, and an array with room for `capacity` rows.
        unsafe {
            let state = read(context)?;
            room(&state.gaps.rows, capacity, "gap constraints")?;
            copy_list("rows", &state.gaps.rows, rows)
        }
    })
}

/// Writes the derivative of the gaps that were found, d gap / d x, in compressed rows: the entries of row r are those from
/// `row_offsets[r]` to `row_offsets[r + 1]`, in ascending order of their columns, which are degrees of freedom,
/// `node * dim + axis`, counted from 0 as in the tangent. Their set is what feels the contact. Pressures p on the rows
/// act with the nodal forces sum over r of p_r times row r.
///
/// `row_offsets` has room for one number more than there are rows, `cols` and `values` for `capacity` entries.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_BUSY`. Threads: several at once on one
/// context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_gap_gradient(
    context: *const fmc_context,
    row_offsets: *mut i64,
    cols: *mut i64,
    values: *mut f64,
    capacity: usize,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context, and arrays of the sizes that it was told.
        unsafe {
            let state = read(context)?;
            room(&state.gaps.cols, capacity, "entries")?;
            for (name, output) in [("row_offsets", row_offsets), ("cols", cols)] {
                check(name, output.cast_const())?;
            }
            check("values", values.cast_const())?;
            copy_list("row_offsets", &state.gaps.row_offsets, row_offsets)?;
            copy_list("cols", &state.gaps.cols, cols)?;
            copy_list("values", &state.gaps.values, values)
        }
    })
}

fn room<T>(list: &[T], capacity: usize, what: &str) -> Result<(), Failure> {
    if capacity < list.len() {
        let text = format!("there is room for {capacity} {what}, and there are {}", list.len());
        return Err(Failure::new(FMC_ERROR_BUFFER_TOO_SMALL, text));
    }
    Ok(())
}
