//! The points of which a context tells, as combinations of the host's nodes.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::pointer::{Output, check};
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::FMC_ERROR_BUFFER_TOO_SMALL;
use crate::capi::context::state::{fmc_context, read};

/// Sizes of the matrix of `fmc_context_point_weights`: rows, which are points, at least as many as there are nodes, and
/// entries. Either output may be NULL. They change with a basis only.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUSY`. Threads: several at once on one context, as long as no call
/// changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_point_weights_size(
    context: *const fmc_context,
    point_count: *mut usize,
    entry_count: *mut usize,
) -> fmc_status {
    entry(|| {
        let points = Output::optional("point_count", point_count)?;
        let entries = Output::optional("entry_count", entry_count)?;
        // SAFETY: the host passes a context.
        let weights = unsafe { read(context) }?.session.point_weights();
        // SAFETY: the outputs, where given, may be written.
        unsafe {
            points.write(weights.point_count());
            entries.write(weights.nodes.len());
        }
        Ok(())
    })
}

/// The matrix P that takes nodes to points, X = P x, in compressed rows: the entries of point p are those from `row_offsets[p]`
/// to `row_offsets[p + 1]`, counted from 0, `nodes`, counted from the option `index_base`, with their `weights`.
///
/// Cells of second order are divided into straight ones, whose points are fixed linear combinations of the nodes.
/// `fmc_boundary_facet`, `fmc_contact_side` and `fmc_gap_constraint` tell of points: their numbers, less the option
/// `index_base`, are rows. What is known at nodes is brought to points by P, forces and other derivatives from points to nodes by
/// its transpose. A point that is a node, or stands for one in the middle of an edge, face or cell, has the node's
/// number; middles of faces without a node come after the nodes. The weights of a row add up to 1, and some are
/// negative. Without cells of second order, and nodes that hang, P is the identity. With a basis (`fmc_context_set_basis`) its
/// columns are unknowns, and rows add up to what those of the basis do.
///
/// `row_offsets` has room for one number more than `point_capacity`, `nodes` and `weights` for `capacity` entries;
/// `fmc_context_point_weights_size` has both sizes.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_BUSY`; nothing is written then. Threads:
/// several at once on one context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_point_weights(
    context: *const fmc_context,
    row_offsets: *mut i64,
    point_capacity: usize,
    nodes: *mut i64,
    weights: *mut f64,
    capacity: usize,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context.
        let state = unsafe { read(context) }?;
        let found = state.session.point_weights();
        for (what, room, count) in
            [("points", point_capacity, found.point_count()), ("entries", capacity, found.nodes.len())]
        {
            if room < count {
                let text = format!("there is room for {room} {what}, and there are {count}");
                return Err(Failure::new(FMC_ERROR_BUFFER_TOO_SMALL, text));
            }
        }
        check("row_offsets", row_offsets.cast_const())?;
        if !found.nodes.is_empty() {
            check("nodes", nodes.cast_const())?;
            check("weights", weights.cast_const())?;
        }
        // SAFETY: the host guarantees one place more than `point_capacity`, and `capacity` entries, of which there are no
        // more than that.
        unsafe {
            for (point, &start) in found.starts.iter().enumerate() {
                row_offsets.add(point).write(start as i64);
            }
            for (place, (&node, &weight)) in found.nodes.iter().zip(&found.weights).enumerate() {
                nodes.add(place).write(i64::from(node) + i64::from(state.index_base));
                weights.add(place).write(weight);
            }
        }
        Ok(())
    })
}
