//! Rigid partners: a shape, or a signed distance function, with a pose.

use crate::geometry::{HeightField, Pose, Vector};
use std::sync::Arc;

/// A body given by its signed distance: negative inside, positive outside, in a frame of its own.
///
/// `phi` must be 1-Lipschitz, |φ(x) − φ(y)| ≤ |x − y|, as every true signed distance and every minimum or maximum of
/// such distances is: lines are marched in steps of |φ|, and a function that grows faster is stepped over. A function
/// that grows more slowly costs evaluations, not accuracy.
///
/// `gradient` need not have unit length; it is used where φ = 0 only, for the outward normal. For the tangent of the law
/// `depth` it must be the gradient of φ inside as well. That law looks where |φ| leaves room only, and refuses a function
/// that it sees to grow faster.
pub trait SignedDistance<const D: usize>: Send + Sync {
    /// Writes φ and ∇φ at the points `x`. All slices have the same length. It is called from one thread at a time, the
    /// one that called the module. An error names the first point that failed.
    fn evaluate(&self, x: &[[f64; D]], phi: &mut [f64], gradient: &mut [[f64; D]]) -> Result<(), usize>;
}

impl<const D: usize, F> SignedDistance<D> for F
where
    F: Fn(&[f64; D]) -> (f64, [f64; D]) + Send + Sync,
{
    fn evaluate(&self, x: &[[f64; D]], phi: &mut [f64], gradient: &mut [[f64; D]]) -> Result<(), usize> {
        for (i, x) in x.iter().enumerate() {
            (phi[i], gradient[i]) = self(x);
        }
        Ok(())
    }
}

/// A rigid shape in its own frame. The axis of revolution is the last one: y in 2D, z in 3D.
///
/// In 2D a ball is a disc, a cylinder a rectangle, a cone an isosceles triangle and a capsule a stadium.
#[derive(Clone)]
#[non_exhaustive]
pub enum Shape<const D: usize> {
    /// All points whose last coordinate is at most 0; its outward normal is the last axis.
    HalfSpace,
    /// Ball about the origin.
    Ball {
        /// Radius.
        radius: f64,
    },
    /// Box about the origin.
    Cuboid {
        /// Half of each side.
        half_extents: [f64; D],
    },
    /// Cylinder about the last axis, centred.
    Cylinder {
        /// Radius.
        radius: f64,
        /// Half of its height.
        half_height: f64,
    },
    /// Cone about the last axis: apex at `+half_height`, base of the given radius at `−half_height`.
    Cone {
        /// Radius of the base.
        radius: f64,
        /// Half of its height.
        half_height: f64,
    },
    /// All points within `radius` of the segment from `−half_height` to `+half_height` on the last axis.
    Capsule {
        /// Radius.
        radius: f64,
        /// Half of the segment's length.
        half_height: f64,
    },
    /// Closed polygon (2D) or closed triangle mesh (3D), facets oriented outwards as in
    /// [`crate::Surface::from_facets`].
    Polytope {
        /// Corners.
        points: Vec<[f64; D]>,
        /// Edges or triangles, as numbers of corners.
        facets: Vec<[u32; D]>,
    },
    /// Convex hull of points, which both estimators meet as a polytope. Feature `shapes`.
    ConvexHull {
        /// Points; those inside the hull are of no effect.
        points: Vec<[f64; D]>,
    },
    /// The solid below a height field, which both estimators meet as a polytope.
    HeightField(HeightField),
    /// Union of shapes, each with a pose in the frame of the compound; fibers, and the law `depth`. Feature `shapes`.
    ///
    /// Its signed distance is the least of its parts': exact outside, and inside one part alone. Where parts overlap,
    /// the true depth is at least as large as that of the deepest part, which is what counts: a point near the seam of
    /// two parts is taken to be as deep as in either of them.
    Compound {
        /// Its parts, which may overlap; signed distances and compounds may be among them.
        parts: Vec<Obstacle<D>>,
    },
    /// Signed distance function; fibers, and the law `depth`.
    SignedDistance(Arc<dyn SignedDistance<D>>),
}

impl<const D: usize> Shape<D> {
    /// Radius of a ball about the shape's origin that holds it; `None` where it is unbounded or unknown.
    pub(crate) fn bounding_radius(&self) -> Option<f64> {
        match self {
            Shape::HalfSpace | Shape::SignedDistance(_) | Shape::HeightField(_) | Shape::Compound { .. } => None,
            Shape::Ball { radius } => Some(*radius),
            Shape::Cuboid { half_extents } => Some(Vector::from(*half_extents).norm()),
            Shape::Cylinder { radius, half_height } | Shape::Cone { radius, half_height } => {
                Some(radius.hypot(*half_height))
            }
            Shape::Capsule { radius, half_height } => Some(radius + half_height),
            Shape::Polytope { points, .. } | Shape::ConvexHull { points } => {
                Some(points.iter().map(|x| Vector::from(*x).norm()).fold(0.0, f64::max))
            }
        }
    }
}

impl<const D: usize> std::fmt::Debug for Shape<D> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Shape::HalfSpace => write!(f, "HalfSpace"),
            Shape::Ball { radius } => write!(f, "Ball {{ radius: {radius} }}"),
            Shape::Cuboid { half_extents } => write!(f, "Cuboid {{ half_extents: {half_extents:?} }}"),
            Shape::Cylinder { radius, half_height } => {
                write!(f, "Cylinder {{ radius: {radius}, half_height: {half_height} }}")
            }
            Shape::Cone { radius, half_height } => write!(f, "Cone {{ radius: {radius}, half_height: {half_height} }}"),
            Shape::Capsule { radius, half_height } => {
                write!(f, "Capsule {{ radius: {radius}, half_height: {half_height} }}")
            }
            Shape::Polytope { points, facets } => {
                write!(f, "Polytope {{ {} points, {} facets }}", points.len(), facets.len())
            }
            Shape::ConvexHull { points } => write!(f, "ConvexHull {{ {} points }}", points.len()),
            Shape::HeightField(field) => write!(f, "{field:?}"),
            Shape::Compound { parts } => write!(f, "Compound {{ {parts:?} }}"),
            Shape::SignedDistance(_) => write!(f, "SignedDistance"),
        }
    }
}

/// A rigid partner: it meets every body of the mesh, but no other obstacle.
#[derive(Clone, Debug)]
pub struct Obstacle<const D: usize> {
    /// Shape in its own frame.
    pub shape: Shape<D>,
    /// Where it stands.
    pub pose: Pose<D>,
}
