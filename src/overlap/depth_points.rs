//! Where the forces of the law `depth` act.

use crate::geometry::Vector;

/// A facet's part inside a cell of the other side, or inside an obstacle, as a point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DepthPoint<const D: usize> {
    pub(crate) of_b: bool,
    /// Index within its side.
    pub(crate) facet: u32,
    /// Centre of its pressure, and of its area.
    pub(crate) pressed: DepthPlace<D>,
    pub(crate) middle: DepthPlace<D>,
    /// Mean depth of the part below the other surface.
    pub(crate) depth: f64,
    /// Area for which the force of the point stands.
    pub(crate) area: f64,
    /// ∫ of the depth's gradient over that area; zero against an obstacle where no second derivative is asked for.
    pub(crate) slope: Vector<D>,
}

/// A place on a facet.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DepthPlace<const D: usize> {
    /// Barycentric coordinates.
    pub(crate) weights: [f64; D],
    /// The same place in the other body; `None` in an obstacle.
    pub(crate) other: Option<PlaceInCell<D>>,
}

/// A place in a cell.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PlaceInCell<const D: usize> {
    pub(crate) cell: u32,
    /// Weights of the cell's nodes, in their order.
    pub(crate) weights: [f64; 8],
    /// Gradients of these weights.
    pub(crate) gradients: [Vector<D>; 8],
}
