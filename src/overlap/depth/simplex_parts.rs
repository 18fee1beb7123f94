//! Simplices of one to three dimensions, divided and cut.

use crate::geometry::primitives::simplex_rule::InSimplex;

/// Corners of a simplex, in the barycentric coordinates of another.
pub(crate) type Corners = [InSimplex; 4];

/// A simplex in its own coordinates.
pub(crate) const WHOLE: Corners =
    [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];

/// Point between corners of a simplex, given by its barycentric coordinates in it.
pub(crate) fn between(corners: &Corners, at: &InSimplex) -> InSimplex {
    std::array::from_fn(|i| (0..4).map(|c| at[c] * corners[c][i]).sum())
}

/// Calls `visit(simplex, part of the measure)` for simplices that make up the part of one of `dimension` dimensions where
/// the linear function with these values at its corners is negative.
pub(crate) fn below(dimension: usize, values: &[f64; 4], mut visit: impl FnMut(&Corners, f64)) {
    let mut order = [0, 1, 2, 3];
    let mut inside = 0;
    for c in 0..=dimension {
        if values[order[c]] < 0.0 {
            order.swap(c, inside);
            inside += 1;
        }
    }
    if inside == dimension + 1 {
        visit(&WHOLE, 1.0);
        return;
    }
    let corner = |c: usize| WHOLE[order[c]];
    let cut = |p: usize, q: usize| {
        let (p, q) = (order[p], order[q]);
        let part = values[p] / (values[p] - values[q]);
        let mut at = [0.0; 4];
        (at[p], at[q]) = (1.0 - part, part);
        at
    };
    let none = [0.0; 4];
    let mut add = |simplex: Corners| {
        let part = measure(dimension, &simplex);
        if part > 0.0 {
            visit(&simplex, part);
        }
    };
    match (dimension, inside) {
        (_, 0) => {}
        (1, _) => add([corner(0), cut(0, 1), none, none]),
        (2, 1) => add([corner(0), cut(0, 1), cut(0, 2), none]),
        (2, _) => {
            add([corner(0), corner(1), cut(0, 2), none]);
            add([corner(1), cut(0, 2), cut(1, 2), none]);
        }
        (_, 1) => add([corner(0), cut(0, 1), cut(0, 2), cut(0, 3)]),
        (_, 2) => {
            // A wedge with the triangles 0 a b and 1 c d.
            let (a, b, c, d) = (cut(0, 2), cut(0, 3), cut(1, 2), cut(1, 3));
            add([corner(0), a, b, corner(1)]);
            add([a, b, corner(1), d]);
            add([a, corner(1), c, d]);
        }
        _ => {
            let (a, b, c) = (cut(0, 3), cut(1, 3), cut(2, 3));
            add([corner(0), corner(1), corner(2), a]);
            add([corner(1), corner(2), a, b]);
            add([corner(2), a, b, c]);
        }
    }
}

/// Measure of a simplex in parts of that whose coordinates are used.
pub(crate) fn measure(dimension: usize, x: &Corners) -> f64 {
    let edge = |c: usize, i: usize| x[c][i] - x[0][i];
    match dimension {
        1 => edge(1, 1),
        2 => edge(1, 1) * edge(2, 2) - edge(1, 2) * edge(2, 1),
        _ => {
            edge(1, 1) * (edge(2, 2) * edge(3, 3) - edge(2, 3) * edge(3, 2))
                + edge(1, 2) * (edge(2, 3) * edge(3, 1) - edge(2, 1) * edge(3, 3))
                + edge(1, 3) * (edge(2, 1) * edge(3, 2) - edge(2, 2) * edge(3, 1))
        }
    }
    .abs()
}
