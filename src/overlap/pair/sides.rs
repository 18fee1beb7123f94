//! The two sides of a pair.

use super::partner::Partner;
use super::region::Region;
use super::surface_point::SurfacePoint;
use crate::configuration::FacetSide;
use crate::depth_field::{DepthField, TiedLayer};
use crate::geometry::boundary::facet_sags::FacetSag;
use crate::geometry::primitives::convex_piece::place;
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::primitives::plane::Plane;
use crate::geometry::shapes::ImplicitShape;
use crate::geometry::{Pose, Surface, Vector, Weighting};
use crate::ranks::{Packed, Sharing};
use std::sync::OnceLock;

/// A rigid shape that is not bounded by facets.
#[derive(Clone, Copy)]
pub(crate) struct ImplicitSide<'a, const D: usize> {
    pub(crate) obstacle: usize,
    pub(crate) shape: &'a ImplicitShape<D>,
    pub(crate) pose: &'a Pose<D>,
    /// The obstacle itself, where this is its surface at an offset, and that is found from its facets.
    pub(crate) offset: Option<Offset<'a, D>>,
}

/// Facets, and how far outside of them a surface lies.
#[derive(Clone, Copy)]
pub(crate) struct Offset<'a, const D: usize> {
    pub(crate) of: FacetSide<'a, D>,
    pub(crate) by: f64,
}

/// What stands against the first body of a pair.
#[derive(Clone, Copy)]
pub(crate) enum Counterpart<'a, const D: usize> {
    /// The body itself: its self-overlap is sought.
    Itself,
    /// Another body of the mesh, or an obstacle bounded by facets.
    Facets(FacetSide<'a, D>),
    /// An obstacle with closed-form or marched crossings.
    Implicit(ImplicitSide<'a, D>),
}

impl<const D: usize> ImplicitSide<'_, D> {
    /// The plane that bounds it, if it is a half-space.
    pub(crate) fn plane(&self) -> Option<Plane<D>> {
        self.shape.is_half_space().then(|| Plane::of(self.pose))
    }
}

impl<const D: usize> Counterpart<'_, D> {
    /// Whether its crossings are marched, through a function that may belong to the host.
    pub(crate) fn is_marched(&self) -> bool {
        matches!(self, Counterpart::Implicit(side) if side.shape.is_function())
    }

    /// Whether it is a rigid shape without facets.
    pub(crate) fn is_shape(&self) -> bool {
        matches!(self, Counterpart::Implicit(_))
    }
}

/// What of two bodies is in no contact, since it is tied.
#[derive(Clone, Copy)]
pub(crate) struct TiedFacets<'a> {
    pub(crate) facets: &'a [Vec<usize>; 2],
    pub(crate) layers: &'a [TiedLayer; 2],
}

/// Two sides, whichever way their overlap is measured.
pub(crate) struct Pair<'a, const D: usize> {
    pub(crate) partners: [Partner; 2],
    pub(crate) a: FacetSide<'a, D>,
    pub(crate) counterpart: Counterpart<'a, D>,
    /// Pose of the second side, where it is an obstacle: that in the counterpart may be another, at a gap offset.
    pub(crate) pose: Option<&'a Pose<D>>,
    pub(crate) surface: &'a Surface<D>,
    /// Coordinates of all nodes.
    pub(crate) coords: &'a [[f64; D]],
    /// Depth of the bodies' cells, where the law needs it and there are cells.
    pub(crate) depth: Option<&'a DepthField<D>>,
    /// How deep below the surfaces the contact of two bodies begins; 0 for an obstacle, which then is another.
    pub(crate) clearance: f64,
    /// Facets of both bodies that are tied to one another, by number in the surface, ascending, and what lies below them: they are in no contact.
    pub(crate) tied: Option<TiedFacets<'a>>,
    /// What its measures count for.
    pub(crate) weighting: Weighting,
    /// Who shares the work.
    pub(crate) sharing: Sharing<'a>,
    /// Where the sides can overlap, once it was asked for: see [`Pair::region`].
    pub(crate) region: OnceLock<Option<Region<D>>>,
}

