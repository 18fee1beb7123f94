//! The points of a cohesive interface: those of the common pieces, at each of which it opens and breaks by itself.
//!
//! At a point a = x_A(ξ) − x_B(η), where ξ and η stay with the material, as in a tie. With the normal n of the facet of B and the gap γ that was
//! there at first the opening is δ_n = a·n − γ, and the sliding δ_t = a − (a·n) n.

use super::between::{Between, HeldFacets, held_facets};
use super::broken_friction::Edges;
use super::common_pieces::Facing;
use super::covered::{Covered, LeftOut};
use super::opposite::Opposite;
use super::place::Weights;
use crate::Error;
use crate::geometry::{Surface, Vector, Weighting};
use std::collections::BTreeMap;

/// Two bodies that are held together by an interface that breaks.
pub(crate) struct Cohesion<const D: usize> {
    pub(crate) bodies: [usize; 2],
    /// Points of the mesh that the interface moves, those of the first body before those of the second, each ascending.
    pub(crate) nodes: Vec<u32>,
    pub(crate) of_b: Vec<bool>,
    pub(crate) points: Vec<CohesivePoint>,
    /// Facets of the second body, by the nodes that move each corner.
    pub(super) frames: Vec<[Weights; D]>,
    /// All of it, in area (2D: length).
    pub(crate) area: f64,
    pub(crate) left_out: Option<LeftOut>,
    pub(crate) facets: HeldFacets,
    /// Whether each facet lies on one.
    pub(crate) is_matching: bool,
    /// The largest gap, or overlap, that is kept.
    pub(crate) largest_gap: f64,
}

/// A point of quadrature.
pub(crate) struct CohesivePoint {
    /// What it stands for, in area (2D: length; with axisymmetry that of whole rings).
    pub(crate) measure: f64,
    /// a by the nodes, as places in the list of the interface.
    pub(super) jump: Weights,
    /// The facet opposite to it, as a place in the list of frames, and how far it was above that at first.
    pub(super) frame: u32,
    pub(super) gap: f64,
}

impl<const D: usize> Cohesion<D> {
    /// Of two bodies where they face one another, at these points of the straight mesh.
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
        let (mut found, mut covered, mut pairs) = (Vec::<(usize, Opposite<D>)>::new(), Covered::default(), Vec::new());
        for piece in facing.candidates(false).into_iter().flat_map(|pair| facing.common(pair)) {
            let there = piece.facets[1];
            covered.add(&piece);
            if piece.within > 0.0 {
                pairs.push(piece.facets);
            }
            facing.for_each_opposite(points, weighting, &piece, |point| found.push((there, point)));
        }
        covered.check()?;
        let area: f64 = found.iter().map(|(_, point)| point.measure).sum();
        if area <= 0.0 {
            return Err(facing.untied(between.bodies, "joined by a cohesive interface"));
        }
        let corners = |facet: usize| surface.facets[facet].map(|vertex| surface.nodes_of_vertex(vertex).collect());
        let mut numbers: BTreeMap<(bool, u32), u32> = BTreeMap::new();
        let mut frames: BTreeMap<usize, u32> = BTreeMap::new();
        for (there, point) in &found {
            numbers.extend(point.own.iter().map(|&(node, _)| ((false, node), 0)));
            numbers.extend(point.other.iter().map(|&(node, _)| ((true, node), 0)));
            if frames.insert(*there, 0).is_none() {
                let nodes: [Weights; D] = corners(*there);
                numbers.extend(nodes.iter().flatten().map(|&(node, _)| ((true, node), 0)));
            }
        }
        numbers.values_mut().zip(0..).for_each(|(number, next)| *number = next);
        frames.values_mut().zip(0..).for_each(|(number, next)| *number = next);
        let of_point = |(there, point): &(usize, Opposite<D>)| {
            let mut jump: BTreeMap<u32, f64> = BTreeMap::new();
            point.own.iter().for_each(|&(node, w)| *jump.entry(numbers[&(false, node)]).or_default() += w);
            point.other.iter().for_each(|&(node, w)| *jump.entry(numbers[&(true, node)]).or_default() -= w);
            let jump = jump.into_iter().collect();
            CohesivePoint { measure: point.measure, jump, frame: frames[there], gap: point.gap }
        };
        let in_list = |weights: Weights| weights.into_iter().map(|(node, w)| (numbers[&(true, node)], w)).collect();
        let (piece_count, facets) = (pairs.len(), held_facets(pairs, false));
        Ok(Self {
            bodies: between.bodies,
            nodes: numbers.keys().map(|(_, node)| *node).collect(),
            of_b: numbers.keys().map(|(of_b, _)| *of_b).collect(),
            points: found.iter().map(of_point).collect(),
            frames: frames.keys().map(|&facet| corners(facet).map(in_list)).collect(),
            area,
            left_out: covered.left_out(&facing, weighting, area),
            is_matching: facets.iter().all(|side| side.len() == piece_count),
            facets,
            largest_gap: found.iter().map(|(_, point)| point.gap.abs()).fold(0.0, f64::max),
        })
    }

    /// The slip of a point that takes the place of another, at points of the mesh where both have the same elastic slip.
    pub(crate) fn slip_of(
        &self,
        (before, old): (&Self, &CohesivePoint),
        new: &CohesivePoint,
        points: &[[f64; D]],
        slip: [f64; 2],
    ) -> [f64; 2] {
        let named = |of: &Self, weights: &Weights| -> Weights {
            weights.iter().map(|&(place, weight)| (of.nodes[place as usize], weight)).collect()
        };
        let corners = |of: &Self, point: &CohesivePoint| {
            of.frames[point.frame as usize].each_ref().map(|weights| named(of, weights))
        };
        let [first, second] =
            [(before, old), (self, new)].map(|(of, point)| (named(of, &point.jump), corners(of, point)));
        if slip == [0.0; 2] || first == second {
            return slip;
        }
        let at = |weights: &Weights| {
            weights.iter().fold(Vector::<D>::zeros(), |x, &(node, w)| x + Vector::from(points[node as usize]) * w)
        };
        let [old, new] = [&first.1, &second.1].map(|corners| Edges::new(&corners.each_ref().map(at)));
        let moved = at(&second.0) - at(&first.0);
        old.zip(new).map_or([0.0; 2], |(old, new)| new.multiples(&(old.vector(&slip) + moved)))
    }

    /// Nodes of the first body on which a point hangs.
    pub(crate) fn own_nodes(&self, point: &CohesivePoint) -> impl Iterator<Item = u32> {
        let own = point.jump.iter().filter(|(place, _)| !self.of_b[*place as usize]);
        own.map(|(place, _)| self.nodes[*place as usize])
    }

    /// Nodes on which a point hangs on either side, with their shares in it.
    pub(crate) fn sides(&self, point: &CohesivePoint) -> [Weights; 2] {
        let of = |second: bool, sign: f64| {
            let on_side = point.jump.iter().filter(move |(place, _)| self.of_b[*place as usize] == second);
            on_side.map(|(place, weight)| (self.nodes[*place as usize], sign * weight)).collect()
        };
        [of(false, 1.0), of(true, -1.0)]
    }

    /// Where a point is, on the first body.
    pub(crate) fn position(&self, point: &CohesivePoint, points: &[[f64; D]]) -> Vector<D> {
        let own = point.jump.iter().filter(|(node, _)| !self.of_b[*node as usize]);
        own.fold(Vector::zeros(), |x, &(node, w)| x + Vector::from(points[self.nodes[node as usize] as usize]) * w)
    }
}
