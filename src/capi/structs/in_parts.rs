//! A mesh that ranks hold in parts, with its dimension hidden.

use super::evaluation::side_of;
use super::partner::partner;
use super::view::{check_node_count, fmc_coords};
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::status::fmc_status::FMC_ERROR_UNSUPPORTED;
use crate::{CarriedSlip, GatheredCounts, PartitionedContact};

/// Elastic slip of a boundary facet against one of the bodies and obstacles that it faced, by the numbers of the whole mesh.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_carried_slip {
    /// Number of its cell in the whole mesh, counted from the option `index_base`.
    pub cell: i64,
    /// Face of that cell, as VTK counts them, always from 0.
    pub face: i32,
    /// Which of the facets of that face, from 0.
    pub part: i32,
    /// Kind of its partner: a value of `fmc_partner`.
    pub partner_kind: i32,
    /// 1 where the facet's body is the second side of that pair, else 0.
    pub is_second: i32,
    /// Index of the partner for `fmc_context_body_resultant` or `fmc_context_obstacle_resultant`.
    pub partner: usize,
    /// Elastic slip of the facet, a length; in 2D the last is 0.
    pub slip: [f64; 3],
    /// Slip since it rested, with `static_coefficient`, else 0; a length.
    pub slid: f64,
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
        let one = |of: CarriedSlip<D>| {
            let (partner_kind, partner) = side_of(of.partner);
            fmc_carried_slip {
                cell: of.cell as i64 + i64::from(index_base),
                face: of.face as i32,
                part: of.part as i32,
                partner_kind,
                is_second: i32::from(of.is_second),
                partner,
                slip: std::array::from_fn(|axis| of.slip.get(axis).copied().unwrap_or(0.0)),
                slid: of.slid,
            }
        };
        Ok(self.slip()?.into_iter().map(one).collect())
    }

    fn set_carried_slip(&mut self, carried: &[fmc_carried_slip], index_base: i32) -> Result<(), Failure> {
        // What is negative names no facet, as what is too large.
        let one = |of: &fmc_carried_slip| {
            Ok(CarriedSlip {
                cell: of.cell.wrapping_sub(index_base.into()) as u64,
                face: of.face as u32,
                part: of.part as u32,
                partner: partner(of.partner_kind, of.partner)?,
                is_second: of.is_second != 0,
                slip: std::array::from_fn(|axis| of.slip[axis]),
                slid: of.slid,
            })
        };
        let carried = carried.iter().map(one).collect::<Result<Vec<_>, Failure>>()?;
        Ok(self.set_slip(&carried)?)
    }
}

/// What a context that was not made from a part of a mesh answers.
pub(crate) fn no_parts() -> Failure {
    Failure::new(FMC_ERROR_UNSUPPORTED, "the context was not made by fmc_context_new_from_part")
}
