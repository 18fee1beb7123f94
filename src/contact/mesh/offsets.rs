//! Where a surface lies beside its nodes: gaps that are closed and overlaps that are removed without strain.
//!
//! What a mesher leaves between bodies that touch is no gap of the machine that is meant. Each point of a surface has a vector, which is added
//! to its place wherever contact looks at it, and nowhere else: the host's mesh and its strains stay, forces and tangents are those of one
//! energy as before. The vectors do not turn with the bodies.

use crate::Error;
use crate::geometry::boundary::submesh::hash_of;

/// The vectors, by point of the straight mesh; none: all are zero.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Offsets<const D: usize>(Vec<[f64; D]>);

impl<const D: usize> Offsets<D> {
    pub(crate) fn none() -> Self {
        Self(Vec::new())
    }

    /// Those of as many points; zeros are none.
    ///
    /// # Errors
    /// [`Error::Length`], [`Error::NonFiniteStiffness`].
    pub(crate) fn new(vectors: Vec<[f64; D]>, point_count: usize) -> Result<Self, Error> {
        if vectors.is_empty() {
            return Ok(Self::none());
        }
        if vectors.len() != point_count {
            return Err(Error::Length { array: "offsets", expected: point_count, found: vectors.len() });
        }
        match vectors.as_flattened().iter().position(|entry| !entry.is_finite()) {
            Some(entry) => Err(Error::NonFiniteStiffness { array: "offsets", entry }),
            None if vectors.as_flattened().iter().all(|entry| *entry == 0.0) => Ok(Self::none()),
            None => Ok(Self(vectors)),
        }
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Hash of its bits.
    pub(crate) fn hash(&self) -> u64 {
        hash_of(&self.0)
    }

    /// Its numbers, none where all are zero.
    pub(crate) fn numbers(&self) -> &[f64] {
        self.0.as_flattened()
    }

    /// Moves points to where the surface lies.
    pub(crate) fn add_to(&self, points: &mut [[f64; D]]) {
        points.as_flattened_mut().iter_mut().zip(self.0.as_flattened()).for_each(|(x, offset)| *x += offset);
    }

    /// One vector for every point.
    pub(crate) fn list(&self, point_count: usize) -> Vec<[f64; D]> {
        if self.is_empty() { vec![[0.0; D]; point_count] } else { self.0.clone() }
    }
}
