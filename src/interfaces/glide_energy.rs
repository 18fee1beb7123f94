//! The energy of surfaces that slide and do not separate, w = Σ λ g m + k/2 g² m over their rows, and its derivatives.
//!
//! With a row's integral A of the distance over a facet of normal n, dg m = Σ n·dA + A·dn over its facets.

use super::frame::{Frame, Matrix};
use super::glide::{Glide, GlideRow};
use super::place::Weights;
use super::tie_energy::Curvature;
use crate::geometry::Vector;
use crate::overlap::{Block, BlockSum};
use std::collections::BTreeMap;

/// Surfaces that slide and do not separate, at some coordinates.
pub(crate) struct GlideAt<'a, const D: usize> {
    glide: &'a Glide<D>,
    frames: Vec<Frame<D>>,
    /// A of every part of every row.
    apart: Vec<Vec<Vector<D>>>,
    /// Means of the gap, less those that are kept.
    pub(crate) gaps: Vec<f64>,
    /// Tractions along the normals, positive in tension.
    pub(crate) tractions: Vec<f64>,
    pub(crate) energy: f64,
    stiffness: f64,
}

impl<const D: usize> Glide<D> {
    /// At these points of the mesh, with a stiffness and multipliers by point. A facet that has collapsed has no normal; nothing is held there.
    pub(crate) fn at(&self, points: &[[f64; D]], stiffness: f64, multipliers: &BTreeMap<u32, f64>) -> GlideAt<'_, D> {
        let x: Vec<Vector<D>> = self.nodes.iter().map(|&node| Vector::from(points[node as usize])).collect();
        let sum = |weights: &Weights| {
            weights.iter().fold(Vector::<D>::zeros(), |sum, &(node, weight)| sum + x[node as usize] * weight)
        };
        let frame = |corners: &[Weights; D]| Frame::new(&corners.each_ref().map(sum)).unwrap_or_else(Frame::none);
        let frames: Vec<_> = self.frames.iter().map(frame).collect();
        let parts = |row: &GlideRow| row.parts.iter().map(|part| sum(&part.apart)).collect();
        let apart: Vec<Vec<Vector<D>>> = self.rows.iter().map(parts).collect();
        let gap = |(row, apart): (&GlideRow, &Vec<Vector<D>>)| {
            let along = row.parts.iter().zip(apart).map(|(part, a)| frames[part.frame as usize].normal.dot(a));
            along.sum::<f64>() / row.measure - row.gap
        };
        let gaps: Vec<f64> = self.rows.iter().zip(&apart).map(gap).collect();
        let (mut energy, mut tractions) = (0.0, Vec::with_capacity(gaps.len()));
        for (row, gap) in self.rows.iter().zip(&gaps) {
            let multiplier = multipliers.get(&row.point).copied().unwrap_or(0.0);
            energy += row.measure * gap * (multiplier + 0.5 * stiffness * gap);
            tractions.push(multiplier + stiffness * gap);
        }
        GlideAt { glide: self, frames, apart, gaps, tractions, energy, stiffness }
    }
}

