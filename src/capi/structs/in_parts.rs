//! A mesh that ranks hold in parts, with its dimension hidden.

use super::view::{check_node_count, fmc_coords};
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::status::fmc_status::FMC_ERROR_UNSUPPORTED;
use crate::{CarriedSlip, GatheredCounts, PartitionedContact};

/// Elastic slip of a boundary facet, by the numbers of the whole mesh.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_carried_slip {
    /// Number of its cell in the whole mesh, counted from the option `index_base`.
    pub cell: i64,
    /// Face of that cell, as VTK counts them, from 0 whatever the base.
    pub face: i32,
    /// Which of the facets of that face, from 0.
    pub part: i32,
    /// Elastic slip; in 2D the last is 0.
    pub slip: [f64; 3],
}

/// A mesh in parts, with its dimension hidden.
pub(crate) trait InParts {
    /// Sets own coordinates; returns whether other cells were gathered.
    ///
    /// # Safety
    /// The host guarantees the view.
    unsafe fn set_coords(&mut self, coords: &fmc_coords, index_base: i32) -> Result<bool, Failure>;

    /// Tells the other ranks that the call failed here.
    fn fail_elsewhere(&self);

    fn counts(&self) -> GatheredCounts;
    fn coords(&self) -> &[f64];
    fn node_numbers(&self) -> &[u64];
    fn own_nodes(&self) -> &[Option<u32>];
    fn cell_numbers(&self) -> &[u64];
    fn carried_slip(&self, index_base: i32) -> Result<Vec<fmc_carried_slip>, Failure>;
    fn set_carried_slip(&mut self, carried: &[fmc_carried_slip], index_base: i32) -> Result<(), Failure>;
}

impl<const D: usize> InParts for PartitionedContact<D> {
    unsafe fn set_coords(&mut self, coords: &fmc_coords, index_base: i32) -> Result<bool, Failure> {
        let mut scratch = Vec::new();
        // SAFETY: passed on to the caller.
        let rows = check_node_count(coords.node_count, self.own_node_count())
            .and_then(|()| unsafe { coords.rows("coords", &mut scratch) })
            .inspect_err(|_| InParts::fail_elsewhere(self))?;
        // From here on ranks tell one another.
        PartitionedContact::set_coords(self, rows).map_err(Failure::counted_from(index_base))
    }

    fn fail_elsewhere(&self) {
        PartitionedContact::fail_elsewhere(self);
    }

    fn counts(&self) -> GatheredCounts {
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

    fn carried_slip(&self, index_base: i32) -> Result<Vec<fmc_carried_slip>, Failure> {
        let carried = self.slip()?.into_iter().map(|CarriedSlip { cell, face, part, slip }| fmc_carried_slip {
            cell: cell as i64 + i64::from(index_base),
            face: face as i32,
            part: part as i32,
            slip: std::array::from_fn(|axis| slip.get(axis).copied().unwrap_or(0.0)),
        });
        Ok(carried.collect())
    }

    fn set_carried_slip(&mut self, carried: &[fmc_carried_slip], index_base: i32) -> Result<(), Failure> {
        // What is negative names no facet, as what is too large.
        let carried = carried.iter().map(|of| CarriedSlip {
            cell: of.cell.wrapping_sub(index_base.into()) as u64,
            face: of.face as u32,
            part: of.part as u32,
            slip: std::array::from_fn(|axis| of.slip[axis]),
        });
        Ok(self.set_slip(&carried.collect::<Vec<_>>())?)
    }
}

/// What a context that was not made from a part of a mesh answers.
pub(crate) fn no_parts() -> Failure {
    Failure::new(FMC_ERROR_UNSUPPORTED, "the context was not made by fmc_context_new_from_part")
}
