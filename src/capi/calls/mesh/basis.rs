//! Displacements of any basis: a host's own unknowns in place of nodes.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::pointer::optional;
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, write};
use crate::capi::structs::csr::fmc_csr;
use crate::{Basis, Error};

/// Lets unknowns of the host move the nodes of the mesh: control points of splines, coefficients of hierarchical shape functions,
/// nodes of another mesh. `weights` has a row for every node of the mesh, and a column for every unknown: node n lies at the sum of
/// value times coordinates of the unknown, over the entries of its row. Rows and columns count from the `index_base` of `weights`,
/// whatever the context's.
///
/// From then on every `fmc_coords` and `fmc_forces` has `unknown_count` rows. Tangents, masses, and the columns of gap
/// gradients and of `fmc_context_point_weights` refer to unknowns. The mesh and its coordinates without deformation stay,
/// and so do the nodes of `fmc_context_nodal_contact` and `fmc_context_set_symmetry_nodes`. A kept pattern
/// (`fmc_context_keep_pattern`) is released. `weights` NULL: the unknowns are again the positions of the nodes.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_STRUCT_SIZE`, `FMC_ERROR_RESERVED_FIELD`, `FMC_ERROR_INDEX_SIZE`,
/// `FMC_ERROR_LENGTH` for another number of rows and for offsets that descend, `FMC_ERROR_INDEX_OUT_OF_RANGE` for an unknown that
/// does not exist, `FMC_ERROR_OVERFLOW` for a weight that is not finite. The basis is then unchanged. Threads: one call at a time
/// on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_basis(
    context: *mut fmc_context,
    weights: *const fmc_csr,
    unknown_count: usize,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context, and a matrix or NULL.
        unsafe {
            write(context, |state| {
                let Some(weights) = optional("weights", weights)? else {
                    in_either!(&mut state.session, one => one.set_basis(None))?;
                    state.pattern = None;
                    return Ok(());
                };
                let rows = weights.read(in_either!(&state.session, one => one.counts()).nodes)?;
                let row_starts: Vec<usize> = rows.offsets.iter().map(|&offset| offset as usize).collect();
                let unknowns = unknowns(&rows.cols, unknown_count, &row_starts, weights.index_base)?;
                let basis = Basis { unknown_count, row_starts: &row_starts, unknowns: &unknowns, weights: rows.values };
                in_either!(&mut state.session, one => one.set_basis(Some(&basis)))?;
                state.pattern = None;
                Ok(())
            })
        }
    })
}

/// Columns as the core has them; one that is out of range is named as the host counts.
fn unknowns(cols: &[i64], count: usize, starts: &[usize], base: i32) -> Result<Vec<u32>, Failure> {
    let convert = |(entry, &unknown): (usize, &i64)| {
        u32::try_from(unknown).ok().filter(|&unknown| (unknown as usize) < count).ok_or_else(|| {
            let row = starts.partition_point(|&start| start <= entry) - 1;
            let unknown = unknown.saturating_add(base.into());
            Failure::counted_from(base)(Error::UnknownOutOfRange { row, unknown, count })
        })
    };
    cols.iter().enumerate().map(convert).collect()
}
