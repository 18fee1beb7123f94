//! The energy of a tie, w = Σ λ·g m + k/2 |g|² m over its rows, and its derivatives.

use super::frame::{Frame, Matrix};
use super::place::Weights;
use super::tie::{Tie, TieRow};
use crate::geometry::Vector;
use crate::overlap::{Block, BlockSum};
use std::collections::BTreeMap;

/// What is asked of the second derivative.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Curvature {
    All,
    /// Without what the turning of facets adds.
    Semidefinite,
}

/// A tie at some coordinates.
pub(crate) struct TieAt<'a, const D: usize> {
    tie: &'a Tie<D>,
    frames: Vec<Frame<D>>,
    /// Means of the jump.
    pub(crate) jumps: Vec<Vector<D>>,
    /// Tractions of the first side of the rows on the second, a force by area, as the energy has them.
    pub(crate) tractions: Vec<Vector<D>>,
    pub(crate) energy: f64,
    stiffness: f64,
}

impl<const D: usize> Tie<D> {
    /// 1 where the first body has the hat functions, −1 where the second has.
    pub(crate) fn sign(&self) -> f64 {
        if self.is_second { -1.0 } else { 1.0 }
    }

    /// The tie at these points of the mesh, with a stiffness and multipliers (`&[]`: none). A facet along which a gap is kept has no
    /// normal once it has collapsed; its gap then counts nothing.
    pub(crate) fn at(&self, points: &[[f64; D]], stiffness: f64, multipliers: &[Vector<D>]) -> TieAt<'_, D> {
        let x: Vec<Vector<D>> = self.nodes.iter().map(|&node| Vector::from(points[node as usize])).collect();
        let sum = |weights: &Weights| {
            weights.iter().fold(Vector::<D>::zeros(), |sum, &(node, weight)| sum + x[node as usize] * weight)
        };
        let frames: Vec<_> = self.frames.iter().map(|corners| Frame::new(&corners.each_ref().map(sum))).collect();
        let frames: Vec<_> = frames.into_iter().map(|frame| frame.unwrap_or_else(Frame::none)).collect();
        // A row is the hat functions' side less the other one.
        let apart = (self.period + self.jump) * self.sign();
        let jump = |row: &TieRow<D>| {
            let kept = row.gaps.iter().map(|&(frame, gap)| frames[frame as usize].normal * gap);
            (sum(&row.jump) - kept.sum::<Vector<D>>()) / row.measure - apart
        };
        let jumps: Vec<_> = self.rows.iter().map(jump).collect();
        let multiplier = |row: usize| multipliers.get(row).copied().unwrap_or_else(Vector::zeros);
        let tractions = jumps.iter().enumerate().map(|(row, jump)| multiplier(row) + jump * stiffness).collect();
        let of_row = |(row, jump): (usize, &Vector<D>)| {
            self.rows[row].measure * (multiplier(row).dot(jump) + 0.5 * stiffness * jump.norm_squared())
        };
        let energy = jumps.iter().enumerate().map(of_row).sum();
        TieAt { tie: self, frames, jumps, tractions, energy, stiffness }
    }
}