impl<'a, const D: usize> Pair<'a, D> {
    /// All facets of a side that are surface: of some cells of a larger mesh others end there.
    pub(crate) fn surface_facets(&self, of_b: bool) -> impl Iterator<Item = u32> + use<'_, D> {
        let first = match self.partners[usize::from(of_b)] {
            Partner::Body(body) => Some(self.surface.ranges[body].start),
            Partner::Obstacle(_) => None,
        };
        let is_surface = move |facet: usize| first.is_none_or(|first| self.surface.is_surface_facet(first + facet));
        (0..self.side(of_b).facets.len()).filter(move |&facet| is_surface(facet)).map(|facet| facet as u32)
    }

    /// Whether a facet of a side is tied to the other.
    pub(crate) fn is_tied(&self, of_b: bool, facet: u32) -> bool {
        let (Some(tied), Partner::Body(body)) = (self.tied, self.partners[usize::from(of_b)]) else { return false };
        let in_surface = self.surface.ranges[body].start + facet as usize;
        tied.facets[usize::from(of_b)].binary_search(&in_surface).is_ok()
    }

    /// The side to which a facet belongs.
    pub(crate) fn side(&self, of_b: bool) -> &FacetSide<'a, D> {
        match &self.counterpart {
            Counterpart::Facets(b) if of_b => b,
            _ => &self.a,
        }
    }

    /// Two pieces of work, on two threads if there are some.
    pub(crate) fn both<T: Send, U: Send>(
        &self,
        first: impl FnOnce() -> T + Send,
        second: impl FnOnce() -> U + Send,
    ) -> (T, U) {
        self.sharing.both(first, second)
    }

    /// What `work` makes of every chunk of some items, in their order, shared among threads and ranks. The chunks do not depend
    /// on the number of either, so that sums over them do not.
    pub(crate) fn in_chunks<T: Sync, U: Packed + Send>(
        &self,
        items: &[T],
        size: usize,
        work: impl Fn(&[T]) -> U + Send + Sync,
    ) -> Vec<U> {
        self.sharing.in_chunks(items, size, work)
    }

    /// The same where there is too little to do for ranks to share it.
    pub(crate) fn on_threads<T: Sync, U: Send>(
        &self,
        items: &[T],
        size: usize,
        work: impl Fn(&[T]) -> U + Send + Sync,
    ) -> Vec<U> {
        self.sharing.on_threads(items, size, work)
    }

    /// Place of a point of the boundary.
    pub(crate) fn position(&self, point: &SurfacePoint<D>) -> Vector<D> {
        match *point {
            SurfacePoint::Facet { of_b, facet, weights } => place(&self.side(of_b).corners(facet as usize), &weights),
            SurfacePoint::Point { point, .. } => point,
        }
    }

    /// What a line between two points counts for: its middle's weight, so that length times this is the weighted length.
    pub(crate) fn weight_between(&self, ends: &[SurfacePoint<D>; 2]) -> f64 {
        if self.weighting.is_plain() {
            return 1.0;
        }
        self.weighting.at(&((self.position(&ends[0]) + self.position(&ends[1])) * 0.5))
    }

    /// How far the curved face for which a facet stands lies outside of it at a place; 0 where it is not measured as curved.
    pub(crate) fn height(&self, of_b: bool, facet: u32, weights: &[f64; D]) -> f64 {
        self.sag(of_b, facet).map_or(0.0, |sag| sag.at(weights))
    }

    /// That of all places of a facet; `None` where there are no curved faces.
    pub(crate) fn sag(&self, of_b: bool, facet: u32) -> Option<&FacetSag<D>> {
        let ([Partner::Body(_), Partner::Body(_)], Counterpart::Facets(_)) = (self.partners, &self.counterpart) else {
            return None;
        };
        let Partner::Body(body) = self.partners[usize::from(of_b)] else { return None };
        let curves = self.depth.and_then(|field| field.curves())?;
        Some(curves.facet(self.surface.ranges[body].start + facet as usize))
    }

    /// Whether the body is measured against itself.
    pub(crate) fn is_own(&self) -> bool {
        matches!(self.counterpart, Counterpart::Itself)
    }

    /// Unit outward normal of the side at a point of its boundary; zero where a facet has no measure.
    pub(crate) fn normal_at(&self, point: &SurfacePoint<D>) -> Vector<D> {
        match *point {
            SurfacePoint::Facet { of_b, facet, .. } => {
                let area = area_vector(&self.side(of_b).corners(facet as usize));
                area.try_normalize(0.0).unwrap_or_else(Vector::zeros)
            }
            SurfacePoint::Point { normal, .. } => normal,
        }
    }
}
