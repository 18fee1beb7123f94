//! ContactPoints of the fiber law integrated exactly: quadrature on the common pieces of facets projected along a patch's
//! direction.
//!
//! Across the lines of one direction, an entered facet e and a facet x through which lines leave share a convex piece (an
//! interval in 2D, a polygon in 3D). On it L = t_x − t_e is linear, and so are the barycentric coordinates of both. The
//! piece is cut where L = 0; Gauss points of degree 3 (2D) and 2 (3D; 4 where patches blend) then integrate
//! ψ'(L) N_a of the quadratic ψ exactly, and any smooth ψ to their order. What a third facet hides of a piece is cut out of it.

use super::projected_facets::{ProjectedFacet, Projection};
use crate::Error;
use crate::geometry::convex_piece::{cut, whole};
use crate::geometry::facet::area_vector;
use crate::geometry::facet_slopes::across;
use crate::geometry::plane::Plane;
use crate::geometry::quadrature::{for_each_gauss_point, mean};
use crate::geometry::{Shape, Vector};
use crate::overlap::exact::clipping::volume::ExactPair;
use crate::overlap::exact::projection::edges::Edge;
use crate::overlap::exact::projection::projected_facets::end;
use crate::overlap::pair::region::Region;
use crate::overlap::pair::sides::{Counterpart, ImplicitSide};
use crate::overlap::pair::surface_point::SurfacePoint;
use crate::overlap::patches::partition::Patches;
use crate::overlap::points::contact_point::ContactPoint;
use crate::overlap::points::contact_points::ContactPoints;
use crate::overlap::points::edge_terms::GapKink;
use crate::sampling::Family;

/// A facet whose shadow is a smaller part of it is seen edge-on: its barycentric coordinates are lost in rounding, and no
/// line of any measure crosses it.
const EDGE_ON: f64 = 1e-9;

impl<const D: usize> ExactPair<'_, D> {
    /// All spans along the directions of `patches`, and, if asked for, the creases that their tangent needs.
    pub(crate) fn contact_points(&self, patches: &Patches<D>, kinks: bool) -> Result<Option<ContactPoints<D>>, Error> {
        let mut points = ContactPoints { patches: patches.clone(), ..ContactPoints::default() };
        let fine = patches.are_blended();
        let Some(Region { aabb, facets }) = self.pair.region()? else { return Ok(None) };
        let rounding = aabb.rounding();
        for (direction, d) in patches.directions.iter().enumerate() {
            let family = Family::along(*d, 0, 0);
            let mut add = |mut span: ContactPoint<D>| {
                span.weight *= patches.part(direction, &span.ends).value;
                span.direction = direction as u32;
                if span.weight > 0.0 && span.length > 0.0 {
                    points.points.push(span);
                }
            };
            let plane = match &self.pair.counterpart {
                Counterpart::Itself | Counterpart::Facets(_) => None,
                Counterpart::Implicit(ImplicitSide { shape: Shape::HalfSpace, pose, .. }) => Some(Plane::of(pose)),
                Counterpart::Implicit(_) => {
                    let what = "the exact overlap with a curved or signed-distance obstacle; use fibers, or give it as \
                                a polygon or triangle mesh";
                    return Err(Error::Unsupported { what });
                }
            };
            let mut seen = self.seen(&family, false, &facets[0], plane.as_ref(), rounding);
            seen.extend(self.seen(&family, true, &facets[1], None, rounding));
            let seen = Projection::new(seen);
            if let Some(plane) = &plane {
                self.points_on_plane(&seen, &family, plane, fine, &mut add);
            }
            self.points_between(&seen, fine, &mut add);
            let edges = self.edge_sides(&seen);
            self.visit_silhouettes(&seen, &edges, &family, plane.as_ref(), |mut silhouette| {
                for span in &mut silhouette.spans {
                    span.weight *= patches.part(direction, &span.ends).value;
                    span.direction = direction as u32;
                }
                points.silhouettes.push(silhouette);
            });
            if kinks {
                let count = |mut kink: GapKink<D>, ends: &[SurfacePoint<D>; 2], edge: Option<&Edge<D>>| {
                    kink.factor *= patches.part(direction, ends).value;
                    kink.blend = edge.map_or(0.0, |edge| self.jump_of_part(patches, direction, ends, edge));
                    points.kinks.push(kink);
                };
                self.visit_kinks(&seen, &edges, &family, plane.as_ref(), count);
            }
        }
        Ok(Some(points))
    }

    /// Jump, across an edge at the first end of a span, of the slope of the part that counts for a direction.
    fn jump_of_part(&self, patches: &Patches<D>, direction: usize, ends: &[SurfacePoint<D>; 2], edge: &Edge<D>) -> f64 {
        if !patches.are_blended() {
            return 0.0;
        }
        let d = &patches.directions[direction];
        let [before, behind] = edge.facets.map(|facet| {
            let first = SurfacePoint::Facet { of_b: edge.of_b, facet, weights: [0.0; D] };
            let [corners, _] = patches.part(direction, &[first, ends[1]]).at_corners;
            let corners = corners.and_then(|c| across(&self.pair.side(edge.of_b).corners(facet as usize), d, &c));
            corners.map_or(0.0, |eta| eta.dot(&edge.nu))
        });
        before - behind
    }

    /// Facets of one side in the region of contact; those seen edge-on are left out: no line crosses them.
    fn seen(
        &self,
        family: &Family<D>,
        of_b: bool,
        facets: &[u32],
        plane: Option<&Plane<D>>,
        rounding: f64,
    ) -> Vec<ProjectedFacet<D>> {
        let side = self.pair.side(of_b);
        let see = |facet: u32| {
            if plane.is_some_and(|p| side.corners(facet as usize).iter().all(|x| p.height(x) > rounding)) {
                return None;
            }
            let area = area_vector(&side.corners(facet as usize));
            let slope = area.dot(family.direction());
            let corners = side.corners(facet as usize).map(|x| family.view(&x));
            let seen = ProjectedFacet { of_b, facet, corners, leaves: slope > 0.0 };
            (seen.projected_area() > EDGE_ON * area.norm()).then_some(seen)
        };
        facets.iter().copied().filter_map(see).collect()
    }

    fn points_between(&self, seen: &Projection<D>, fine: bool, add: &mut impl FnMut(ContactPoint<D>)) {
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
                        let across = share * part * e.projected_area();
                        add(ContactPoint {
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

    fn points_on_plane(
        &self,
        seen: &Projection<D>,
        family: &Family<D>,
        plane: &Plane<D>,
        fine: bool,
        add: &mut impl FnMut(ContactPoint<D>),
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
                    let on_plane =
                        SurfacePoint::Point { point: on_facet + family.direction() * along, normal: plane.normal };
                    let ends = if s.leaves { [on_plane, end(s, *w)] } else { [end(s, *w), on_plane] };
                    let across = share * part * s.projected_area();
                    add(ContactPoint { weight: across, across, length, direction: 0, ends });
                });
            }
        }
    }
}
