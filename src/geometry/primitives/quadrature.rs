//! Quadrature on convex pieces of facets.

pub(crate) fn mean<const D: usize>(piece: &[[f64; D]]) -> [f64; D] {
    std::array::from_fn(|a| piece.iter().map(|w| w[a]).sum::<f64>() / piece.len() as f64)
}

/// Calls `visit(corners, part of the facet's measure)` for the simplices that make up a convex piece: the interval
/// itself, or the triangles about its first corner.
pub(crate) fn for_each_simplex<const D: usize>(piece: &[[f64; D]], mut visit: impl FnMut([&[f64; D]; D], f64)) {
    let p = &piece[0];
    for k in 1..=piece.len() + 1 - D {
        let corners: [&[f64; D]; D] = std::array::from_fn(|c| if c == 0 { p } else { &piece[k + c - 1] });
        let part = match D {
            2 => (corners[1][1] - p[1]).abs(),
            _ => {
                let (q, r) = (corners[1], corners[D - 1]);
                ((q[1] - p[1]) * (r[2] - p[2]) - (q[2] - p[2]) * (r[1] - p[1])).abs()
            }
        };
        visit(corners, part);
    }
}

/// Two Gauss points on an interval: degree 3.
const ON_INTERVAL: [f64; 2] = [0.211_324_865_405_187_13, 0.788_675_134_594_812_9];

/// Three Gauss points on an interval of length 1 about 0, degree 5.
pub(crate) const ON_CURVE: [(f64, f64); 3] =
    [(-0.387_298_334_620_741_7, 5.0 / 18.0), (0.0, 4.0 / 9.0), (0.387_298_334_620_741_7, 5.0 / 18.0)];

/// Points of a triangle's quadrature: one barycentric coordinate, the others being alike, and the weight of all three.
const DEGREE_2: [(f64, f64); 1] = [(2.0 / 3.0, 1.0)];

/// Strang and Fix' six points (Dunavant 1985, degree 4).
const DEGREE_4: [(f64, f64); 2] =
    [(0.108_103_018_168_070_2, 0.670_144_769_034_034), (0.816_847_572_980_458_5, 0.329_855_230_965_966)];

/// Calls `visit(barycentric, part of the facet's measure)` for every quadrature point of a convex piece: on an interval
/// exact to degree 3, on a polygon, triangle by triangle, to degree 2, or 4 if it shall be `fine`.
pub(crate) fn for_each_gauss_point<const D: usize>(
    piece: &[[f64; D]],
    fine: bool,
    mut visit: impl FnMut(&[f64; D], f64),
) {
    if D == 2 {
        let (p, q) = (&piece[0], &piece[1]);
        for s in ON_INTERVAL {
            visit(&std::array::from_fn(|a| p[a] + s * (q[a] - p[a])), 0.5 * (q[1] - p[1]).abs());
        }
        return;
    }
    for_each_simplex(piece, |corners, part| {
        for &(own, weight) in if fine { &DEGREE_4[..] } else { &DEGREE_2[..] } {
            for near in 0..3 {
                let at = |corner: usize| if corner == near { own } else { 0.5 * (1.0 - own) };
                let w = std::array::from_fn(|a| (0..3).map(|c| at(c) * corners[c][a]).sum());
                visit(&w, part * weight / 3.0);
            }
        }
    });
}

/// Part of the facet's measure.
pub(crate) fn measure<const D: usize>(piece: &[[f64; D]]) -> f64 {
    let mut measure = 0.0;
    for_each_simplex(piece, |_, part| measure += part);
    measure
}