impl<const D: usize> GlideAt<'_, D> {
    /// Rows with their parts, and the place of each of these.
    fn parts(&self) -> impl Iterator<Item = (usize, usize, &super::glide::GlidePart)> {
        let rows = self.glide.rows.iter().enumerate();
        rows.flat_map(|(row, of_row)| of_row.parts.iter().enumerate().map(move |(at, part)| (row, at, part)))
    }

    /// Mean normal of the facets that a row faces.
    pub(crate) fn normal(&self, row: usize) -> Vector<D> {
        let parts = self.glide.rows[row].parts.iter();
        let sum = parts.map(|part| self.frames[part.frame as usize].normal * part.measure).sum::<Vector<D>>();
        sum.try_normalize(0.0).unwrap_or_else(Vector::zeros)
    }

    /// Derivative of the energy by the nodes.
    pub(crate) fn gradient(&self) -> Vec<Vector<D>> {
        let mut gradient = vec![Vector::zeros(); self.glide.nodes.len()];
        for (row, _, part) in self.parts() {
            let traction = self.frames[part.frame as usize].normal * self.tractions[row];
            part.apart.iter().for_each(|&(node, weight)| gradient[node as usize] += traction * weight);
        }
        for (number, load) in self.loads_of_frames().iter().enumerate() {
            for (corner, slope) in self.glide.frames[number].iter().zip(&self.frames[number].slopes) {
                let force = along(slope, load);
                corner.iter().for_each(|&(node, weight)| gradient[node as usize] += force * weight);
            }
        }
        gradient
    }

    /// Σ T A over the rows, by frame.
    fn loads_of_frames(&self) -> Vec<Vector<D>> {
        let mut loads = vec![Vector::zeros(); self.frames.len()];
        self.parts()
            .for_each(|(row, at, part)| loads[part.frame as usize] += self.apart[row][at] * self.tractions[row]);
        loads
    }

    /// The second derivative, by points of the mesh.
    pub(crate) fn curvature(&self, which: Curvature) -> Vec<Block<D>> {
        let mut sum = BlockSum::default();
        for (row, apart) in self.glide.rows.iter().zip(&self.apart) {
            self.add_row(row, apart, &mut sum);
        }
        if which == Curvature::All {
            self.add_turning(&mut sum);
        }
        sum.into_blocks()
    }

    /// Adds k m dgᵀ dg of a row.
    fn add_row(&self, row: &GlideRow, apart: &[Vector<D>], sum: &mut BlockSum<D>) {
        let mut slopes: BTreeMap<u32, Vector<D>> = BTreeMap::new();
        for (part, a) in row.parts.iter().zip(apart) {
            let (frame, corners) = (&self.frames[part.frame as usize], &self.glide.frames[part.frame as usize]);
            let mut add = |node: u32, value: Vector<D>| *slopes.entry(node).or_insert_with(Vector::zeros) += value;
            part.apart.iter().for_each(|&(node, weight)| add(node, frame.normal * weight));
            for (corner, slope) in corners.iter().zip(&frame.slopes) {
                let turned = along(slope, a);
                corner.iter().for_each(|&(node, weight)| add(node, turned * weight));
            }
        }
        let factor = self.stiffness / row.measure;
        let nodes: Vec<u32> = slopes.keys().map(|node| self.glide.nodes[*node as usize]).collect();
        let mut square = Vec::with_capacity(slopes.len() * slopes.len());
        for a in slopes.values() {
            for b in slopes.values() {
                square.push(std::array::from_fn(|i| std::array::from_fn(|j| factor * a[i] * b[j])));
            }
        }
        sum.add_square(&nodes, &square);
    }

    /// Adds Σ T (dA·dn + dn·dA + A·d²n).
    fn add_turning(&self, sum: &mut BlockSum<D>) {
        let mut weights: Vec<BTreeMap<u32, f64>> = vec![BTreeMap::new(); self.frames.len()];
        for (row, _, part) in self.parts() {
            let of_frame = &mut weights[part.frame as usize];
            let add = |&(node, weight): &(u32, f64)| *of_frame.entry(node).or_default() += self.tractions[row] * weight;
            part.apart.iter().for_each(add);
        }
        let nodes = &self.glide.nodes;
        for (number, load) in self.loads_of_frames().iter().enumerate() {
            let (corners, frame) = (&self.glide.frames[number], &self.frames[number]);
            for (c, of_row) in corners.iter().enumerate() {
                for &(row, by_row) in of_row {
                    let row_node = nodes[row as usize];
                    for (&col, weight) in &weights[number] {
                        let value = frame.slopes[c].map(|line| line.map(|x| x * by_row * weight));
                        sum.add(nodes[col as usize], row_node, &value);
                        sum.add(row_node, nodes[col as usize], &transposed(&value));
                    }
                    for (d, of_col) in corners.iter().enumerate() {
                        let second = frame.second(load, [c, d]);
                        for &(col, by_col) in of_col {
                            let value = second.map(|line| line.map(|x| by_row * by_col * x));
                            sum.add(row_node, nodes[col as usize], &value);
                        }
                    }
                }
            }
        }
    }
}

/// a·dn by the position of a corner.
fn along<const D: usize>(slope: &Matrix<D>, a: &Vector<D>) -> Vector<D> {
    Vector::from_fn(|j, _| (0..D).map(|i| a[i] * slope[i][j]).sum())
}

fn transposed<const D: usize>(matrix: &Matrix<D>) -> Matrix<D> {
    std::array::from_fn(|i| std::array::from_fn(|j| matrix[j][i]))
}
