//! Distances of points from the surface of a body.

use crate::geometry::aabb::Aabb;
use crate::geometry::nearest_on_facet::squared_distance;
use crate::geometry::tree::Tree;
use crate::geometry::{Surface, Vector};

/// The facets of every body, to be found by place.
pub(super) struct Distances<'a, const D: usize> {
    surface: &'a Surface<D>,
    points: Vec<Vector<D>>,
    trees: Vec<Tree<D>>,
}

impl<'a, const D: usize> Distances<'a, D> {
    /// The surfaces of all bodies at `coords`.
    pub(super) fn new(surface: &'a Surface<D>, coords: &[[f64; D]]) -> Self {
        let points = surface.points(coords);
        let trees = surface.ranges.iter().map(|range| {
            let facets = &surface.facets[range.clone()];
            let boxes: Vec<Aabb<D>> = facets.iter().map(|f| Aabb::of(f.iter().map(|&v| &points[v as usize]))).collect();
            Tree::new(&boxes)
        });
        Self { surface, trees: trees.collect(), points }
    }

    /// Distance of a point from the surface of a body.
    pub(super) fn of_point(&self, body: usize, x: &Vector<D>) -> f64 {
        let first = self.surface.ranges[body].start;
        let squared = self.trees[body].least_squared_distance(x, |facet| {
            let corners = self.surface.facets[first + facet as usize].map(|v| self.points[v as usize]);
            squared_distance(&corners, x)
        });
        squared.sqrt()
    }
}
