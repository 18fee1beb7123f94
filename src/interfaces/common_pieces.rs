//! Pieces of facets of one body that face a facet of another.

use crate::Error;
use crate::geometry::aabb::Aabb;
use crate::geometry::convex_piece::{Corners, Piece, place};
use crate::geometry::facet::{area_vector, determinant};
use crate::geometry::tree::Tree;
use crate::geometry::{Surface, Vector};
use std::collections::BTreeSet;

/// Cosine of the largest angle, 60°, between a normal and the reversed one of a facet that it faces.
const FACING: f64 = 0.5;

/// Reach by default, by the size of the larger facets.
const REACH: f64 = 0.1;

/// Part of a facet below which a piece is rounding.
const ROUNDING: f64 = 1e-14;

/// A piece of a facet, and the facet that it faces, within reach; of what is farther apart there is the size alone.
pub(super) struct CommonPiece<const D: usize> {
    /// Numbers of both facets in the surface.
    pub(super) facets: [usize; 2],
    /// Corners of the piece, in barycentric coordinates of the first facet.
    pub(super) corners: Corners<D>,
    /// Barycentric coordinates in the second facet, along the normal of the first, at the corners of the first facet.
    pub(super) across: [[f64; D]; D],
    /// How far the second facet lies above the first there, along its normal.
    pub(super) gaps: [f64; D],
    /// The part of the first facet that faces the second within reach, and farther apart.
    pub(super) within: f64,
    pub(super) beyond: f64,
    /// The distance between both facets, or how far they overlap: the least and the largest.
    pub(super) distances: [f64; 2],
}

/// Facets of two bodies that come within reach of one another and face one another, ordered by the first.
pub(super) struct Facing<'a, const D: usize> {
    pub(super) surface: &'a Surface<D>,
    /// Positions of the surface's vertices.
    pub(super) vertices: &'a [Vector<D>],
    /// How far apart facets may be, or how far they may overlap.
    pub(super) reach: f64,
    /// The same as it was given.
    pub(super) given: f64,
}

/// Part of the reach, and units of rounding of a coordinate, by which distances are known.
const ROUNDED: f64 = 1e-9;
const UNITS: f64 = 64.0 * f64::EPSILON;

impl<'a, const D: usize> Facing<'a, D> {
    /// Those of two bodies, within a reach; 0: a tenth of the larger facets.
    pub(super) fn of_bodies(
        surface: &'a Surface<D>,
        vertices: &'a [Vector<D>],
        bodies: [usize; 2],
        reach: f64,
    ) -> Self {
        let facing = Self::new(surface, vertices, reach);
        if reach > 0.0 {
            return facing;
        }
        let sizes = bodies.map(|body| facing.facet_size(surface.ranges[body].clone()));
        Self::new(surface, vertices, REACH * sizes[0].max(sizes[1]))
    }

    /// What is as far apart as the reach but for rounding is within it.
    pub(super) fn new(surface: &'a Surface<D>, vertices: &'a [Vector<D>], reach: f64) -> Self {
        let farthest = vertices.iter().map(|x| x.amax()).fold(0.0, f64::max);
        Self { surface, vertices, reach: reach * (1.0 + ROUNDED) + UNITS * farthest, given: reach }
    }

    /// The mean size of facets.
    pub(super) fn facet_size(&self, facets: impl Iterator<Item = usize>) -> f64 {
        let facets: BTreeSet<usize> = facets.collect();
        let sizes = facets.iter().map(|facet| area_vector(&self.corners(*facet)).norm().powf(1.0 / (D as f64 - 1.0)));
        sizes.sum::<f64>() / facets.len().max(1) as f64
    }

    /// The least distance between facets that face one another; `None` where none do.
    fn nearest(&self, bodies: [usize; 2]) -> Option<f64> {
        let farthest = self.vertices.iter().map(|x| x.amax()).fold(0.0, f64::max);
        let mut reach = self.reach;
        while reach < 4.0 * farthest {
            reach *= 4.0;
            let farther = Facing { reach, ..*self };
            let pieces = farther.candidates(bodies).into_iter().filter_map(|pair| farther.common(pair));
            let least = pieces.map(|piece| piece.distances[0]).fold(f64::INFINITY, f64::min);
            if least <= reach {
                return Some(least);
            }
        }
        None
    }

