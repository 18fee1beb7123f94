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

use super::edges::{EdgeSide, along, distance, flanks};
use super::projected_facets::{ProjectedFacet, Projection, flat};
use crate::geometry::Vector;
use crate::geometry::aabb::Aabb;
use crate::geometry::plane::Plane;
use crate::geometry::quadrature::ON_CURVE;
use crate::overlap::exact::clipping::volume::ExactPair;
use crate::overlap::exact::projection::projected_facets::end;
use crate::overlap::pair::surface_point::SurfacePoint;
use crate::overlap::points::contact_point::ContactPoint;
use crate::overlap::points::edge_terms::{Anchor, SilhouettePoint};
use crate::sampling::Family;

/// A shorter part of an edge is rounding.
const LEAST: f64 = 1e-14;

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

/// What bounds a line at a place: a facet, or the plane.
#[derive(Clone, Copy)]
enum Bound<'a, const D: usize> {
    Facet(&'a ProjectedFacet<D>),
    Plane { leaves: bool },
}

impl<const D: usize> ExactPair<'_, D> {
    /// Every point of the quadrature along the silhouette edges inside the overlap.
    pub(crate) fn silhouettes(
        &self,
        seen: &Projection<D>,
        edges: &[EdgeSide],
        family: &Family<D>,
        plane: Option<&Plane<D>>,
    ) -> Vec<SilhouettePoint<D>> {
        let concave = self.silhouette_edges(seen, edges, family);
        self.in_order(concave.len(), |index, _, found| {
            let edge_seen = &concave[index];
            let projected_area = Aabb::of(&edge_seen.ends.map(|place| flat::<D>(&place)));
            let near: Vec<&ProjectedFacet<D>> = seen
                .near(&projected_area)
                .into_iter()
                .filter(|other| !edge_seen.facets.contains(other))
                .map(|other| &seen.facets[other as usize])
                .collect();
            let breaks = breaks(edge_seen, &near);
            let length = if D == 2 { 1.0 } else { distance(&edge_seen.ends) };
            for pair in breaks.windows(2).filter(|pair| pair[1] - pair[0] > LEAST) {
                let (from, to) = (pair[0], pair[1]);
                let points: &[(f64, f64)] = if D == 2 { &[(0.0, 1.0)] } else { &ON_CURVE };
                for &(place, part) in points {
                    let s = 0.5 * (from + to) + place * (to - from);
                    let Some(spans) = self.parted(seen, family, plane, edge_seen, &near, s) else { continue };
                    let [p, q] = edge_seen.anchors;
                    let share = part * (to - from);
                    found.push(SilhouettePoint {
                        weights: if D == 2 { vec![(p, 1.0)] } else { vec![(p, 1.0 - s), (q, s)] },
                        across: edge_seen.nu * (share * length),
                        axes: [family.across([1.0, 0.0]), family.across([0.0, 1.0])],
                        turn: if D == 2 { 0.0 } else { 0.5 * share * edge_seen.sense },
                        spans,
                    });
                }
            }
        })
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

    /// The spans on both sides of a notch's edge, if it lies in the overlap.
    fn parted(
        &self,
        seen: &Projection<D>,
        family: &Family<D>,
        plane: Option<&Plane<D>>,
        edge_seen: &SilhouetteEdge<D>,
        near: &[&ProjectedFacet<D>],
        s: f64,
    ) -> Option<[ContactPoint<D>; 3]> {
        let place = edge_seen.at(s);
        let mut before: Option<(f64, Bound<D>)> = None;
        let mut behind = before;
        let mut bound = |t: f64, bound| {
            if t < place[2] && before.is_none_or(|(nearest, _)| t > nearest) {
                before = Some((t, bound));
            } else if t >= place[2] && behind.is_none_or(|(nearest, _)| t < nearest) {
                behind = Some((t, bound));
            }
        };
        for facet in near {
            let w = facet.barycentric(&place);
            if w.iter().all(|w| *w >= 0.0) {
                bound(facet.t(&w), Bound::Facet(facet));
            }
        }
        let here = self.place(family, &place);
        if let Some(plane) = plane {
            let slope = plane.normal.dot(family.direction());
            if slope != 0.0 {
                bound(place[2] - plane.height(&here) / slope, Bound::Plane { leaves: slope > 0.0 });
            }
        }
        let ((from, first), (to, last)) = (before?, behind?);
        let leaves = |bound: &Bound<D>| match bound {
            Bound::Facet(facet) => facet.leaves,
            Bound::Plane { leaves } => *leaves,
        };
        if leaves(&first) || !leaves(&last) {
            return None;
        }
        if let (Bound::Facet(first), Bound::Facet(last)) = (&first, &last)
            && !self.is_inside_both(seen, first, last, &place)
        {
            return None;
        }
        let end_of = |t: f64, bound: &Bound<D>| match (bound, plane) {
            (Bound::Facet(facet), _) => end(facet, facet.barycentric(&place)),
            (_, plane) => SurfacePoint::Point {
                point: here + family.direction() * (t - place[2]),
                normal: plane.map_or(Vector::zeros(), |plane| plane.normal),
            },
        };
        let [out, back] = edge_seen.facets.map(|facet| {
            let facet = &seen.facets[facet as usize];
            end(facet, facet.barycentric(&place))
        });
        let (first, last) = (end_of(from, &first), end_of(to, &last));
        let span =
            |sign: f64, length: f64, ends| ContactPoint { weight: sign, across: sign, length, direction: 0, ends };
        let (t, length) = (place[2], to - from);
        Some([span(1.0, t - from, [first, out]), span(1.0, to - t, [back, last]), span(-1.0, length, [first, last])])
    }
}

/// Places along an edge, from 0 to 1, between which the same facets bound its lines.
fn breaks<const D: usize>(edge_seen: &SilhouetteEdge<D>, near: &[&ProjectedFacet<D>]) -> Vec<f64> {
    let mut breaks = vec![0.0, 1.0];
    if D == 2 {
        return breaks;
    }
    let mut cut = |p: f64, q: f64| {
        if (p > 0.0) != (q > 0.0) {
            breaks.push(p / (p - q));
        }
    };
    let [p, q] = edge_seen.ends;
    let heights: Vec<[f64; 2]> =
        near.iter().map(|f| [p, q].map(|place| f.t(&f.barycentric(&place)) - place[2])).collect();
    for (n, (facet, height)) in near.iter().zip(&heights).enumerate() {
        facet.barycentric(&p).into_iter().zip(facet.barycentric(&q)).for_each(|(a, b)| cut(a, b));
        cut(height[0], height[1]);
        for other in &heights[..n] {
            cut(height[0] - other[0], height[1] - other[1]);
        }
    }
    breaks.sort_unstable_by(f64::total_cmp);
    breaks
}
