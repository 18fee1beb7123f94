//! Rigid shapes, one file each.
//!
//! [`Shape`] is what a host gives: the measures of a shape, in a frame of its own. [`Shape::solid`] checks them and makes the
//! [`Solid`] with which contact is measured: a convex shape in closed form ([`ConvexShape`]), a [`SignedDistance`], or a
//! closed surface of facets. Nothing outside this folder asks which shape it is.
//!
//! A new shape is a file that makes a solid of its measures, and its lines in this one: the kind, the variant, and an arm
//! each of [`Shape::kind`], [`Shape::read`] and [`Shape::solid`]. Whoever reads shapes, from C, from a command or from a
//! file, then reads it as well.

mod ball;
mod capsule;
mod chord;
#[cfg(feature = "shapes")]
mod compound;
mod cone;
#[cfg(feature = "shapes")]
mod convex_hull;
mod convex_shape;
mod cuboid;
mod cylinder;
mod extent;
mod faces;
mod flat_faces;
mod half_space;
mod height_field;
mod implicit_shape;
mod measures;
#[cfg(feature = "shapes")]
mod nearest;
mod obstacle;
mod plane_tree;
mod revolution;
mod ridges;
mod signed_distance;
mod solid;
#[cfg(not(feature = "shapes"))]
mod without_parry;

pub(crate) use chord::Hit;
pub(crate) use convex_shape::ConvexShape;
#[cfg(test)]
pub(crate) use convex_shape::tests::convex;
pub(crate) use extent::Extent;
pub(crate) use faces::Faces;
pub(crate) use flat_faces::{ConvexFaces, FLAT};
pub(crate) use half_space::HalfSpace;
pub use height_field::HeightField;
pub(crate) use implicit_shape::ImplicitShape;
pub use measures::Measures;
pub use obstacle::Obstacle;
pub(crate) use plane_tree::{PlaneBounds, PlaneTree};
pub(crate) use ridges::Ridge;
pub use signed_distance::SignedDistance;
pub(crate) use solid::Solid;

use crate::Error;
use std::sync::Arc;
#[cfg(not(feature = "shapes"))]
use without_parry::{compound, convex_hull};

/// cbindgen:rename-all=prefix:FMC_SHAPE_
/// Kinds of shapes, each with the measures that it has. The axis of revolution is the last one: y in 2D, z in 3D.
#[allow(non_camel_case_types, clippy::upper_case_acronyms)] // The C interface takes its names from here.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShapeKind {
    /// All points whose last coordinate is at most 0; the outward normal is the last axis. No measures.
    HALF_SPACE = 0,
    /// A ball (2D: a disc) about the origin: `radius`.
    BALL = 1,
    /// A box about the origin: `half_extents`, halves of its sides.
    CUBOID = 2,
    /// A cylinder (2D: a rectangle) about the last axis, centred: `radius`, `half_height`.
    CYLINDER = 3,
    /// A cone (2D: an isosceles triangle) about the last axis, its apex at +half_height and its base at -half_height:
    /// `radius` of the base, `half_height`.
    CONE = 4,
    /// A capsule (2D: a stadium), all points within `radius` of the segment from -half_height to +half_height on the last
    /// axis: `radius`, `half_height`.
    CAPSULE = 5,
    /// A closed polygon (2D) or triangle mesh (3D): `points`, its corners, and `facets`, as numbers of corners. In 2D the
    /// body lies left of an edge, in 3D a triangle runs counter-clockwise seen from outside.
    POLYTOPE = 6,
    /// The convex hull of `points`; those inside have no effect. It becomes a polytope.
    CONVEX_HULL = 7,
    /// The solid below a height field: `heights` over a grid with `counts` points along its axes and `lengths`, and
    /// `thickness`. It becomes a polytope.
    HEIGHT_FIELD = 8,
    /// The union of other shapes: `parts`, which may overlap.
    COMPOUND = 9,
    /// A body given by a function: `signed_distance`.
    SIGNED_DISTANCE = 10,
}

impl ShapeKind {
    /// cbindgen:ignore
    /// All of them, by number.
    pub const ALL: [Self; 11] = [
        Self::HALF_SPACE,
        Self::BALL,
        Self::CUBOID,
        Self::CYLINDER,
        Self::CONE,
        Self::CAPSULE,
        Self::POLYTOPE,
        Self::CONVEX_HULL,
        Self::HEIGHT_FIELD,
        Self::COMPOUND,
        Self::SIGNED_DISTANCE,
    ];

