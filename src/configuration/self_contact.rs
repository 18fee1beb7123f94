//! Whether a body can overlap itself.
//!
//! A closed surface whose facets meet only in shared vertices has the winding number 0 or 1 about every point.
//! So a body can overlap itself only if two of its facets cross, or if it has several closed surfaces, one of which may
//! have left another.

use super::FacetSide;
use crate::geometry::Vector;
use crate::geometry::facet::area_vector;
use crate::geometry::facet_slopes::cross;

/// Facets that share a vertex can cross only if they are bent against each other: with unit normals whose product is
/// larger than this they are two pieces of one smooth surface, which meets itself elsewhere if at all.
const SMOOTH: f64 = 0.5;

impl<const D: usize> FacetSide<'_, D> {
    /// Whether two facets may cross: false only if no two can.
    pub(crate) fn may_cross_itself(&self) -> bool {
        let tolerance = self.aabb.rounding();
        let mut found = false;
        self.tree.boxes().visit_own_pairs(|f, g| {
            if !found && self.facet_box(f as usize).meets(&self.facet_box(g as usize).inflated(tolerance)) {
                found = self.may_cross(f, g, tolerance);
            }
            !found
        });
        found
    }

    fn may_cross(&self, f: u32, g: u32, tolerance: f64) -> bool {
        let (x, y) = (self.corners(f as usize), self.corners(g as usize));
        let (of_f, of_g) = (&self.facets[f as usize], &self.facets[g as usize]);
        let shares = of_f.iter().any(|v| of_g.contains(v));
        let (a, b) = (area_vector(&x), area_vector(&y));
        if shares && a.dot(&b) > SMOOTH * a.norm() * b.norm() {
            return false;
        }
        !(is_beside(&x, of_f, &y, of_g, &b, tolerance) || is_beside(&y, of_g, &x, of_f, &a, tolerance))
    }
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
