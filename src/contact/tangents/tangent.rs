//! Second derivative of the contact energy.

use crate::Error;
use crate::overlap::{Block, merged};

/// Which part of the second derivative.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TangentPart {
    /// All of it: the derivative of the force. Newton converges quadratically near the solution.
    #[default]
    Full,
    /// Without what makes it unsymmetric: that a frictional force grows with the pressure, and the unsymmetric part of a cohesive
    /// interface whose mode changes as it breaks. The same as `Full` without friction and such interfaces.
    Symmetric,
    /// Symmetric and without the part from the turning of facets, which can be negative, with cohesive interfaces at the damage there
    /// is, and where frozen friction slides with its traction by its slip: safe far from the solution.
    Semidefinite,
}

/// Tangent of a contact: ∂²w/∂x², which is −∂F/∂x of the nodal forces F, to be added to the host's stiffness.
///
/// Symmetric. The nodes of the mesh come first; number `node_count + o` stands for the translation of obstacle `o`, so
/// that a host may drive an obstacle by its load: the row of its reaction and the columns of its displacement.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tangent<const D: usize> {
    /// Blocks of `D` by `D`, sorted by row and column, one per place.
    pub blocks: Vec<Block<D>>,
    /// Symmetric parts of rank one, which couple all nodes of a pair.
    pub rank_one: Vec<RankOne<D>>,
}

/// factor · g gᵀ.
#[derive(Clone, Debug, PartialEq)]
pub struct RankOne<const D: usize> {
    /// Second derivative w''(V) of the law.
    pub factor: f64,
    /// Nodes, numbered as in [`Tangent`], and g on them.
    pub nodes: Vec<u32>,
    /// g on those nodes.
    pub vector: Vec<[f64; D]>,
}

impl<const D: usize> Tangent<D> {
    /// The tangent, if all entries are finite.
    pub(crate) fn checked(self) -> Result<Self, Error> {
        let of_blocks = self.blocks.iter().flat_map(|block| block.value.as_flattened());
        let of_rank_one = self.rank_one.iter().flat_map(|part| part.vector.as_flattened().iter().chain([&part.factor]));
        let beyond = of_blocks.chain(of_rank_one).copied().find(|x| !x.is_finite());
        match beyond {
            Some(value) => Err(Error::Overflow { quantity: "tangent", value }),
            None => Ok(self),
        }
    }

    /// Entries of the blocks as (row, column, value), degree of freedom `node * D + axis`; without the rank-one parts.
    pub fn triplets(&self) -> impl Iterator<Item = (usize, usize, f64)> {
        self.blocks.iter().flat_map(|block| {
            let (row, col) = (block.row as usize * D, block.col as usize * D);
            (0..D * D).map(move |k| (row + k / D, col + k % D, block.value[k / D][k % D]))
        })
    }

    /// Product with a displacement of all nodes (and obstacles, if it is as long), rank-one parts included.
    pub fn product(&self, displacement: &[[f64; D]]) -> Vec<[f64; D]> {
        let mut product = vec![[0.0; D]; displacement.len()];
        let count = displacement.len();
        for block in &self.blocks {
            let (row, col) = (block.row as usize, block.col as usize);
            if row < count && col < count {
                for i in 0..D {
                    product[row][i] += (0..D).map(|j| block.value[i][j] * displacement[col][j]).sum::<f64>();
                }
            }
        }
        for part in &self.rank_one {
            let nodes = || part.nodes.iter().map(|&n| n as usize).zip(&part.vector).filter(|(n, _)| *n < count);
            let along: f64 =
                nodes().map(|(n, g)| (0..D).map(|i| g[i] * displacement[n][i]).sum::<f64>()).sum::<f64>() * part.factor;
            for (n, g) in nodes() {
                for i in 0..D {
                    product[n][i] += along * g[i];
                }
            }
        }
        product
    }

    /// The sum of the tangents of several pairs.
    pub(crate) fn sum(parts: Vec<Self>) -> Self {
        let (mut blocks, mut rank_one) = (Vec::with_capacity(parts.len()), Vec::new());
        for part in parts {
            blocks.push(part.blocks);
            rank_one.extend(part.rank_one);
        }
        Self { blocks: merged(blocks), rank_one }
    }
}
