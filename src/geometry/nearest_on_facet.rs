//! The point of a facet that is nearest to a point.

use super::Vector;

/// Squared distance of `x` from the facet with these corners.
pub(crate) fn squared_distance<const D: usize>(corners: &[Vector<D>; D], x: &Vector<D>) -> f64 {
    (x - nearest(corners, x)).norm_squared()
}

/// The point of the facet with these corners that is nearest to `x`.
///
/// In 3D by the regions of a triangle's corners, edges and inside (Ericson, Real-Time Collision Detection, 2005, 5.1.5).
pub(crate) fn nearest<const D: usize>(corners: &[Vector<D>; D], x: &Vector<D>) -> Vector<D> {
    if D == 2 {
        return on_segment(&corners[0], &corners[1], x);
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
        return a + ab * (vb / sum) + ac * (vc / sum);
    }
    let on_edges = [(a, b), (b, c), (c, a)].map(|(p, q)| on_segment(p, q, x));
    let nearer = |p: Vector<D>, q: Vector<D>| if (x - q).norm_squared() < (x - p).norm_squared() { q } else { p };
    on_edges.into_iter().reduce(nearer).unwrap_or(*a)
}

fn on_segment<const D: usize>(p: &Vector<D>, q: &Vector<D>, x: &Vector<D>) -> Vector<D> {
    let (along, from) = (q - p, x - p);
    let squared = along.norm_squared();
    let part = if squared > 0.0 { (along.dot(&from) / squared).clamp(0.0, 1.0) } else { 0.0 };
    p + along * part
}
