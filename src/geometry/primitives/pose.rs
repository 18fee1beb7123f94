//! Where a rigid shape stands.

use crate::Error;
use crate::geometry::Vector;
use crate::geometry::primitives::facet::determinant;
use nalgebra::SMatrix;

/// Position, rotation and scale: `x = position + scale · rotation · X` for a point `X` of the shape.
///
/// `rotation` is stored by rows, `rotation[i][j] = e_i · R e_j`; it must be orthonormal with determinant +1 to 1e-8.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose<const D: usize> {
    /// Where the shape's origin lies.
    pub position: [f64; D],
    /// Rotation matrix, by rows.
    pub rotation: [[f64; D]; D],
    /// Uniform scale, positive.
    pub scale: f64,
}

impl<const D: usize> Default for Pose<D> {
    fn default() -> Self {
        Self::at([0.0; D])
    }
}

impl<const D: usize> Pose<D> {
    /// Unturned and unscaled at `position`.
    pub fn at(position: [f64; D]) -> Self {
        let mut rotation = [[0.0; D]; D];
        for i in 0..D {
            rotation[i][i] = 1.0;
        }
        Self { position, rotation, scale: 1.0 }
    }

    /// The same with another scale.
    pub fn scaled(self, scale: f64) -> Self {
        Self { scale, ..self }
    }

    fn matrix(&self) -> SMatrix<f64, D, D> {
        SMatrix::from_fn(|i, j| self.rotation[i][j])
    }

    /// Direction or normal from the shape's frame into space.
    pub(crate) fn rotate(&self, v: &Vector<D>) -> Vector<D> {
        self.matrix() * v
    }

    /// Point from the shape's frame into space.
    pub(crate) fn place(&self, x: &Vector<D>) -> Vector<D> {
        Vector::from(self.position) + self.rotate(x) * self.scale
    }

    /// Direction from space into the shape's frame, unscaled.
    pub(crate) fn unrotate(&self, v: &Vector<D>) -> Vector<D> {
        self.matrix().transpose() * v
    }

    /// Point from space into the shape's frame.
    pub(crate) fn unplace(&self, x: &Vector<D>) -> Vector<D> {
        self.unrotate(&(x - Vector::from(self.position))) / self.scale
    }

    /// Checks the pose of an obstacle.
    pub(crate) fn check(&self, obstacle: usize) -> Result<(), Error> {
        if self.is_proper() { Ok(()) } else { Err(Error::BadPose { obstacle }) }
    }

    /// Whether it is a finite position, a proper rotation and a positive, finite scale.
    fn is_proper(&self) -> bool {
        let r = self.matrix();
        let deviation = (r * r.transpose() - SMatrix::identity()).amax();
        let rows = std::array::from_fn::<Vector<D>, D, _>(|i| Vector::from(self.rotation[i]));
        self.position.iter().all(|x| x.is_finite())
            && deviation <= 1e-8
            && determinant(&rows) > 0.0
            && self.scale.is_finite()
            && self.scale > 0.0
    }
}

impl Pose<2> {
    /// The same, turned counter-clockwise by `angle` in radians.
    pub fn turned(self, angle: f64) -> Self {
        let (s, c) = angle.sin_cos();
        Self { rotation: [[c, -s], [s, c]], ..self }
    }
}

impl Pose<3> {
    /// The same, turned by `angle` in radians about `axis` (right-hand rule; `axis` need not have unit length).
    pub fn turned_about(self, axis: [f64; 3], angle: f64) -> Self {
        let a = Vector::<3>::from(axis).normalize();
        let (s, c) = angle.sin_cos();
        let k = SMatrix::<f64, 3, 3>::new(0.0, -a[2], a[1], a[2], 0.0, -a[0], -a[1], a[0], 0.0);
        let r = SMatrix::<f64, 3, 3>::identity() + k * s + k * k * (1.0 - c);
        Self { rotation: std::array::from_fn(|i| std::array::from_fn(|j| r[(i, j)])), ..self }
    }
}
