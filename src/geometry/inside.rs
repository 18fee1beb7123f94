//! Where points lie.

use super::Vector;
use super::crossing::{Projected, Window, for_each_crossing};

/// How often closed, oriented facets cover the point `x`: 0 outside, 1 inside, 2 where the body folds over itself.
///
/// Counted along the line through `x` parallel to the last axis. On the boundary it may be either.
pub(crate) fn winding_number<const D: usize>(facets: &[[u32; D]], points: &[Vector<D>], x: &Vector<D>) -> i32 {
    winding_numbers(facets, points, std::slice::from_ref(x))[0]
}

/// [`winding_number`] of many points, in one pass over the facets.
pub(crate) fn winding_numbers<const D: usize>(facets: &[[u32; D]], points: &[Vector<D>], x: &[Vector<D>]) -> Vec<i32> {
    let mut counts = vec![0; x.len()];
    let mut order: Vec<u32> = (0..x.len() as u32).collect();
    order.sort_unstable_by(|&p, &q| x[p as usize][0].total_cmp(&x[q as usize][0]));
    for facet in facets {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for &v in facet {
            let u = points[v as usize][0];
            (low, high) = (low.min(u), high.max(u));
        }
        let first = if x.len() == 1 { 0 } else { order.partition_point(|&q| x[q as usize][0] < low) };
        for &query in &order[first..] {
            let x = &x[query as usize];
            if low > x[0] || high < x[0] {
                break;
            }
            let mut p: [Projected; D] = [[0.0; 3]; D];
            for (p, &v) in p.iter_mut().zip(facet) {
                let y = points[v as usize] - x;
                *p = if D == 2 { [y[0], 0.0, y[1]] } else { [y[0], y[1], y[D - 1]] };
            }
            for_each_crossing::<D>(std::array::from_fn(|k| &p[k]), &Window::single(), |_, _, t, leaves| {
                if t < 0.0 {
                    counts[query as usize] += if leaves { -1 } else { 1 };
                }
            });
        }
    }
    counts
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
        for (x, count) in queries.iter().zip(winding_numbers(&facets, &points, &queries)) {
            assert_eq!(count, inside(x, 0.0, 3.0) + inside(x, -1.5, 1.0) - inside(x, 1.5, 1.0), "{x:?}");
            assert_eq!(count, winding_number(&facets, &points, x));
        }
    }
}
