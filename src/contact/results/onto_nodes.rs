//! Results at the points of a division, as the host's nodes have them: see [`crate::geometry::second_order`].

use super::forces::ContactForces;
use super::gap_constraints::GapConstraints;
use super::{FrictionHeat, NodalContact, PointOfContact};
use crate::contact::friction::SlipFacets;
use crate::contact::tangents::{RankOne, Tangent};
use crate::contact::wear::WornOff;
use crate::geometry::Vector;
use crate::geometry::second_order::{Division, Interpolation};
use crate::overlap::{Block, FiberTrace, Overlap, Partner, Patches};
use std::collections::BTreeMap;

/// A result that was found at the points of a division.
pub(crate) trait OntoNodes: Sized {
    /// The same for the nodes; by default what does not speak of nodes.
    fn onto_nodes(self, _division: &Division) -> Self {
        self
    }
}

impl OntoNodes for f64 {}
impl<const D: usize> OntoNodes for Vec<SlipFacets<D>> {}
/// Surfaces wear at the points of the division.
impl OntoNodes for Vec<WornOff> {}
impl<const D: usize> OntoNodes for Vec<([Partner; 2], Patches<D>)> {}
impl<const D: usize> OntoNodes for Vec<FiberTrace<D>> {}

impl<const D: usize> OntoNodes for ContactForces<D> {
    fn onto_nodes(mut self, division: &Division) -> Self {
        self.forces = division.map().onto_nodes(&self.forces);
        self
    }
}

impl OntoNodes for FrictionHeat {
    fn onto_nodes(mut self, division: &Division) -> Self {
        let at_points: Vec<[f64; 1]> = self.nodes.iter().map(|heat| [*heat]).collect();
        self.nodes = division.map().onto_nodes(&at_points).into_iter().flatten().collect();
        self
    }
}

impl OntoNodes for Vec<Block<1>> {
    fn onto_nodes(self, division: &Division) -> Self {
        blocks_of_nodes(division.map(), &self)
    }
}

impl<const D: usize> OntoNodes for (ContactForces<D>, Tangent<D>) {
    fn onto_nodes(self, division: &Division) -> Self {
        (self.0.onto_nodes(division), self.1.onto_nodes(division))
    }
}

impl<const D: usize> OntoNodes for Tangent<D> {
    fn onto_nodes(self, division: &Division) -> Self {
        let map = division.map();
        let blocks = blocks_of_nodes(map, &self.blocks);
        let rank_one = self.rank_one.into_iter().map(|part| {
            let (nodes, vector) = gathered(map, part.nodes.iter().zip(&part.vector).map(|(node, g)| (*node, *g)));
            RankOne { factor: part.factor, nodes, vector }
        });
        Self { blocks, rank_one: rank_one.collect() }
    }
}

impl<const D: usize> OntoNodes for Vec<Overlap<D>> {
    fn onto_nodes(mut self, division: &Division) -> Self {
        for overlap in &mut self {
            let mut sums: BTreeMap<(u32, bool), Vector<D>> = BTreeMap::new();
            for ((&point, gradient), &of_b) in overlap.nodes.iter().zip(&overlap.gradient).zip(&overlap.of_b) {
                for (node, weight) in nodes(division.map(), point) {
                    *sums.entry((node, of_b)).or_insert_with(Vector::zeros) += gradient * weight;
                }
            }
            overlap.nodes = sums.keys().map(|(node, _)| *node).collect();
            overlap.of_b = sums.keys().map(|(_, of_b)| *of_b).collect();
            overlap.gradient = sums.into_values().collect();
        }
        self
    }
}

/// At a node what is at the point that stands for it: shape functions of second order have no mean at a corner, where their
/// integral vanishes, or is negative.
impl<const D: usize> OntoNodes for NodalContact<D> {
    fn onto_nodes(self, division: &Division) -> Self {
        let mut at_nodes = self.truncated(division.interpolation.node_count());
        division.welds().iter().for_each(|nodes| at_nodes.share(nodes));
        at_nodes
    }
}

/// Points of contact name points of the division; their cells are those given.
impl<const D: usize> OntoNodes for Vec<PointOfContact<D>> {
    fn onto_nodes(mut self, division: &Division) -> Self {
        for side in self.iter_mut().flat_map(|point| &mut point.sides) {
            side.cell = side.cell.map(|cell| division.cell(cell));
        }
        self
    }
}

/// A row stays that of a point, whose shape function is positive; its derivatives are those with respect to nodes.
impl<const D: usize> OntoNodes for GapConstraints<D> {
    fn onto_nodes(mut self, division: &Division) -> Self {
        let (mut row_starts, mut columns, mut slopes) = (vec![0], Vec::new(), Vec::new());
        for ends in self.row_starts.windows(2) {
            let entries = self.columns[ends[0]..ends[1]].iter().zip(&self.slopes[ends[0]..ends[1]]);
            let (nodes, vector) = gathered(division.map(), entries.map(|(point, g)| (*point, *g)));
            columns.extend(nodes);
            slopes.extend(vector);
            row_starts.push(columns.len());
        }
        (self.row_starts, self.columns, self.slopes) = (row_starts, columns, slopes);
        self
    }
}