    /// Its name in files and on command lines, as `half-space`.
    pub fn name(self) -> String {
        format!("{self:?}").to_lowercase().replace('_', "-")
    }

    /// The kind of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }
}

/// A rigid shape in its own frame. The axis of revolution is the last one: y in 2D, z in 3D.
///
/// In 2D a ball is a disc, a cylinder a rectangle, a cone an isosceles triangle and a capsule a stadium.
#[derive(Clone, Debug)]
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
    /// Whether it has edges; of a function of the host nothing is known.
    pub(crate) fn has_edges(&self) -> bool {
        !matches!(self, Self::HalfSpace | Self::Ball { .. } | Self::Capsule { .. } | Self::SignedDistance(_))
    }

    /// What kind it is.
    pub fn kind(&self) -> ShapeKind {
        match self {
            Shape::HalfSpace => ShapeKind::HALF_SPACE,
            Shape::Ball { .. } => ShapeKind::BALL,
            Shape::Cuboid { .. } => ShapeKind::CUBOID,
            Shape::Cylinder { .. } => ShapeKind::CYLINDER,
            Shape::Cone { .. } => ShapeKind::CONE,
            Shape::Capsule { .. } => ShapeKind::CAPSULE,
            Shape::Polytope { .. } => ShapeKind::POLYTOPE,
            Shape::ConvexHull { .. } => ShapeKind::CONVEX_HULL,
            Shape::HeightField(_) => ShapeKind::HEIGHT_FIELD,
            Shape::Compound { .. } => ShapeKind::COMPOUND,
            Shape::SignedDistance(_) => ShapeKind::SIGNED_DISTANCE,
        }
    }

    /// The shape of a kind, whose measures are read.
    ///
    /// # Errors
    /// Those of the measures.
    pub fn read<M: Measures<D>>(kind: ShapeKind, from: &mut M) -> Result<Self, M::Error> {
        Ok(match kind {
            ShapeKind::HALF_SPACE => Shape::HalfSpace,
            ShapeKind::BALL => Shape::Ball { radius: from.radius()? },
            ShapeKind::CUBOID => Shape::Cuboid { half_extents: from.half_extents()? },
            ShapeKind::CYLINDER => Shape::Cylinder { radius: from.radius()?, half_height: from.half_height()? },
            ShapeKind::CONE => Shape::Cone { radius: from.radius()?, half_height: from.half_height()? },
            ShapeKind::CAPSULE => Shape::Capsule { radius: from.radius()?, half_height: from.half_height()? },
            ShapeKind::POLYTOPE => Shape::Polytope { points: from.points()?, facets: from.facets()? },
            ShapeKind::CONVEX_HULL => Shape::ConvexHull { points: from.points()? },
            ShapeKind::HEIGHT_FIELD => Shape::HeightField(from.height_field()?),
            ShapeKind::COMPOUND => Shape::Compound { parts: from.parts()? },
            ShapeKind::SIGNED_DISTANCE => Shape::SignedDistance(from.signed_distance()?),
        })
    }

    /// What contact is measured with. `obstacle` is the number that errors name.
    pub(crate) fn solid(&self, obstacle: usize) -> Result<Solid<D>, Error> {
        match self {
            Shape::HalfSpace => Solid::convex(HalfSpace),
            &Shape::Ball { radius } => Solid::convex(ball::Ball::new(radius)?),
            Shape::Cuboid { half_extents } => Solid::convex(cuboid::Cuboid::new(half_extents)?),
            &Shape::Cylinder { radius, half_height } => Solid::convex(cylinder::Cylinder::new(radius, half_height)?),
            &Shape::Cone { radius, half_height } => Solid::convex(cone::Cone::new(radius, half_height)?),
            &Shape::Capsule { radius, half_height } => Solid::convex(capsule::Capsule::new(radius, half_height)?),
            Shape::Polytope { points, facets } => Solid::faceted(points, facets),
            Shape::ConvexHull { points } => convex_hull::solid(points),
            Shape::HeightField(field) => field.solid(),
            Shape::Compound { parts } => compound::solid(parts, obstacle),
            Shape::SignedDistance(function) => Ok(Solid::function(function.clone())),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kinds_are_counted_and_named() {
        for (number, kind) in ShapeKind::ALL.into_iter().enumerate() {
            assert_eq!(kind as usize, number);
            assert_eq!(ShapeKind::named(&kind.name()), Some(kind));
        }
        assert_eq!(ShapeKind::HALF_SPACE.name(), "half-space");
        assert_eq!(ShapeKind::named("wedge"), None);
    }
}
