//! Results at the points of a division, as the host's nodes have them: see [`crate::geometry::second_order`].

use super::fields::{NodalContact, PointOfContact};
use super::forces::ContactForces;
use super::friction::SlipFacets;
use super::gap_constraints::GapConstraints;
use super::tangent::{RankOne, Tangent};
use crate::geometry::Vector;
use crate::geometry::second_order::{Division, Interpolation};
use crate::overlap::{Block, FiberTrace, Overlap, Partner, Patches, merged};
use std::collections::BTreeMap;

/// A result that was found at the points of a division.
pub(super) trait OntoNodes: Sized {
    /// The same for the nodes; by default what does not speak of nodes.
    fn onto_nodes(self, _division: &Division) -> Self {
        self
    }
}

impl OntoNodes for f64 {}
impl<const D: usize> OntoNodes for Vec<SlipFacets<D>> {}
impl<const D: usize> OntoNodes for Vec<([Partner; 2], Patches<D>)> {}
impl<const D: usize> OntoNodes for Vec<FiberTrace<D>> {}

impl<const D: usize> OntoNodes for ContactForces<D> {
    fn onto_nodes(mut self, division: &Division) -> Self {
        self.forces = division.map().onto_nodes(&self.forces);
        self
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
        let mut blocks = Vec::with_capacity(2 * self.blocks.len());
        for block in &self.blocks {
            for (row, of_row) in nodes(map, block.row) {
                for (col, of_col) in nodes(map, block.col) {
                    let weight = of_row * of_col;
                    blocks.push(Block { row, col, value: block.value.map(|line| line.map(|value| weight * value)) });
                }
            }
        }
        let rank_one = self.rank_one.into_iter().map(|part| {
            let (nodes, vector) = gathered(map, part.nodes.iter().zip(&part.vector).map(|(node, g)| (*node, *g)));
            RankOne { factor: part.factor, nodes, vector }
        });
        // As two parts, so that places which occur twice are merged.
        Self { blocks: merged(vec![blocks, Vec::new()]), rank_one: rank_one.collect() }
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
    fn onto_nodes(mut self, division: &Division) -> Self {
        let count = division.interpolation.node_count();
        for field in [&mut self.pressure, &mut self.gap, &mut self.area, &mut self.sliding] {
            field.truncate(count);
        }
        self.normal.truncate(count);
        self.friction.truncate(count);
        self.status.truncate(count);
        self
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
