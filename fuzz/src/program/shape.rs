//! Obstacles, and what is wrong with a host's callbacks.

use crate::number::Number;
use arbitrary::Arbitrary;

/// Where an obstacle stands.
#[derive(Arbitrary, Clone, Debug)]
pub struct Pose {
    pub position: [Number; 3],
    pub axis: [Number; 3],
    pub scale: Option<Number>,
    /// The rotation as it comes, instead of one along the axis.
    pub rotation: Option<[Number; 9]>,
}

/// An obstacle: everything that a shape may have, whatever its kind.
#[derive(Arbitrary, Clone, Debug)]
pub struct Shape {
    /// Its kind by number, which may be none.
    pub kind: u8,
    pub radius: Number,
    pub half_height: Number,
    pub half_extents: [Number; 3],
    pub corners: Vec<[Number; 3]>,
    /// A simplex or, where numbers are added, facets of any kind.
    pub facets: Vec<u8>,
    pub is_wide: bool,
    /// Heights over a grid of so many points by 2.
    pub count: u8,
    pub heights: [Number; 8],
    pub thickness: Number,
    /// Parts by number of the kind and size.
    pub parts: Vec<(u8, Number)>,
    /// A ball by its signed distance, and how the callback misbehaves.
    pub fault: Fault,
}

/// What a host's callback does wrong.
#[derive(Arbitrary, Clone, Copy, Debug, PartialEq)]
pub enum Fault {
    None,
    /// Returns this.
    Returns(i32),
    /// Leaves all as it was.
    WritesNothing,
    WritesNan,
    NoGradient,
    /// Grows faster than distance.
    Steep,
    /// Calls the context that calls it.
    CallsBack,
}
