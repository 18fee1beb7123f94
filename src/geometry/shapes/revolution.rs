//! Shapes of revolution about the last axis: y in 2D, z in 3D.

use crate::geometry::Vector;

/// Signed distance and gradient of a shape of revolution from those of its section, half of a plane through the axis, whose
/// points are a distance from the axis and a height.
pub(super) fn turned<const D: usize>(
    x: &Vector<D>,
    section: impl FnOnce(&Vector<2>) -> (f64, Vector<2>),
) -> (f64, Vector<D>) {
    let mut outwards = *x;
    outwards[D - 1] = 0.0;
    let radial = outwards.norm();
    if radial > 0.0 {
        outwards /= radial;
    } else {
        outwards[0] = 1.0;
    }
    let (phi, gradient) = section(&Vector::<2>::new(radial, x[D - 1]));
    (phi, outwards * gradient[0] + last_axis::<D>() * gradient[1])
}

/// Distance of a point from the axis.
pub(super) fn radial<const D: usize>(x: &Vector<D>) -> f64 {
    (0..D - 1).map(|i| x[i] * x[i]).sum::<f64>().sqrt()
}

/// The unit vector along the axis.
pub(super) fn last_axis<const D: usize>() -> Vector<D> {
    let mut up = Vector::zeros();
    up[D - 1] = 1.0;
    up
}
