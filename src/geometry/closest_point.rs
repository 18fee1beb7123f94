//! The point of a facet that is nearest to a point of space.

use super::Vector;

/// Barycentric coordinates of the point of a facet that is nearest to `x`.
///
/// 3D: by the region of the triangle's plane in which `x` lies (Ericson, Real-Time Collision Detection, 5.1.5).
pub(crate) fn closest_point<const D: usize>(facet: &[Vector<D>; D], x: &Vector<D>) -> [f64; D] {
    let mut w = [0.0; D];
    let ab = facet[1] - facet[0];
    if D == 2 {
        let s = along(ab.dot(&(x - facet[0])), ab.norm_squared());
        (w[0], w[1]) = (1.0 - s, s);
        return w;
    }
    let ac = facet[2 % D] - facet[0];
    let [a, b, c] = [0, 1, 2 % D].map(|k| x - facet[k]);
    let [[d1, d2], [d3, d4], [d5, d6]] = [a, b, c].map(|p| [ab.dot(&p), ac.dot(&p)]);
    let (va, vb, vc) = (d3 * d6 - d5 * d4, d5 * d2 - d1 * d6, d1 * d4 - d3 * d2);
    let v: [f64; 3] = if d1 <= 0.0 && d2 <= 0.0 {
        [1.0, 0.0, 0.0]
    } else if d3 >= 0.0 && d4 <= d3 {
        [0.0, 1.0, 0.0]
    } else if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        let s = along(d1, d1 - d3);
        [1.0 - s, s, 0.0]
    } else if d6 >= 0.0 && d5 <= d6 {
        [0.0, 0.0, 1.0]
    } else if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        let s = along(d2, d2 - d6);
        [1.0 - s, 0.0, s]
    } else if va <= 0.0 && d4 >= d3 && d5 >= d6 {
        let s = along(d4 - d3, (d4 - d3) + (d5 - d6));
        [0.0, 1.0 - s, s]
    } else {
        let (s, t) = (along(vb, va + vb + vc), along(vc, va + vb + vc));
        [1.0 - s - t, s, t]
    };
    std::array::from_fn(|k| v[k])
}

/// `part / whole` in [0, 1]; 0 where there is no whole.
fn along(part: f64, whole: f64) -> f64 {
    if whole > 0.0 { (part / whole).clamp(0.0, 1.0) } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// No point of a fine raster over the facet is nearer.
    fn against_raster<const D: usize>(facet: &[Vector<D>; D]) {
        let place = |w: &[f64; D]| (0..D).fold(Vector::<D>::zeros(), |sum, k| sum + facet[k] * w[k]);
        for n in 0..400u32 {
            let random = |k: u32| f64::from((n * 7919 + k * 104_729) % 1009) / 1009.0 * 6.0 - 2.5;
            let x = Vector::<D>::from_fn(|i, _| random(i as u32 + 1));
            let w = closest_point(facet, &x);
            assert!(w.iter().all(|w| *w >= -1e-15) && (w.iter().sum::<f64>() - 1.0).abs() < 1e-12);
            let found = (place(&w) - x).norm();
            for i in 0..=60 {
                for j in 0..=(if D == 2 { 0 } else { 60 - i }) {
                    let (s, t) = (f64::from(i) / 60.0, f64::from(j) / 60.0);
                    let at = [1.0 - s - t, s, t];
                    assert!((place(&std::array::from_fn(|k| at[k])) - x).norm() >= found - 1e-12);
                }
            }
        }
    }

    #[test]
    fn nothing_is_nearer() {
        against_raster(&[Vector::<2>::new(0.2, -0.4), Vector::<2>::new(1.7, 1.1)]);
        let v = Vector::<3>::new;
        against_raster(&[v(0.1, 0.2, -0.3), v(1.9, 0.3, 0.4), v(0.4, 1.8, 0.9)]);
        against_raster(&[v(0.0, 0.0, 0.0), v(2.0, 0.0, 0.0), v(-1.5, 0.3, 0.2)]);
    }
}