/// Pᵀ K P, sorted, one block a place: row by row, each summed up in the order of the points' blocks.
fn blocks_of_nodes<const D: usize>(map: &Interpolation, blocks: &[Block<D>]) -> Vec<Block<D>> {
    // Parts of rows: a node, its weight at the point whose blocks go to it, and these.
    let mut parts: Vec<(u32, f64, &[Block<D>])> = Vec::new();
    for of_point in blocks.chunk_by(|a, b| a.row == b.row) {
        parts.extend(nodes(map, of_point[0].row).map(|(node, weight)| (node, weight, of_point)));
    }
    parts.sort_by_key(|(node, ..)| *node);
    let beyond = blocks.iter().map(|block| (block.col as usize + 1).saturating_sub(map.point_count())).max();
    let mut places = vec![u32::MAX; map.node_count() + beyond.unwrap_or(0)];
    let (mut sums, mut row_of): (Vec<Block<D>>, Vec<Block<D>>) = (Vec::with_capacity(2 * blocks.len()), Vec::new());
    for of_node in parts.chunk_by(|a, b| a.0 == b.0) {
        for &(row, of_row, blocks) in of_node {
            for block in blocks {
                for (col, of_col) in nodes(map, block.col) {
                    let weight = of_row * of_col;
                    let place = &mut places[col as usize];
                    if *place == u32::MAX {
                        *place = row_of.len() as u32;
                        row_of.push(Block {
                            row,
                            col,
                            value: block.value.map(|line| line.map(|value| weight * value)),
                        });
                        continue;
                    }
                    let sums = row_of[*place as usize].value.as_flattened_mut();
                    sums.iter_mut().zip(block.value.as_flattened()).for_each(|(sum, value)| *sum += weight * value);
                }
            }
        }
        row_of.iter().for_each(|block| places[block.col as usize] = u32::MAX);
        row_of.sort_unstable_by_key(|block| block.col);
        sums.append(&mut row_of);
    }
    sums
}

/// Nodes that move a point, with their weights; what stands for an obstacle in a tangent comes after the nodes as it did after
/// the points.
fn nodes(map: &Interpolation, point: u32) -> impl Iterator<Item = (u32, f64)> {
    let beyond = (point as usize).checked_sub(map.point_count()).map(|number| (map.node_count() + number) as u32);
    let row = beyond.is_none().then(|| map.row(point as usize));
    row.into_iter().flatten().chain(beyond.map(|node| (node, 1.0)))
}

/// Pᵀ g of a sparse vector, by ascending node.
fn gathered<const D: usize>(
    map: &Interpolation,
    entries: impl Iterator<Item = (u32, [f64; D])>,
) -> (Vec<u32>, Vec<[f64; D]>) {
    let mut sums: BTreeMap<u32, [f64; D]> = BTreeMap::new();
    for (point, g) in entries {
        for (node, weight) in nodes(map, point) {
            let sum = sums.entry(node).or_insert([0.0; D]);
            (0..D).for_each(|axis| sum[axis] += weight * g[axis]);
        }
    }
    sums.into_iter().unzip()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::overlap::merged;

    /// Against all products, sorted: the same bits, with what stands for an obstacle and a point that no node moves.
    #[test]
    fn rows_are_summed_in_the_order_of_the_points() {
        let rows = [
            vec![(0, 1.0)],
            vec![(1, 1.0)],
            vec![(0, -1.0 / 6.0), (1, -1.0 / 6.0), (2, 4.0 / 3.0)],
            vec![(2, 0.3), (0, 0.1), (3, 0.7)],
            vec![],
        ];
        let map = Interpolation::new(4, &rows, |_| true);
        let value = |k: u32| [[(f64::from(k) * 0.37).sin(), 1e3], [-1.0 / f64::from(k + 3), f64::from(k)]];
        let mut blocks = Vec::new();
        for row in 0..7 {
            blocks.extend((0..7).filter(|col| (row * 7 + col) % 3 != 0).map(|col| Block {
                row,
                col,
                value: value(7 * row + col),
            }));
        }
        let mut all = Vec::new();
        for block in &blocks {
            for (row, of_row) in nodes(&map, block.row) {
                for (col, of_col) in nodes(&map, block.col) {
                    let weight = of_row * of_col;
                    all.push(Block { row, col, value: block.value.map(|line| line.map(|value| weight * value)) });
                }
            }
        }
        let expected = merged(vec![all, Vec::new()]);
        let found = blocks_of_nodes(&map, &blocks);
        assert_eq!(found.len(), expected.len());
        for (found, expected) in found.iter().zip(&expected) {
            assert_eq!((found.row, found.col), (expected.row, expected.col));
            let bits = |block: &Block<2>| block.value.as_flattened().iter().map(|x| x.to_bits()).collect::<Vec<_>>();
            assert_eq!(bits(found), bits(expected));
        }
    }
}
