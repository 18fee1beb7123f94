//! Closed polygons, as edges only.

use crate::Mesh;
use std::f64::consts::TAU;

/// Closed polygon with the given corners, counter-clockwise, each side divided into `side_edges` edges.
pub fn polygon(corners: &[[f64; 2]], side_edges: usize) -> Mesh<2> {
    let n = corners.len();
    assert!(n >= 3 && side_edges > 0, "a polygon of {n} corners and {side_edges} edges a side");
    let mut coords = Vec::with_capacity(n * side_edges);
    for (k, a) in corners.iter().enumerate() {
        let b = corners[(k + 1) % n];
        let along = |s: f64| [a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])];
        coords.extend((0..side_edges).map(|s| along(s as f64 / side_edges as f64)));
    }
    let count = coords.len() as u32;
    Mesh { coords, conn: (0..count).flat_map(|k| [k, (k + 1) % count]).collect(), nodes_per_cell: 2 }
}

/// Regular polygon of `corners` corners on a circle about the origin, the first on the x axis.
pub fn regular_polygon(corners: usize, radius: f64) -> Mesh<2> {
    let corner = |k: usize| on_circle(radius, k as f64 / corners as f64);
    polygon(&(0..corners).map(corner).collect::<Vec<_>>(), 1)
}

/// Star with `tips` tips on radius `outer`, the first on the x axis, and corners between them on radius `inner`.
pub fn star_polygon(tips: usize, outer: f64, inner: f64, side_edges: usize) -> Mesh<2> {
    let corner = |k: usize| {
        let radius = if k.is_multiple_of(2) { outer } else { inner };
        on_circle(radius, k as f64 / (2 * tips) as f64)
    };
    polygon(&(0..2 * tips).map(corner).collect::<Vec<_>>(), side_edges)
}

/// Point at a fraction of the full turn, counter-clockwise from the x axis.
pub(crate) fn on_circle(radius: f64, turn: f64) -> [f64; 2] {
    let (s, c) = (TAU * turn).sin_cos();
    [radius * c, radius * s]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polygons_enclose_their_area() {
        let hexagon = regular_polygon(6, 2.0);
        assert!((hexagon.measure() - 6.0 * 3f64.sqrt()).abs() < 1e-14);
        // A star is 2·tips triangles of sides `outer` and `inner` at the angle π/tips.
        let star = star_polygon(5, 1.0, 0.4, 3);
        assert!((star.measure() - 5.0 * 0.4 * (TAU / 10.0).sin()).abs() < 1e-14);
        assert_eq!(star.cell_count(), 30);
        assert!(star.boundary_faces().is_empty());
    }
}
