//! Spans of the fiber law integrated exactly: quadrature on the common pieces of facets projected along a patch's
//! direction.
//!
//! Across the lines of one direction, an entered facet e and a facet x through which lines leave share a convex piece (an
//! interval in 2D, a polygon in 3D). On it L = t_x − t_e is linear, and so are the barycentric coordinates of both. The
//! piece is cut where L = 0; Gauss points of degree 3 (2D) and 2 (3D; 4 where patches blend) then integrate
//! ψ'(L) N_a of the quadratic ψ exactly, and any smooth ψ to their order. What a third facet hides of a piece is cut out of it.

use super::exact::ExactPair;
use super::exact_creases::Edge;
use super::patch::Patches;
use super::piece::{cut, whole};
use super::quadrature::{for_each_gauss_point, mean};
use super::shadow::{Seen, Shadows};
use super::side::{ImplicitSide, Opponent};
use super::slopes::across;
use super::span::{Crease, End, Span, Spans};
use crate::Error;
use crate::geometry::facet::area_vector;
use crate::geometry::{Pose, Shape, Vector};
use crate::sampling::Family;

/// A facet whose shadow is a smaller part of it is seen edge-on: its barycentric coordinates are lost in rounding, and no
/// line of any measure crosses it.
const EDGE_ON: f64 = 1e-9;

