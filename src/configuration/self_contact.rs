//! Whether a body can overlap itself.
//!
//! A closed surface whose facets meet only in shared vertices has the winding number 0 or 1 about every point.
//! So a body can overlap itself only if two of its facets cross, or if it has several closed surfaces, one of which may
//! have left another.

use super::FacetSide;
use crate::geometry::Vector;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::primitives::facet_slopes::cross;
use crate::geometry::primitives::tree::Tree;

/// Facets that share a vertex can cross only if they are bent against each other: with unit normals whose product is
/// larger than this they are two pieces of one smooth surface, which meets itself elsewhere if at all.
const SMOOTH: f64 = 0.5;

/// What is known of a facet before it is held against others: its box, a little wider, its corners and its area vector.
struct Held<const D: usize> {
    aabb: Aabb<D>,
    corners: [Vector<D>; D],
    area: Vector<D>,
    unit: Vector<D>,
}

impl<const D: usize> FacetSide<'_, D> {
    /// Whether two facets may cross: false only if no two can.
    pub(crate) fn may_cross_itself(&self) -> bool {
        let tolerance = self.aabb.rounding();
        let held: Vec<Held<D>> = (0..self.facets.len() as u32).map(|facet| self.hold(facet, tolerance)).collect();
        let boxes: Vec<Aabb<D>> = held.iter().map(|held| held.aabb).collect();
        let mut found = false;
        self.tree.visit_own_pairs(
            |f, aabb| boxes[f as usize].meets(aabb),
            |f, g| {
                let [i, j] = [f as usize, g as usize];
                found = boxes[i].meets(&boxes[j]) && self.may_cross([f, g], [&held[i], &held[j]], tolerance);
                !found
            },
        );
        found
    }

    /// Whether any two of some facets may cross.
    pub(super) fn may_cross_among(&self, facets: &[u32]) -> bool {
        let tolerance = self.aabb.rounding();
        let held: Vec<Held<D>> = facets.iter().map(|&facet| self.hold(facet, tolerance)).collect();
        let boxes: Vec<Aabb<D>> = held.iter().map(|held| held.aabb).collect();
        let mut found = false;
        let may_meet = |i: u32, aabb: &Aabb<D>| boxes[i as usize].meets(aabb);
        Tree::new(&boxes).visit_own_pairs(&Vector::zeros(), may_meet, |i, j| {
            let [i, j] = [i as usize, j as usize];
            found =
                boxes[i].meets(&boxes[j]) && self.may_cross([facets[i], facets[j]], [&held[i], &held[j]], tolerance);
            !found
        });
        found
    }

    fn hold(&self, facet: u32, tolerance: f64) -> Held<D> {
        let corners = self.corners(facet as usize);
        let area = area_vector(&corners);
        let unit = area.try_normalize(0.0).unwrap_or_else(Vector::zeros);
        Held { aabb: Aabb::of(&corners).inflated(tolerance), corners, area, unit }
    }

    /// Whether two facets whose boxes meet may do so in more than the vertices that they share.
    fn may_cross(&self, [f, g]: [u32; 2], [p, q]: [&Held<D>; 2], tolerance: f64) -> bool {
        let (of_f, of_g) = (&self.facets[f as usize], &self.facets[g as usize]);
        let shared = || of_f.iter().filter(|v| of_g.contains(v));
        if shared().count() > 0 && p.unit.dot(&q.unit) > SMOOTH {
            return false;
        }
        let (x, y) = (&p.corners, &q.corners);
        if is_beside(x, of_f, y, of_g, &q.area, tolerance) || is_beside(y, of_g, x, of_f, &p.area, tolerance) {
            return false;
        }
        let (Some(v), 1) = (shared().next(), shared().count()) else {
            return shared().count() > 0 || !are_apart_across_edges(x, y, tolerance);
        };
        let from = |of: &[u32; D], corners: &[Vector<D>; D]| -> Vec<Vector<D>> {
            let others = of.iter().zip(corners).filter(|(w, _)| *w != v);
            others.map(|(_, x)| x - self.points[*v as usize]).collect()
        };
        !are_apart(&from(of_f, x), &from(of_g, y), tolerance)
    }
}

