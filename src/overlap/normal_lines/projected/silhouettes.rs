//! Where the spans of a line become one: the edges of notches, for the force of the exactly integrated fiber law.
//!
//! A line beside the inner edge of a notch leaves the body, enters it again, and has two spans, of lengths L₁ and L₂;
//! past the edge it stays inside and has one, L₁ + L₂. The energy per line jumps there from ψ(L₁) + ψ(L₂) to ψ(L₁ + L₂),
//! so that the gradient has, beside the one on the facets, a part on the edge's nodes:
//!
//! ```text
//! ∂w/∂x_a += ∫_e N_a ν [ψ(L₁) + ψ(L₂) − ψ(L₁ + L₂)] dl
//! ```
//!
//! = ∫ N_a ν J dl, with ν across the edge as seen along the lines, away from the notch. J changes with the ends of the
//! spans at a fixed line, ∇J, and with the line, −Σ ∇J; the second derivative gains
//!
//! ```text
//! ∂²w/∂x_a∂x_b += ∫_e [∇_a J g_bᵀ + g_a ∇_b Jᵀ + (q_a g_bᵀ + g_a q_bᵀ)/2] dl + J turn,   g = N ν, q = −N Σ ∇J
//! ```
//!
//! where the last is what two ends of an edge that move sweep together. Side walls of a body that are seen nearly edge-on
//! and warped have such edges. Without this part the forces of two bodies would not balance.

use super::edge_bounds::{Bound, Bounded, Segment, bounded};
use super::edges::{EdgeSide, along, distance, flanks};
use super::projected_facets::end;
use super::projected_facets::{Projection, flat};
use super::projected_pair::ProjectedPair;
use crate::geometry::Vector;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::plane::Plane;
use crate::geometry::primitives::quadrature::ON_CURVE;
use crate::overlap::normal_lines::points::contact_point::ContactPoint;
use crate::overlap::normal_lines::points::edge_terms::{Anchor, SilhouettePoint};
use crate::overlap::pair::surface_point::SurfacePoint;
use crate::sampling::Family;

/// The inner edge of a notch: lines leave through the first facet and enter through the second.
struct SilhouetteEdge<const D: usize> {
    ends: [[f64; 3]; 2],
    facets: [u32; 2],
    anchors: [Anchor; 2],
    nu: Vector<D>,
    /// +1 if ν is a quarter turn ahead of the edge.
    sense: f64,
}

impl<const D: usize> SilhouetteEdge<D> {
    fn at(&self, s: f64) -> [f64; 3] {
        along(&self.ends, s)
    }
}

