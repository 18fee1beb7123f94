//! What is known of a convex shape in closed form.

use super::chord::Chord;
use super::extent::Extent;
use super::faces::Faceted;
#[cfg(feature = "shapes")]
use super::nearest::Nearest;
use crate::geometry::Vector;
use std::sync::Arc;

/// A convex rigid shape in closed form, in its own frame. Its measures have been checked.
pub(crate) trait ConvexShape<const D: usize>: Send + Sync {
    /// How far it reaches.
    fn extent(&self) -> Extent<D>;

    /// The part of the line `o + t d` inside; `d` has unit length.
    fn chord(&self, o: &Vector<D>, d: &Vector<D>) -> Chord<D>;

    /// Distance of a point from the surface, negative inside, and its gradient. Where several points of the surface are
    /// nearest, the gradient is that from one of them.
    fn signed_distance(&self, x: &Vector<D>) -> (f64, Vector<D>);

    /// A distance that costs less: negative inside, never more than the true one, and not steeper.
    fn distance_bound(&self, x: &Vector<D>) -> f64 {
        self.signed_distance(x).0
    }

    /// Corners and facets of its surface, where its faces are flat and bounded: it is then measured exactly.
    fn faces(&self) -> Option<Faceted<D>> {
        None
    }

    /// The shape whose surface lies `offset` further out, or in, where that is convex and in closed form as well. A
    /// half-space is moved by its pose instead, and stays what it is. `None`: its distance is taken, less the offset.
    fn parallel(&self, _offset: f64) -> Option<Arc<dyn ConvexShape<D>>> {
        None
    }

    /// How a compound finds its nearest points, where it does not use the distance.
    #[cfg(feature = "shapes")]
    fn nearest(&self) -> Option<Nearest<D>> {
        None
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::geometry::shapes::{ImplicitShape, Shape};

    /// A shape that is in closed form.
    pub(crate) fn convex<const D: usize>(shape: &Shape<D>) -> Arc<dyn ConvexShape<D>> {
        match shape.solid(0).as_ref().map(|solid| solid.implicit()) {
            Ok(Some(ImplicitShape::Convex(convex))) => convex.clone(),
            _ => panic!("{shape:?} is not in closed form"),
        }
    }

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
            let convex = convex(shape);
            for point in surface.map(Vector::from) {
                assert!(convex.distance_bound(&point).abs() < 1e-15, "{point} of {shape:?}");
                for x in [[3.0, 1.0, 2.0], [0.1, -0.2, 0.1], [-2.0, 0.3, -1.1], [0.0, 0.0, 4.0]].map(Vector::from) {
                    assert!(convex.distance_bound(&x) <= (x - point).norm() + 1e-15, "{x} and {point} of {shape:?}");
                }
            }
        }
    }
}
