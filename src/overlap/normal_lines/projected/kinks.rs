//! Kinks of the penetration depth L, for the tangent of the exactly integrated fiber law.
//!
//! The force is ∫ ψ'(L) ∂L/∂x across the lines. Where the integrand jumps along a curve that moves with the nodes, its
//! derivative gains what the curve sweeps. There are two such curves:
//!
//! ```text
//! an edge e between two facets of one side        K_ab += ∫_e ψ' s (N_a ν)(N_b ν)ᵀ dl,   s = (∇L⁺ − ∇L⁻)·ν
//! the meeting of two facets, one of each side,    K    −= ∫   ψ' g gᵀ / |m_f − m_g| dl,  g = ∂(t_f − t_g)/∂x
//! through which lines run the same way
//! ```
//!
//! with ν across the edge as seen along the lines, + being the side to which it points. Where patches blend, the slope of
//! the part that counts jumps there too. On the second, the nearer end of the span passes from one facet to the other. Where a span shrinks to nothing there is no jump, since ψ'(0) = 0.

use super::edges::Edge;
use super::edges::{EdgeSide, along, distance, flanks};
use super::projected_facets::end;
use super::projected_facets::{ProjectedFacet, Projection, flat};
use super::projected_pair::ProjectedPair;
use crate::geometry::Vector;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::convex_piece::{Corners, cut, whole, zeros};
use crate::geometry::primitives::facet_slopes::slopes;
use crate::geometry::primitives::plane::Plane;
use crate::geometry::primitives::quadrature::ON_CURVE;
use crate::overlap::normal_lines::points::edge_terms::{Anchor, GapKink};
use crate::overlap::pair::surface_point::SurfacePoint;
use crate::ranks::packed;
use crate::sampling::Family;
use smallvec::{SmallVec, smallvec};

/// Bounds of the part of a curve over which a facet lies: its own edges, and the two ends of the lines.
const MOST_BOUNDS: usize = 6;

/// A straight curve (2D: a point, twice) as seen along the lines, on which L has a kink at one of its ends.
struct KinkCurve<const D: usize> {
    ends: [[f64; 3]; 2],
    /// Whether lines leave there.
    leaves: bool,
    /// Facets that meet in it.
    facets: Vec<u32>,
    factor: f64,
    /// g at both ends, linear between.
    gradient: Vec<(Anchor, [Vector<D>; 2])>,
    /// Where it is the edge of a side.
    edge: Option<Edge<D>>,
}

packed!(KinkCurve<D> { ends, leaves, facets, factor, gradient, edge });

impl<const D: usize> KinkCurve<D> {
    fn at(&self, s: f64) -> [f64; 3] {
        along(&self.ends, s)
    }

    /// Where on it the line's other end is at linear depth, `bounds` positive, in [0, 1].
    fn clipped(&self, bounds: impl Fn(f64) -> SmallVec<[f64; MOST_BOUNDS]>) -> Option<[f64; 2]> {
        let (mut from, mut to) = (0.0f64, 1.0f64);
        for (p, q) in bounds(0.0).into_iter().zip(bounds(1.0)) {
            match (p > 0.0, q > 0.0) {
                (true, true) => {}
                (false, false) => return None,
                (true, false) => to = to.min(p / (p - q)),
                (false, true) => from = from.max(p / (p - q)),
            }
        }
        (from < to).then_some([from, to])
    }

    /// Whether it is where a facet meets the plane of a half-space.
    fn is_on_plane(&self) -> bool {
        self.gradient.iter().any(|(anchor, _)| matches!(anchor, Anchor::Obstacle))
    }

