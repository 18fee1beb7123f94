//! A tie: two surfaces that go together, whatever their meshes.
//!
//! Both surfaces are cut into common pieces. At a point of a piece the jump is x_A(ξ) − x_B(η) − γ n, where ξ and η stay with the material,
//! on curved cells on the curve, and γ is the gap that was there at first, along the normal n of the facet of B. The jump vanishes in every
//! rigid motion. Its means over the hat functions ψ_i of one side, g_i = ∫ψ_i jump dA / ∫ψ_i dA, are what is held. The side is the one with the
//! larger facets, so that nothing locks, however stiff the tie is: the jump at points would lock, and so would means of many small facets of
//! first order on one of second order. Where few nodes of the larger facets would let a small patch turn as on a hinge, it is the other one.

use super::between::{Between, HeldFacets, held_facets};
use super::common_pieces::{CommonPiece, Facing};
use super::covered::{Covered, LeftOut};
use super::hold::{TiedPoint, firmness};
use super::opposite::Opposite;
use super::place::{Weights, of_vertices, place_of};
use super::sums_by_node::SumsByNode;
use crate::Error;
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::{Surface, Vector, Weighting};
use std::collections::BTreeMap;
use std::rc::Rc;
use std::sync::OnceLock;

/// How firmly means hold the rotations of patches, at least, so that those of the larger facets are taken.
const FIRM: f64 = 0.2;

/// Two bodies that are tied.
pub(crate) struct Tie<const D: usize> {
    pub(crate) bodies: [usize; 2],
    /// Points of the mesh that the tie moves, those of the first body before those of the second, each ascending.
    pub(crate) nodes: Vec<u32>,
    pub(crate) of_b: Vec<bool>,
    pub(crate) rows: Vec<TieRow<D>>,
    /// Facets along whose normals a gap is kept, by the nodes that move each corner.
    pub(super) frames: Vec<[Weights; D]>,
    /// Whether the side of the hat functions is the second body.
    pub(crate) is_second: bool,
    /// How far apart the surfaces may be, or how far they may overlap.
    pub(crate) reach: f64,
    /// The same without what rounding adds.
    pub(crate) given: f64,
    /// What is tied, in area (2D: length).
    pub(crate) area: f64,
    /// The largest gap, or overlap, that is kept.
    pub(crate) largest_gap: f64,
    /// The area of facets that are tied in part, and face the other body farther apart than the reach, and how far apart they are.
    pub(crate) left_out: Option<LeftOut>,
    pub(crate) facets: HeldFacets,
    /// What brings the second body to the first, and how far the first is then to be from the second.
    pub(crate) period: Vector<D>,
    pub(crate) jump: Vector<D>,
    /// Σ c cᵀ/m over the rows, where no gap is kept.
    pub(super) products: OnceLock<Vec<(u32, u32, f64)>>,
}

/// A mean of the jump that is held.
pub(crate) struct TieRow<const D: usize> {
    /// The point of whose hat function it is the mean.
    pub(crate) point: u32,
    /// ∫ψ dA.
    pub(crate) measure: f64,
    /// ∫ψ jump dA by the nodes, as places in the list of the tie; positive on the side of the hat function.
    pub(crate) jump: Weights,
    /// ∫ψ γ dA by frame.
    pub(crate) gaps: Weights,
    /// Mean normal of the straight facets about it, of the side of the hat function.
    pub(super) normal: Vector<D>,
    /// Where its point is without deformation, on curved cells on the curve.
    pub(super) place: Vector<D>,
}

/// Sums of one row while they are made, by point of either body and by facet.
struct Sums<const D: usize> {
    /// One of the facets about the point.
    facet: usize,
    measure: f64,
    normal: Vector<D>,
    jump: SumsByNode,
    gaps: BTreeMap<usize, f64>,
}

impl<const D: usize> Default for Sums<D> {
    fn default() -> Self {
        Self { facet: 0, measure: 0.0, normal: Vector::zeros(), jump: SumsByNode::default(), gaps: BTreeMap::new() }
    }
}

impl<const D: usize> Tie<D> {
    /// Ties two bodies where they face one another, at these points of the straight mesh.
    ///
    /// # Errors
    /// [`Error::Untied`] where they do so nowhere; [`Error::Unsupported`] where faces of one lie above one another within reach.
    pub(crate) fn new(
        surface: &Surface<D>,
        points: &[[f64; D]],
        weighting: Weighting,
        between: &Between,
    ) -> Result<Self, Error> {
        let vertices = surface.points(points);
        let facing = Facing::of_bodies(surface, &vertices, between);
        let candidates = facing.candidates(false);
        let sizes = [0, 1].map(|side| facing.facet_size(candidates.iter().map(|pair| pair[side])));
        // The first where both are equal.
        let coarser = usize::from(sizes[1] > sizes[0]);
        let build = Build::of(&facing, points, weighting, &candidates, coarser);
        if build.area > 0.0 && firmness(&build.tied) >= FIRM {
            return build.finish(between.bodies, coarser == 1);
        }
        Build::of(&facing, points, weighting, &candidates, 1 - coarser).finish(between.bodies, coarser == 0)
    }
}

