//! Distances of points from the surface of a body.

use crate::geometry::aabb::Aabb;
use crate::geometry::nearest_on_facet::squared_distance;
use crate::geometry::tree::Tree;
use crate::geometry::{Surface, Vector};
use std::cell::Cell;

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
        let found = Cell::new(facets.first().copied().unwrap_or(0));
        let nearer = |item: u32, least: f64| {
            if boxes[item as usize].squared_distance(x) >= least {
                return None;
            }
            let facet = facets[item as usize];
            let corners = self.surface.facets[facet as usize].map(|v| self.points[v as usize]);
            let squared = Some(squared_distance(&corners, x)).filter(|squared| *squared < least);
            if squared.is_some() {
                found.set(facet);
            }
            squared
        };
        let limit = limit * WIDER;
        let distance = tree.least_squared_distance(x, limit * limit, nearer).sqrt();
        (distance, found.get())
    }
}
