//! Cells between the front and the back of a layer.

use super::front::Front;
use fmc_contact::CellType;
use std::collections::BTreeMap;

/// Nodes at the back and in the middle of a layer, which it adds to those of the mesh.
pub(crate) struct Layer<'a> {
    points: &'a mut Vec<[f64; 3]>,
    to_back: &'a BTreeMap<usize, [f64; 3]>,
    back: BTreeMap<usize, usize>,
    middles: BTreeMap<[usize; 2], usize>,
}

impl<'a> Layer<'a> {
    /// Behind nodes of these points.
    pub(crate) fn new(points: &'a mut Vec<[f64; 3]>, to_back: &'a BTreeMap<usize, [f64; 3]>) -> Self {
        Self { points, to_back, back: BTreeMap::new(), middles: BTreeMap::new() }
    }

    fn add(&mut self, point: [f64; 3]) -> usize {
        self.points.push(point);
        self.points.len() - 1
    }

    fn back(&mut self, node: usize) -> usize {
        if let Some(&back) = self.back.get(&node) {
            return back;
        }
        let way = self.to_back.get(&node).copied().unwrap_or_default();
        let back = self.add(std::array::from_fn(|k| self.points[node][k] + way[k]));
        self.back.insert(node, back);
        back
    }

    fn middle(&mut self, a: usize, b: usize) -> usize {
        let key = [a.min(b), a.max(b)];
        if let Some(&middle) = self.middles.get(&key) {
            return middle;
        }
        let middle = self.add(std::array::from_fn(|k| 0.5 * (self.points[a][k] + self.points[b][k])));
        self.middles.insert(key, middle);
        middle
    }

    /// The cell behind a face, which is its first in the plane and its second in space.
    pub(crate) fn cell(&mut self, front: &Front) -> (CellType, Vec<u32>) {
        let Front { corners, middles } = front;
        let count = corners.len();
        let is_second_order = !middles.is_empty();
        let back: Vec<usize> = corners.iter().map(|&node| self.back(node)).collect();
        let mut nodes = match (&corners[..], &back[..]) {
            ([a, b], [c, d]) => vec![*b, *a, *c, *d],
            _ => [&back[..], corners].concat(),
        };
        if is_second_order {
            let more: Vec<usize> = match (&corners[..], &back[..]) {
                ([a, b], [c, d]) => vec![middles[0], self.middle(*a, *c), self.middle(*c, *d), self.middle(*b, *d)],
                _ => {
                    let around: Vec<usize> = (0..count).map(|k| self.middle(back[k], back[(k + 1) % count])).collect();
                    let upright: Vec<usize> = (0..count).map(|k| self.middle(back[k], corners[k])).collect();
                    [around, middles.clone(), upright].concat()
                }
            };
            nodes.extend(more);
        }
        let cell_type = match (count, is_second_order) {
            (2, false) => CellType::Quad4,
            (2, true) => CellType::Quad8,
            (3, false) => CellType::Wedge6,
            (3, true) => CellType::Wedge15,
            (_, false) => CellType::Hex8,
            (_, true) => CellType::Hex20,
        };
        (cell_type, nodes.into_iter().map(|node| node as u32).collect())
    }
}
