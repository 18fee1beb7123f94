//! Shapes that are built by parry (feature `shapes`): convex hulls become facets, compounds signed distances.

mod chord;
#[cfg(feature = "shapes")]
mod compound;
#[cfg(feature = "shapes")]
mod convex_hull;
mod height_field;
#[cfg(feature = "shapes")]
mod nearest;
mod shape;

pub(crate) use chord::{Hit, chord};
pub use height_field::HeightField;
pub use shape::{Obstacle, Shape, SignedDistance};

#[cfg(feature = "shapes")]
pub(crate) use {compound::compound, convex_hull::convex_hull};

/// A part of a compound: its shape where it has no facets, its facets else, and where it stands.
#[cfg_attr(not(feature = "shapes"), allow(dead_code))] // Read by what parry builds.
pub(crate) struct Part<'a, const D: usize> {
    pub(crate) shape: &'a super::Shape<D>,
    pub(crate) facets: Option<(&'a [super::Vector<D>], &'a [[u32; D]])>,
    pub(crate) pose: super::Pose<D>,
}

#[cfg(not(feature = "shapes"))]
mod without {
    use super::Part;
    use crate::Error;
    use crate::geometry::{Shape, shapes::height_field::Faceted};

    const WHAT: Error =
        Error::Unsupported { what: "convex hulls and compounds: this library is built without 'shapes'" };

    pub(crate) fn convex_hull<const D: usize>(_: &[[f64; D]]) -> Result<Faceted<D>, Error> {
        Err(WHAT)
    }

    pub(crate) fn compound<const D: usize>(_: Vec<Part<D>>) -> Result<Shape<D>, Error> {
        Err(WHAT)
    }
}

#[cfg(not(feature = "shapes"))]
pub(crate) use without::{compound, convex_hull};
