//! A tie: two surfaces that go together, whatever their meshes.
//!
//! Both surfaces are cut into common pieces. At a point of a piece the jump is x_A(ξ) − x_B(η) − γ n, where ξ and η stay with the material,
//! on curved cells on the curve, and γ is the gap that was there at first, along the normal n of the facet of B. The jump vanishes in every
//! rigid motion. Its means over the hat functions ψ_i of one side, g_i = ∫ψ_i jump dA / ∫ψ_i dA, are what is held. The side is the one with the
//! larger facets, so that nothing locks, however stiff the tie is: the jump at points would lock, and so would means of many small facets of
//! first order on one of second order. Where few nodes of the larger facets would let a small patch turn as on a hinge, it is the other one.

use super::common_pieces::{CommonPiece, Facing};
use super::hold::{TiedPoint, firmness};
use super::place::{Weights, of_vertices, position, weights};
use crate::Error;
use crate::geometry::convex_piece::place;
use crate::geometry::facet::area_vector;
use crate::geometry::facet_slopes::slopes;
use crate::geometry::quadrature::for_each_simplex;
use crate::geometry::simplex_rule::degree_5;
use crate::geometry::{Surface, Vector, Weighting};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::OnceLock;

/// Reach by default, by the size of the larger facets.
const REACH: f64 = 0.1;

/// Rounds in which the place opposite to a point is found on a curve, and the part of a facet that is near enough.
const ROUNDS: usize = 12;
const NEAR: f64 = 1e-14;

/// Part of a facet that pieces may cover twice by rounding.
const TWICE: f64 = 1e-6;

/// How firmly means hold the rotations of patches, at least, so that those of the larger facets are taken.
const FIRM: f64 = 0.2;

/// Part of what is tied above which facets that are tied in part are told.
const TOLD: f64 = 0.01;

/// A gap that is rounding, by the largest coordinate.
const CLOSED: f64 = 64.0 * f64::EPSILON;

/// Two bodies that are tied.
pub(crate) struct Tie<const D: usize> {
    pub(crate) bodies: [usize; 2],
    /// Points of the mesh that the tie moves, those of the first body before those of the second, each ascending.
    pub(crate) nodes: Vec<u32>,
    pub(crate) of_b: Vec<bool>,
    pub(crate) rows: Vec<TieRow>,
    /// Facets along whose normals a gap is kept, by the nodes that move each corner.
    pub(super) frames: Vec<[Weights; D]>,
    /// Whether the side of the hat functions is the second body.
    pub(crate) is_second: bool,
    /// How far apart the surfaces may be, or how far they may overlap.
    pub(crate) reach: f64,
    /// What is tied, in area (2D: length).
    pub(crate) area: f64,
    /// The largest gap, or overlap, that is kept.
    pub(crate) largest_gap: f64,
    /// The area of facets that are tied in part, and face the other body farther apart than the reach, and how far apart they are.
    pub(crate) left_out: Option<LeftOut>,
    /// Σ c cᵀ/m over the rows, where no gap is kept.
    pub(super) products: OnceLock<Vec<(u32, u32, f64)>>,
}

/// What is not tied of facets that are tied in part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct LeftOut {
    pub(crate) area: f64,
    pub(crate) farthest: f64,
    pub(crate) reach: f64,
}

/// A mean of the jump that is held.
pub(crate) struct TieRow {
    /// The point of whose hat function it is the mean.
    pub(crate) point: u32,
    /// ∫ψ dA.
    pub(crate) measure: f64,
    /// ∫ψ jump dA by the nodes, as places in the list of the tie; positive on the side of the hat function.
    pub(crate) jump: Weights,
    /// ∫ψ γ dA by frame.
    pub(crate) gaps: Weights,
}

/// Sums of one row while they are made, by point of either body and by facet.
#[derive(Default)]
struct Sums {
    measure: f64,
    jump: BTreeMap<(bool, u32), f64>,
    gaps: BTreeMap<usize, f64>,
}

