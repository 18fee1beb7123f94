//! Points as fixed linear combinations of the host's nodes.

use crate::Error;
use crate::geometry::mesh::hanging::HangingNode;
use std::collections::BTreeMap;

/// X = P x: rows of nodes and weights, one for every point.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Interpolation {
    node_count: usize,
    starts: Vec<usize>,
    nodes: Vec<u32>,
    weights: Vec<f64>,
    /// Nodes that move a point that is used, ascending, and these points.
    used: Vec<u32>,
    used_points: Vec<bool>,
    /// Points that are not the node of their number: three nodes move the middle of an edge, most points of most meshes, others
    /// any number.
    of_three: Vec<(u32, [u32; 3], [f64; 3])>,
    of_others: Vec<u32>,
}

impl Interpolation {
    /// Points given by nodes and weights, of which those marked are used.
    pub(crate) fn new(node_count: usize, rows: &[Vec<(u32, f64)>], is_used: impl Fn(usize) -> bool) -> Self {
        let used_points: Vec<bool> = (0..rows.len()).map(is_used).collect();
        let entries = || rows.iter().flatten();
        let of_used = rows.iter().zip(&used_points).filter(|(_, is_used)| **is_used).flat_map(|(row, _)| row);
        let mut used: Vec<u32> = of_used.map(|(node, _)| *node).collect();
        used.sort_unstable();
        used.dedup();
        let mut starts = vec![0];
        starts.extend(rows.iter().scan(0, |end, row| {
            *end += row.len();
            Some(*end)
        }));
        let (nodes, weights) = (entries().map(|entry| entry.0).collect(), entries().map(|entry| entry.1).collect());
        let (mut of_three, mut of_others) = (Vec::new(), Vec::new());
        for (point, row) in (0..).zip(rows) {
            match row[..] {
                [(node, 1.0)] if node == point && (node as usize) < node_count => {}
                [a, b, c] => of_three.push((point, [a.0, b.0, c.0], [a.1, b.1, c.1])),
                _ => of_others.push(point),
            }
        }
        Self { node_count, starts, nodes, weights, used, used_points, of_three, of_others }
    }

    /// Every point a node.
    pub(crate) fn identity(node_count: usize) -> Self {
        let rows: Vec<_> = (0..node_count as u32).map(|node| vec![(node, 1.0)]).collect();
        Self::new(node_count, &rows, |_| true)
    }

    /// The same with points that hang brought to the middle of others, which may hang themselves.
    pub(crate) fn with_hanging(&self, hanging: &[HangingNode], is_used: impl Fn(usize) -> bool) -> Self {
        let parents_of = |point: u32| {
            let place = hanging.binary_search_by_key(&point, |hanging| hanging.node);
            place.ok().map(|place| &hanging[place].parents)
        };
        let resolved = |point: u32| {
            let (mut row, mut open) = (BTreeMap::new(), vec![(point, 1.0)]);
            // A chain of parents is no longer than there are points that hang: what would be longer runs in a circle.
            for _ in 0..=hanging.len() {
                let mut next = Vec::new();
                for (point, weight) in open {
                    match parents_of(point) {
                        Some(parents) => {
                            next.extend(parents.iter().map(|&parent| (parent, weight / parents.len() as f64)));
                        }
                        None => {
                            for (node, part) in self.row(point as usize) {
                                *row.entry(node).or_insert(0.0) += weight * part;
                            }
                        }
                    }
                }
                open = next;
                if open.is_empty() {
                    break;
                }
            }
            row.into_iter().collect()
        };
        let row = |point: usize| match parents_of(point as u32) {
            Some(_) => resolved(point as u32),
            None => self.row(point).collect::<Vec<_>>(),
        };
        let rows: Vec<_> = (0..self.point_count()).map(row).collect();
        Self::new(self.node_count, &rows, is_used)
    }

    /// Number of nodes.
    pub(crate) fn node_count(&self) -> usize {
        self.node_count
    }

    /// Whether a cell or facet has a point.
    pub(super) fn is_used(&self, point: usize) -> bool {
        self.used_points[point]
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

    /// The points where the nodes are.
    ///
    /// # Errors
    /// [`Error::Length`], [`Error::NonFiniteCoordinate`].
    pub(crate) fn points<const D: usize>(&self, coords: &[[f64; D]]) -> Result<Vec<[f64; D]>, Error> {
        if coords.len() != self.node_count {
            return Err(Error::Length { array: "coords", expected: self.node_count, found: coords.len() });
        }
        for &node in &self.used {
            let node = node as usize;
            if let Some(axis) = coords[node].iter().position(|x| !x.is_finite()) {
                return Err(Error::NonFiniteCoordinate { node, axis });
            }
        }
        let mut points = Vec::with_capacity(self.point_count());
        points.extend_from_slice(&coords[..self.node_count.min(self.point_count())]);
        points.resize(self.point_count(), [0.0; D]);
        for (point, [a, b, c], weights) in &self.of_three {
            let (a, b, c) = (&coords[*a as usize], &coords[*b as usize], &coords[*c as usize]);
            let x = &mut points[*point as usize];
            for axis in 0..D {
                x[axis] = weights[0] * a[axis] + weights[1] * b[axis] + weights[2] * c[axis];
            }
        }
        for &point in &self.of_others {
            let mut row = self.row(point as usize);
            // From the first on, not from zero, which has a sign.
            let mut x = row.next().map_or([0.0; D], |(node, weight)| coords[node as usize].map(|x| weight * x));
            for (node, weight) in row {
                (0..D).for_each(|axis| x[axis] += weight * coords[node as usize][axis]);
            }
            points[point as usize] = x;
        }
        Ok(points)
    }

    /// Forces on the nodes that do the work of forces on the points: Pᵀ f.
    pub(crate) fn onto_nodes<const D: usize>(&self, forces: &[[f64; D]]) -> Vec<[f64; D]> {
        let mut on_nodes = vec![[0.0; D]; self.node_count];
        for (point, force) in forces.iter().enumerate() {
            // Most points of most meshes: sums that begin at zero keep their bits without it.
            if force.iter().all(|x| *x == 0.0) {
                continue;
            }
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
