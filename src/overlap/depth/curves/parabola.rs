//! Quadratic functions of a number from 0 to 1, c + b t + a t².

use smallvec::SmallVec;

/// Numbers from 0 to 1, ascending.
pub(super) type Marks = SmallVec<[f64; 16]>;

/// The coefficients of such a function.
pub(super) fn quadratic(at: impl Fn(f64) -> f64) -> [f64; 3] {
    quadratic_through([0.0, 0.5, 1.0].map(at))
}

/// The same from its values at 0, in the middle, and at 1.
pub(super) fn quadratic_through([first, middle, last]: [f64; 3]) -> [f64; 3] {
    [first, 4.0 * middle - 3.0 * first - last, 2.0 * (first + last) - 4.0 * middle]
}

/// Where a t² + b t + c = 0, without loss of digits; not finite where there is no root.
fn roots(a: f64, b: f64, c: f64) -> [f64; 2] {
    let q = -0.5 * (b + (b * b - 4.0 * a * c).sqrt().copysign(b));
    [q / a, c / q]
}

/// Its value.
pub(super) fn value([c, b, a]: &[f64; 3], t: f64) -> f64 {
    c + t * (b + t * a)
}

/// Where it is at a level, with both ends.
pub(super) fn crossings([c, b, a]: &[f64; 3], levels: &[f64]) -> Marks {
    let mut marks = Marks::from_slice(&[0.0, 1.0]);
    for level in levels {
        marks.extend(roots(*a, *b, c - level).into_iter().filter(|r| 0.0 < *r && *r < 1.0));
    }
    marks.sort_unstable_by(f64::total_cmp);
    marks.dedup();
    marks
}

/// Its roots, real and imaginary part.
pub(super) fn complex_roots([c, b, a]: [f64; 3]) -> impl Iterator<Item = [f64; 2]> {
    let discriminant = b * b - 4.0 * a * c;
    let found = match discriminant < 0.0 {
        true => [[-0.5 * b / a, 0.5 * (-discriminant).sqrt() / a]; 2],
        false => roots(a, b, c).map(|t| [t, 0.0]),
    };
    found.into_iter().filter(|[t, aside]| t.is_finite() && aside.is_finite())
}
