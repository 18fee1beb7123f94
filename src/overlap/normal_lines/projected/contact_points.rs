//! Contact points of the fiber law integrated exactly: quadrature on the common pieces of facets projected along a patch's
//! direction (segment-based mortar integration of a penalty on the gap).
//!
//! Across the lines of one direction, an entered facet e and a facet x through which lines leave share a convex piece (an
//! interval in 2D, a polygon in 3D). On it L = t_x − t_e is linear, and so are the barycentric coordinates of both. The
//! piece is cut where L = 0; Gauss points of degree 3 (2D) and 2 (3D; 4 where patches blend) then integrate
//! ψ'(L) N_a of the quadratic ψ exactly, and any smooth ψ to their order. What a third facet hides of a piece is cut out of it.

use super::edges::Edge;
use super::projected_facets::{Near, ProjectedFacet, Projection, SLIVER, end};
use super::projected_pair::ProjectedPair;
use super::reached::Reached;
use super::work::Work;
use crate::Error;
use crate::geometry::Vector;
use crate::geometry::primitives::convex_piece::Piece;
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::primitives::facet_slopes::across;
use crate::geometry::primitives::plane::Plane;
use crate::geometry::primitives::quadrature::{for_each_gauss_point, mean, measure};
use crate::overlap::normal_lines::patches::partition::Patches;
use crate::overlap::normal_lines::points::contact_point::ContactPoint;
use crate::overlap::normal_lines::points::contact_points::ContactPoints;
use crate::overlap::normal_lines::points::edge_terms::GapKink;
use crate::overlap::pair::partner::Partner;
use crate::overlap::pair::surface_point::SurfacePoint;
use crate::ranks::Packed;
use crate::sampling::Family;

/// A facet whose projection is a smaller part of it is seen edge-on: its barycentric coordinates are lost in rounding, and
/// no line of any measure crosses it.
pub(super) const EDGE_ON: f64 = 1e-9;

/// Facets, edges or curves that a thread takes at once.
const CHUNK: usize = 32;