impl<const D: usize> Tie<D> {
    /// Ties two bodies where they face one another within `reach`, at these points of the straight mesh; 0: a tenth of a facet.
    ///
    /// # Errors
    /// [`Error::Untied`] where they do so nowhere; [`Error::Unsupported`] where faces of one lie above one another within reach.
    pub(crate) fn new(
        surface: &Surface<D>,
        points: &[[f64; D]],
        weighting: Weighting,
        bodies: [usize; 2],
        reach: f64,
    ) -> Result<Self, Error> {
        let vertices = surface.points(points);
        let mut facing = Facing::new(surface, &vertices, reach);
        if reach == 0.0 {
            let size = bodies.map(|body| facet_size(&facing, surface.ranges[body].clone()));
            facing = Facing::new(surface, &vertices, REACH * size[0].max(size[1]));
        }
        let candidates = facing.candidates(bodies);
        let sizes = [0, 1].map(|side| facet_size(&facing, candidates.iter().map(|pair| pair[side])));
        // The first where both are equal.
        let coarser = usize::from(sizes[1] > sizes[0]);
        let build = Build::of(&facing, points, weighting, &candidates, coarser);
        if build.area > 0.0 && firmness(&build.tied) >= FIRM {
            return build.finish(bodies, coarser == 1);
        }
        Build::of(&facing, points, weighting, &candidates, 1 - coarser).finish(bodies, coarser == 0)
    }
}

/// The mean size of facets.
fn facet_size<const D: usize>(facing: &Facing<D>, facets: impl Iterator<Item = usize>) -> f64 {
    let facets: BTreeSet<usize> = facets.collect();
    let sizes = facets.iter().map(|facet| area_vector(&facing.corners(*facet)).norm().powf(1.0 / (D as f64 - 1.0)));
    sizes.sum::<f64>() / facets.len().max(1) as f64
}

struct Build<'a, const D: usize> {
    facing: &'a Facing<'a, D>,
    points: &'a [[f64; D]],
    weighting: Weighting,
    sums: BTreeMap<u32, Sums>,
    area: f64,
    largest_gap: f64,
    /// Which part of every facet is tied.
    covered: BTreeMap<usize, f64>,
    /// Which part of it faces the other body beyond the reach, and how far apart it is.
    beyond: BTreeMap<usize, (f64, f64)>,
    tied: Vec<TiedPoint<D>>,
}

impl<'a, const D: usize> Build<'a, D> {
    /// With the hat functions of one side of the candidates.
    fn of(
        facing: &'a Facing<'a, D>,
        points: &'a [[f64; D]],
        weighting: Weighting,
        candidates: &[[usize; 2]],
        side: usize,
    ) -> Self {
        let mut build = Self {
            facing,
            points,
            weighting,
            sums: BTreeMap::new(),
            area: 0.0,
            largest_gap: 0.0,
            covered: BTreeMap::new(),
            beyond: BTreeMap::new(),
            tied: Vec::new(),
        };
        let mut candidates: Vec<_> = candidates.iter().map(|pair| [pair[side], pair[1 - side]]).collect();
        candidates.sort_unstable();
        candidates.into_iter().filter_map(|pair| facing.common(pair)).for_each(|piece| build.add(&piece));
        build
    }

    fn add(&mut self, piece: &CommonPiece<D>) {
        let (surface, [here, there]) = (self.facing.surface, piece.facets);
        let corners = self.facing.corners(here);
        let size = area_vector(&corners).norm();
        if piece.beyond > 0.0 {
            let (part, farthest) = self.beyond.entry(here).or_default();
            (*part, *farthest) = (*part + piece.beyond, farthest.max(piece.distances[1]));
        }
        if piece.corners.is_empty() {
            return;
        }
        let rule = degree_5(D - 1);
        for_each_simplex(&piece.corners, |simplex, share| {
            *self.covered.entry(here).or_default() += share;
            for (at, weight) in &rule {
                let at: [f64; D] = std::array::from_fn(|c| (0..D).map(|k| at[k] * simplex[k][c]).sum());
                let straight = place(&corners, &at);
                let measure = weight * share * size * self.weighting.at(&straight);
                let own = weights(surface, here, &at);
                let start = std::array::from_fn(|k| (0..D).map(|c| at[c] * piece.across[c][k]).sum());
                let (other, gap) = self.opposite(there, position(&own, self.points), start);
                self.area += measure;
                self.largest_gap = self.largest_gap.max(gap.abs());
                let hats = of_vertices(surface, here, &at);
                let nodes = surface.facets[there].iter().flat_map(|&vertex| surface.nodes_of_vertex(vertex));
                let nodes = nodes.map(|(node, _)| node).collect();
                self.tied.push(TiedPoint { x: straight, measure, hats: hats.clone(), other: nodes });
                for (point, hat) in hats {
                    let sums = self.sums.entry(point).or_default();
                    sums.measure += hat * measure;
                    own.iter().for_each(|(node, w)| *sums.jump.entry((false, *node)).or_default() += hat * measure * w);
                    other
                        .iter()
                        .for_each(|(node, w)| *sums.jump.entry((true, *node)).or_default() -= hat * measure * w);
                    if gap != 0.0 {
                        *sums.gaps.entry(there).or_default() += hat * measure * gap;
                    }
                }
            }
        });
    }

