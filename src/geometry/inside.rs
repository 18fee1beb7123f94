//! Where a point lies.

use super::Vector;
use super::crossing::{Projected, Window, for_each_crossing};

/// How often closed, oriented facets cover the point `x`: 0 outside, 1 inside, 2 where the body folds over itself.
///
/// Counted along the line through `x` parallel to the last axis. On the boundary it may be either.
pub(crate) fn cover_count<const D: usize>(facets: &[[u32; D]], points: &[Vector<D>], x: &Vector<D>) -> i32 {
    let mut count = 0;
    for facet in facets {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for &v in facet {
            let u = points[v as usize][0];
            (low, high) = (low.min(u), high.max(u));
        }
        if low > x[0] || high < x[0] {
            continue;
        }
        let mut p: [Projected; D] = [[0.0; 3]; D];
        for (p, &v) in p.iter_mut().zip(facet) {
            let y = points[v as usize] - x;
            *p = if D == 2 { [y[0], 0.0, y[1]] } else { [y[0], y[1], y[D - 1]] };
        }
        for_each_crossing::<D>(std::array::from_fn(|k| &p[k]), &Window::single(), |_, _, t, leaves| {
            if t < 0.0 {
                count += if leaves { -1 } else { 1 };
            }
        });
    }
    count
}
