//! A contact point as a plain struct.

use super::evaluation::{padded, side_of};
use crate::contact::{PointOfContact, SideOfPoint};

/// One end of a contact point: where, and the shape functions of the boundary face, or of the cell, there. With cells of second
/// order they belong to the straight face or cell of the division.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_contact_side {
    /// A value of `fmc_partner`.
    pub kind: i32,
    /// How many of `nodes` and `weights` are used; 0 for an obstacle, and where no cell of the other body is.
    pub node_count: i32,
    /// Index for `fmc_context_body_resultant` or `fmc_context_obstacle_resultant`.
    pub index: usize,
    /// Cell, counted from the option `index_base` over all blocks; -1 for an obstacle and for a surface without cells.
    pub cell: i64,
    /// Nodes of the boundary face, or of the cell for a place inside it, counted from the option `index_base`. Where the cell
    /// is of second order they are points of its division: row p of `fmc_context_point_weights` takes the force at point p
    /// to the nodes.
    pub nodes: [i64; 8],
    /// Values of their shape functions: a force at this end is distributed to the nodes, or points, with these factors.
    pub weights: [f64; 8],
    /// The end; in 2D the last entry is 0.
    pub position: [f64; 3],
}

/// A point of the contact, and its tributary area.
///
/// With the law "fiber" it is a piece of a line inside both sides of a pair, between their boundaries. With the law "depth"
/// it is the centre of the pressure on the part of a facet inside the other side. Facets of both bodies are pressed, each
/// with half of its area, facets against an obstacle with all of it.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_contact_point {
    /// Size of this struct, as the library wrote it.
    pub struct_size: usize,
    /// Number of the patch within the pair; points of one patch have one normal, up to its sign. 0 with
    /// the law "depth".
    pub patch: usize,
    /// Middle of the piece, or the centre of pressure; in 2D the last entry is 0.
    pub position: [f64; 3],
    /// Unit vector along the line, or normal of the facet, outwards of the first side; in 2D the last entry is 0.
    pub normal: [f64; 3],
    /// Minus the penetration: the length of the piece; the mean depth of the facet's part below the other surface.
    pub gap: f64,
    /// Contact pressure.
    pub pressure: f64,
    /// Area (2D: length) across the line, or of the facet's part.
    pub area: f64,
    /// Traction of friction on the first side, the sum of friction * area being its resultant there; in 2D the last entry
    /// is 0.
    pub friction: [f64; 3],
    /// Slip of the first side against the second since the step began, without its elastic part, at the facets on which
    /// the point lies; in 2D the last entry is 0.
    pub slip: [f64; 3],
    /// Part of the area that slides: 0 where the point sticks, 0.5 where one of its two facets does, else 1.
    pub sliding: f64,
    /// The ends, in the order of the pair's sides; with the law "depth" the point on the facet, and the same place in a
    /// cell of the other body.
    pub sides: [fmc_contact_side; 2],
    /// Zero.
    pub reserved: [u64; 8],
}

impl fmc_contact_point {
    pub(crate) fn new<const D: usize>(point: &PointOfContact<D>, index_base: i32) -> Self {
        let [first, second] = [0, 1].map(|k| {
            let (kind, index) = side_of(point.partners[k]);
            side(&point.sides[k], kind, index, index_base)
        });
        Self {
            struct_size: size_of::<Self>(),
            patch: point.patch,
            position: padded(&point.position),
            normal: padded(&point.normal),
            gap: point.gap,
            pressure: point.pressure,
            area: point.area,
            friction: padded(&point.friction),
            slip: padded(&point.slip),
            sliding: point.sliding,
            sides: [first, second],
            reserved: [0; 8],
        }
    }
}

fn side<const D: usize>(side: &SideOfPoint<D>, kind: i32, index: usize, index_base: i32) -> fmc_contact_side {
    let number = |k: usize| if k < side.node_count { i64::from(side.nodes[k]) + i64::from(index_base) } else { 0 };
    fmc_contact_side {
        kind,
        node_count: side.node_count as i32,
        index,
        cell: side.cell.map_or(-1, |cell| cell as i64 + i64::from(index_base)),
        nodes: std::array::from_fn(number),
        weights: side.weights,
        position: padded(&side.position),
    }
}
