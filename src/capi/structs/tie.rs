//! Ties as plain structs.

use crate::contact::{TieConstraints, TieNode, TieSummary};

/// The tie of two bodies.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_tie {
    /// Size of this struct, as the library wrote it.
    pub struct_size: usize,
    /// Area that is tied (2D: length; with axisymmetry the area of whole rings); 0: the bodies are not tied.
    pub area: f64,
    /// The largest gap, or overlap, that is kept between the surfaces, a length.
    pub largest_gap: f64,
    /// Number of means of the jump that are held: one for each node of the holding side, mostly the side with the
    /// larger facets.
    pub node_count: usize,
    /// Largest distance or overlap of tied faces, a length: as given, or its default.
    pub reach: f64,
    /// Zero.
    pub reserved: [u64; 3],
}

/// A node of a tie, on the holding side, mostly the side with the larger facets.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_tie_node {
    /// Size of this struct, as the library wrote it.
    pub struct_size: usize,
    /// The node, counted from the option `index_base`; with cells of second order the point, see
    /// `fmc_context_point_weights`.
    pub node: i64,
    /// Its body, an index for `fmc_context_body_resultant`.
    pub body: usize,
    /// The body to which it is tied.
    pub partner: usize,
    /// Its tributary area.
    pub area: f64,
    /// Traction on its body, force per area; in 2D the last is 0.
    pub traction: [f64; 3],
    /// Mean separation of its body from the other one, a length; in 2D the last is 0.
    pub jump: [f64; 3],
    /// Zero.
    pub reserved: [u64; 4],
}

impl From<Option<TieSummary>> for fmc_tie {
    fn from(found: Option<TieSummary>) -> Self {
        let TieSummary { area, largest_gap, reach, count } = found.unwrap_or_default();
        Self { struct_size: size_of::<Self>(), area, largest_gap, node_count: count, reach, reserved: [0; 3] }
    }
}

impl fmc_tie_node {
    pub(crate) fn new<const D: usize>(one: &TieNode<D>, index_base: i32) -> Self {
        let in_space = |x: &[f64; D]| std::array::from_fn(|axis| if axis < D { x[axis] } else { 0.0 });
        Self {
            struct_size: size_of::<Self>(),
            node: i64::from(one.node) + i64::from(index_base),
            body: one.bodies[0],
            partner: one.bodies[1],
            area: one.area,
            traction: in_space(&one.traction),
            jump: in_space(&one.jump),
            reserved: [0; 4],
        }
    }
}

/// Equations of ties by degrees of freedom, all counted from zero.
pub(crate) struct TieRows {
    pub(crate) row_starts: Vec<usize>,
    pub(crate) cols: Vec<usize>,
    pub(crate) values: Vec<f64>,
    /// One more than the largest column.
    pub(crate) dof_count: usize,
}

impl TieRows {
    pub(crate) fn new<const D: usize>(found: &TieConstraints) -> Self {
        let (mut row_starts, mut cols, mut values) = (vec![0], Vec::new(), Vec::new());
        for ends in found.row_starts.windows(2) {
            for axis in 0..D {
                cols.extend(found.columns[ends[0]..ends[1]].iter().map(|&node| node as usize * D + axis));
                values.extend(&found.weights[ends[0]..ends[1]]);
                row_starts.push(cols.len());
            }
        }
        let dof_count = cols.iter().max().map_or(0, |last| last + 1);
        Self { row_starts, cols, values, dof_count }
    }
}
