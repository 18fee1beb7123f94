//! How far a convex shape reaches.

use crate::geometry::Vector;

/// How far a convex shape reaches, in its own frame.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Extent<const D: usize> {
    /// It is all that lies below the plane across the last axis through the origin.
    HalfSpace,
    /// It lies in a box and in a ball about the origin.
    Bounded {
        /// Half of each side of the box.
        half: Vector<D>,
        /// Radius of the ball.
        radius: f64,
    },
}

impl<const D: usize> Extent<D> {
    /// That of a shape about the last axis.
    pub(super) fn about_axis(radius: f64, half_height: f64, around: f64) -> Self {
        let mut half = Vector::<D>::zeros();
        half.fill(radius);
        half[D - 1] = half_height;
        Extent::Bounded { half, radius: around }
    }
}