impl<const D: usize> ProjectedPair<'_, D> {
    /// All contact points along the directions of `patches`, and, if asked for, the kinks of the gap that their tangent
    /// needs.
    pub(crate) fn contact_points(
        &self,
        patches: &Patches<D>,
        derivative: bool,
    ) -> Result<Option<ContactPoints<D>>, Error> {
        let plane = self.pair.plane()?;
        patches.check(self.pair.weighting)?;
        let Some(reached) = self.reached_facets()? else { return Ok(None) };
        let mut points = ContactPoints { patches: patches.clone(), ..ContactPoints::default() };
        let rule = if patches.are_blended() { Rule::Fine } else { Rule::Gauss };
        for (direction, d) in patches.directions.iter().enumerate() {
            let family = Family::along(*d, 0, 0);
            let weighted = |point: &mut ContactPoint<D>| {
                point.weight *= patches.part(direction, &point.ends).value * self.pair.weight_between(&point.ends);
                point.direction = direction as u32;
            };
            let keep = |mut point: ContactPoint<D>| {
                weighted(&mut point);
                (point.weight > 0.0 && point.length > 0.0).then_some(point)
            };
            let seen = self.projection(&family, &reached, plane.as_ref());
            if let Some(plane) = &plane {
                self.points_on_plane(&seen, &family, plane, rule, |point| points.points.extend(keep(point)));
            }
            let between = self.in_order(&seen.work, seen.facets.len(), |entered, scratch, found| {
                let along = (&family, plane.as_ref());
                self.points_between(&seen, along, (entered, None), rule, scratch, |point| found.extend(keep(point)));
            });
            points.points.extend(between);
            let edges = self.edge_sides(&seen);
            let mut silhouettes = self.silhouettes(&seen, &edges, &family, plane.as_ref());
            silhouettes.iter_mut().flat_map(|silhouette| &mut silhouette.spans).for_each(weighted);
            points.silhouettes.extend(silhouettes);
            if derivative {
                let finish = |mut kink: GapKink<D>, ends: &[SurfacePoint<D>; 2], edge: Option<&Edge<D>>| {
                    let part = patches.part(direction, ends).value;
                    kink.factor *= part;
                    kink.blend =
                        kink.blend * part + edge.map_or(0.0, |edge| self.jump_of_part(patches, direction, ends, edge));
                    kink
                };
                points.kinks.extend(self.kinks(&seen, &edges, &family, plane.as_ref(), finish));
            }
            self.check(&seen.work)?;
        }
        Ok(Some(points))
    }

    /// The facets as lines of a family see them.
    pub(crate) fn projection(&self, family: &Family<D>, reached: &Reached, plane: Option<&Plane<D>>) -> Projection<D> {
        self.projection_without(family, reached, plane, |_| EDGE_ON)
    }

    /// The same without facets of which no larger part than `edge_on` is seen, a function of the area vector.
    pub(crate) fn projection_without(
        &self,
        family: &Family<D>,
        Reached { facets, rounding, is_upright }: &Reached,
        plane: Option<&Plane<D>>,
        edge_on: impl Fn(&Vector<D>) -> f64,
    ) -> Projection<D> {
        let mut seen = self.seen(family, (false, &facets[0]), plane, *rounding, &edge_on);
        seen.extend(self.seen(family, (true, &facets[1]), None, *rounding, &edge_on));
        Projection::new(seen, *is_upright)
    }

    /// Refuses what fell apart into more pieces than are counted to the end.
    pub(crate) fn check(&self, work: &Work) -> Result<(), Error> {
        let sides = self.pair.partners.map(|partner| match partner {
            Partner::Body(index) => ("body", index),
            Partner::Obstacle(index) => ("obstacle", index),
        });
        if work.is_over_on_ranks(&self.pair.sharing) {
            Err(Error::TooManyPieces { sides, limit: work.limit })
        } else {
            Ok(())
        }
    }

    /// What `work` finds for each of so many items, in their order.
    pub(crate) fn in_order<T: Packed + Send>(
        &self,
        pieces: &Work,
        count: usize,
        work: impl Fn(usize, &mut Scratch<D>, &mut Vec<T>) + Sync,
    ) -> Vec<T> {
        let items: Vec<usize> = (0..count).collect();
        let of_chunk = |items: &[usize]| {
            let (mut scratch, mut found) = (Scratch::default(), Vec::new());
            items.iter().for_each(|item| work(*item, &mut scratch, &mut found));
            found
        };
        let all_chunks = || self.pair.in_chunks(&items, CHUNK, of_chunk);
        let is_shared = self.pair.sharing.is_shared(items.len().div_ceil(CHUNK));
        let chunks = if is_shared { all_chunks() } else { pieces.in_common(all_chunks) };
        let mut all = Vec::with_capacity(chunks.iter().map(Vec::len).sum());
        chunks.into_iter().for_each(|mut chunk| all.append(&mut chunk));
        all
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
        (of_b, facets): (bool, &[u32]),
        plane: Option<&Plane<D>>,
        rounding: f64,
        edge_on: impl Fn(&Vector<D>) -> f64,
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
            (seen.projected_area() > edge_on(&area) * area.norm()).then_some(seen)
        };
        facets.iter().copied().filter_map(see).collect()
    }

    /// Points on the lines that enter through one facet and leave through any, as far as both lie below the plane of a
    /// half-space: elsewhere it is the plane that bounds the line. One of the two at least is among the `wanted`.
    pub(crate) fn points_between(
        &self,
        seen: &Projection<D>,
        (family, plane): (&Family<D>, Option<&Plane<D>>),
        (entered, wanted): (usize, Option<&[bool]>),
        rule: Rule,
        scratch: &mut Scratch<D>,
        mut add: impl FnMut(ContactPoint<D>),
    ) {
        let e = &seen.facets[entered];
        if e.leaves || seen.work.is_over() {
            return;
        }
        let is_wanted = |facet: usize| wanted.is_none_or(|wanted| wanted[facet]);
        let is_any = is_wanted(entered);
        if !is_any && !seen.is_near_any(entered, |x| seen.facets[x].leaves && is_wanted(x)) {
            return;
        }
        let Scratch { near, piece } = scratch;
        let [first, _] = seen.ranges[entered];
        seen.find_near(entered as u32, first, near);
        let slope = plane.map_or(0.0, |plane| plane.normal.dot(family.direction()));
        let entered_at = self.pair.side(e.of_b).corners(e.facet as usize);
        for &Near { facet: left, bounds, t } in near.iter() {
            let x = &seen.facets[left as usize];
            if !x.leaves || seen.ranges[left as usize][1] <= first || !(is_any || is_wanted(left as usize)) {
                continue;
            }
            let lengths: [f64; D] = std::array::from_fn(|c| t[c] - e.corners[c][2]);
            if lengths.iter().all(|l| *l <= 0.0) {
                continue;
            }
            piece.reset();
            let mut cuts = bounds.iter().chain([&lengths]).map(|positive| positive.map(|w| -w));
            if !cuts.all(|at_corners| piece.cut(&at_corners)) {
                continue;
            }
            // Heights of both ends over the plane, linear on the facet.
            if let Some(plane) = plane {
                let from = entered_at.map(|x| plane.height(&x));
                let along: [f64; D] = std::array::from_fn(|c| from[c] + slope * lengths[c]);
                if !piece.cut(&from) || !piece.cut(&along) {
                    continue;
                }
            }
            seen.visible(piece.corners(), [entered as u32, left], &lengths, near, |piece, share| {
                if measure(piece) <= SLIVER || !self.is_inside_both(seen, e, x, &e.place(&mean(piece))) {
                    return;
                }
                rule.for_each_point(piece, |w, part| {
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
            });
        }
    }

    pub(crate) fn points_on_plane(
        &self,
        seen: &Projection<D>,
        family: &Family<D>,
        plane: &Plane<D>,
        rule: Rule,
        mut add: impl FnMut(ContactPoint<D>),
    ) {
        let slope = plane.normal.dot(family.direction());
        let (mut piece, mut near) = (Piece::default(), Vec::new());
        for (index, s) in seen.facets.iter().enumerate().filter(|(_, s)| s.leaves != (slope > 0.0)) {
            let corners = self.pair.a.corners(s.facet as usize);
            // From the facet along the line to the plane; on the body's side of it the length is positive.
            let lengths = corners.map(|x| -plane.height(&x) / slope.abs());
            piece.reset();
            if !piece.cut(&lengths.map(|l| -l)) {
                continue;
            }
            seen.find_near(index as u32, f64::NEG_INFINITY, &mut near);
            seen.visible(piece.corners(), [index as u32; 2], &lengths, &near, |piece, share| {
                rule.for_each_point(piece, |w, part| {
                    let length = (0..D).map(|a| w[a] * lengths[a]).sum::<f64>();
                    let along = if s.leaves { -length } else { length };
                    let on_facet = (0..D).fold(Vector::zeros(), |sum, a| sum + corners[a] * w[a]);
                    let on_plane =
                        SurfacePoint::Point { point: on_facet + family.direction() * along, normal: plane.normal };
                    let ends = if s.leaves { [on_plane, end(s, *w)] } else { [end(s, *w), on_plane] };
                    let across = share * part * s.projected_area();
                    add(ContactPoint { weight: across, across, length, direction: 0, ends });
                });
            });
        }
    }
}

/// How points are laid on a piece of a facet.
#[derive(Clone, Copy)]
pub(crate) enum Rule {
    /// One in its middle.
    Middle,
    /// Gauss points that integrate a quadratic energy exactly.
    Gauss,
    /// More of them, for where patches blend.
    Fine,
}

impl Rule {
    fn for_each_point<const D: usize>(self, piece: &[[f64; D]], mut visit: impl FnMut(&[f64; D], f64)) {
        match self {
            Rule::Middle => visit(&mean(piece), measure(piece)),
            Rule::Gauss => for_each_gauss_point(piece, false, visit),
            Rule::Fine => for_each_gauss_point(piece, true, visit),
        }
    }
}

/// Memory that serves one facet after the other.
#[derive(Default)]
pub(crate) struct Scratch<const D: usize> {
    near: Vec<Near<D>>,
    piece: Piece<D>,
}