impl<const D: usize> ExactPair<'_, D> {
    /// All spans along the directions of `patches`, and, if asked for, the creases that their tangent needs.
    pub(crate) fn spans(&self, patches: &Patches<D>, creases: bool) -> Result<Option<Spans<D>>, Error> {
        let mut spans = Spans { patches: patches.clone(), ..Spans::default() };
        let fine = patches.are_blended();
        for (direction, d) in patches.directions.iter().enumerate() {
            let family = Family::along(*d, 0, 0);
            let mut add = |mut span: Span<D>| {
                span.weight *= patches.part(direction, &span.ends).value;
                span.direction = direction as u32;
                if span.weight > 0.0 && span.length > 0.0 {
                    spans.spans.push(span);
                }
            };
            let plane = match &self.pair.opponent {
                Opponent::Itself | Opponent::Facets(_) => None,
                Opponent::Implicit(ImplicitSide { shape: Shape::HalfSpace, pose, .. }) => Some(Plane::of(pose)),
                Opponent::Implicit(_) => {
                    let what = "the exact overlap with a curved or signed-distance obstacle; use fibers, or give it as \
                                a polygon or triangle mesh";
                    return Err(Error::Unsupported { what });
                }
            };
            let mut seen = self.seen(&family, false, plane.as_ref());
            if matches!(self.pair.opponent, Opponent::Facets(_)) {
                seen.extend(self.seen(&family, true, None));
            }
            let seen = Shadows::new(seen);
            if let Some(plane) = &plane {
                self.spans_on_plane(&seen, &family, plane, fine, &mut add);
            }
            self.spans_between(&seen, fine, &mut add);
            let edges = self.edge_sides(&seen);
            self.visit_rims(&seen, &edges, &family, plane.as_ref(), |mut rim| {
                for span in &mut rim.spans {
                    span.weight *= patches.part(direction, &span.ends).value;
                    span.direction = direction as u32;
                }
                spans.rims.push(rim);
            });
            if creases {
                let count = |mut crease: Crease<D>, ends: &[End<D>; 2], edge: Option<&Edge<D>>| {
                    crease.factor *= patches.part(direction, ends).value;
                    crease.blend = edge.map_or(0.0, |edge| self.jump_of_part(patches, direction, ends, edge));
                    spans.creases.push(crease);
                };
                self.visit_creases(&seen, &edges, &family, plane.as_ref(), count);
            }
        }
        Ok(Some(spans))
    }

    /// Jump, across an edge at the first end of a span, of the slope of the part that counts for a direction.
    fn jump_of_part(&self, patches: &Patches<D>, direction: usize, ends: &[End<D>; 2], edge: &Edge<D>) -> f64 {
        if !patches.are_blended() {
            return 0.0;
        }
        let d = &patches.directions[direction];
        let [before, behind] = edge.facets.map(|facet| {
            let first = End::Facet { of_b: edge.of_b, facet, weights: [0.0; D] };
            let [corners, _] = patches.part(direction, &[first, ends[1]]).at_corners;
            let corners = corners.and_then(|c| across(&self.pair.side(edge.of_b).corners(facet as usize), d, &c));
            corners.map_or(0.0, |eta| eta.dot(&edge.nu))
        });
        before - behind
    }

    /// Facets of one side that the other side's box, or the half-space, reaches; those seen edge-on are left out: no line
    /// crosses them.
    fn seen(&self, family: &Family<D>, of_b: bool, plane: Option<&Plane<D>>) -> Vec<Seen<D>> {
        let side = self.pair.side(of_b);
        let other = match &self.pair.opponent {
            Opponent::Facets(_) => self.pair.side(!of_b).aabb,
            _ => side.aabb,
        };
        let region = side.aabb.intersection(&other);
        let region = region.inflated(region.rounding());
        let rounding = region.rounding();
        let see = |facet: u32| {
            if plane.is_some_and(|p| side.corners(facet as usize).iter().all(|x| p.height(x) > rounding)) {
                return None;
            }
            let area = area_vector(&side.corners(facet as usize));
            let slope = area.dot(family.direction());
            let corners = side.corners(facet as usize).map(|x| family.view(&x));
            let seen = Seen { of_b, facet, corners, leaves: slope > 0.0 };
            (seen.shadow() > EDGE_ON * area.norm()).then_some(seen)
        };
        side.facets_in(&region).into_iter().filter_map(see).collect()
    }

    fn spans_between(&self, seen: &Shadows<D>, fine: bool, add: &mut impl FnMut(Span<D>)) {
        for (entered, e) in seen.facets.iter().enumerate().filter(|(_, s)| !s.leaves) {
            for left in seen.near(&seen.boxes[entered]) {
                let x = &seen.facets[left as usize];
                if !x.leaves {
                    continue;
                }
                let mut piece = whole::<D>();
                let at_corners: [[f64; D]; D] = e.corners.map(|c| x.barycentric(&c));
                for a in 0..D {
                    piece = cut(&piece, &at_corners.map(|w| -w[a]));
                }
                let lengths: [f64; D] = std::array::from_fn(|c| x.t(&at_corners[c]) - e.corners[c][2]);
                piece = cut(&piece, &lengths.map(|l| -l));
                if piece.len() < D {
                    continue;
                }
                for (piece, share) in seen.visible(piece, [entered as u32, left], &lengths) {
                    if !self.is_inside_both(seen, e, x, &e.place(&mean(&piece))) {
                        continue;
                    }
                    for_each_gauss_point(&piece, fine, |w, part| {
                        let weights = x.barycentric(&e.place(w));
                        let across = share * part * e.shadow();
                        add(Span {
                            weight: across,
                            across,
                            length: (0..D).map(|a| w[a] * lengths[a]).sum(),
                            direction: 0,
                            ends: [end(e, *w), end(x, weights)],
                        });
                    });
                }
            }
        }
    }

    fn spans_on_plane(
        &self,
        seen: &Shadows<D>,
        family: &Family<D>,
        plane: &Plane<D>,
        fine: bool,
        add: &mut impl FnMut(Span<D>),
    ) {
        let slope = plane.normal.dot(family.direction());
        for (index, s) in seen.facets.iter().enumerate().filter(|(_, s)| s.leaves != (slope > 0.0)) {
            let corners = self.pair.a.corners(s.facet as usize);
            // From the facet along the line to the plane; on the body's side of it the length is positive.
            let lengths = corners.map(|x| -plane.height(&x) / slope.abs());
            let piece = cut(&whole::<D>(), &lengths.map(|l| -l));
            if piece.len() < D {
                continue;
            }
            for (piece, share) in seen.visible(piece, [index as u32; 2], &lengths) {
                for_each_gauss_point(&piece, fine, |w, part| {
                    let length = (0..D).map(|a| w[a] * lengths[a]).sum::<f64>();
                    let along = if s.leaves { -length } else { length };
                    let on_facet = (0..D).fold(Vector::zeros(), |sum, a| sum + corners[a] * w[a]);
                    let on_plane = End::Point { point: on_facet + family.direction() * along, normal: plane.normal };
                    let ends = if s.leaves { [on_plane, end(s, *w)] } else { [end(s, *w), on_plane] };
                    let across = share * part * s.shadow();
                    add(Span { weight: across, across, length, direction: 0, ends });
                });
            }
        }
    }
}

/// The surface of a half-space.
pub(super) struct Plane<const D: usize> {
    pub(super) point: Vector<D>,
    pub(super) normal: Vector<D>,
}

impl<const D: usize> Plane<D> {
    pub(super) fn of(pose: &Pose<D>) -> Self {
        let mut up = Vector::zeros();
        up[D - 1] = 1.0;
        Self { point: pose.position.into(), normal: pose.rotate(&up) }
    }

    pub(super) fn height(&self, x: &Vector<D>) -> f64 {
        self.normal.dot(&(x - self.point))
    }
}

pub(super) fn end<const D: usize>(seen: &Seen<D>, weights: [f64; D]) -> End<D> {
    End::Facet { of_b: seen.of_b, facet: seen.facet, weights }
}
