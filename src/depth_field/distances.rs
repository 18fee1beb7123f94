//! Distances of points from the surface of a body.

use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::nearest_on_facet::squared_distance;
use crate::geometry::primitives::tree::Tree;
use crate::geometry::{Surface, Vector};

/// The facets of every body that are surface, to be found by place.
pub(super) struct Distances<'a, const D: usize> {
    surface: &'a Surface<D>,
    points: Vec<Vector<D>>,
    /// Facets of every body, the box of each, and a tree over them.
    bodies: Vec<(Vec<u32>, Vec<Aabb<D>>, Tree<D>)>,
}

/// A limit is wider than the distance from which it comes by more than its rounding.
const WIDER: f64 = 1.0 + 1e-9;

impl<'a, const D: usize> Distances<'a, D> {
    /// The facets of all bodies at `coords` for which `is_surface` holds.
    pub(super) fn new(surface: &'a Surface<D>, coords: &[[f64; D]], is_surface: impl Fn(usize) -> bool) -> Self {
        let points = surface.points(coords);
        let bodies = surface.ranges.iter().map(|range| {
            let facets: Vec<u32> = range.clone().filter(|&f| is_surface(f)).map(|f| f as u32).collect();
            let of = |&f: &u32| Aabb::of(surface.facets[f as usize].iter().map(|&v| &points[v as usize]));
            let boxes: Vec<Aabb<D>> = facets.iter().map(of).collect();
            let tree = Tree::new(&boxes);
            (facets, boxes, tree)
        });
        let bodies = bodies.collect();
        Self { surface, points, bodies }
    }

    /// Distance of a point from the surface of a body, which is known to be at most `limit`, and the nearest facet.
    pub(super) fn of_point(&self, body: usize, x: &Vector<D>, limit: f64) -> (f64, u32) {
        let (facets, boxes, tree) = &self.bodies[body];
        let squared = |item: u32| {
            let facet = facets[item as usize];
            let squared = squared_distance(&self.surface.facets[facet as usize].map(|v| self.points[v as usize]), x);
            // As rounding has it a facet may be nearer than its box: then who is looked at first would tell.
            squared.max(boxes[item as usize].squared_distance(x))
        };
        let nearer = |item: u32, least: f64| {
            let may_be = boxes[item as usize].squared_distance(x) < least;
            may_be.then(|| squared(item)).filter(|squared| *squared < least)
        };
        let limit = limit * WIDER;
        let least = tree.least_squared_distance(x, limit * limit, nearer);
        // Of several that are as near the first, whatever the tree: facets share their edges and corners.
        let mut nearest = u32::MAX;
        tree.visit(
            |aabb| aabb.squared_distance(x) <= least,
            |item| {
                if item < nearest && squared(item) <= least {
                    nearest = item;
                }
            },
        );
        (least.sqrt(), facets.get(nearest as usize).or(facets.first()).copied().unwrap_or(0))
    }
}
