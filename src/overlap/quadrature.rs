//! Quadrature on convex pieces of facets.

pub(super) fn mean<const D: usize>(piece: &[[f64; D]]) -> [f64; D] {
    std::array::from_fn(|a| piece.iter().map(|w| w[a]).sum::<f64>() / piece.len() as f64)
}

/// Calls `visit(barycentric, part of the facet's measure)` for every quadrature point of a convex piece: two Gauss points
/// on an interval (degree 3), three in every triangle of a polygon (degree 2).
pub(super) fn for_each_gauss_point<const D: usize>(piece: &[[f64; D]], mut visit: impl FnMut(&[f64; D], f64)) {
    if D == 2 {
        let (p, q) = (&piece[0], &piece[1]);
        for s in [0.5 - 0.5 / 3f64.sqrt(), 0.5 + 0.5 / 3f64.sqrt()] {
            visit(&std::array::from_fn(|a| p[a] + s * (q[a] - p[a])), 0.5 * (q[1] - p[1]).abs());
        }
        return;
    }
    let p = &piece[0];
    for k in 1..piece.len() - 1 {
        let corners = [p, &piece[k], &piece[k + 1]];
        let [_, q, r] = corners;
        let part = ((q[1] - p[1]) * (r[2] - p[2]) - (q[2] - p[2]) * (r[1] - p[1])).abs();
        for near in 0..3 {
            let weight = |corner: usize| if corner == near { 2.0 / 3.0 } else { 1.0 / 6.0 };
            visit(&std::array::from_fn(|a| (0..3).map(|c| weight(c) * corners[c][a]).sum()), part / 3.0);
        }
    }
}

/// Part of the facet's measure.
pub(super) fn measure<const D: usize>(piece: &[[f64; D]]) -> f64 {
    let mut measure = 0.0;
    for_each_gauss_point(piece, |_, part| measure += part);
    measure
}
