//! The two sides of a pair.

use crate::geometry::aabb::Aabb;
use crate::geometry::crossing::Projected;
use crate::geometry::{Pose, Shape, Surface, Vector};
use crate::overlap::pair::partner::Partner;
use crate::sampling::Family;
use std::sync::Arc;

/// Vertices at their current positions, and as seen along every line family.
pub(crate) struct Views<const D: usize> {
    pub(crate) points: Arc<Vec<Vector<D>>>,
    pub(crate) viewed: Vec<Vec<Projected>>,
}

impl<const D: usize> Views<D> {
    /// Views along `families`; none are needed for segments and for the exact estimator.
    pub(crate) fn new(points: Vec<Vector<D>>, families: &[Family<D>]) -> Self {
        let viewed = families.iter().map(|f| points.iter().map(|x| f.view(x)).collect()).collect();
        Self { points: Arc::new(points), viewed }
    }

    /// The view of one side along one family of its own; vertices of other sides are not seen.
    pub(crate) fn of_side(side: &FacetSide<D>, family: &Family<D>) -> Self {
        let points = side.views.points.clone();
        let mut viewed = vec![[0.0; 3]; points.len()];
        for &vertex in side.facets.iter().flatten() {
            viewed[vertex as usize] = family.view(&points[vertex as usize]);
        }
        Self { points, viewed: vec![viewed] }
    }
}

/// A body bounded by facets.
#[derive(Clone, Copy)]
pub(crate) struct FacetSide<'a, const D: usize> {
    pub(crate) facets: &'a [[u32; D]],
    pub(crate) views: &'a Views<D>,
    /// Box of all its vertices.
    pub(crate) aabb: Aabb<D>,
}

impl<'a, const D: usize> FacetSide<'a, D> {
    /// A body with these facets, whose vertices are `vertices`.
    pub(crate) fn new(facets: &'a [[u32; D]], vertices: impl Iterator<Item = u32>, views: &'a Views<D>) -> Self {
        let aabb = Aabb::of(vertices.map(|v| &views.points[v as usize]));
        Self { facets, views, aabb }
    }

    pub(crate) fn corners(&self, facet: usize) -> [Vector<D>; D] {
        let mut corners = [Vector::zeros(); D];
        for (corner, &v) in corners.iter_mut().zip(&self.facets[facet]) {
            *corner = self.views.points[v as usize];
        }
        corners
    }

    pub(crate) fn facet_box(&self, facet: usize) -> Aabb<D> {
        Aabb::of(self.facets[facet].iter().map(|&v| &self.views.points[v as usize]))
    }

    /// Facets whose box meets `region`.
    pub(crate) fn facets_in(&self, region: &Aabb<D>) -> Vec<u32> {
        (0..self.facets.len() as u32).filter(|&f| self.facet_box(f as usize).meets(region)).collect()
    }
}

/// A rigid shape that is not bounded by facets.
#[derive(Clone, Copy)]
pub(crate) struct ImplicitSide<'a, const D: usize> {
    pub(crate) obstacle: usize,
    pub(crate) shape: &'a Shape<D>,
    pub(crate) pose: &'a Pose<D>,
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
    /// Whether its crossings are marched, through a function that belongs to the host.
    pub(crate) fn is_marched(&self) -> bool {
        matches!(self.shape, Shape::SignedDistance(_))
    }
}

impl<const D: usize> Counterpart<'_, D> {
    /// Whether it is a signed distance function.
    pub(crate) fn is_marched(&self) -> bool {
        matches!(self, Counterpart::Implicit(side) if side.is_marched())
    }
}

/// Two sides, whichever way their overlap is measured.
pub(crate) struct Pair<'a, const D: usize> {
    pub(crate) partners: [Partner; 2],
    pub(crate) a: FacetSide<'a, D>,
    pub(crate) counterpart: Counterpart<'a, D>,
    /// Pose of the second side, where it is an obstacle.
    pub(crate) pose: Option<&'a Pose<D>>,
    pub(crate) surface: &'a Surface<D>,
    /// Whether the threads of the pool that calls may share the work.
    pub(crate) parallel: bool,
}

impl<'a, const D: usize> Pair<'a, D> {
    /// The side to which a facet belongs.
    pub(crate) fn side(&self, of_b: bool) -> &FacetSide<'a, D> {
        match &self.counterpart {
            Counterpart::Facets(b) if of_b => b,
            _ => &self.a,
        }
    }

    /// Whether the body is measured against itself.
    pub(crate) fn is_own(&self) -> bool {
        matches!(self.counterpart, Counterpart::Itself)
    }
}