impl<const D: usize> TieAt<'_, D> {
    /// Derivative of the energy by the jump: the force on the first body.
    pub(crate) fn force(&self) -> Vector<D> {
        let rows = self.tie.rows.iter().zip(&self.tractions);
        rows.map(|(row, traction)| traction * row.measure).sum::<Vector<D>>() * -self.tie.sign()
    }

    /// Derivative of the energy by the nodes of the tie.
    pub(crate) fn gradient(&self) -> Vec<Vector<D>> {
        let mut gradient = vec![Vector::zeros(); self.tie.nodes.len()];
        for (row, traction) in self.tie.rows.iter().zip(&self.tractions) {
            row.jump.iter().for_each(|&(node, weight)| gradient[node as usize] += traction * weight);
        }
        for (number, load) in self.loads_of_frames().iter().enumerate() {
            for (corner, slope) in self.tie.frames[number].iter().zip(&self.frames[number].slopes) {
                let force = Vector::<D>::from_fn(|j, _| (0..D).map(|i| load[i] * slope[i][j]).sum());
                corner.iter().for_each(|&(node, weight)| gradient[node as usize] -= force * weight);
            }
        }
        gradient
    }

    /// Σ γ T over the rows, by frame.
    fn loads_of_frames(&self) -> Vec<Vector<D>> {
        let mut loads = vec![Vector::zeros(); self.frames.len()];
        for (row, traction) in self.tie.rows.iter().zip(&self.tractions) {
            row.gaps.iter().for_each(|&(frame, gap)| loads[frame as usize] += traction * gap);
        }
        loads
    }

    /// The second derivative, by points of the mesh.
    pub(crate) fn curvature(&self, which: Curvature) -> Vec<Block<D>> {
        if self.frames.is_empty() {
            return self.constant();
        }
        let mut sum = BlockSum::default();
        for row in &self.tie.rows {
            self.add_row(row, &mut sum);
        }
        if which == Curvature::All {
            self.add_turning(&mut sum);
        }
        sum.into_blocks()
    }

    /// Where no gap is kept: k Σ c cᵀ/m, the same for every axis and at all coordinates.
    fn constant(&self) -> Vec<Block<D>> {
        let nodes = &self.tie.nodes;
        let block = |&(row, col, value): &(u32, u32, f64)| Block {
            row: nodes[row as usize],
            col: nodes[col as usize],
            value: identity(self.stiffness * value),
        };
        let mut blocks: Vec<Block<D>> = self.tie.products().iter().map(block).collect();
        blocks.sort_by_key(|block| (block.row, block.col));
        // A point may be on both sides of a body that is tied to itself.
        blocks.dedup_by(|next, sum| {
            let is_same = (next.row, next.col) == (sum.row, sum.col);
            if is_same {
                (0..D).for_each(|axis| sum.value[axis][axis] += next.value[axis][axis]);
            }
            is_same
        });
        blocks
    }

    /// Adds k/m dGᵀ dG of a row.
    fn add_row(&self, row: &TieRow<D>, sum: &mut BlockSum<D>) {
        let mut slopes: BTreeMap<u32, Matrix<D>> = BTreeMap::new();
        let mut add = |node: u32, value: Matrix<D>| {
            let slope = slopes.entry(node).or_insert([[0.0; D]; D]);
            (0..D).for_each(|i| (0..D).for_each(|j| slope[i][j] += value[i][j]));
        };
        row.jump.iter().for_each(|&(node, weight)| add(node, identity(weight)));
        for &(frame, gap) in &row.gaps {
            let number = frame as usize;
            for (corner, slope) in self.tie.frames[number].iter().zip(&self.frames[number].slopes) {
                corner.iter().for_each(|&(node, weight)| add(node, slope.map(|line| line.map(|x| -gap * weight * x))));
            }
        }
        let factor = self.stiffness / row.measure;
        let nodes: Vec<u32> = slopes.keys().map(|node| self.tie.nodes[*node as usize]).collect();
        let values: Vec<_> = slopes.values().collect();
        let mut square = Vec::with_capacity(values.len() * values.len());
        for a in &values {
            for b in &values {
                let product = |i: usize, j: usize| factor * (0..D).map(|k| a[k][i] * b[k][j]).sum::<f64>();
                square.push(std::array::from_fn(|i| std::array::from_fn(|j| product(i, j))));
            }
        }
        sum.add_square(&nodes, &square);
    }

    /// Adds −d²n·Σ γ T of every frame.
    fn add_turning(&self, sum: &mut BlockSum<D>) {
        for (number, load) in self.loads_of_frames().iter().enumerate() {
            let corners = &self.tie.frames[number];
            for (c, of_row) in corners.iter().enumerate() {
                for (d, of_col) in corners.iter().enumerate() {
                    let second = self.frames[number].second(load, [c, d]);
                    for &(row, by_row) in of_row {
                        for &(col, by_col) in of_col {
                            let value = second.map(|line| line.map(|x| -by_row * by_col * x));
                            sum.add(self.tie.nodes[row as usize], self.tie.nodes[col as usize], &value);
                        }
                    }
                }
            }
        }
    }
}

impl<const D: usize> Tie<D> {
    /// Σ c cᵀ/m over the rows, by row and column.
    fn products(&self) -> &[(u32, u32, f64)] {
        self.products.get_or_init(|| {
            let mut of_node: Vec<Vec<(usize, f64)>> = vec![Vec::new(); self.nodes.len()];
            for (number, row) in self.rows.iter().enumerate() {
                row.jump.iter().for_each(|&(node, weight)| of_node[node as usize].push((number, weight / row.measure)));
            }
            let (mut found, mut sums) = (Vec::new(), BTreeMap::new());
            for (node, rows) in (0..).zip(&of_node) {
                sums.clear();
                for &(row, weight) in rows {
                    for &(other, value) in &self.rows[row].jump {
                        *sums.entry(other).or_insert(0.0) += weight * value;
                    }
                }
                found.extend(sums.iter().map(|(&other, &value)| (node, other, value)));
            }
            found
        })
    }
}

fn identity<const D: usize>(value: f64) -> Matrix<D> {
    std::array::from_fn(|i| std::array::from_fn(|j| if i == j { value } else { 0.0 }))
}
