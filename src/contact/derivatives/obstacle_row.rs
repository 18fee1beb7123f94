//! Rows of the transposed tangent.

use crate::contact::tangents::Tangent;

/// Kᵀ a, of so many rows: a has those of the nodes, and is zero for what stands for obstacles.
pub(super) fn add_transposed<const D: usize>(tangent: &Tangent<D>, a: &[[f64; D]], factor: f64, sums: &mut [[f64; D]]) {
    for block in &tangent.blocks {
        let (Some(along), Some(sum)) = (a.get(block.row as usize), sums.get_mut(block.col as usize)) else { continue };
        for (j, sum) in sum.iter_mut().enumerate() {
            *sum += factor * (0..D).map(|i| block.value[i][j] * along[i]).sum::<f64>();
        }
    }
    for part in &tangent.rank_one {
        let of_nodes = || part.nodes.iter().zip(&part.vector);
        let known = of_nodes().filter_map(|(&node, g)| Some((a.get(node as usize)?, g)));
        let along = factor * part.factor * known.map(|(a, g)| (0..D).map(|i| a[i] * g[i]).sum::<f64>()).sum::<f64>();
        for (&node, g) in of_nodes() {
            if let Some(sum) = sums.get_mut(node as usize) {
                (0..D).for_each(|i| sum[i] += along * g[i]);
            }
        }
    }
}
