//! A multiplier as a plain struct, and what an update says.

use super::evaluation::side_of;
use super::partner::partner;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::status::fmc_status::{FMC_ERROR_NODE_OUT_OF_RANGE, FMC_ERROR_STRUCT_SIZE};
use crate::contact::{Augmentation, Multiplier};
use crate::overlap::Partner;

/// Results of `fmc_context_augment`, at the coordinates of its call.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_augmentation {
    /// Size of this struct, as the library wrote it.
    pub struct_size: usize,
    /// Largest mean penetration of a node over its part of the surface, of the side of each pair that has the multipliers.
    pub penetration: f64,
    /// Largest change of a multiplier / stiffness of the law: distance of a pressed node from the partner, inside or outside.
    pub change: f64,
    /// Number of multipliers, for `fmc_context_multipliers`.
    pub multiplier_count: usize,
    /// Whether both are within the tolerance: the multipliers are then unchanged.
    pub is_converged: i32,
    /// Zero.
    pub reserved_flags: i32,
    /// Zero.
    pub reserved: [u64; 4],
}

/// Multiplier of a node: by how far its surface is shifted towards one partner.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_multiplier {
    /// Size of this struct, as the library wrote it.
    pub struct_size: usize,
    /// The node, counted from the option `index_base`; with cells of second order the point, see
    /// `fmc_context_point_weights`.
    pub node: i64,
    /// Its body, an index for `fmc_context_body_resultant`.
    pub body: usize,
    /// Kind of the partner: a value of `fmc_partner`.
    pub partner_kind: i32,
    /// Zero.
    pub reserved_flags: i32,
    /// Index of the partner for `fmc_context_body_resultant` or `fmc_context_obstacle_resultant`.
    pub partner: usize,
    /// Shift, a positive length; times the law's stiffness it is the pressure without penetration.
    pub shift: f64,
    /// Unit vector towards the partner; in 2D the last is 0.
    pub towards: [f64; 3],
    /// Zero.
    pub reserved: [u64; 4],
}

impl From<Augmentation> for fmc_augmentation {
    fn from(found: Augmentation) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            penetration: found.penetration,
            change: found.change,
            multiplier_count: found.count,
            is_converged: i32::from(found.is_enough),
            reserved_flags: 0,
            reserved: [0; 4],
        }
    }
}

impl fmc_multiplier {
    pub(crate) fn new<const D: usize>(one: &Multiplier<D>, index_base: i32) -> Self {
        let [(_, body), (partner_kind, partner)] = one.partners.map(side_of);
        Self {
            struct_size: size_of::<Self>(),
            node: i64::from(one.node) + i64::from(index_base),
            body,
            partner_kind,
            reserved_flags: 0,
            partner,
            shift: one.shift,
            towards: std::array::from_fn(|axis| if axis < D { one.towards[axis] } else { 0.0 }),
            reserved: [0; 4],
        }
    }

    /// Number `place` of a list.
    pub(crate) fn taken<const D: usize>(&self, place: usize, index_base: i32) -> Result<Multiplier<D>, Failure> {
        if self.struct_size != size_of::<Self>() {
            let text = format!(
                "multiplier {place} was not written by fmc_context_multipliers: its struct_size is {}",
                self.struct_size
            );
            return Err(Failure::new(FMC_ERROR_STRUCT_SIZE, text));
        }
        let node = self.node.checked_sub(i64::from(index_base)).and_then(|node| u32::try_from(node).ok());
        let node = node.ok_or_else(|| {
            let text = format!("multiplier {place} is of node {}, which does not exist", self.node);
            Failure::new(FMC_ERROR_NODE_OUT_OF_RANGE, text)
        })?;
        Ok(Multiplier {
            node,
            partners: [Partner::Body(self.body), partner(self.partner_kind, self.partner)?],
            shift: self.shift,
            towards: std::array::from_fn(|axis| self.towards[axis]),
        })
    }
}
