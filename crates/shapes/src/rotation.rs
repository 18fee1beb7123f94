//! Turning a shape whose axis is the last coordinate axis.

/// Rotation in the plane of e and `a` that takes e, the last axis, to the unit vector `a`:
/// R = I − (e + a)(e + a)ᵀ / (1 + e·a) + 2 a eᵀ, since R e = e − (e + a) + 2 a. For a = −e, half a turn about the first
/// axis (in 2D: about the origin).
pub fn rotation_onto<const D: usize>(a: [f64; D]) -> [[f64; D]; D] {
    let unit = |row: usize, column: usize| f64::from(u8::from(row == column));
    let last = D - 1;
    let cosine = a[last];
    std::array::from_fn(|row| {
        std::array::from_fn(|column| {
            if cosine < -1.0 + 1e-12 {
                return if row + 2 < D { unit(row, column) } else { -unit(row, column) };
            }
            let sum = |k: usize| unit(k, last) + a[k];
            unit(row, column) - sum(row) * sum(column) / (1.0 + cosine) + 2.0 * a[row] * unit(column, last)
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axis_is_turned_onto_its_direction() {
        for axis in [[0.0, 0.6, 0.8], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0], [0.6, 0.0, -0.8], [1.0, 0.0, 0.0]] {
            let r = rotation_onto(axis);
            let dot = |p: [f64; 3], q: [f64; 3]| (0..3).map(|k| p[k] * q[k]).sum::<f64>();
            for i in 0..3 {
                assert!((r[i][2] - axis[i]).abs() < 1e-15, "{axis:?}: {r:?}");
                for j in 0..3 {
                    assert!((dot(r[i], r[j]) - f64::from(u8::from(i == j))).abs() < 1e-15, "{axis:?}: {r:?}");
                }
            }
            let minor = |j: usize, k: usize| r[1][j] * r[2][k] - r[1][k] * r[2][j];
            let determinant = r[0][0] * minor(1, 2) - r[0][1] * minor(0, 2) + r[0][2] * minor(0, 1);
            assert!((determinant - 1.0).abs() < 1e-15);
        }
        assert_eq!(rotation_onto([1.0, 0.0]), [[0.0, 1.0], [-1.0, 0.0]]);
    }
}
