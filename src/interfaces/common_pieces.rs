//! Pieces of facets of one body that face a facet of another.

use super::between::Between;
use super::near_facets::NearFacets;
use crate::Error;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::convex_piece::{Corners, Piece, place, value};
use crate::geometry::primitives::facet::{area_vector, determinant};
use crate::geometry::primitives::tree::Tree;
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

/// Facets of two bodies that come within reach of one another, face one another and are hidden by nothing, ordered by the first.
pub(super) struct Facing<'a, const D: usize> {
    pub(super) surface: &'a Surface<D>,
    /// Positions of the surface's vertices.
    pub(super) vertices: &'a [Vector<D>],
    /// Facets of both sides, by number in the surface.
    sides: [Vec<usize>; 2],
    pub(super) near_facets: NearFacets<D>,
    /// How far apart facets may be, or how far they may overlap.
    pub(super) reach: f64,
    /// The same as it was given.
    pub(super) given: f64,
    /// By how much places may be wrong that are meant to be one.
    pub(super) rounding: f64,
    /// What brings the facets of the second side to those of the first, and whether that is anything.
    period: Vector<D>,
    is_shifted: bool,
}

/// Part of the reach, and units of rounding of a coordinate, by which distances are known.
const ROUNDED: f64 = 1e-9;
const UNITS: f64 = 64.0 * f64::EPSILON;

impl<'a, const D: usize> Facing<'a, D> {
    /// Those of two bodies. What hides them may be any facet of either.
    pub(super) fn of_bodies(surface: &'a Surface<D>, vertices: &'a [Vector<D>], between: &Between) -> Self {
        let all = between.bodies.map(|body| surface.ranges[body].clone().collect());
        let mut facing = Self::new(surface, vertices, all, between.reach);
        if between.reach <= 0.0 {
            let sizes = facing.sides.each_ref().map(|facets| facing.facet_size(facets.iter().copied()));
            facing.set_reach(REACH * sizes[0].max(sizes[1]));
        }
        if let Some(facets) = &between.facets {
            facing.sides = facets.each_ref().map(|facets| facets.to_vec());
        }
        facing.period = Vector::from_fn(|axis, _| between.period[axis]);
        facing.is_shifted = facing.period != Vector::<D>::zeros();
        if facing.is_shifted {
            // What lies elsewhere than these parts, where one of them is brought, hides nothing.
            let near_facets = NearFacets::new(&facing.sides, |facet| facing.corners(facet));
            facing.near_facets = near_facets;
            facing.rounding += UNITS * facing.period.amax();
            facing.set_reach(facing.given);
        }
        facing
    }

    /// The same of these facets of two sides.
    pub(super) fn new(surface: &'a Surface<D>, vertices: &'a [Vector<D>], sides: [Vec<usize>; 2], reach: f64) -> Self {
        let rounding = UNITS * vertices.iter().map(|x| x.amax()).fold(0.0, f64::max);
        let corners = |facet: usize| surface.facets[facet].map(|vertex| vertices[vertex as usize]);
        let near_facets = NearFacets::new(&sides, corners);
        let (period, is_shifted) = (Vector::zeros(), false);
        let mut facing =
            Self { surface, vertices, sides, near_facets, reach, given: reach, rounding, period, is_shifted };
        facing.set_reach(reach);
        facing
    }

    /// What is as far apart as the reach but for rounding is within it.
    fn set_reach(&mut self, given: f64) {
        (self.reach, self.given) = (given * (1.0 + ROUNDED) + self.rounding, given);
    }

    /// The mean size of facets.
    pub(super) fn facet_size(&self, facets: impl Iterator<Item = usize>) -> f64 {
        let facets: BTreeSet<usize> = facets.collect();
        let sizes = facets.iter().map(|facet| area_vector(&self.corners(*facet)).norm().powf(1.0 / (D as f64 - 1.0)));
        sizes.sum::<f64>() / facets.len().max(1) as f64
    }

    /// The least distance between facets that face one another; `None` where none do.
    fn nearest(&self) -> Option<f64> {
        let farthest = self.vertices.iter().map(|x| x.amax()).fold(0.0, f64::max);
        let mut reach = self.reach;
        while reach < 4.0 * farthest {
            reach *= 4.0;
            let pieces =
                self.pairs_within(reach).into_iter().flat_map(|pair| self.common_between(pair, [-reach, reach]));
            let least = pieces.map(|piece| piece.distances[0]).fold(f64::INFINITY, f64::min);
            if least <= reach {
                return Some(least);
            }
        }
        None
    }

    /// Why there is nothing between two bodies.
    pub(super) fn untied(&self, bodies: [usize; 2], held: &'static str) -> Error {
        Error::Untied { bodies, distances: [self.given, self.nearest().unwrap_or(f64::INFINITY)], held }
    }

    pub(super) fn corners(&self, facet: usize) -> [Vector<D>; D] {
        let corners = self.surface.facets[facet].map(|vertex| self.vertices[vertex as usize]);
        if self.is_shifted { corners.map(|x| x + self.shift(facet)) } else { corners }
    }

    pub(super) fn period(&self) -> Vector<D> {
        self.period
    }

    /// What a facet is brought by.
    pub(super) fn shift(&self, facet: usize) -> Vector<D> {
        let is_brought = self.is_shifted && self.sides[1].binary_search(&facet).is_ok();
        if is_brought { self.period } else { Vector::zeros() }
    }

