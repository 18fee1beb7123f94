//! Displacements of any basis: a host's own unknowns in place of nodes.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::pointer::slice;
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::{FMC_ERROR_INDEX_OUT_OF_RANGE, FMC_ERROR_LENGTH};
use crate::capi::context::state::{fmc_context, write};
use crate::{Basis, Error};

/// Has the nodes of the mesh moved by unknowns of the host: control points of splines, coefficients of hierarchical shape
/// functions, nodes of another mesh. Node n lies at the sum of weights[k] times the coordinates of unknown unknowns[k], for k
/// from `row_offsets[n]` to `row_offsets[n + 1]`, which count from 0 and are one number more than the nodes of the mesh.
/// `unknowns` and `weights` have `entry_count` entries; unknowns are counted from the option `index_base`.
///
/// From then on every `fmc_coords` and `fmc_forces` has `unknown_count` rows, tangents and the columns of gap gradients are
/// those of unknowns, and so are masses and the columns of `fmc_context_point_weights`. The mesh and its coordinates without
/// deformation stay, and so do the nodes of `fmc_context_nodal_contact` and `fmc_context_set_symmetry_nodes`. A pattern that
/// is kept (`fmc_context_keep_pattern`) is released.
/// `row_offsets` NULL: nodes move by themselves again.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_LENGTH` for offsets that descend or do not end at `entry_count`,
/// `FMC_ERROR_INDEX_OUT_OF_RANGE` for an unknown that does not exist, `FMC_ERROR_OVERFLOW` for a weight that is not finite;
/// nothing changes then. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_basis(
    context: *mut fmc_context,
    unknown_count: usize,
    row_offsets: *const i64,
    unknowns: *const i64,
    weights: *const f64,
    entry_count: usize,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context, and arrays of the sizes that it says.
        unsafe {
            write(context, |state| {
                if row_offsets.is_null() {
                    state.session.set_basis(None)?;
                    state.pattern = None;
                    return Ok(());
                }
                let node_count = state.session.counts().nodes;
                let offsets = slice("row_offsets", row_offsets, node_count + 1, 1)?;
                let row_starts = starts(offsets, entry_count)?;
                let unknowns = slice("unknowns", unknowns, entry_count, 1)?;
                let weights = slice("weights", weights, entry_count, 1)?;
                let unknowns = zero_based(unknowns, unknown_count, &row_starts, state.index_base)?;
                state.session.set_basis(Some(&Basis {
                    unknown_count,
                    row_starts: &row_starts,
                    unknowns: &unknowns,
                    weights,
                }))?;
                state.pattern = None;
                Ok(())
            })
        }
    })
}

fn starts(offsets: &[i64], entry_count: usize) -> Result<Vec<usize>, Failure> {
    let is_right = offsets.first() == Some(&0)
        && offsets.is_sorted()
        && offsets.last().is_some_and(|&last| usize::try_from(last) == Ok(entry_count));
    if !is_right {
        let text = format!("the row offsets of the basis do not ascend from 0 to {entry_count}");
        return Err(Failure::new(FMC_ERROR_LENGTH, text));
    }
    Ok(offsets.iter().map(|&offset| offset as usize).collect())
}

fn zero_based(unknowns: &[i64], count: usize, starts: &[usize], index_base: i32) -> Result<Vec<u32>, Failure> {
    let convert = |(entry, &unknown): (usize, &i64)| {
        let zero_based = unknown.checked_sub(index_base.into()).and_then(|unknown| u32::try_from(unknown).ok());
        zero_based.filter(|&unknown| (unknown as usize) < count).ok_or_else(|| {
            let row = starts.partition_point(|&start| start <= entry) - 1 + usize::try_from(index_base).unwrap_or(0);
            Failure::new(FMC_ERROR_INDEX_OUT_OF_RANGE, Error::UnknownOutOfRange { row, unknown, count }.to_string())
        })
    };
    unknowns.iter().enumerate().map(convert).collect()
}
