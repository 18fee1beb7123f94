//! Shape functions of wedges.
//!
//! With the barycentric coordinates L of the triangle, ζ along the axis and ζ_a = ±1 at the ends:
//!
//! ```text
//! Wedge6    corner L ½ (1 + ζ ζ_a)
//! Wedge15   corner ½ L ((2L − 1)(1 + ζ ζ_a) − (1 − ζ²))    middle of an edge of a triangle 2 L_p L_q (1 + ζ ζ_a)
//!           middle of an edge along ζ  L (1 − ζ²)
//! ```

/// Edges of the triangle, in the order of the nodes in their middles.
const EDGES: [[usize; 2]; 3] = [[0, 1], [1, 2], [2, 0]];

/// Barycentric coordinates of the points in the triangle: the first at their own corner, the second at the others.
pub(super) const NEAR: f64 = 2.0 / 3.0;
pub(super) const FAR: f64 = 1.0 / 6.0;

/// Corners about the nodes of `Wedge15` that are no corners, in their order.
pub(super) const MIDDLES: [[usize; 2]; 9] = [[0, 1], [1, 2], [2, 0], [3, 4], [4, 5], [5, 3], [0, 3], [1, 4], [2, 5]];

/// Shape functions of a wedge of `count` nodes, 6 or 15, and their derivatives, where the triangle has the first two coordinates.
pub(super) fn wedge(count: usize, [xi, eta, zeta]: [f64; 3]) -> Vec<(f64, [f64; 3])> {
    let l = [1.0 - xi - eta, xi, eta];
    let slopes = [[-1.0, -1.0], [1.0, 0.0], [0.0, 1.0]];
    // A function of L times one of ζ: values and derivatives of both.
    let product = |(f, df): (f64, [f64; 2]), (g, dg): (f64, f64)| (f * g, [df[0] * g, df[1] * g, f * dg]);
    let end = |top: usize| if top == 0 { (0.5 * (1.0 - zeta), -0.5) } else { (0.5 * (1.0 + zeta), 0.5) };
    let bubble = (1.0 - zeta * zeta, -2.0 * zeta);
    let linear = |k: usize| (l[k], slopes[k]);
    let places = || (0..2).flat_map(|top| (0..3).map(move |k| (k, top)));
    if count == 6 {
        return places().map(|(k, top)| product(linear(k), end(top))).collect();
    }
    let corner = |(k, top): (usize, usize)| {
        // L (2L − 1) ½ (1 ± ζ) − ½ L (1 − ζ²)
        let whole = product((l[k] * (2.0 * l[k] - 1.0), slopes[k].map(|d| (4.0 * l[k] - 1.0) * d)), end(top));
        let less = product(linear(k), bubble);
        (whole.0 - 0.5 * less.0, std::array::from_fn(|i| whole.1[i] - 0.5 * less.1[i]))
    };
    let middle = |(edge, top): (usize, usize)| {
        let [p, q] = EDGES[edge];
        let slope = [0, 1].map(|i| 4.0 * (slopes[p][i] * l[q] + l[p] * slopes[q][i]));
        product((4.0 * l[p] * l[q], slope), end(top))
    };
    let upright = (0..3).map(|k| product(linear(k), bubble));
    places().map(corner).chain(places().map(middle)).chain(upright).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn nodes(count: usize) -> Vec<[f64; 3]> {
        let corner = |k: usize| {
            let [xi, eta] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]][k % 3];
            [xi, eta, if k < 3 { -1.0 } else { 1.0 }]
        };
        let mean = |[p, q]: [usize; 2]| std::array::from_fn(|i| 0.5 * (corner(p)[i] + corner(q)[i]));
        (0..6).map(corner).chain(MIDDLES.into_iter().map(mean)).take(count).collect()
    }

    /// One at their node and zero at the others; and a polynomial that they have is met with its derivatives.
    #[test]
    fn shape_functions_are_those_of_their_nodes() {
        for count in [6, 15] {
            for (node, place) in nodes(count).into_iter().enumerate() {
                for (other, (value, _)) in wedge(count, place).iter().enumerate() {
                    assert!((value - f64::from(u8::from(node == other))).abs() < 1e-15, "{count}: {other} at {node}");
                }
            }
            let second = f64::from(u8::from(count == 15));
            let f = |[x, y, z]: [f64; 3]| {
                1.0 + 2.0 * x - y + 3.0 * z + x * z - 2.0 * y * z
                    + second * (x * x - 0.5 * y * y + x * y + z * z + x * x * z)
            };
            let slope = |[x, y, z]: [f64; 3]| {
                [
                    2.0 + z + second * (2.0 * x + y + 2.0 * x * z),
                    -1.0 - 2.0 * z + second * (x - y),
                    3.0 + x - 2.0 * y + second * (2.0 * z + x * x),
                ]
            };
            let xi = [0.21, 0.37, 0.13];
            let (values, shapes): (Vec<f64>, _) = (nodes(count).into_iter().map(f).collect(), wedge(count, xi));
            let pairs = || shapes.iter().zip(&values);
            assert!((pairs().map(|(shape, v)| shape.0 * v).sum::<f64>() - f(xi)).abs() < 1e-14);
            for (axis, expected) in slope(xi).into_iter().enumerate() {
                let found: f64 = pairs().map(|(shape, v)| shape.1[axis] * v).sum();
                assert!((found - expected).abs() < 1e-13, "{count} {axis}");
            }
        }
    }
}
