//! Where the forces of the law `depth` act.

/// A facet's part inside the other side, as a point: the centre of its pressure.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DepthPoint<const D: usize> {
    pub(crate) of_b: bool,
    /// Index within its side.
    pub(crate) facet: u32,
    /// Barycentric coordinates of the point.
    pub(crate) weights: [f64; D],
    /// Unit outward normal of the facet.
    pub(crate) normal: [f64; D],
    /// Mean depth of the part below the other surface.
    pub(crate) depth: f64,
    /// Area for which the force of the point stands.
    pub(crate) area: f64,
    /// The place in the other body; `None` in an obstacle.
    pub(crate) other: Option<PlaceInCell>,
}

/// A place in a cell.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PlaceInCell {
    pub(crate) cell: u32,
    /// Weights of the cell's nodes, in their order.
    pub(crate) weights: [f64; 8],
}
