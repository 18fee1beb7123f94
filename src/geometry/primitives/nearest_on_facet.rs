//! The point of a facet that is nearest to a point.

use super::convex_piece::place;
use crate::geometry::Vector;

/// Barycentric coordinates of the point of the facet with these corners that is nearest to `x`.
///
/// In 3D by the regions of a triangle's corners, edges and inside (Ericson, Real-Time Collision Detection, 2005, 5.1.5).
pub(crate) fn nearest<const D: usize>(corners: &[Vector<D>; D], x: &Vector<D>) -> [f64; D] {
    let on_edge = |p: usize, q: usize| {
        let part = along(&corners[p], &corners[q], x);
        let mut weights = [0.0; D];
        (weights[p], weights[q]) = (1.0 - part, part);
        weights
    };
    if D == 2 {
        return on_edge(0, 1);
    }
    let [a, b, c] = [&corners[0], &corners[1], &corners[D - 1]];
    let (ab, ac) = (b - a, c - a);
    let (ap, bp, cp) = (x - a, x - b, x - c);
    // Products with the edges: their signs tell which corner or edge is nearest.
    let (d1, d2) = (ab.dot(&ap), ac.dot(&ap));
    let (d3, d4) = (ab.dot(&bp), ac.dot(&bp));
    let (d5, d6) = (ab.dot(&cp), ac.dot(&cp));
    let (va, vb, vc) = (d3 * d6 - d5 * d4, d5 * d2 - d1 * d6, d1 * d4 - d3 * d2);
    let sum = va + vb + vc;
    if va > 0.0 && vb > 0.0 && vc > 0.0 && sum > 0.0 {
        return std::array::from_fn(|k| [va, vb, vc][k] / sum);
    }
    let mut best = (f64::INFINITY, [0.0; D]);
    for (p, q) in [(0, 1), (1, 2), (2, 0)] {
        let weights = on_edge(p, q);
        let squared = (x - place(corners, &weights)).norm_squared();
        if squared < best.0 {
            best = (squared, weights);
        }
    }
    best.1
}

/// Squared distance of `x` from a facet.
pub(crate) fn squared_distance<const D: usize>(corners: &[Vector<D>; D], x: &Vector<D>) -> f64 {
    (x - place(corners, &nearest(corners, x))).norm_squared()
}

/// Part of the way from `p` to `q` at which it is nearest to `x`.
fn along<const D: usize>(p: &Vector<D>, q: &Vector<D>, x: &Vector<D>) -> f64 {
    let way = q - p;
    let squared = way.norm_squared();
    if squared > 0.0 { (way.dot(&(x - p)) / squared).clamp(0.0, 1.0) } else { 0.0 }
}
