//! Where a straight way passes the surface of a body.

use super::facet_side::FacetSide;
use crate::geometry::Vector;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::crossing::{Projected, Window, for_each_crossing};
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::primitives::nearest_on_facet::squared_distance;
use std::cell::Cell;

/// A place where a way passes the surface.
#[derive(Clone, Copy)]
pub(crate) struct Passage<const D: usize> {
    /// Part of the way.
    part: f64,
    /// Whether the way comes out there.
    pub(crate) leaves: bool,
    /// Outward normal of the facet, with its area.
    pub(crate) normal: Vector<D>,
}

impl<const D: usize> FacetSide<'_, D> {
    /// Where the way from one point straight to another passes the surface, in this order.
    pub(crate) fn passages(&self, from: &Vector<D>, to: &Vector<D>) -> Vec<Passage<D>> {
        let mut found = Vec::new();
        let (way, length) = (to - from, (to - from).norm());
        if length == 0.0 {
            return found;
        }
        let along = way / length;
        let frame = across(&along);
        let seen = |x: &Vector<D>| -> Projected {
            let y = x - from;
            let [u, v] = frame.map(|axis| axis.dot(&y));
            [u, v, along.dot(&y)]
        };
        let reaches = |aabb: &Aabb<D>| aabb.meets_ray(from, &along, length);
        self.tree.visit(reaches, |facet| {
            let corners = self.corners(facet as usize);
            let seen = corners.each_ref().map(seen);
            for_each_crossing::<D>(std::array::from_fn(|k| &seen[k]), &Window::single(), |_, _, t, leaves| {
                if (0.0..length).contains(&t) {
                    found.push(Passage { part: t / length, leaves, normal: area_vector(&corners) });
                }
            });
        });
        // Facets that are passed in one place, as at an edge between a body and a cavity, have an order too.
        found.sort_by(|a, b| a.part.total_cmp(&b.part).then(a.leaves.cmp(&b.leaves)));
        found
    }

    /// The outward normal, with its area, of the facet that is nearest to a point, and its squared distance.
    pub(crate) fn nearest_normal(&self, x: &Vector<D>) -> (Vector<D>, f64) {
        let (least, nearest) = (Cell::new(f64::INFINITY), Cell::new((u32::MAX, Vector::zeros())));
        self.tree.visit(
            |aabb| aabb.squared_distance(x) <= least.get(),
            |facet| {
                let corners = self.corners(facet as usize);
                let squared = squared_distance(&corners, x);
                if (squared, facet) < (least.get(), nearest.get().0) {
                    least.set(squared);
                    nearest.set((facet, area_vector(&corners)));
                }
            },
        );
        (nearest.get().1, least.get())
    }
}

/// Unit vectors across a unit vector, which is the last axis of a right-handed frame with them; in 2D the second is zero.
fn across<const D: usize>(along: &Vector<D>) -> [Vector<D>; 2] {
    if D == 2 {
        return [Vector::from_fn(|i, _| if i == 0 { along[1] } else { -along[0] }), Vector::zeros()];
    }
    let least = along.iamin();
    let axis = Vector::<D>::from_fn(|i, _| if i == least { 1.0 } else { 0.0 });
    let first = (axis - along * along[least]).normalize();
    let second = Vector::from_fn(|i, _| {
        let (j, k) = ((i + 1) % D, (i + 2) % D);
        along[j] * first[k] - along[k] * first[j]
    });
    [first, second]
}

#[cfg(test)]
mod tests {
    use crate::configuration::{FacetSide, FacetTree};
    use crate::geometry::{Bodies, Surface, Vector};
    use fmc_shapes::icosphere;

    /// Ways through a ball of many facets: they come in and go out where the sphere says, but for the sag of the facets, and the nearest facet
    /// looks away from the centre.
    #[test]
    fn a_way_through_a_ball_comes_in_and_goes_out_on_the_sphere() {
        let ball = icosphere(1.0, 4);
        let facets = ball.facets();
        let surface = Surface::from_facets(&ball.coords, &facets, Bodies::Ids(&vec![0; facets.len()])).expect("a ball");
        let points = surface.points(&ball.coords);
        let tree = FacetTree::new(&surface.facets, &surface.vertices[0], &points);
        let side = FacetSide {
            facets: &surface.facets,
            points: &points,
            tree: &tree,
            aabb: tree.aabb(),
            is_upright: true,
            rigid: None,
        };
        let sag = 0.01; // (h/2)² / 2 of facets with h = 0.13, with room.
        for k in 0..60 {
            let s = f64::from(k);
            let from = Vector::<3>::new((1.3 * s).sin(), (2.1 * s).cos(), (0.7 * s).sin()).normalize() * 1.5;
            let to = -from + Vector::<3>::new(0.3 * s.sin(), 0.2, 0.1);
            let found = side.passages(&from, &to);
            assert_eq!(found.iter().map(|one| one.leaves).collect::<Vec<_>>(), [false, true], "{k}");
            for one in &found {
                let place = from + (to - from) * one.part;
                assert!((place.norm() - 1.0).abs() < sag && one.normal.normalize().dot(&place) > 0.95, "{k}: {place}");
            }
            // A way that ends in the middle comes in alone, and one backwards meets the same facets.
            assert_eq!(side.passages(&from, &(from + (to - from) * 0.5)).len(), 1);
            assert_eq!(side.passages(&to, &from).iter().map(|one| one.leaves).collect::<Vec<_>>(), [false, true]);
            assert!(side.nearest_normal(&(from * 0.4)).0.normalize().dot(&from.normalize()) > 0.95);
        }
    }
}
