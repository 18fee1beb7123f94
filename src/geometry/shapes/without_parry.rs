//! In the place of the shapes that parry builds, where the library is built without the feature `shapes`.

use super::{Obstacle, Solid};
use crate::Error;

const WHAT: Error = Error::Unsupported { what: "convex hulls and compounds: this library is built without 'shapes'" };

pub(super) mod convex_hull {
    use super::*;

    pub(in super::super) fn solid<const D: usize>(_points: &[[f64; D]]) -> Result<Solid<D>, Error> {
        Err(WHAT)
    }
}

pub(super) mod compound {
    use super::*;

    pub(in super::super) fn solid<const D: usize>(_parts: &[Obstacle<D>], _obstacle: usize) -> Result<Solid<D>, Error> {
        Err(WHAT)
    }
}
