//! Where a point lies.

use super::Vector;
use super::crossing::{Projected, Window, for_each_crossing};

/// How often closed, oriented facets cover the point `x`: 0 outside, 1 inside, 2 where the body folds over itself.
///
/// Counted along the line through `x` parallel to the last axis. On the boundary it may be either.
pub(crate) fn cover_count<const D: usize>(facets: &[[u32; D]], points: &[Vector<D>], x: &Vector<D>) -> i32 {
    let mut count = 0;
    for facet in facets {
        let p: [Projected; D] = facet.map(|v| {
            let y = points[v as usize] - x;
            if D == 2 { [y[0], 0.0, y[1]] } else { [y[0], y[1], y[D - 1]] }
        });
        if p.iter().all(|q| q[0] < 0.0) || p.iter().all(|q| q[0] > 0.0) {
            continue;
        }
        for_each_crossing::<D>(std::array::from_fn(|k| &p[k]), &Window::single(), |_, _, t, leaves| {
            if t < 0.0 {
                count += if leaves { -1 } else { 1 };
            }
        });
    }
    count
}