    /// The place of a facet that a point is above, and how far above it the point is, along the normal of the straight facet.
    fn opposite(&self, facet: usize, x: Vector<D>, start: [f64; D]) -> (Weights, f64) {
        let corners = self.facing.corners(facet);
        let area = area_vector(&corners);
        let n = area.normalize();
        let size = area.norm().powf(1.0 / (D as f64 - 1.0));
        let Some((_, gradients)) = slopes(&corners, &n) else { return (Weights::new(), 0.0) };
        let mut at = start;
        let mut found = weights(self.facing.surface, facet, &at);
        for _ in 0..ROUNDS {
            let off = x - position(&found, self.points);
            let aside = off - n * off.dot(&n);
            if aside.norm() <= NEAR * size {
                break;
            }
            at.iter_mut().zip(&gradients).for_each(|(at, gradient)| *at += gradient.dot(&aside));
            found = weights(self.facing.surface, facet, &at);
        }
        // What is left aside of the normal goes with the facet, too.
        let off = x - position(&found, self.points);
        let aside = off - n * off.dot(&n);
        let rest = gradients.map(|gradient| gradient.dot(&aside));
        found.extend(of_vertices(self.facing.surface, facet, &rest));
        let rounding = CLOSED * x.amax().max(size);
        let gap = off.dot(&n);
        (found, if gap.abs() > rounding { gap } else { 0.0 })
    }

    /// What is tied by another pair of facets is not left out.
    fn left_out(&self) -> Option<LeftOut> {
        let (mut area, mut farthest) = (0.0, 0.0_f64);
        for (facet, (part, distance)) in &self.beyond {
            let Some(covered) = self.covered.get(facet) else { continue };
            let corners = self.facing.corners(*facet);
            let centre = corners.iter().sum::<Vector<D>>() / D as f64;
            area += part.min(1.0 - covered).max(0.0) * area_vector(&corners).norm() * self.weighting.at(&centre);
            farthest = farthest.max(*distance);
        }
        (area > TOLD * self.area).then_some(LeftOut { area, farthest, reach: self.facing.given })
    }

    fn finish(self, bodies: [usize; 2], is_second: bool) -> Result<Tie<D>, Error> {
        if self.covered.values().any(|part| *part > 1.0 + TWICE) {
            return Err(Error::Unsupported {
                what: "a tie where faces of one body lie above one another within reach",
            });
        }
        if self.area <= 0.0 {
            let nearest = self.facing.nearest(bodies).unwrap_or(f64::INFINITY);
            return Err(Error::Untied { bodies, distances: [self.facing.given, nearest] });
        }
        let left_out = self.left_out();
        let surface = self.facing.surface;
        let mut numbers: BTreeMap<(bool, u32), u32> = BTreeMap::new();
        let mut frames: BTreeMap<usize, u32> = BTreeMap::new();
        for sums in self.sums.values() {
            // Those of the first body of the pair come first.
            numbers.extend(sums.jump.keys().map(|&(is_other, node)| ((is_other != is_second, node), 0)));
            for &facet in sums.gaps.keys() {
                frames.insert(facet, 0);
                for (node, _) in surface.facets[facet].iter().flat_map(|&vertex| surface.nodes_of_vertex(vertex)) {
                    numbers.insert((!is_second, node), 0);
                }
            }
        }
        numbers.values_mut().zip(0..).for_each(|(number, next)| *number = next);
        frames.values_mut().zip(0..).for_each(|(number, next)| *number = next);
        let row = |(&point, sums): (&u32, &Sums)| TieRow {
            point,
            measure: sums.measure,
            jump: sums
                .jump
                .iter()
                .map(|(&(is_other, node), w)| (numbers[&(is_other != is_second, node)], *w))
                .collect(),
            gaps: sums.gaps.iter().map(|(facet, gap)| (frames[facet], *gap)).collect(),
        };
        let corner = |vertex: u32| {
            surface.nodes_of_vertex(vertex).map(|(node, w)| (numbers[&(!is_second, node)], w)).collect::<Weights>()
        };
        Ok(Tie {
            bodies,
            nodes: numbers.keys().map(|(_, node)| *node).collect(),
            of_b: numbers.keys().map(|(of_b, _)| *of_b).collect(),
            rows: self.sums.iter().filter(|(_, sums)| sums.measure > 0.0).map(row).collect(),
            frames: frames.keys().map(|facet| surface.facets[*facet].map(corner)).collect(),
            is_second,
            reach: self.facing.reach,
            area: self.area,
            largest_gap: self.largest_gap,
            left_out,
            products: OnceLock::new(),
        })
    }
}
