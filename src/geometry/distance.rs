//! How far a point is from a convex rigid shape, at least.

use super::{Shape, Vector};

/// A distance of a point from a shape, in the shape's own frame: negative inside, never more than the true one, and not
/// steeper. Without a bound, −∞: what is made of facets, and what has a signed distance only.
pub(crate) fn distance_bound<const D: usize>(shape: &Shape<D>, x: &Vector<D>) -> f64 {
    let height = x[D - 1];
    let radial = (0..D - 1).map(|i| x[i] * x[i]).sum::<f64>().sqrt();
    let beyond = |half_height: f64| height.abs() - half_height;
    match *shape {
        Shape::HalfSpace => height,
        Shape::Ball { radius } => x.norm() - radius,
        Shape::Cuboid { half_extents } => {
            (0..D).map(|i| x[i].abs() - half_extents[i]).fold(f64::NEG_INFINITY, f64::max)
        }
        Shape::Cylinder { radius, half_height } => (radial - radius).max(beyond(half_height)),
        Shape::Cone { radius, half_height } => {
            // The lateral surface, endless.
            let slope = radius / (2.0 * half_height);
            let lateral = (radial - slope * (half_height - height)) / slope.hypot(1.0);
            lateral.max(beyond(half_height))
        }
        Shape::Capsule { radius, half_height } => radial.hypot(beyond(half_height).max(0.0)) - radius,
        Shape::Polytope { .. }
        | Shape::ConvexHull { .. }
        | Shape::HeightField(_)
        | Shape::Compound { .. }
        | Shape::SignedDistance(_) => f64::NEG_INFINITY,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_point_of_a_shape_is_nearer_than_the_bound_and_its_surface_is_at_zero() {
        let (radius, half_height) = (1.5, 0.8);
        let shapes: [(Shape<3>, [[f64; 3]; 3]); 4] = [
            (Shape::Ball { radius }, [[1.5, 0.0, 0.0], [0.0, 1.2, 0.9], [0.0, 0.0, -1.5]]),
            (Shape::Cylinder { radius, half_height }, [[1.2, 0.9, 0.3], [0.4, 0.0, 0.8], [1.5, 0.0, -0.8]]),
            (Shape::Cone { radius, half_height }, [[0.0, 0.0, 0.8], [0.75, 0.0, 0.0], [0.9, 1.2, -0.8]]),
            (Shape::Capsule { radius, half_height }, [[1.5, 0.0, 0.5], [0.0, 1.5, -0.8], [0.0, 0.0, 2.3]]),
        ];
        for (shape, surface) in &shapes {
            for point in surface.map(Vector::from) {
                assert!(distance_bound(shape, &point).abs() < 1e-15, "{point} of {shape:?}");
                for x in [[3.0, 1.0, 2.0], [0.1, -0.2, 0.1], [-2.0, 0.3, -1.1], [0.0, 0.0, 4.0]].map(Vector::from) {
                    assert!(distance_bound(shape, &x) <= (x - point).norm() + 1e-15, "{x} and {point} of {shape:?}");
                }
            }
        }
    }
}
