//! Where the points of a mesh were, as friction needs them later.

use std::borrow::Cow;
use std::ops::Index;
use std::sync::Arc;

/// The points of the straight mesh at an earlier time, and where the surface is taken to have lain then. Both are one where nothing lies
/// beside its nodes.
#[derive(Clone)]
pub(crate) struct PastPoints<const D: usize> {
    /// The host's coordinates, of which the points are found.
    given: Arc<Vec<[f64; D]>>,
    of_mesh: Arc<Vec<[f64; D]>>,
    placed: Arc<Vec<[f64; D]>>,
}

impl<const D: usize> PastPoints<D> {
    /// Points of a mesh at coordinates, and where `place` has the surface.
    pub(crate) fn new(
        given: &[[f64; D]],
        of_mesh: Cow<'_, [[f64; D]]>,
        place: impl FnOnce(&[[f64; D]]) -> Cow<'_, [[f64; D]]>,
    ) -> Self {
        let given = Arc::new(given.to_vec());
        let of_mesh = match of_mesh {
            Cow::Borrowed(_) => Arc::clone(&given),
            Cow::Owned(points) => Arc::new(points),
        };
        let mut points = Self { given, placed: Arc::clone(&of_mesh), of_mesh };
        points.place(place);
        points
    }

    /// The host's coordinates then.
    pub(crate) fn given(&self) -> Arc<Vec<[f64; D]>> {
        Arc::clone(&self.given)
    }

    /// Has the surface have lain elsewhere: as if it had from the beginning, bit by bit.
    pub(crate) fn place(&mut self, place: impl FnOnce(&[[f64; D]]) -> Cow<'_, [[f64; D]]>) {
        self.placed = match place(&self.of_mesh) {
            Cow::Borrowed(_) => Arc::clone(&self.of_mesh),
            Cow::Owned(placed) => Arc::new(placed),
        };
    }

    /// Where the surface lay.
    pub(crate) fn placed(&self) -> &[[f64; D]] {
        &self.placed
    }
}

impl<const D: usize> Index<usize> for PastPoints<D> {
    type Output = [f64; D];

    fn index(&self, point: usize) -> &[f64; D] {
        &self.placed[point]
    }
}
