//! The simplices on which the depth field is linear, where they are now.

use super::cell_parts::{cell_face, weights};
use super::field::DepthField;
use crate::geometry::Vector;
use crate::geometry::aabb::Aabb;
use crate::geometry::cells::Cells;
use crate::geometry::facet_slopes::cross;

/// Nodes that a cell has at most.
pub(crate) const MOST_NODES: usize = 8;

/// A simplex of a cell on which its depth is linear.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DepthPiece<const D: usize> {
    pub(crate) cell: u32,
    /// D + 1 corners.
    pub(crate) corners: [Vector<D>; 4],
    /// Depth at the corners.
    pub(crate) depths: [f64; 4],
    /// Weights of the cell's nodes in the corners.
    pub(crate) weights: [[f64; MOST_NODES]; 4],
    /// Gradients of the barycentric coordinates.
    pub(crate) slopes: [Vector<D>; 4],
    /// Gradient of the depth.
    pub(crate) gradient: Vector<D>,
    /// Its measure, positive.
    pub(crate) measure: f64,
    /// +1, or −1 where the cell is inverted.
    pub(crate) sign: f64,
    /// Whether the depth is the height above a facet of the body, which the piece has for a face.
    pub(crate) is_at_surface: bool,
}

impl<const D: usize> DepthPiece<D> {
    fn new(
        cell: u32,
        corners: [Vector<D>; 4],
        depths: [f64; 4],
        weights: [[f64; MOST_NODES]; 4],
        flipped: bool,
    ) -> Option<Self> {
        let (slopes, signed) = slopes(&corners)?;
        let gradient = (0..=D).fold(Vector::zeros(), |sum, k| sum + slopes[k] * depths[k]);
        let sign = if flipped { -signed.signum() } else { signed.signum() };
        Some(Self {
            cell,
            corners,
            depths,
            weights,
            slopes,
            gradient,
            measure: signed.abs(),
            sign,
            is_at_surface: false,
        })
    }

    /// Barycentric coordinates of a point.
    pub(crate) fn barycentric(&self, x: &Vector<D>) -> [f64; 4] {
        let from = x - self.corners[0];
        let mut all = [0.0; 4];
        let mut rest = 1.0;
        for k in 1..=D {
            all[k] = self.slopes[k].dot(&from);
            rest -= all[k];
        }
        all[0] = rest;
        all
    }

    pub(crate) fn aabb(&self) -> Aabb<D> {
        Aabb::of(&self.corners[..=D])
    }

    /// Values that are given at the corners, as values at the cell's nodes: the transpose of the interpolation.
    pub(crate) fn at_nodes(&self, at_corners: &[f64; 4]) -> [f64; MOST_NODES] {
        let mut at_nodes = [0.0; MOST_NODES];
        for k in 0..=D {
            for (sum, weight) in at_nodes.iter_mut().zip(&self.weights[k]) {
                *sum += weight * at_corners[k];
            }
        }
        at_nodes
    }
}

impl<const D: usize> DepthField<D> {
    /// Calls `visit` for every piece of a cell that has a measure, in a fixed order.
    pub(crate) fn for_each_piece(
        &self,
        cells: &Cells,
        cell: usize,
        coords: &[[f64; D]],
        mut visit: impl FnMut(DepthPiece<D>),
    ) {
        let (nodes, flipped) = (cells.nodes(cell), cells.is_flipped(cell));
        let mut at_nodes = [Vector::<D>::zeros(); MOST_NODES];
        for (x, &n) in at_nodes.iter_mut().zip(nodes) {
            *x = coords[n as usize].into();
        }
        let place = |weights: &[f64; MOST_NODES]| {
            at_nodes[..nodes.len()].iter().zip(weights).fold(Vector::zeros(), |sum, (x, w)| sum + x * *w)
        };
        self.for_each_part(cells, cell, |part, depths, incentre| {
            let (mut corners, mut of_nodes) = ([Vector::zeros(); 4], [[0.0; MOST_NODES]; 4]);
            for k in 0..=D {
                of_nodes[k] = weights(cells, cell, part.corners[k]);
                corners[k] = place(&of_nodes[k]);
            }
            let Some(incentre) = incentre else {
                DepthPiece::new(cell as u32, corners, depths, of_nodes, flipped).into_iter().for_each(&mut visit);
                return;
            };
            let mut about = [0.0; MOST_NODES];
            for (weights, weight) in of_nodes.iter().zip(&incentre.weights) {
                about.iter_mut().zip(weights).for_each(|(sum, w)| *sum += weight * w);
            }
            let middle = place(&about);
            for k in 0..=D {
                let (mut corners, mut depths, mut of_nodes) = (corners, depths, of_nodes);
                (corners[k], depths[k], of_nodes[k]) = (middle, incentre.depth, about);
                let face = cell_face(cells.cell_type(cell), D, part, k);
                if let Some(piece) = DepthPiece::new(cell as u32, corners, depths, of_nodes, flipped) {
                    visit(DepthPiece { is_at_surface: face.is_some_and(|face| self.is_surface(cell, face)), ..piece });
                }
            }
        });
    }
}

/// Gradients of the barycentric coordinates of a simplex, and its signed measure; `None` where it is flat.
fn slopes<const D: usize>(corners: &[Vector<D>; 4]) -> Option<([Vector<D>; 4], f64)> {
    let mut slopes = [Vector::zeros(); 4];
    let edge = |k: usize| corners[k] - corners[0];
    let signed = match D {
        2 => {
            let (e, f) = (edge(1), edge(2));
            let twice = e[0] * f[1] - e[1] * f[0];
            (slopes[1][0], slopes[1][1]) = (f[1] / twice, -f[0] / twice);
            (slopes[2][0], slopes[2][1]) = (-e[1] / twice, e[0] / twice);
            twice / 2.0
        }
        _ => {
            let (e, f, g) = (edge(1), edge(2), edge(3));
            let of_first = cross(&f, &g);
            let sixfold = e.dot(&of_first);
            slopes[1] = of_first / sixfold;
            slopes[2] = cross(&g, &e) / sixfold;
            slopes[3] = cross(&e, &f) / sixfold;
            sixfold / 6.0
        }
    };
    slopes[0] = -(slopes[1] + slopes[2] + slopes[3]);
    let is_finite = slopes.iter().all(|slope| slope.iter().all(|x| x.is_finite()));
    (signed != 0.0 && is_finite).then_some((slopes, signed))
}
