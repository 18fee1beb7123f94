//! The second side of a pair as a plane.

use super::sides::{Counterpart, Pair};
use crate::Error;
use crate::geometry::primitives::plane::Plane;

impl<const D: usize> Pair<'_, D> {
    /// The plane of a half-space, where that is the second side.
    ///
    /// # Errors
    /// [`Error::Unsupported`] for other obstacles without facets: what is exact knows facets and planes.
    pub(crate) fn plane(&self) -> Result<Option<Plane<D>>, Error> {
        match &self.counterpart {
            Counterpart::Itself | Counterpart::Facets(_) => Ok(None),
            Counterpart::Implicit(side) => {
                let what = "the exact overlap with a curved or signed-distance obstacle; use fibers, or give it as a polygon or triangle mesh";
                side.plane().map(Some).ok_or(Error::Unsupported { what })
            }
        }
    }
}
