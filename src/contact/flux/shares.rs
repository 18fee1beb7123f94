//! What points conduct, summed by the nodes on both sides.

use crate::overlap::BlockSum;

/// Nodes that have a share in points close to one another, and these: the matrix Σ h dA j jᵀ, j being how the jump of a field at the point
/// follows from its values at the nodes. Kept in parts, each of few nodes.
#[derive(Default)]
pub(super) struct Shares {
    sum: BlockSum<1>,
    nodes: Vec<u32>,
    square: Vec<f64>,
    points: Vec<(f64, Vec<(usize, f64)>)>,
}

impl Shares {
    /// Adds a point that conducts so much by the jump of a field: the sum over `near` less that over `far`.
    pub(super) fn add(&mut self, conducts: f64, near: &[(u32, f64)], far: &[(u32, f64)]) {
        if conducts == 0.0 {
            return;
        }
        let mut jump: Vec<(usize, f64)> = Vec::with_capacity(near.len() + far.len());
        for (node, weight) in near.iter().copied().chain(far.iter().map(|&(node, weight)| (node, -weight))) {
            let place = self.nodes.iter().position(|known| *known == node).unwrap_or_else(|| {
                self.nodes.push(node);
                self.nodes.len() - 1
            });
            match jump.iter_mut().find(|(known, _)| *known == place) {
                Some((_, sum)) => *sum += weight,
                None => jump.push((place, weight)),
            }
        }
        self.points.push((conducts, jump));
    }

    /// Ends a part: the points that follow have other nodes.
    pub(super) fn end_part(&mut self) {
        let count = self.nodes.len();
        self.square.clear();
        self.square.resize(count * count, 0.0);
        for (conducts, jump) in self.points.drain(..) {
            for &(row, a) in &jump {
                for &(col, b) in &jump {
                    // (a b) first: the same bits on both sides of the diagonal.
                    self.square[row * count + col] += conducts * (a * b);
                }
            }
        }
        let values: Vec<[[f64; 1]; 1]> = self.square.iter().map(|value| [[*value]]).collect();
        self.sum.add_square(&self.nodes, &values);
        self.nodes.clear();
    }

    pub(super) fn into_sum(mut self) -> BlockSum<1> {
        self.end_part();
        self.sum
    }
}
