//! What a measure in the plane counts for: itself, or the ring that it sweeps around an axis.
//!
//! In axisymmetry the coordinates are (r, z), and everything counts 2πr: an area of the plane is a volume of revolution, a
//! length an area. The weight is a function of space: what moves outwards counts for more.

use super::convex_piece::Piece;
use super::quadrature::{for_each_gauss_point, for_each_simplex};
use crate::geometry::Vector;
use std::f64::consts::TAU;

/// Weight of a measure.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Weighting {
    /// 1.
    #[default]
    Plain,
    /// 2πr, r being the first coordinate.
    Axisymmetric,
}

impl Weighting {
    pub(crate) fn is_plain(self) -> bool {
        self == Self::Plain
    }

    /// The weight at a point.
    pub(crate) fn at<const D: usize>(self, x: &Vector<D>) -> f64 {
        match self {
            Self::Plain => 1.0,
            Self::Axisymmetric => TAU * x[0],
        }
    }

    /// Its gradient, the same everywhere.
    pub(crate) fn gradient<const D: usize>(self) -> Vector<D> {
        let mut gradient = Vector::zeros();
        if self == Self::Axisymmetric {
            gradient[0] = TAU;
        }
        gradient
    }

    /// Whether points lie on the axis, where a body is not bounded.
    pub(crate) fn is_axis<'a, const D: usize>(
        self,
        points: impl IntoIterator<Item = &'a Vector<D>>,
        rounding: f64,
    ) -> bool {
        self == Self::Axisymmetric && points.into_iter().all(|x| x[0].abs() <= rounding)
    }

    /// ∫ of every barycentric coordinate over a piece of a facet, the whole facet having measure 1; and what the products
    /// of two add to it as they move by 1 down the gradient of the weight.
    pub(crate) fn moments<const D: usize>(self, facet: &[Vector<D>; D], piece: &Piece<D>) -> ([f64; D], [[f64; D]; D]) {
        let mut spread = [[0.0; D]; D];
        if self == Self::Plain {
            return (piece.moments(), spread);
        }
        let mut moments = [0.0; D];
        for_each_gauss_point(piece.corners(), false, |w, part| {
            let radius = (0..D).map(|c| w[c] * facet[c][0]).sum::<f64>();
            for a in 0..D {
                moments[a] += part * TAU * radius * w[a];
                (0..D).for_each(|c| spread[a][c] += part * TAU * w[a] * w[c]);
            }
        });
        (moments, spread)
    }

    /// Calls `visit(corners, part of the facet's measure with its weight, the part alone)` for simplices on which products
    /// of two linear functions sum up to their weighted integral over a convex piece of a facet: those that make up the
    /// piece, or, where they have a weight, the points of a quadrature of degree 3, each as a simplex without extent.
    pub(crate) fn for_each_simplex<const D: usize>(
        self,
        facet: &[Vector<D>; D],
        piece: &[[f64; D]],
        mut visit: impl FnMut([&[f64; D]; D], f64, f64),
    ) {
        match self {
            Self::Plain => for_each_simplex(piece, |corners, part| visit(corners, part, part)),
            Self::Axisymmetric => for_each_gauss_point(piece, false, |w, part| {
                let radius = (0..D).map(|c| w[c] * facet[c][0]).sum::<f64>();
                visit([w; D], part * TAU * radius, part);
            }),
        }
    }
}
