//! Crossings of lines with facets, watertight by construction.
//!
//! A family of parallel lines is seen along its direction: every vertex is projected once, into `[u, v, t]`, with u and
//! v across the lines in units of their spacing, so that lines stand at whole numbers, and t along them (2D: v = 0).
//! A facet is then rasterised. In 3D, on the row v = j an edge is crossed if one of its ends has v ≤ j and the other
//! v > j; where, follows from its two ends, ordered by v, and is therefore the same number for both facets at the edge.
//! On that row a facet covers the whole numbers from ⌈u of one crossed edge⌉ up to, not including, ⌈u of the other⌉.
//!
//! On a closed, oriented surface every crossed edge is the upward edge of one facet and the downward edge of another,
//! so the signs of the crossings of any line sum to zero and count each passage once, whatever the rounding and also
//! where a line meets an edge or a node. In 2D the same holds with ⌈u⌉ of the two ends of an edge.

use std::ops::Range;

/// Vertex seen along a family of lines: across, across (0 in 2D), along.
pub(crate) type Projected = [f64; 3];

/// Lines of a family that are of interest: `i` counts along u, `j` along v (2D: `0..1`).
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Window {
    pub(crate) i: Range<i64>,
    pub(crate) j: Range<i64>,
}

impl Window {
    /// The single line at u = v = 0.
    pub(crate) fn single() -> Self {
        Self { i: 0..1, j: 0..1 }
    }

    /// Number of lines.
    pub(crate) fn line_count(&self) -> usize {
        let length = |r: &Range<i64>| (r.end - r.start).max(0) as usize;
        length(&self.i) * length(&self.j)
    }

    /// Number of the line (i, j).
    pub(crate) fn line(&self, i: i64, j: i64) -> u32 {
        ((j - self.j.start) * (self.i.end - self.i.start) + (i - self.i.start)) as u32
    }
}

/// ⌈x⌉ for numbers of lines. The library function is a call where the processor's baseline lacks the instruction.
pub(crate) fn ceil(x: f64) -> i64 {
    let towards_zero = x as i64;
    towards_zero.saturating_add(i64::from(x > towards_zero as f64))
}

/// Value on an edge from `p` to `q` where coordinate `axis` is `at`; exact at the ends, monotone between.
fn along(p: &Projected, q: &Projected, axis: usize, at: f64) -> f64 {
    (at - p[axis]) / (q[axis] - p[axis])
}

/// Calls `visit(i, j, t, leaves)` for every line of the window that crosses the facet with vertices `p`.
///
/// `leaves` is true where the line runs out through the facet (d·n > 0), for facets that are oriented outwards and
/// projected into a right-handed frame (u, v, t), in 2D (u, t).
pub(crate) fn for_each_crossing<const D: usize>(
    p: [&Projected; D],
    window: &Window,
    mut visit: impl FnMut(i64, i64, f64, bool),
) {
    match D {
        2 => {
            let leaves = p[1][0] < p[0][0];
            let (low, high) = if leaves { (p[1], p[0]) } else { (p[0], p[1]) };
            let first = ceil(low[0]).max(window.i.start);
            let last = ceil(high[0]).min(window.i.end);
            for i in first..last {
                visit(i, 0, low[2] + along(low, high, 0, i as f64) * (high[2] - low[2]), leaves);
            }
        }
        _ => {
            // a, b, c: ascending v. `even`: the facet runs a → b → c, so its long edge a–c is passed downwards.
            let (mut a, mut b, mut c, mut even) = (p[0], p[1], p[2], true);
            if b[1] < a[1] {
                (a, b, even) = (b, a, !even);
            }
            if c[1] < b[1] {
                (b, c, even) = (c, b, !even);
            }
            if b[1] < a[1] {
                (a, b, even) = (b, a, !even);
            }
            let middle = ceil(b[1]);
            let first = ceil(a[1]).max(window.j.start);
            let last = ceil(c[1]).min(window.j.end);
            for j in first..last {
                let (s, long) = (j as f64, along(a, c, 1, j as f64));
                let (from, to) = if j < middle { (a, b) } else { (b, c) };
                let short = along(from, to, 1, s);
                let (ul, tl) = (a[0] + long * (c[0] - a[0]), a[2] + long * (c[2] - a[2]));
                let (us, ts) = (from[0] + short * (to[0] - from[0]), from[2] + short * (to[2] - from[2]));
                // The line leaves where the upward edge is on the right.
                let (left, right, leaves) =
                    if ul <= us { ((ul, tl), (us, ts), even) } else { ((us, ts), (ul, tl), !even) };
                let i_first = ceil(left.0).max(window.i.start);
                let i_last = ceil(right.0).min(window.i.end);
                if i_first < i_last {
                    let slope = (right.1 - left.1) / (right.0 - left.0);
                    for i in i_first..i_last {
                        visit(i, j, left.1 + (i as f64 - left.0) * slope, leaves);
                    }
                }
            }
        }
    }
}