    /// Pairs of facets of both sides that may have a common piece, ordered; with `is_swapped` those of the second side come first.
    pub(super) fn candidates(&self, is_swapped: bool) -> Vec<[usize; 2]> {
        let mut found = self.pairs_within(self.reach);
        if is_swapped {
            found.iter_mut().for_each(|pair| pair.swap(0, 1));
            found.sort_unstable();
        }
        found
    }

    fn pairs_within(&self, reach: f64) -> Vec<[usize; 2]> {
        let boxes = self.sides.each_ref().map(|facets| {
            let inflated = |&facet: &usize| Aabb::of(&self.corners(facet)).inflated(reach);
            facets.iter().map(inflated).collect::<Vec<_>>()
        });
        let mut found = Vec::new();
        Tree::new(&boxes[0]).visit_pairs(&Tree::new(&boxes[1]), [&boxes[0], &boxes[1]], |i, j| {
            found.push([self.sides[0][i as usize], self.sides[1][j as usize]]);
        });
        found.retain(|&[here, there]| self.face(here, there));
        found.sort_unstable();
        found
    }

    fn face(&self, here: usize, there: usize) -> bool {
        let [n, m] = [here, there].map(|facet| area_vector(&self.corners(facet)));
        n.dot(&m) < -FACING * n.norm() * m.norm()
    }

    /// The pieces of the first facet that face the second; one, unless something lies between them in part.
    pub(super) fn common(&self, facets: [usize; 2]) -> Vec<CommonPiece<D>> {
        self.common_between(facets, [-self.reach, self.reach])
    }

    /// The same where the gap lies between two limits, and none where it does so nowhere.
    pub(super) fn common_within(&self, facets: [usize; 2], limits: [f64; 2]) -> Vec<CommonPiece<D>> {
        let mut found = self.common_between(facets, limits);
        found.retain(|piece| !piece.corners.is_empty());
        found
    }

    /// The part of a facet that a strip along its rim takes, as wide as places are rounded: neighbours have it in common by rounding alone.
    fn least_part(&self, x: &[Vector<D>; D]) -> f64 {
        let rim = if D == 2 { 2.0 } else { (0..D).map(|k| (x[(k + 1) % D] - x[k]).norm()).sum() };
        ROUNDING.max(self.rounding * rim / area_vector(x).norm())
    }

    fn common_between(&self, facets: [usize; 2], [least, most]: [f64; 2]) -> Vec<CommonPiece<D>> {
        let [x, y] = facets.map(|facet| self.corners(facet));
        let Some(n) = area_vector(&x).try_normalize(0.0) else { return Vec::new() };
        let Some((across, gaps)) = seen_along(&x, &y, &n) else { return Vec::new() };
        let (mut piece, least_part) = (Piece::default(), self.least_part(&x));
        piece.reset();
        if !(0..D).all(|k| piece.cut(&across.map(|at| -at[k]))) || piece.moments().iter().sum::<f64>() <= least_part {
            return Vec::new();
        }
        let visible = self.visible(facets, (&x, &n), &gaps, (piece.corners(), least_part));
        let part = |corners: Corners<D>| {
            piece.set(&corners);
            let whole: f64 = piece.moments().iter().sum();
            let at_corners = corners.iter().map(|corner| value(corner, &gaps));
            let [low, high] =
                at_corners.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], gap| [a.min(gap), b.max(gap)]);
            let nearest = if low <= 0.0 && high >= 0.0 { 0.0 } else { low.abs().min(high.abs()) };
            let is_within = piece.cut(&gaps.map(|gap| gap - most)) && piece.cut(&gaps.map(|gap| least - gap));
            let within: f64 = if is_within { piece.moments().iter().sum() } else { 0.0 };
            let corners = if within > least_part { piece.corners().iter().copied().collect() } else { Corners::new() };
            let (distances, beyond) = ([nearest, low.abs().max(high.abs())], (whole - within).max(0.0));
            CommonPiece { facets, corners, across, gaps, within, beyond, distances }
        };
        visible.into_iter().map(part).collect()
    }
}

/// The barycentric coordinates in a facet y, along a vector n, of the corners of another, x, and how far y lies above them there; `None` where
/// it is seen edge on.
pub(super) fn seen_along<const D: usize>(
    x: &[Vector<D>; D],
    y: &[Vector<D>; D],
    n: &Vector<D>,
) -> Option<([[f64; D]; D], [f64; D])> {
    let whole = seen(y, n);
    if whole == 0.0 {
        return None;
    }
    let across = x.map(|x| std::array::from_fn(|k| seen(&with(y, k, x), n) / whole));
    Some((across, std::array::from_fn(|c| (place(y, &across[c]) - x[c]).dot(n))))
}

/// What a facet with these corners measures, seen along n, up to a factor.
fn seen<const D: usize>(y: &[Vector<D>; D], n: &Vector<D>) -> f64 {
    determinant(&std::array::from_fn(|k| if k + 1 < D { y[k + 1] - y[0] } else { *n }))
}

fn with<const D: usize>(y: &[Vector<D>; D], k: usize, x: Vector<D>) -> [Vector<D>; D] {
    std::array::from_fn(|c| if c == k { x } else { y[c] })
}
