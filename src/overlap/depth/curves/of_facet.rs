//! A facet of one body, and a piece of the other below it.

use super::point_blocks::PointBlocks;
use crate::depth_field::{DepthPiece, Quadratic};
use crate::geometry::Vector;
use crate::geometry::boundary::facet_sags::FacetSag;
use crate::geometry::primitives::facet::area_vector;
use crate::overlap::depth::bodies::PointSums;
use crate::overlap::pair::body_facet::BodyFacet;

/// A facet, and what is summed up over it.
pub(super) struct OfFacet<'a, const D: usize> {
    pub(super) facet: BodyFacet<D>,
    pub(super) sag: &'a FacetSag<D>,
    /// Its corners and its measure without deformation.
    pub(super) before: ([Vector<D>; D], f64),
    pub(super) area: [f64; D],
    pub(super) depth: [f64; D],
    pub(super) points: PointSums<D>,
    pub(super) blocks: PointBlocks<D>,
    /// Forces at its corners.
    pub(super) forces: [Vector<D>; D],
    pub(super) is_met: bool,
}

/// A piece of the other body, as a facet sees it.
pub(super) struct Below<'a, const D: usize> {
    pub(super) piece: &'a DepthPiece<D>,
    /// What curved faces add to its depth.
    pub(super) heights: &'a Quadratic,
    /// Barycentric coordinates of the facet's corners.
    pub(super) barycentric: [[f64; 4]; D],
    /// 1 − cos of the angle between the facet and the straight face below it.
    pub(super) turn: f64,
}

impl<'a, const D: usize> OfFacet<'a, D> {
    pub(super) fn new(facet: BodyFacet<D>, sag: &'a FacetSag<D>, before: [Vector<D>; D]) -> Self {
        Self {
            facet,
            sag,
            before: (before, area_vector(&before).norm()),
            area: [0.0; D],
            depth: [0.0; D],
            points: PointSums::default(),
            blocks: PointBlocks::default(),
            forces: [Vector::zeros(); D],
            is_met: false,
        }
    }
}

impl<'a, const D: usize> Below<'a, D> {
    pub(super) fn new((piece, heights): (&'a DepthPiece<D>, &'a Quadratic), facet: &BodyFacet<D>) -> Self {
        let barycentric = facet.corners.each_ref().map(|x| piece.barycentric(x));
        let mut below = Self { piece, heights, barycentric, turn: 1.0 };
        if let Some(inwards) = below.gradient(&piece.depths).try_normalize(0.0) {
            below.turn = 1.0 - facet.normal.dot(&inwards);
        }
        below
    }

    /// Barycentric coordinates in the piece of a place of the facet.
    pub(super) fn at(&self, w: &[f64; D]) -> [f64; 4] {
        std::array::from_fn(|k| (0..D).map(|c| w[c] * self.barycentric[c][k]).sum())
    }

    /// The gradient of a function with these derivatives by the coordinates in the piece.
    pub(super) fn gradient(&self, by_coordinate: &[f64; 4]) -> Vector<D> {
        (0..=D).fold(Vector::zeros(), |sum, k| sum + self.piece.slopes[k] * by_coordinate[k])
    }
}

/// A place of a facet on the way from one to another.
pub(super) fn on<const D: usize>(from: &[f64; D], to: &[f64; D], part: f64) -> [f64; D] {
    std::array::from_fn(|c| from[c] + part * (to[c] - from[c]))
}