    /// The parts of an interval of it whose lines meet no other facet over this depth; `near` are those that may be over it.
    fn visible(
        &self,
        seen: &Projection<D>,
        near: &[u32],
        interval: [f64; 2],
        depth: &dyn Fn(f64) -> f64,
        other: Option<u32>,
    ) -> SmallVec<[[f64; 2]; 4]> {
        let mut visible: SmallVec<[[f64; 2]; 4]> = SmallVec::from_slice(&[interval]);
        let is_own = |facet: u32| self.facets.contains(&facet) || other == Some(facet);
        for other in near.iter().copied().filter(|&facet| !is_own(facet)) {
            let h = &seen.facets[other as usize];
            let bounds = |s: f64| {
                let p = self.at(s);
                let w = h.barycentric(&p);
                let ahead = if self.leaves { p[2] - h.t(&w) } else { h.t(&w) - p[2] };
                w.into_iter().chain([ahead, depth(s) - ahead]).collect()
            };
            let Some([from, to]) = self.clipped(bounds) else { continue };
            visible = visible
                .into_iter()
                .flat_map(|[low, high]| [[low, high.min(from)], [low.max(to), high]])
                .filter(|[low, high]| low < high)
                .collect();
        }
        visible
    }
}

impl<const D: usize> ProjectedPair<'_, D> {
    /// Every kink seen along `family`; `finish` is given each with the ends of the lines there, and the edge it is on.
    pub(crate) fn kinks(
        &self,
        seen: &Projection<D>,
        edges: &[EdgeSide],
        family: &Family<D>,
        plane: Option<&Plane<D>>,
        finish: impl Fn(GapKink<D>, &[SurfacePoint<D>; 2], Option<&Edge<D>>) -> GapKink<D> + Sync,
    ) -> Vec<GapKink<D>> {
        let mut curves = self.edges(seen, edges, family);
        curves.extend(self.in_order(&seen.work, seen.facets.len(), |facet, _, found| {
            self.meetings(seen, facet, family, plane, found);
        }));
        let slope_of_plane = plane.map_or(0.0, |plane| plane.normal.dot(family.direction()));
        self.in_order(&seen.work, curves.len(), |index, _, found| {
            let curve = &curves[index];
            let Some(&first) = curve.facets.first() else { return };
            let f = &seen.facets[first as usize];
            let near = seen.near(&Aabb::of(&curve.ends.map(|place| flat::<D>(&place))));
            let mut add = |interval: [f64; 2], depth: &dyn Fn(f64) -> f64, other: Option<u32>| {
                for [from, to] in curve.visible(seen, &near, interval, depth, other) {
                    let middle = 0.5 * (from + to);
                    let x = other.map(|other| &seen.facets[other as usize]);
                    // Where facets of both sides meet, both are entered, or left, at once.
                    let is_edge = curve.facets.iter().all(|&g| seen.facets[g as usize].of_b == f.of_b);
                    if is_edge
                        && !curve.is_on_plane()
                        && x.is_some_and(|x| !self.is_inside_both(seen, f, x, &curve.at(middle)))
                    {
                        continue;
                    }
                    let width = if D == 2 { 1.0 } else { distance(&curve.ends) * (to - from) };
                    for (place, part) in ON_CURVE {
                        let s = middle + place * (to - from);
                        let gradient = curve.gradient.iter().map(|(anchor, g)| (*anchor, g[0] + (g[1] - g[0]) * s));
                        let (weight, gradient) = (part * width, gradient.collect());
                        let (place, length, weighting) = (curve.at(s), depth(s), self.pair.weighting);
                        // The weight is that of the middle of the line, which moves half as far as its end.
                        let back = if curve.leaves { -1.0 } else { 1.0 };
                        let along_line = family.direction();
                        let at_middle = self.place(family, &place) + along_line * (0.5 * back * length);
                        let factor = curve.factor * weighting.at(&at_middle);
                        let blend = -0.5 * back * curve.factor * along_line.dot(&weighting.gradient());
                        let kink = GapKink { weight, length, factor, blend, gradient };
                        let none = SurfacePoint::Point { point: Vector::zeros(), normal: Vector::zeros() };
                        let ends = [end(f, f.barycentric(&place)), x.map_or(none, |x| end(x, x.barycentric(&place)))];
                        found.push(finish(kink, &ends, curve.edge.as_ref()));
                    }
                }
            };
            if let Some(plane) = plane.filter(|_| curve.leaves != (slope_of_plane > 0.0)) {
                let depth = |s: f64| -plane.height(&self.place(family, &curve.at(s))) / slope_of_plane.abs();
                if let Some(interval) = curve.clipped(|s| smallvec![depth(s)]) {
                    add(interval, &depth, None);
                }
            }
            for &other in &near {
                let x = &seen.facets[other as usize];
                if x.leaves == curve.leaves || curve.facets.contains(&other) {
                    continue;
                }
                let depth = |s: f64| {
                    let p = curve.at(s);
                    let ahead = x.t(&x.barycentric(&p)) - p[2];
                    if curve.leaves { -ahead } else { ahead }
                };
                let bounds = |s: f64| {
                    let mut bounds = SmallVec::from_slice(&x.barycentric(&curve.at(s)));
                    bounds.push(depth(s));
                    // Above the plane of a half-space it is the plane that bounds the line. What lies in it is below.
                    if let Some(plane) = plane {
                        let place = curve.at(s);
                        let far = [place[0], place[1], x.t(&x.barycentric(&place))];
                        let below = |end: [f64; 3]| -plane.height(&self.place(family, &end));
                        bounds.push(below(far));
                        bounds.extend((!curve.is_on_plane()).then(|| below(place)));
                    }
                    bounds
                };
                let Some(interval) = curve.clipped(bounds) else { continue };
                add(interval, &depth, Some(other));
            }
        })
    }

    /// The point of space that is seen at `place`.
    pub(crate) fn place(&self, family: &Family<D>, place: &[f64; 3]) -> Vector<D> {
        family.across([place[0], place[1]]) + family.direction() * place[2]
    }

    /// Edges (2D: nodes) between two seen facets of one side through which lines run the same way.
    fn edges(&self, seen: &Projection<D>, sides: &[EdgeSide], family: &Family<D>) -> Vec<KinkCurve<D>> {
        let mut curves = Vec::new();
        for chunk in sides.chunk_by(|p, q| p.key == q.key && p.leaves == q.leaves).filter(|chunk| chunk.len() == 2) {
            let EdgeSide { key: (_, of_b), leaves, facet: index, corners } = chunk[0];
            let facet = &seen.facets[index as usize];
            let vertices = self.pair.side(of_b).facets[facet.facet as usize];
            let ends = corners.map(|c| facet.corners[c]);
            let both = [facet, &seen.facets[chunk[1].facet as usize]];
            let Some((across, jump, is_before)) = kink(&ends, both) else { continue };
            let nu = family.across(across);
            let anchors = corners.map(|c| Anchor::Vertex { of_b, vertex: vertices[c] });
            let none = Vector::zeros();
            let [first, second] = both.map(|facet| facet.facet);
            let facets = if is_before { [first, second] } else { [second, first] };
            curves.push(KinkCurve {
                edge: Some(Edge { of_b, facets, nu }),
                ends,
                leaves,
                facets: vec![index, chunk[1].facet],
                factor: if leaves { jump } else { -jump },
                gradient: if D == 2 {
                    vec![(anchors[0], [nu, nu])]
                } else {
                    vec![(anchors[0], [nu, none]), (anchors[1], [none, nu])]
                },
            });
        }
        curves
    }

    /// Where facets of both sides (or a facet and the plane) meet through which lines run the same way.
    fn meetings(
        &self,
        seen: &Projection<D>,
        index: usize,
        family: &Family<D>,
        plane: Option<&Plane<D>>,
        curves: &mut Vec<KinkCurve<D>>,
    ) {
        let d = family.direction();
        let f = &seen.facets[index];
        let corners = self.pair.side(f.of_b).corners(f.facet as usize);
        let Some((m, _)) = slopes(&corners, d) else { return };
        let mut meet = |piece: Corners<D>, heights: [f64; D], other: &Other<D>| {
            let zeros = zeros(&piece, &heights);
            let Some((first, last)) = zeros.first().zip(zeros.last()) else { return };
            let apart = (m - other.m).norm();
            let ends = [first, last].map(|w| f.place(w));
            if apart == 0.0 || (D > 2 && distance(&ends) == 0.0) {
                return;
            }
            let vertices = self.pair.side(f.of_b).facets[f.facet as usize];
            let mut gradient: Vec<(Anchor, [Vector<D>; 2])> = (0..D)
                .map(|a| (Anchor::Vertex { of_b: f.of_b, vertex: vertices[a] }, [m * first[a], m * last[a]]))
                .collect();
            for (anchor, weight) in &other.anchors {
                gradient.push((*anchor, ends.map(|place| -other.m * weight(&place))));
            }
            let facets = [index as u32].into_iter().chain(other.facet).collect();
            let factor = -1.0 / apart;
            curves.push(KinkCurve { ends, leaves: f.leaves, facets, factor, gradient, edge: None });
        };
        if let Some(plane) = plane.filter(|plane| f.leaves == (plane.normal.dot(d) > 0.0)) {
            let slope = plane.normal.dot(d);
            let anchors: Vec<(Anchor, Weight)> = vec![(Anchor::Obstacle, Box::new(|_| 1.0))];
            let other = Other { facet: None, m: plane.normal / slope, anchors };
            meet(whole::<D>(), corners.map(|x| plane.height(&x) / slope), &other);
        }
        if f.of_b {
            return;
        }
        let [low, high] = seen.ranges[index];
        for near in seen.near(&seen.boxes[index]) {
            let g = &seen.facets[near as usize];
            let [least, largest] = seen.ranges[near as usize];
            if g.leaves != f.leaves || !g.of_b || least > high || largest < low {
                continue;
            }
            let side = self.pair.side(g.of_b);
            let Some((m, _)) = slopes(&side.corners(g.facet as usize), d) else { continue };
            let at_corners: [[f64; D]; D] = f.corners.map(|c| g.barycentric(&c));
            if (0..D).any(|a| at_corners.iter().all(|w| w[a] <= 0.0)) {
                continue;
            }
            let piece = (0..D).fold(whole::<D>(), |piece, a| cut(&piece, &at_corners.map(|w| -w[a])));
            let heights = std::array::from_fn(|c| f.corners[c][2] - g.t(&at_corners[c]));
            let anchors = (0..D).map(|a| {
                let anchor = Anchor::Vertex { of_b: g.of_b, vertex: side.facets[g.facet as usize][a] };
                (anchor, Box::new(move |place: &[f64; 3]| g.barycentric(place)[a]) as Weight)
            });
            meet(piece, heights, &Other { facet: Some(near), m, anchors: anchors.collect() });
        }
    }
}

