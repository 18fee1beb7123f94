//! Points as fixed linear combinations of the host's nodes.

use crate::Error;
use crate::geometry::PointWeights;

/// X = P x: rows of nodes and weights, one for every point.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Interpolation {
    node_count: usize,
    starts: Vec<usize>,
    nodes: Vec<u32>,
    weights: Vec<f64>,
    /// Nodes that move a point that is used.
    used: Vec<bool>,
}

impl Interpolation {
    /// Points given by nodes and weights, of which those marked are used.
    pub(crate) fn new(node_count: usize, rows: &[Vec<(u32, f64)>], is_used: impl Fn(usize) -> bool) -> Self {
        let mut all =
            Self { node_count, starts: vec![0], nodes: Vec::new(), weights: Vec::new(), used: vec![false; node_count] };
        for (point, row) in rows.iter().enumerate() {
            for &(node, weight) in row {
                all.nodes.push(node);
                all.weights.push(weight);
                all.used[node as usize] |= is_used(point);
            }
            all.starts.push(all.nodes.len());
        }
        all
    }

    /// Number of nodes.
    pub(crate) fn node_count(&self) -> usize {
        self.node_count
    }

    /// Number of points.
    pub(crate) fn point_count(&self) -> usize {
        self.starts.len() - 1
    }

    /// Nodes that move a point, with their weights.
    pub(crate) fn row(&self, point: usize) -> impl Iterator<Item = (u32, f64)> {
        let range = self.starts[point]..self.starts[point + 1];
        self.nodes[range.clone()].iter().copied().zip(self.weights[range].iter().copied())
    }

    /// All rows, as hosts are told.
    pub(crate) fn weights(&self) -> PointWeights {
        PointWeights { starts: self.starts.clone(), nodes: self.nodes.clone(), weights: self.weights.clone() }
    }

    /// The points where the nodes are.
    ///
    /// # Errors
    /// [`Error::Length`], [`Error::NonFiniteCoordinate`].
    pub(crate) fn points<const D: usize>(&self, coords: &[[f64; D]]) -> Result<Vec<[f64; D]>, Error> {
        if coords.len() != self.node_count {
            return Err(Error::Length { array: "coords", expected: self.node_count, found: coords.len() });
        }
        for (node, x) in coords.iter().enumerate().filter(|(node, _)| self.used[*node]) {
            if let Some(axis) = x.iter().position(|x| !x.is_finite()) {
                return Err(Error::NonFiniteCoordinate { node, axis });
            }
        }
        let point = |point: usize| {
            let mut sum: Option<[f64; D]> = None;
            for (node, weight) in self.row(point) {
                let x = coords[node as usize];
                // A point that is a node keeps its bits.
                sum = Some(match sum {
                    None => x.map(|x| weight * x),
                    Some(sum) => std::array::from_fn(|axis| sum[axis] + weight * x[axis]),
                });
            }
            sum.unwrap_or([0.0; D])
        };
        Ok((0..self.point_count()).map(point).collect())
    }

    /// Forces on the nodes that do the work of forces on the points: Pᵀ f.
    pub(crate) fn onto_nodes<const D: usize>(&self, forces: &[[f64; D]]) -> Vec<[f64; D]> {
        let mut on_nodes = vec![[0.0; D]; self.node_count];
        for (point, force) in forces.iter().enumerate() {
            for (node, weight) in self.row(point) {
                for axis in 0..D {
                    on_nodes[node as usize][axis] += weight * force[axis];
                }
            }
        }
        on_nodes
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn forces_do_the_same_work_on_nodes_as_on_points() {
        let rows = [vec![(0, 1.0)], vec![(0, -0.25), (2, 1.25)], vec![(1, f64::NAN)]];
        let map = Interpolation::new(4, &rows[..2], |_| true);
        let x = [[1.0, 2.0], [f64::NAN, 0.0], [3.0, 5.0], [0.0, f64::INFINITY]];
        let points = map.points(&x).expect("nodes that nothing uses may be anything");
        assert_eq!(points, [[1.0, 2.0], [3.5, 5.75]]);
        let forces = [[2.0, 0.0], [4.0, 8.0]];
        assert_eq!(map.onto_nodes(&forces), [[1.0, -2.0], [0.0; 2], [5.0, 10.0], [0.0; 2]]);
        let refused = Interpolation::new(4, &rows, |_| true).points(&x);
        assert_eq!(refused, Err(Error::NonFiniteCoordinate { node: 1, axis: 0 }));
        assert_eq!(map.points(&x[1..]), Err(Error::Length { array: "coords", expected: 4, found: 3 }));
    }
}
