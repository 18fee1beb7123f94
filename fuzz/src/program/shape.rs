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

/// An obstacle.
#[derive(Arbitrary, Clone, Debug)]
pub enum Shape {
    HalfSpace,
    Ball(Number),
    Cuboid([Number; 3]),
    Cylinder(Number, Number),
    Cone(Number, Number),
    Capsule(Number, Number),
    /// A simplex or, where numbers are added, facets of any kind.
    Polytope {
        corners: [[Number; 3]; 4],
        facets: Vec<u8>,
        is_wide: bool,
    },
    /// Points of any kind.
    ConvexHull(Vec<[Number; 3]>),
    /// Heights over a grid of so many points by 2.
    HeightField {
        count: u8,
        heights: [Number; 8],
        thickness: Number,
    },
    /// Parts by number of the shape and size.
    Compound(Vec<(u8, Number)>),
    /// A ball by its signed distance, and how the callback misbehaves.
    SignedDistance {
        radius: Number,
        fault: Fault,
    },
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