/// Weights of the facet's vertices at the line (i, j), and the facet's projected measure times (D−1)!.
///
/// Weights are at least 0 and sum to 1. Where the facet is seen exactly edge-on, the measure is 0 and they are equal.
pub(crate) fn weights_at<const D: usize>(p: [&Projected; D], i: f64, j: f64) -> ([f64; D], f64) {
    let mut w = [0.0; D];
    let total;
    match D {
        2 => {
            total = p[1][0] - p[0][0];
            w[0] = (p[1][0] - i) / total;
            w[1] = (i - p[0][0]) / total;
        }
        _ => {
            let r: [[f64; 2]; 3] = std::array::from_fn(|k| [p[k][0] - i, p[k][1] - j]);
            let minor = |a: usize, b: usize| r[a][0] * r[b][1] - r[a][1] * r[b][0];
            let parts = [minor(1, 2), minor(2, 0), minor(0, 1)];
            total = (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]);
            for k in 0..D {
                w[k] = parts[k] / total;
            }
        }
    }
    if !w.iter().all(|x| x.is_finite()) {
        return ([1.0 / D as f64; D], 0.0);
    }
    w = w.map(|x| x.max(0.0));
    let sum: f64 = w.iter().sum();
    if sum > 0.0 { (w.map(|x| x / sum), total.abs()) } else { ([1.0 / D as f64; D], 0.0) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An octahedron with its nodes and edges on the lines, and the same a little off them by rounding.
    #[test]
    fn lines_through_nodes_and_edges_count_once() {
        for tilt in [0.0, 1e-16, 1e-9, 0.3] {
            let x: [Projected; 6] =
                [[2., 0., 0.], [-2., 0., 0.], [0., 2., 0.], [0., -2., 0.], [0., tilt, 2.], [tilt, 0., -2.]];
            let faces = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
            let window = Window { i: -4..5, j: -4..5 };
            let mut sums = vec![(0i32, 0usize, 0.0); window.line_count()];
            for f in faces {
                for_each_crossing([&x[f[0]], &x[f[1]], &x[f[2]]], &window, |i, j, t, leaves| {
                    let sum = &mut sums[window.line(i, j) as usize];
                    let sign = if leaves { 1.0 } else { -1.0 };
                    *sum = (sum.0 + sign as i32, sum.1 + 1, sum.2 + sign * t);
                });
            }
            for j in -4..5i64 {
                for i in -4..5i64 {
                    let (sign, count, length) = sums[window.line(i, j) as usize];
                    assert_eq!(sign, 0);
                    assert!(count == 0 || count == 2, "line {i} {j}: {count} crossings");
                    if tilt < 1e-6 {
                        let expected = 2.0 * (2 - i.abs() - j.abs()).max(0) as f64;
                        assert!((length - expected).abs() < 1e-6, "line {i} {j}: {length} against {expected}");
                    }
                }
            }
        }
    }

    #[test]
    fn weights_reproduce_the_point() {
        let x: [Projected; 3] = [[0.1, 0.2, 0.0], [3.0, 0.4, 1.0], [1.0, 2.5, 2.0]];
        let (w, twice_area) = weights_at([&x[0], &x[1], &x[2]], 1.3, 0.9);
        let at = |k: usize| (0..3).map(|a| w[a] * x[a][k]).sum::<f64>();
        assert!((at(0) - 1.3).abs() < 1e-14 && (at(1) - 0.9).abs() < 1e-14);
        assert!((twice_area - (2.9 * 2.3 - 0.2 * 0.9)).abs() < 1e-14);
    }
}