impl<const D: usize> ProjectedPair<'_, D> {
    /// Every point of the quadrature along the silhouette edges inside the overlap.
    pub(crate) fn silhouettes(
        &self,
        seen: &Projection<D>,
        edges: &[EdgeSide],
        family: &Family<D>,
        plane: Option<&Plane<D>>,
    ) -> Vec<SilhouettePoint<D>> {
        let concave = self.silhouette_edges(seen, edges, family);
        self.in_order(&seen.work, concave.len(), |index, _, found| {
            let edge_seen = &concave[index];
            let projected_area = Aabb::of(&edge_seen.ends.map(|place| flat::<D>(&place)));
            let mut segments: Vec<Segment<D>> = seen
                .near(&projected_area)
                .into_iter()
                .filter(|other| !edge_seen.facets.contains(other))
                .filter_map(|other| Segment::of_facet(&edge_seen.ends, &seen.facets[other as usize]))
                .collect();
            segments.extend(plane.and_then(|plane| self.segment_of_plane(edge_seen, family, plane)));
            let length = if D == 2 { 1.0 } else { distance(&edge_seen.ends) };
            if !seen.work.allows(segments.len()) {
                return;
            }
            for Bounded { part: [from, to], before, behind } in bounded(&segments) {
                let (first, last) = (segments[before].bound, segments[behind].bound);
                let middle = 0.5 * (from + to);
                if !self.is_in_overlap(seen, &edge_seen.at(middle), first, last) {
                    continue;
                }
                let points: &[(f64, f64)] = if D == 2 { &[(0.0, 1.0)] } else { &ON_CURVE };
                for &(place, part) in points {
                    let s = middle + place * (to - from);
                    let [p, q] = edge_seen.anchors;
                    let share = part * (to - from);
                    found.push(SilhouettePoint {
                        weights: if D == 2 { vec![(p, 1.0)] } else { vec![(p, 1.0 - s), (q, s)] },
                        across: edge_seen.nu * (share * length),
                        axes: [family.across([1.0, 0.0]), family.across([0.0, 1.0])],
                        turn: if D == 2 { 0.0 } else { 0.5 * share * edge_seen.sense },
                        spans: self.spans(seen, family, plane, edge_seen, [first, last], s),
                    });
                }
            }
        })
    }

    /// The plane as the lines through an edge meet it.
    fn segment_of_plane<'a>(
        &self,
        edge_seen: &SilhouetteEdge<D>,
        family: &Family<D>,
        plane: &Plane<D>,
    ) -> Option<Segment<'a, D>> {
        let slope = plane.normal.dot(family.direction());
        let ahead = edge_seen.ends.map(|place| -plane.height(&self.place(family, &place)) / slope);
        let bound = Bound::Plane { leaves: slope > 0.0 };
        (slope != 0.0).then_some(Segment { part: [0.0, 1.0], ahead, bound })
    }

    /// Edges between a facet through which lines leave and, farther along on the same side, one through which they enter.
    fn silhouette_edges(&self, seen: &Projection<D>, edges: &[EdgeSide], family: &Family<D>) -> Vec<SilhouetteEdge<D>> {
        let mut silhouette_edges = Vec::new();
        for chunk in edges.chunk_by(|p, q| p.key == q.key) {
            let [entered, left] = chunk else { continue };
            if entered.leaves || !left.leaves {
                continue;
            }
            let facets = [left, entered].map(|side| &seen.facets[side.facet as usize]);
            let ends = left.corners.map(|c| facets[0].corners[c]);
            let Some((across, [out, back])) = flanks(&ends, facets) else { continue };
            let sign = if out.is_before { 1.0 } else { -1.0 };
            if out.is_before != back.is_before || sign * (back.slope - out.slope) <= 0.0 {
                continue;
            }
            let vertices = self.pair.side(facets[0].of_b).facets[facets[0].facet as usize];
            silhouette_edges.push(SilhouetteEdge {
                ends,
                facets: [left.facet, entered.facet],
                anchors: left.corners.map(|c| Anchor::Vertex { of_b: facets[0].of_b, vertex: vertices[c] }),
                nu: family.across(across) * -sign,
                sense: -sign,
            });
        }
        silhouette_edges
    }

    /// Whether lines through a place are inside both sides from one bound to the other.
    fn is_in_overlap(&self, seen: &Projection<D>, place: &[f64; 3], first: Bound<D>, last: Bound<D>) -> bool {
        if first.leaves() || !last.leaves() {
            return false;
        }
        match (first, last) {
            (Bound::Facet(first), Bound::Facet(last)) => self.is_inside_both(seen, first, last, place),
            _ => true,
        }
    }

    /// The spans on both sides of a notch's edge, and the one past it, between these bounds.
    fn spans(
        &self,
        seen: &Projection<D>,
        family: &Family<D>,
        plane: Option<&Plane<D>>,
        edge_seen: &SilhouetteEdge<D>,
        bounds: [Bound<D>; 2],
        s: f64,
    ) -> [ContactPoint<D>; 3] {
        let place = edge_seen.at(s);
        let here = self.place(family, &place);
        // How far ahead of the edge, and where on the boundary.
        let [(from, first), (to, last)] = bounds.map(|bound| match (bound, plane) {
            (Bound::Facet(facet), _) => {
                let w = facet.barycentric(&place);
                (facet.t(&w) - place[2], end(facet, w))
            }
            (Bound::Plane { .. }, plane) => {
                let normal = plane.map_or(Vector::zeros(), |plane| plane.normal);
                let ahead = plane.map_or(0.0, |plane| -plane.height(&here) / normal.dot(family.direction()));
                (ahead, SurfacePoint::Point { point: here + family.direction() * ahead, normal })
            }
        });
        let [out, back] = edge_seen.facets.map(|facet| {
            let facet = &seen.facets[facet as usize];
            end(facet, facet.barycentric(&place))
        });
        let span =
            |sign: f64, length: f64, ends| ContactPoint { weight: sign, across: sign, length, direction: 0, ends };
        [span(1.0, -from, [first, out]), span(1.0, to, [back, last]), span(-1.0, to - from, [first, last])]
    }
}
