//! Shapes of obstacles, as the host gives them.

use super::mesh::{Numbering, rows};
use super::part::fmc_part;
use super::part::fmc_shape::{self, *};
use super::signed_distance::Callback;
use super::view::fmc_coords;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::pointer::{reference, slice};
use crate::capi::boundary::status::fmc_status::FMC_ERROR_BAD_VALUE;
use crate::{HeightField, Obstacle, Shape};
use std::sync::Arc;

/// A shape as the host gives it, before its dimension is known.
pub(crate) enum ShapeOf {
    HalfSpace,
    Ball { radius: f64 },
    Cuboid { half_extents: *const f64 },
    Cylinder { radius: f64, half_height: f64 },
    Cone { radius: f64, half_height: f64 },
    Capsule { radius: f64, half_height: f64 },
    Polytope { points: fmc_coords, facets: Facets, facet_count: usize },
    ConvexHull { points: fmc_coords },
    HeightField { counts: *const usize, lengths: *const f64, heights: *const f64, thickness: f64 },
    Compound { parts: *const fmc_part, part_count: usize },
    SignedDistance(Callback),
}

/// Node numbers of either width.
pub(crate) enum Facets {
    Narrow(*const i32),
    Wide(*const i64),
}

impl ShapeOf {
    /// The shape in D dimensions.
    ///
    /// # Safety
    /// The host guarantees D half extents, the points, D numbers per facet, the height field's arrays, and the parts
    /// with theirs.
    pub(crate) unsafe fn in_dimension<const D: usize>(self, index_base: i32) -> Result<Shape<D>, Failure> {
        Ok(match self {
            ShapeOf::HalfSpace => Shape::HalfSpace,
            ShapeOf::Ball { radius } => Shape::Ball { radius },
            ShapeOf::Cuboid { half_extents } => {
                // SAFETY: passed on to the caller.
                let given = unsafe { slice("half_extents", half_extents, D, 1) }?;
                Shape::Cuboid { half_extents: std::array::from_fn(|axis| given[axis]) }
            }
            ShapeOf::Cylinder { radius, half_height } => Shape::Cylinder { radius, half_height },
            ShapeOf::Cone { radius, half_height } => Shape::Cone { radius, half_height },
            ShapeOf::Capsule { radius, half_height } => Shape::Capsule { radius, half_height },
            ShapeOf::Polytope { points, facets, facet_count } => {
                let numbering = Numbering { index_base, node_count: points.node_count };
                // SAFETY: passed on to the caller.
                let (points, facets) = unsafe {
                    let points = points.rows("points", &mut Vec::new())?.to_vec();
                    let facets = match facets {
                        Facets::Narrow(ids) => numbering.zero_based(slice("facets", ids, facet_count, D)?, D, 0)?,
                        Facets::Wide(ids) => numbering.zero_based(slice("facets", ids, facet_count, D)?, D, 0)?,
                    };
                    (points, facets)
                };
                Shape::Polytope { points, facets: rows(&facets) }
            }
            ShapeOf::ConvexHull { points } => {
                let mut scratch = Vec::new();
                // SAFETY: passed on to the caller.
                let points = unsafe { points.rows("points", &mut scratch) }?;
                Shape::ConvexHull { points: points.to_vec() }
            }
            ShapeOf::HeightField { counts, lengths, heights, thickness } => {
                // SAFETY: passed on to the caller.
                let (counts, lengths, heights) = unsafe {
                    let counts = slice("counts", counts, D - 1, 1)?;
                    let count = counts.iter().try_fold(1usize, |all, &count| all.checked_mul(count));
                    let heights = slice("heights", heights, count.unwrap_or(usize::MAX), 1)?;
                    (counts.to_vec(), slice("lengths", lengths, D - 1, 1)?.to_vec(), heights.to_vec())
                };
                Shape::HeightField(HeightField { counts, lengths, heights, thickness })
            }
            ShapeOf::Compound { parts, part_count } => {
                // SAFETY: passed on to the caller.
                let parts = unsafe { slice("parts", parts, part_count, 1) }?;
                // SAFETY: passed on to the caller.
                let part = |part: &fmc_part| unsafe {
                    Ok(Obstacle { shape: shape_of(part)?.in_dimension(index_base)?, pose: part.pose.to_pose() })
                };
                Shape::Compound { parts: parts.iter().map(part).collect::<Result<_, Failure>>()? }
            }
            ShapeOf::SignedDistance(callback) => Shape::SignedDistance(Arc::new(callback)),
        })
    }
}

/// The shape that the part names.
///
/// # Safety
/// The host guarantees the view of the points.
unsafe fn shape_of(part: &fmc_part) -> Result<ShapeOf, Failure> {
    let &fmc_part { radius, half_height, facet_count, .. } = part;
    // SAFETY: passed on to the caller.
    let points = || unsafe { reference("points", part.points) }.copied();
    let is = |shape: fmc_shape| part.shape == shape as i32;
    Ok(if is(FMC_SHAPE_HALF_SPACE) {
        ShapeOf::HalfSpace
    } else if is(FMC_SHAPE_BALL) {
        ShapeOf::Ball { radius }
    } else if is(FMC_SHAPE_CUBOID) {
        ShapeOf::Cuboid { half_extents: part.half_extents.as_ptr() }
    } else if is(FMC_SHAPE_CYLINDER) {
        ShapeOf::Cylinder { radius, half_height }
    } else if is(FMC_SHAPE_CONE) {
        ShapeOf::Cone { radius, half_height }
    } else if is(FMC_SHAPE_CAPSULE) {
        ShapeOf::Capsule { radius, half_height }
    } else if is(FMC_SHAPE_POLYTOPE) {
        ShapeOf::Polytope { points: points()?, facets: Facets::Narrow(part.facets), facet_count }
    } else if is(FMC_SHAPE_CONVEX_HULL) {
        ShapeOf::ConvexHull { points: points()? }
    } else {
        return Err(Failure::new(
            FMC_ERROR_BAD_VALUE,
            format!("{} is no value of fmc_shape that a part may have", part.shape),
        ));
    })
}

/// Value of `fmc_shape` for the shape of an obstacle.
pub(crate) fn kind_of<const D: usize>(shape: &Shape<D>) -> fmc_shape {
    match shape {
        Shape::HalfSpace => FMC_SHAPE_HALF_SPACE,
        Shape::Ball { .. } => FMC_SHAPE_BALL,
        Shape::Cuboid { .. } => FMC_SHAPE_CUBOID,
        Shape::Cylinder { .. } => FMC_SHAPE_CYLINDER,
        Shape::Cone { .. } => FMC_SHAPE_CONE,
        Shape::Capsule { .. } => FMC_SHAPE_CAPSULE,
        Shape::Polytope { .. } => FMC_SHAPE_POLYTOPE,
        Shape::ConvexHull { .. } => FMC_SHAPE_CONVEX_HULL,
        Shape::HeightField(_) => FMC_SHAPE_HEIGHT_FIELD,
        Shape::Compound { .. } => FMC_SHAPE_COMPOUND,
        Shape::SignedDistance(_) => FMC_SHAPE_SIGNED_DISTANCE,
    }
}
