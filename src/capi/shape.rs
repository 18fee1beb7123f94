//! Shapes of obstacles, as the host gives them.

use super::failure::Failure;
use super::mesh::{Numbering, rows};
use super::pointer::slice;
use super::signed_distance::Callback;
use super::view::fmc_coords;
use crate::Shape;
use std::sync::Arc;

/// A shape as the host gives it, before its dimension is known.
pub(super) enum ShapeOf {
    HalfSpace,
    Ball { radius: f64 },
    Cuboid { half_extents: *const f64 },
    Cylinder { radius: f64, half_height: f64 },
    Cone { radius: f64, half_height: f64 },
    Capsule { radius: f64, half_height: f64 },
    Polytope { points: fmc_coords, facets: Facets, facet_count: usize },
    SignedDistance(Callback),
}

/// Node numbers of either width.
pub(super) enum Facets {
    Narrow(*const i32),
    Wide(*const i64),
}

impl ShapeOf {
    /// The shape in D dimensions.
    ///
    /// # Safety
    /// The host guarantees D half extents, the points, and D numbers per facet.
    pub(super) unsafe fn in_dimension<const D: usize>(self, index_base: i32) -> Result<Shape<D>, Failure> {
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
            ShapeOf::SignedDistance(callback) => Shape::SignedDistance(Arc::new(callback)),
        })
    }
}
