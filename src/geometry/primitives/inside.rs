//! Where points lie.

use super::crossing::{Projected, Window, for_each_crossing};
use crate::geometry::Vector;

/// Winding number of closed, oriented facets about the point `x`: 0 outside, 1 inside, 2 where the body is folded
/// over itself.
///
/// Counted along the line through `x` parallel to the last axis. On the boundary it may be either.
pub(crate) fn winding_number<const D: usize>(facets: &[[u32; D]], points: &[Vector<D>], x: &Vector<D>) -> i32 {
    facets.iter().map(|facet| winding_step(facet, points, x, D - 1)).sum()
}

/// What one facet contributes to the winding number at `x`, counted along the line through `x` parallel to `axis`.
pub(crate) fn winding_step<const D: usize>(facet: &[u32; D], points: &[Vector<D>], x: &Vector<D>, axis: usize) -> i32 {
    let mut p: [Projected; D] = [[0.0; 3]; D];
    for (p, &v) in p.iter_mut().zip(facet) {
        let y = points[v as usize] - x;
        // A right-handed frame, the axis last.
        *p = match (D, axis) {
            (2, 1) => [y[0], 0.0, y[1]],
            (2, _) => [-y[1], 0.0, y[0]],
            _ => [y[(axis + 1) % 3], y[(axis + 2) % 3], y[axis]],
        };
    }
    let mut step = 0;
    for_each_crossing::<D>(std::array::from_fn(|k| &p[k]), &Window::single(), |_, _, t, leaves| {
        if t < 0.0 {
            step += if leaves { -1 } else { 1 };
        }
    });
    step
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square in a square, the inner one a second cover on the left and a hole on the right, and points everywhere.
    #[test]
    fn points_are_covered_as_often_as_squares_lie_around_them() {
        let v = Vector::<2>::new;
        let square = |x: f64, r: f64| [v(x - r, -r), v(x + r, -r), v(x + r, r), v(x - r, r)];
        let points: Vec<Vector<2>> = [square(0.0, 3.0), square(-1.5, 1.0), square(1.5, 1.0)].concat();
        let edges = |first: u32, forward: bool| {
            (0..4).map(move |k| {
                let (p, q) = (first + k, first + (k + 1) % 4);
                if forward { [p, q] } else { [q, p] }
            })
        };
        let facets: Vec<[u32; 2]> = edges(0, true).chain(edges(4, true)).chain(edges(8, false)).collect();
        let queries: Vec<Vector<2>> =
            (0..400).map(|i| v(0.4 * f64::from(i % 20) - 3.9, 0.4 * f64::from(i / 20) - 3.9)).collect();
        let inside = |x: &Vector<2>, center: f64, r: f64| i32::from((x[0] - center).abs() < r && x[1].abs() < r);
        for x in &queries {
            let expected = inside(x, 0.0, 3.0) + inside(x, -1.5, 1.0) - inside(x, 1.5, 1.0);
            assert_eq!(winding_number(&facets, &points, x), expected, "{x:?}");
        }
    }
}
