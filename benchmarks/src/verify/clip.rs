//! Overlap of a moving polygon with a fixed convex one, in closed form.
//!
//! The moving polygon is cut by the half-plane of every side of the fixed one (Sutherland and Hodgman). Each side of the
//! result remembers whose it is, because only the moving sides sweep area: with velocity v = dx/dθ and outward normal n,
//!
//! ```text
//!     dA/dθ = Σ_{moving sides} ∫ v·n dl ,
//! ```
//!
//! and the integral is that of a linear function, as v is linear (a translation, a turn, a growth).

use super::closed_form::ClosedForm;

type Point = [f64; 2];

/// A corner, and whether the side that starts there belongs to the moving polygon.
type Corner = (Point, bool);

/// Area common to both polygons, and its derivative; corners counter-clockwise.
pub(super) fn clip(moving: &[Point], velocity: impl Fn(Point) -> Point, fixed: &[Point]) -> ClosedForm {
    let mut corners: Vec<Corner> = moving.iter().map(|&x| (x, true)).collect();
    for (k, &from) in fixed.iter().enumerate() {
        corners = cut(&corners, from, fixed[(k + 1) % fixed.len()]);
    }
    let mut sum = ClosedForm { value: 0.0, derivative: 0.0, flux: 0.0 };
    let Some(&(pivot, _)) = corners.first() else { return sum };
    for (k, &(a, is_moving)) in corners.iter().enumerate() {
        let (b, _) = corners[(k + 1) % corners.len()];
        sum.value += 0.5 * ((a[0] - pivot[0]) * (b[1] - pivot[1]) - (a[1] - pivot[1]) * (b[0] - pivot[0]));
        if is_moving {
            let outflow = |x: Point| velocity(x)[0] * (b[1] - a[1]) - velocity(x)[1] * (b[0] - a[0]);
            let (at_a, at_b) = (outflow(a), outflow(b));
            sum.derivative += 0.5 * (at_a + at_b);
            // Linear between its ends: two triangles where the sign changes, else a trapezium.
            let size = at_a.abs() + at_b.abs();
            sum.flux += if at_a * at_b < 0.0 { 0.5 * (at_a * at_a + at_b * at_b) / size } else { 0.5 * size };
        }
    }
    sum
}

/// The part on the left of the line from `from` to `to`.
fn cut(corners: &[Corner], from: Point, to: Point) -> Vec<Corner> {
    let height = |x: Point| (to[0] - from[0]) * (x[1] - from[1]) - (to[1] - from[1]) * (x[0] - from[0]);
    let mut kept = Vec::with_capacity(corners.len() + 1);
    for (k, &(a, is_moving)) in corners.iter().enumerate() {
        let (b, _) = corners[(k + 1) % corners.len()];
        let (height_a, height_b) = (height(a), height(b));
        let meeting = || {
            let s = height_a / (height_a - height_b);
            [a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])]
        };
        match (height_a > 0.0, height_b > 0.0) {
            (true, true) => kept.push((a, is_moving)),
            (true, false) => kept.extend([(a, is_moving), (meeting(), false)]),
            (false, true) => kept.push((meeting(), is_moving)),
            (false, false) => {}
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(corner: Point) -> [Point; 4] {
        let [x, y] = corner;
        [[x, y], [x + 1.0, y], [x + 1.0, y + 1.0], [x, y + 1.0]]
    }

    #[test]
    fn shifted_squares() {
        let overlap = clip(&square([0.25, 0.5]), |_| [1.0, 0.0], &square([0.0, 0.0]));
        assert_eq!(overlap, ClosedForm { value: 0.375, derivative: -0.5, flux: 0.5 });
        assert_eq!(clip(&square([2.0, 0.0]), |_| [1.0, 0.0], &square([0.0, 0.0])).value, 0.0);
    }

    #[test]
    fn derivative_is_that_of_the_area() {
        let turned = |angle: f64| {
            let (s, c) = angle.sin_cos();
            square([-0.5, -0.5]).map(|x| [c * x[0] - s * x[1], s * x[0] + c * x[1]])
        };
        let overlap = |angle| clip(&turned(angle), |x| [-x[1], x[0]], &square([-0.2, -0.3]));
        for angle in [0.1, 0.4, 0.9, 1.3] {
            let step = 1e-5;
            let difference = (overlap(angle + step).value - overlap(angle - step).value) / (2.0 * step);
            assert!((overlap(angle).derivative - difference).abs() < 1e-9);
        }
    }

    /// A whole turning unit square: on each side |v·n| is the distance from the middle.
    #[test]
    fn flux_counts_both_ways() {
        let overlap = clip(&square([-0.5, -0.5]), |x| [-x[1], x[0]], &square([-0.5, -0.5]).map(|x| x.map(|x| 3.0 * x)));
        assert_eq!(overlap, ClosedForm { value: 1.0, derivative: 0.0, flux: 1.0 });
    }
}
