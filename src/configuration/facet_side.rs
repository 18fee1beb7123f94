//! A body bounded by facets, at given coordinates.

use super::facet_tree::FacetTree;
use crate::geometry::Vector;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::inside::winding_step;
use crate::geometry::shapes::Faces;

/// A body (or an obstacle bounded by facets) as the estimators see it.
#[derive(Clone, Copy)]
pub(crate) struct FacetSide<'a, const D: usize> {
    pub(crate) facets: &'a [[u32; D]],
    /// Positions of the vertices that the facets name.
    pub(crate) points: &'a [Vector<D>],
    pub(crate) tree: &'a FacetTree<D>,
    /// Box of all its vertices.
    pub(crate) aabb: Aabb<D>,
    /// Whether all its cells are known to have positive volume, or it is rigid: its winding number is then
    /// nowhere negative.
    pub(crate) is_upright: bool,
    /// Of an obstacle, its faces in their own frame.
    pub(crate) rigid: Option<&'a Faces<D>>,
}

impl<const D: usize> FacetSide<'_, D> {
    pub(crate) fn corners(&self, facet: usize) -> [Vector<D>; D] {
        let mut corners = [Vector::zeros(); D];
        for (corner, &v) in corners.iter_mut().zip(&self.facets[facet]) {
            *corner = self.points[v as usize];
        }
        corners
    }

    pub(crate) fn facet_box(&self, facet: usize) -> Aabb<D> {
        Aabb::of(self.facets[facet].iter().map(|&v| &self.points[v as usize]))
    }

    /// Facets whose box meets `region`, ascending.
    pub(crate) fn facets_in(&self, region: &Aabb<D>) -> Vec<u32> {
        self.facets_where(|aabb| aabb.meets(region))
    }

    /// Facets for whose boxes, and all boxes around them, `accept` holds; ascending.
    pub(crate) fn facets_where(&self, accept: impl Fn(&Aabb<D>) -> bool) -> Vec<u32> {
        let mut found = Vec::new();
        self.tree.visit(&accept, |facet| {
            if accept(&self.facet_box(facet as usize)) {
                found.push(facet);
            }
        });
        found.sort_unstable();
        found
    }

    /// Winding number of the body about the point `x`: 0 outside, 1 inside, 2 where it is folded over itself.
    ///
    /// Counted along the line through `x` parallel to the last axis. On the boundary it may be either.
    pub(crate) fn winding_number(&self, x: &Vector<D>) -> i32 {
        self.winding_number_along(x, D - 1, None)
    }

    /// The same, counted along the line through `x` parallel to this axis; for a point of a facet, which then does not
    /// count, the number just below it. Where a facet comes as near as rounding and is parallel to the line, it may be
    /// either: a line across the facets that are near is safe.
    pub(crate) fn winding_number_along(&self, x: &Vector<D>, axis: usize, but: Option<u32>) -> i32 {
        // A crossing is found by interpolation, which may be off by rounding along the line.
        let top = x[axis] + self.aabb.rounding();
        let reaches = |b: &Aabb<D>| {
            b.min[axis] <= top && (0..D).fold(true, |all, i| all & (i == axis || b.min[i] <= x[i] && x[i] <= b.max[i]))
        };
        let mut count = 0;
        self.tree.visit(reaches, |facet| {
            if Some(facet) != but {
                count += winding_step(&self.facets[facet as usize], self.points, x, axis);
            }
        });
        count
    }
}
