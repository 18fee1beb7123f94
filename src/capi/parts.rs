//! A mesh that ranks hold in parts, brought to coordinates.

use super::boundary::entry;
use super::context::{fmc_context, write};
use super::failure::Failure;
use super::pointer::{Output, reference, slice};
use super::status::fmc_status;
use super::status::fmc_status::FMC_ERROR_UNSUPPORTED;
use super::view::{check_node_count, fmc_coords};
use crate::{CarriedSlip, PartitionCounts, PartitionedContact};

/// Elastic slip of a boundary facet, by the numbers of the whole mesh.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_carried_slip {
    /// Number of its cell in the whole mesh.
    pub cell: i64,
    /// Face of that cell, as VTK counts them, from 0.
    pub face: i32,
    /// Which of the facets of that face, from 0.
    pub part: i32,
    /// Elastic slip; in 2D the last is 0.
    pub slip: [f64; 3],
}

/// A mesh in parts, with its dimension hidden.
pub(super) trait InParts {
    /// Brings it to own coordinates; returns whether other cells were gathered.
    ///
    /// # Safety
    /// The host guarantees the view.
    unsafe fn bring(&mut self, coords: &fmc_coords, index_base: i32) -> Result<bool, Failure>;

    /// Tells the other ranks that the call failed here.
    fn fail_elsewhere(&self);

    fn counts(&self) -> PartitionCounts;
    fn coords(&self) -> &[f64];
    fn node_numbers(&self) -> &[u64];
    fn own_nodes(&self) -> &[Option<u32>];
    fn cell_numbers(&self) -> &[u64];
    fn carried_slip(&self) -> Result<Vec<fmc_carried_slip>, Failure>;
    fn set_carried_slip(&mut self, carried: &[fmc_carried_slip]) -> Result<(), Failure>;
}

impl<const D: usize> InParts for PartitionedContact<D> {
    unsafe fn bring(&mut self, coords: &fmc_coords, index_base: i32) -> Result<bool, Failure> {
        let mut scratch = Vec::new();
        // SAFETY: passed on to the caller.
        let rows = check_node_count(coords.node_count, self.own_node_count())
            .and_then(|()| unsafe { coords.rows("coords", &mut scratch) })
            .inspect_err(|_| InParts::fail_elsewhere(self))?;
        // From here on ranks tell one another.
        PartitionedContact::bring(self, rows).map_err(Failure::counted_from(index_base))
    }

    fn fail_elsewhere(&self) {
        PartitionedContact::fail_elsewhere(self);
    }

    fn counts(&self) -> PartitionCounts {
        PartitionedContact::counts(self)
    }

    fn coords(&self) -> &[f64] {
        PartitionedContact::coords(self).as_flattened()
    }

    fn node_numbers(&self) -> &[u64] {
        PartitionedContact::node_numbers(self)
    }

    fn own_nodes(&self) -> &[Option<u32>] {
        PartitionedContact::own_nodes(self)
    }

    fn cell_numbers(&self) -> &[u64] {
        PartitionedContact::cell_numbers(self)
    }

    fn carried_slip(&self) -> Result<Vec<fmc_carried_slip>, Failure> {
        let carried = self.slip()?.into_iter().map(|CarriedSlip { cell, face, part, slip }| fmc_carried_slip {
            cell: cell as i64,
            face: face as i32,
            part: part as i32,
            slip: std::array::from_fn(|axis| slip.get(axis).copied().unwrap_or(0.0)),
        });
        Ok(carried.collect())
    }

    fn set_carried_slip(&mut self, carried: &[fmc_carried_slip]) -> Result<(), Failure> {
        // What is negative names no facet, as what is too large.
        let carried = carried.iter().map(|of| CarriedSlip {
            cell: of.cell as u64,
            face: of.face as u32,
            part: of.part as u32,
            slip: std::array::from_fn(|axis| of.slip[axis]),
        });
        Ok(self.set_slip(&carried.collect::<Vec<_>>())?)
    }
}

/// What a context that was not made from a part of a mesh answers.
pub(super) fn no_parts() -> Failure {
    Failure::new(FMC_ERROR_UNSUPPORTED, "the context was not made by fmc_context_new_from_part")
}

/// Brings a mesh in parts to coordinates of its nodes: `coords` are those of this rank's own nodes, as many as were given to
/// `fmc_context_new_from_part`. Every rank calls it before it evaluates at these coordinates, after its options and obstacles
/// were set. Then the nodes, facets and cells of the context are those gathered: those that may be in contact, the same on all
/// ranks. `fmc_context_gathered_nodes` tells which and where they are.
///
/// `renumbered`, which may be NULL, becomes 1 where other cells were gathered than before, so that their numbers have changed,
/// else 0. Slip, kept patches and frozen friction are carried over; tangents, patterns and points of the last evaluation are not.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_LENGTH`, `FMC_ERROR_STRIDE`, `FMC_ERROR_UNSUPPORTED`; naming own nodes and cells
/// `FMC_ERROR_NON_FINITE_COORDINATE`, `FMC_ERROR_INVERTED_CELL`, `FMC_ERROR_ZERO_MEASURE`; `FMC_ERROR_RANKS_DIFFER` for a node in two
/// places, `FMC_ERROR_ON_OTHER_RANK`, `FMC_ERROR_COMMUNICATION`, `FMC_ERROR_BUSY`. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_bring(
    context: *mut fmc_context,
    coords: *const fmc_coords,
    renumbered: *mut i32,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context, a view and an output or NULL.
        unsafe {
            write(context, |state| {
                let index_base = state.index_base;
                let parts = state.session.parts_mut().ok_or_else(no_parts)?;
                let arguments = Output::optional("renumbered", renumbered)
                    .and_then(|output| Ok((output, reference("coords", coords)?)));
                let (output, coords) = arguments.inspect_err(|_| parts.fail_elsewhere())?;
                let has_changed = parts.bring(coords, index_base)?;
                if has_changed {
                    state.renumber();
                }
                output.write(i32::from(has_changed));
                Ok(())
            })
        }
    })
}

/// Sets the elastic slip that was carried into the step that has begun, of a mesh in parts: that of `count` facets, as
/// `fmc_context_carried_slip` writes them, zero for all others. All ranks give the same, after `fmc_context_begin_step`.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_NO_STEP`, `FMC_ERROR_NON_FINITE_SLIP`, `FMC_ERROR_UNSUPPORTED` for a facet that was not
/// gathered, `FMC_ERROR_BUSY`; the old slip then stays. Threads: one call at a time on a context.
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
                state.session.parts_mut().ok_or_else(no_parts)?.set_carried_slip(carried)
            })
        }
    })
}