    /// Why there is nothing between two bodies.
    pub(super) fn untied(&self, bodies: [usize; 2]) -> Error {
        Error::Untied { bodies, distances: [self.given, self.nearest(bodies).unwrap_or(f64::INFINITY)] }
    }

    pub(super) fn corners(&self, facet: usize) -> [Vector<D>; D] {
        self.surface.facets[facet].map(|vertex| self.vertices[vertex as usize])
    }

    /// Pairs of facets of two bodies that may have a common piece.
    pub(super) fn candidates(&self, bodies: [usize; 2]) -> Vec<[usize; 2]> {
        self.candidates_among(bodies.map(|body| self.surface.ranges[body].clone().collect()))
    }

    /// The same among some facets of either.
    pub(super) fn candidates_among(&self, facets: [Vec<usize>; 2]) -> Vec<[usize; 2]> {
        let boxes = facets.each_ref().map(|facets| {
            let inflated = |&facet: &usize| Aabb::of(&self.corners(facet)).inflated(self.reach);
            facets.iter().map(inflated).collect::<Vec<_>>()
        });
        let mut found = Vec::new();
        Tree::new(&boxes[0]).visit_pairs(&Tree::new(&boxes[1]), [&boxes[0], &boxes[1]], |i, j| {
            found.push([facets[0][i as usize], facets[1][j as usize]]);
        });
        found.retain(|&[here, there]| self.face(here, there));
        found.sort_unstable();
        found
    }

    fn face(&self, here: usize, there: usize) -> bool {
        let [n, m] = [here, there].map(|facet| area_vector(&self.corners(facet)));
        n.dot(&m) < -FACING * n.norm() * m.norm()
    }

    /// The piece of the first facet that faces the second.
    pub(super) fn common(&self, facets: [usize; 2]) -> Option<CommonPiece<D>> {
        self.common_between(facets, [-self.reach, self.reach])
    }

    /// The same where the gap lies between two limits, and none where it does so nowhere.
    pub(super) fn common_within(&self, facets: [usize; 2], limits: [f64; 2]) -> Option<CommonPiece<D>> {
        self.common_between(facets, limits).filter(|piece| !piece.corners.is_empty())
    }

    fn common_between(&self, facets: [usize; 2], [least, most]: [f64; 2]) -> Option<CommonPiece<D>> {
        let [x, y] = facets.map(|facet| self.corners(facet));
        let n = area_vector(&x).try_normalize(0.0)?;
        let whole = seen(&y, &n);
        if whole == 0.0 {
            return None;
        }
        let across = x.map(|x| std::array::from_fn(|k| seen(&with(&y, k, x), &n) / whole));
        let mut piece = Piece::default();
        piece.reset();
        for k in 0..D {
            if !piece.cut(&across.map(|at: [f64; D]| -at[k])) {
                return None;
            }
        }
        let gaps: [f64; D] = std::array::from_fn(|c| (place(&y, &across[c]) - x[c]).dot(&n));
        let whole: f64 = piece.moments().iter().sum();
        if whole <= ROUNDING {
            return None;
        }
        let at_corners = piece.corners().iter().map(|corner| (0..D).map(|c| corner[c] * gaps[c]).sum::<f64>());
        let [low, high] = at_corners.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], gap| [a.min(gap), b.max(gap)]);
        let nearest = if low <= 0.0 && high >= 0.0 { 0.0 } else { low.abs().min(high.abs()) };
        let is_within = piece.cut(&gaps.map(|gap| gap - most)) && piece.cut(&gaps.map(|gap| least - gap));
        let size: f64 = if is_within { piece.moments().iter().sum() } else { 0.0 };
        let corners = if size > ROUNDING { piece.corners().iter().copied().collect() } else { Corners::new() };
        let distances = [nearest, low.abs().max(high.abs())];
        Some(CommonPiece { facets, corners, across, gaps, within: size, beyond: (whole - size).max(0.0), distances })
    }
}

/// What a facet with these corners measures, seen along n, up to a factor.
fn seen<const D: usize>(y: &[Vector<D>; D], n: &Vector<D>) -> f64 {
    determinant(&std::array::from_fn(|k| if k + 1 < D { y[k + 1] - y[0] } else { *n }))
}

fn with<const D: usize>(y: &[Vector<D>; D], k: usize, x: Vector<D>) -> [Vector<D>; D] {
    std::array::from_fn(|c| if c == k { x } else { y[c] })
}
