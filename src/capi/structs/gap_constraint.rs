//! A weighted gap as a plain struct, and its derivative in compressed rows.

use super::evaluation::side_of;
use crate::contact::GapConstraints;

/// The weighted gap of a node of one body over the surface of one partner: gap = int N phi dA over a part of the facets of
/// the node. This part is nearer than the reach, and faces the partner within 60 degrees of the direction to its nearest
/// point. N is the shape function of the node, phi the distance from the partner's surface, negative inside. Contact is gap
/// >= 0.
///
/// With cells of second order a row belongs to a point of their division, and N is its straight shape function, which is
/// positive everywhere. The shape function of a node is not, and its integral at the corner of a face may vanish.
/// Multipliers are then pressures at points; the derivative is that by nodes.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_gap_constraint {
    /// Size of this struct, as the library wrote it.
    pub struct_size: usize,
    /// The node, counted from the option `index_base`; with cells of second order the point, see
    /// `fmc_context_point_weights`: numbers from the node count on are not nodes.
    pub node: i64,
    /// Its body, an index for `fmc_context_body_resultant`.
    pub body: usize,
    /// Kind of the partner: a value of `fmc_partner`.
    pub partner_kind: i32,
    /// Zero.
    pub reserved_flags: i32,
    /// Index of the partner for `fmc_context_body_resultant` or `fmc_context_obstacle_resultant`.
    pub partner: usize,
    /// Weighted gap, in length^dim.
    pub gap: f64,
    /// int N dA over the same part: `gap / area` is the mean gap at the node.
    pub area: f64,
    /// Zero.
    pub reserved: [u64; 4],
}

/// What a context keeps of the gaps that were found last.
pub(crate) struct KeptGaps {
    pub(crate) rows: Vec<fmc_gap_constraint>,
    /// Rows of degrees of freedom, all counted from zero.
    pub(crate) row_starts: Vec<usize>,
    pub(crate) cols: Vec<usize>,
    pub(crate) values: Vec<f64>,
    /// One more than the largest column.
    pub(crate) dof_count: usize,
}

impl Default for KeptGaps {
    /// None.
    fn default() -> Self {
        Self { rows: Vec::new(), row_starts: vec![0], cols: Vec::new(), values: Vec::new(), dof_count: 0 }
    }
}

impl KeptGaps {
    pub(crate) fn new<const D: usize>(found: &GapConstraints<D>, index_base: i32) -> Self {
        let row = |r: usize| {
            let [(_, body), (partner_kind, partner)] = found.partners[r].map(side_of);
            fmc_gap_constraint {
                struct_size: size_of::<fmc_gap_constraint>(),
                node: i64::from(found.nodes[r]) + i64::from(index_base),
                body,
                partner_kind,
                reserved_flags: 0,
                partner,
                gap: found.gaps[r],
                area: found.areas[r],
                reserved: [0; 4],
            }
        };
        let of_nodes = |node: &u32| {
            let first = *node as usize * D;
            first..first + D
        };
        let cols: Vec<usize> = found.columns.iter().flat_map(of_nodes).collect();
        Self {
            rows: (0..found.nodes.len()).map(row).collect(),
            row_starts: found.row_starts.iter().map(|start| D * start).collect(),
            dof_count: cols.iter().max().map_or(0, |last| last + 1),
            cols,
            values: found.slopes.iter().flatten().copied().collect(),
        }
    }
}
