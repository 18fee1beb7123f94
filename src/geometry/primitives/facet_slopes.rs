//! How the place where a line crosses a facet depends on the place of the line.
//!
//! With m·(x_b − x_c) = 0, m·d = 1, and h_a·(x_b − x_c) = δ_ab − δ_ac, h_a·d = 0: a line moved by s across d crosses
//! m·s earlier, at barycentric coordinates that are h_a·s larger.

use super::facet::area_vector;
use crate::geometry::Vector;

/// m and h_a of a facet with these corners, for lines along `d`; `None` if they run along it.
pub(crate) fn slopes<const D: usize>(x: &[Vector<D>; D], d: &Vector<D>) -> Option<(Vector<D>, [Vector<D>; D])> {
    let mut h = [Vector::zeros(); D];
    let mut m = Vector::zeros();
    let e = x[1] - x[0];
    let det = match D {
        2 => {
            let det = e[0] * d[1] - e[1] * d[0];
            (m[0], m[1]) = (-e[1], e[0]);
            (h[1][0], h[1][1]) = (d[1], -d[0]);
            det
        }
        _ => {
            let f = x[2] - x[0];
            (h[1], h[2], m) = (cross(&f, d), cross(d, &e), cross(&e, &f));
            e.dot(&h[1])
        }
    };
    if det == 0.0 {
        return None;
    }
    m /= det;
    for a in 1..D {
        h[a] /= det;
        let part = h[a];
        h[0] -= part;
    }
    Some((m, h))
}

/// p × q, in 3D.
pub(crate) fn cross<const D: usize>(p: &Vector<D>, q: &Vector<D>) -> Vector<D> {
    Vector::from_fn(|i, _| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        p[j] * q[k] - p[k] * q[j]
    })
}

/// Barycentric coordinates of the foot of a point on the plane of a facet; `None` where that has no measure.
pub(crate) fn foot<const D: usize>(corners: &[Vector<D>; D], x: &Vector<D>) -> Option<[f64; D]> {
    let (_, along) = slopes(corners, &area_vector(corners).try_normalize(0.0)?)?;
    let from = x - corners[0];
    Some(std::array::from_fn(|k| along[k].dot(&from) + f64::from(u8::from(k == 0))))
}

/// Slope across the lines of what is linear on a facet; `None` if lines run along it.
pub(crate) fn across<const D: usize>(x: &[Vector<D>; D], d: &Vector<D>, at_corners: &[f64; D]) -> Option<Vector<D>> {
    let (_, h) = slopes(x, d)?;
    Some((0..D).fold(Vector::zeros(), |sum, a| sum + h[a] * at_corners[a]))
}