struct Build<'a, const D: usize> {
    facing: &'a Facing<'a, D>,
    points: &'a [[f64; D]],
    weighting: Weighting,
    sums: BTreeMap<u32, Sums<D>>,
    area: f64,
    largest_gap: f64,
    covered: Covered,
    /// Facets that have something in common.
    pairs: Vec<[usize; 2]>,
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
        let (sums, covered, pairs, tied) = (BTreeMap::new(), Covered::default(), Vec::new(), Vec::new());
        let mut build = Self { facing, points, weighting, sums, area: 0.0, largest_gap: 0.0, covered, pairs, tied };
        let mut candidates: Vec<_> = candidates.iter().map(|pair| [pair[side], pair[1 - side]]).collect();
        candidates.sort_unstable();
        candidates.into_iter().flat_map(|pair| facing.common(pair)).for_each(|piece| build.add(&piece));
        build
    }

    fn add(&mut self, piece: &CommonPiece<D>) {
        let Self { facing, points, weighting, sums, area, largest_gap, covered, pairs, tied } = self;
        let (surface, [here, there]) = (facing.surface, piece.facets);
        covered.add(piece);
        if piece.within > 0.0 {
            pairs.push(piece.facets);
        }
        let normal = area_vector(&facing.corners(here)).try_normalize(0.0).unwrap_or_else(Vector::zeros);
        let nodes = surface.facets[there].iter().flat_map(|&vertex| surface.nodes_of_vertex(vertex));
        let nodes: Rc<[u32]> = nodes.map(|(node, _)| node).collect();
        // All points of a piece hang on the same nodes.
        let mut places = Vec::new();
        facing.for_each_opposite(points, *weighting, piece, |point| {
            let Opposite { straight, measure, own, other, gap, at } = point;
            *area += measure;
            *largest_gap = largest_gap.max(gap.abs());
            let hats = of_vertices(surface, here, &at);
            places.resize(places.len().max(hats.len() * (own.len() + other.len())), 0);
            let mut places = places.iter_mut();
            for &(point, hat) in &hats {
                let sums = sums.entry(point).or_default();
                sums.facet = here;
                sums.measure += hat * measure;
                sums.normal += normal * (hat * measure);
                let own = own.iter().map(|&(node, w)| ((false, node), hat * measure * w));
                let other = other.iter().map(|&(node, w)| ((true, node), -(hat * measure * w)));
                for ((key, value), last) in own.chain(other).zip(&mut places) {
                    sums.jump.add(key, value, last);
                }
                if gap != 0.0 {
                    *sums.gaps.entry(there).or_default() += hat * measure * gap;
                }
            }
            tied.push(TiedPoint { x: straight, measure, hats, other: Rc::clone(&nodes) });
        });
    }

    fn finish(mut self, bodies: [usize; 2], is_second: bool) -> Result<Tie<D>, Error> {
        self.covered.check()?;
        if self.area <= 0.0 {
            return Err(self.facing.untied(bodies, "tied"));
        }
        let left_out = self.covered.left_out(self.facing, self.weighting, self.area);
        let surface = self.facing.surface;
        self.sums.values_mut().for_each(|sums| sums.jump.sort());
        let mut numbers: BTreeMap<(bool, u32), u32> = BTreeMap::new();
        let mut frames: BTreeMap<usize, u32> = BTreeMap::new();
        for sums in self.sums.values() {
            // Those of the first body of the pair come first.
            numbers.extend(sums.jump.entries.iter().map(|&((is_other, node), _)| ((is_other != is_second, node), 0)));
            for &facet in sums.gaps.keys() {
                frames.insert(facet, 0);
                for (node, _) in surface.facets[facet].iter().flat_map(|&vertex| surface.nodes_of_vertex(vertex)) {
                    numbers.insert((!is_second, node), 0);
                }
            }
        }
        numbers.values_mut().zip(0..).for_each(|(number, next)| *number = next);
        frames.values_mut().zip(0..).for_each(|(number, next)| *number = next);
        let row = |(&point, sums): (&u32, &Sums<D>)| TieRow {
            point,
            measure: sums.measure,
            jump: sums
                .jump
                .entries
                .iter()
                .map(|((is_other, node), w)| (numbers[&(*is_other != is_second, *node)], *w))
                .collect(),
            gaps: sums.gaps.iter().map(|(facet, gap)| (frames[facet], *gap)).collect(),
            place: place_of(surface, sums.facet, point, self.points),
            normal: sums.normal.try_normalize(0.0).unwrap_or(sums.normal),
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
            given: self.facing.given,
            area: self.area,
            largest_gap: self.largest_gap,
            left_out,
            facets: held_facets(self.pairs, is_second),
            period: self.facing.period(),
            jump: Vector::zeros(),
            products: OnceLock::new(),
        })
    }
}
