//! Contact points, as hosts and outputs see them.

use crate::overlap::Partner;

/// A point of the contact, and the area for which it stands.
///
/// With the law `fiber` it is a piece of a line inside both sides, from the boundary of one to that of the other. With the
/// law `depth` it is the centre of the pressure on what a facet has inside one cell of the other body, or inside an obstacle:
/// facets of both bodies are pressed, each for half of its area, facets against an obstacle for all of it.
#[derive(Clone, Debug, PartialEq)]
pub struct PointOfContact<const D: usize> {
    /// The two sides.
    pub partners: [Partner; 2],
    /// Middle of the piece; the centre of pressure.
    pub position: [f64; D],
    /// Unit vector along the line, or that of the facet, outwards of the first side.
    pub normal: [f64; D],
    /// Minus the penetration: the length of the piece; the mean depth of the facet's part below the other surface.
    pub gap: f64,
    /// Contact pressure.
    pub pressure: f64,
    /// Area (2D: length) across the line, or of the facet's part; the resultant on the first side is
    /// −Σ pressure · area · normal, with the law `fiber` where its facets lie across the lines.
    pub area: f64,
    /// Traction of friction on the first side, Σ friction · area being its resultant there; zero without friction.
    pub friction: [f64; D],
    /// Slip of the first side against the second since the step began, without what is elastic; a point has the slip of the
    /// facets on which it lies.
    pub slip: [f64; D],
    /// Part of the point's area that slides: 0 where it sticks, ½ where one of its two facets does.
    pub sliding: f64,
    /// Number of the patch within the pair: points of one patch have one normal, up to its sign. 0 with the law `depth`,
    /// which has no patches.
    pub patch: usize,
    /// The end on the boundary of either side, in the order of `partners`; with the law `depth` the point on the facet
    /// and the same place in a cell of the other body.
    pub sides: [SideOfPoint<D>; 2],
}

/// One end of a contact point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SideOfPoint<const D: usize> {
    /// Where.
    pub position: [f64; D],
    /// Cell of the mesh, counted over all blocks; `None` for an obstacle, and for a surface without cells.
    pub cell: Option<usize>,
    /// How many of `nodes` and `weights` are used: those of the boundary face, or of the cell for a place inside it; 0
    /// for an obstacle.
    pub node_count: usize,
    /// Nodes of the mesh; where the cell is of second order points of its division
    /// ([`PointWeights`](crate::PointWeights)).
    pub nodes: [u32; 8],
    /// Values of their shape functions here: Σ weights · coordinates is `position`, and a force here goes to the nodes
    /// by these parts.
    pub weights: [f64; 8],
}