/// Weight of an anchor at a place.
type Weight<'a> = Box<dyn Fn(&[f64; 3]) -> f64 + 'a>;

/// What a facet meets: another, or the plane.
struct Other<'a, const D: usize> {
    facet: Option<u32>,
    m: Vector<D>,
    anchors: Vec<(Anchor, Weight<'a>)>,
}

/// Unit vector across an edge in the plane across the lines, the jump of the slope of t along it, and whether the first
/// facet is on the side to which the vector points; `None` if both are on one side.
fn kink<const D: usize>(ends: &[[f64; 3]; 2], facets: [&ProjectedFacet<D>; 2]) -> Option<([f64; 2], f64, bool)> {
    let (across, [first, second]) = flanks(ends, facets)?;
    if first.is_before == second.is_before {
        return None;
    }
    let jump = if first.is_before { first.slope - second.slope } else { second.slope - first.slope };
    jump.is_finite().then_some((across, jump, first.is_before))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slopes_jump_across_an_edge() {
        let ends = [[0.0, 0.0, 1.0], [3.0, 4.0, 2.0]];
        let seen =
            |r: [f64; 3]| ProjectedFacet::<3> { of_b: false, facet: 0, corners: [ends[0], ends[1], r], leaves: true };
        // Behind the edge t does not change across it, before it by 2 for every unit.
        let (f, g) = (seen([-4.0, 3.0, 11.0]), seen([4.0, -3.0, 1.0]));
        let (across, jump, first) = kink(&ends, [&f, &g]).unwrap();
        assert!((across[0] + 0.8).abs() < 1e-15 && (across[1] - 0.6).abs() < 1e-15);
        assert!((jump - 2.0).abs() < 1e-15);
        assert!(first);
    }
}
