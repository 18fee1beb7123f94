//! Pieces of a boundary: edges in 2D, triangles in 3D.

use crate::geometry::Vector;

/// Area vector of a facet with corners `x`: along the outward normal, as long as the facet's measure.
///
/// 2D: the body lies on the left of the edge `x[0] → x[1]`. 3D: corners run counter-clockwise seen from outside.
pub(crate) fn area_vector<const D: usize>(x: &[Vector<D>; D]) -> Vector<D> {
    let mut a = Vector::zeros();
    match D {
        2 => {
            let e = x[1] - x[0];
            a[0] = e[1];
            a[1] = -e[0];
        }
        _ => {
            let (e, f) = (x[1] - x[0], x[2] - x[0]);
            a[0] = 0.5 * (e[1] * f[2] - e[2] * f[1]);
            a[1] = 0.5 * (e[2] * f[0] - e[0] * f[2]);
            a[2] = 0.5 * (e[0] * f[1] - e[1] * f[0]);
        }
    }
    a
}

/// Derivatives of the area vector with respect to the corners, row by row.
pub(crate) fn area_slopes<const D: usize>(x: &[Vector<D>; D]) -> [[[f64; D]; D]; D] {
    let mut slopes = [[[0.0; D]; D]; D];
    if D == 2 {
        for (slope, sign) in slopes.iter_mut().zip([-1.0, 1.0]) {
            (slope[0][1], slope[1][0]) = (sign, -sign);
        }
        return slopes;
    }
    for (c, slope) in slopes.iter_mut().enumerate() {
        // ½ w × (x_{c+1} − x_{c+2}) for a corner that moves by w.
        let d = (x[(c + 1) % D] - x[(c + 2) % D]) * 0.5;
        for i in 0..D {
            let (j, k) = ((i + 1) % D, (i + 2) % D);
            (slope[i][j], slope[i][k]) = (d[k], -d[j]);
        }
    }
    slopes
}

/// Determinant of the matrix with these rows: twice the area, or six times the volume, of the simplex they span.
pub(crate) fn determinant<const D: usize>(rows: &[Vector<D>; D]) -> f64 {
    let r = rows;
    match D {
        2 => r[0][0] * r[1][1] - r[0][1] * r[1][0],
        _ => {
            r[0][0] * (r[1][1] * r[2][2] - r[1][2] * r[2][1])
                + r[0][1] * (r[1][2] * r[2][0] - r[1][0] * r[2][2])
                + r[0][2] * (r[1][0] * r[2][1] - r[1][1] * r[2][0])
        }
    }
}

/// `x × f` as a vector of three; in 2D only the last entry differs from zero.
pub(crate) fn moment<const D: usize>(x: &Vector<D>, f: &Vector<D>) -> [f64; 3] {
    match D {
        2 => [0.0, 0.0, x[0] * f[1] - x[1] * f[0]],
        _ => [x[1] * f[2] - x[2] * f[1], x[2] * f[0] - x[0] * f[2], x[0] * f[1] - x[1] * f[0]],
    }
}

/// The matrix of x ×; in 2D its first row gives the one component there is.
pub(crate) fn cross_matrix<const D: usize>(x: &[f64; D]) -> [[f64; D]; D] {
    let mut matrix = [[0.0; D]; D];
    if D == 2 {
        (matrix[0][0], matrix[0][1]) = (-x[1], x[0]);
        return matrix;
    }
    for i in 0..D {
        let (j, k) = ((i + 1) % D, (i + 2) % D);
        (matrix[i][j], matrix[i][k]) = (-x[k], x[j]);
    }
    matrix
}
