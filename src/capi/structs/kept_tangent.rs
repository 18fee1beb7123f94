//! A tangent that waits to be fetched.

use crate::contact::{CompressedRows, Pattern, Tangent, compressed};

/// A tangent with its dimension hidden: degree of freedom `node * dim + axis`, obstacles after the nodes.
#[derive(Default)]
pub(crate) struct Kept {
    /// 0 before the first tangent.
    pub(crate) dim: usize,
    pub(crate) node_count: usize,
    pub(crate) obstacle_count: usize,
    /// Row and column of the blocks, sorted.
    pub(crate) places: Vec<(u32, u32)>,
    /// Their numbers, row by row, `dim * dim` each.
    values: Vec<f64>,
    pub(crate) rank_one: Vec<(f64, Vec<(usize, f64)>)>,
}

impl Kept {
    /// Flattens a tangent of a mesh with so many nodes and obstacles.
    pub(crate) fn new<const D: usize>(tangent: &Tangent<D>, node_count: usize, obstacle_count: usize) -> Self {
        let rank_one = tangent.rank_one.iter().map(|part| {
            let entries = part.nodes.iter().zip(&part.vector);
            let flat = entries.flat_map(|(&node, g)| (0..D).map(move |axis| (node as usize * D + axis, g[axis])));
            (part.factor, flat.collect())
        });
        Self {
            dim: D,
            node_count,
            obstacle_count,
            places: tangent.places().collect(),
            values: tangent.blocks.iter().flat_map(|block| block.value.as_flattened()).copied().collect(),
            rank_one: rank_one.collect(),
        }
    }

    /// Degrees of freedom of the mesh.
    pub(crate) fn dof_count(&self) -> usize {
        self.node_count * self.dim
    }

    /// Number of [`Self::entries`].
    pub(crate) fn entry_count(&self) -> usize {
        self.values.len()
    }

    /// Entries of the blocks as (row, column, value).
    pub(crate) fn entries(&self) -> impl Iterator<Item = (usize, usize, f64)> {
        let dim = self.dim;
        self.blocks().flat_map(move |((row, col), block)| {
            let corner = (row as usize * dim, col as usize * dim);
            block.iter().enumerate().map(move |(k, value)| (corner.0 + k / dim, corner.1 + k % dim, *value))
        })
    }

    fn blocks(&self) -> impl Iterator<Item = ((u32, u32), &[f64])> {
        // Before the first tangent there are neither places nor values.
        self.places.iter().copied().zip(self.values.chunks_exact((self.dim * self.dim).max(1)))
    }

    /// The blocks of the first `row_count` nodes and obstacles in compressed rows; `None` where `pattern` has a place
    /// and the tangent no block.
    pub(crate) fn rows(&self, row_count: usize, pattern: Option<&Pattern>) -> CompressedRows<Option<&[f64]>> {
        compressed(row_count, pattern, self.blocks().map(|(place, block)| (place, Some(block))), None)
    }

    /// `y = K x`.
    pub(crate) fn product(&self, x: &[f64]) -> Vec<f64> {
        let mut y = vec![0.0; x.len()];
        for (row, col, value) in self.entries() {
            if row < x.len() && col < x.len() {
                y[row] += value * x[col];
            }
        }
        for (factor, vector) in &self.rank_one {
            let inside = || vector.iter().filter(|(dof, _)| *dof < x.len());
            let along: f64 = inside().map(|(dof, g)| g * x[*dof]).sum::<f64>() * factor;
            inside().for_each(|(dof, g)| y[*dof] += along * g);
        }
        y
    }
}