/// Steps in which a plane between two cones is looked for: those of neighbouring facets take one or two.
const STEPS: usize = 12;

/// Whether a plane through the tip keeps two cones with a common tip apart, given vectors along their edges, whose ends
/// are farther from it than `tolerance`.
///
/// Where one is found, it is a proof; a narrow gap may go unnoticed (the perceptron's steps).
fn are_apart<const D: usize>(one: &[Vector<D>], other: &[Vector<D>], tolerance: f64) -> bool {
    let edges: Vec<Vector<D>> = one.iter().copied().chain(other.iter().map(|y| -y)).collect();
    let units: Vec<Vector<D>> = edges.iter().map(|e| e.try_normalize(0.0).unwrap_or_else(Vector::zeros)).collect();
    let mut normal: Vector<D> = units.iter().sum();
    for _ in 0..STEPS {
        let bound = tolerance * normal.norm();
        let Some(behind) = edges.iter().position(|e| normal.dot(e) <= bound) else { return true };
        normal += units[behind];
    }
    false
}

/// Whether two facets are apart along a direction across an edge of either: with those of `is_beside` these are all directions in which
/// triangles can be apart (the separating axis theorem; Gottschalk, Lin, Manocha 1996, section 5).
fn are_apart_across_edges<const D: usize>(x: &[Vector<D>; D], y: &[Vector<D>; D], tolerance: f64) -> bool {
    let edges =
        |corners: &[Vector<D>; D]| -> [Vector<D>; D] { std::array::from_fn(|k| corners[(k + 1) % D] - corners[k]) };
    let extent = |axis: &Vector<D>, corners: &[Vector<D>; D]| {
        let heights = corners.each_ref().map(|corner| axis.dot(&(corner - x[0])));
        [heights.into_iter().fold(f64::INFINITY, f64::min), heights.into_iter().fold(f64::NEG_INFINITY, f64::max)]
    };
    let of_y = edges(y);
    D == 3
        && edges(x).iter().flat_map(|e| of_y.iter().map(move |f| cross(e, f))).any(|axis| {
            let ([low_x, high_x], [low_y, high_y]) = (extent(&axis, x), extent(&axis, y));
            (low_x - high_y).max(low_y - high_x) > tolerance * axis.norm()
        })
}

/// Whether the corners `x` that are not shared lie on one side of the plane of `y`, or beside one of its edges, and
/// farther away than `tolerance`.
fn is_beside<const D: usize>(
    x: &[Vector<D>; D],
    of_x: &[u32; D],
    y: &[Vector<D>; D],
    of_y: &[u32; D],
    area: &Vector<D>,
    tolerance: f64,
) -> bool {
    let mut shared = 0;
    // Heights, in units of the direction's length, of the corners that are not shared.
    let mut heights = |direction: &Vector<D>, origin: &Vector<D>| {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        shared = 0;
        for (x, vertex) in x.iter().zip(of_x) {
            if of_y.contains(vertex) {
                shared += 1;
            } else {
                let height = direction.dot(&(x - origin));
                (low, high) = (low.min(height), high.max(height));
            }
        }
        (low, high)
    };
    let size = area.norm();
    let (low, high) = heights(area, &y[0]);
    if size > 0.0 && (low > tolerance * size || high < -tolerance * size) {
        return true;
    }
    // An edge's outward direction in the facet's plane; in 2D, along the facet at either end.
    let beside = (0..D).any(|k| {
        let (p, q) = (y[k], y[(k + 1) % D]);
        let outward = if D == 2 { p - q } else { cross(&(q - p), area) };
        let (low, _) = heights(&outward, &p);
        low > tolerance * outward.norm()
    });
    beside && shared == 0
}
