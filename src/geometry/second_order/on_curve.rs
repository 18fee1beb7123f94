//! Where a part of a curved cell lies on the curve.

use super::curved_cells::CurvedCells;
use super::division::{Division, Origin, Place};
use crate::geometry::Vector;

/// A straight cell, and the curved one of which it is a part.
#[derive(Clone, Copy)]
pub(crate) struct OnCurve<'a, const D: usize> {
    pub(super) curved: &'a CurvedCells,
    pub(super) cell: usize,
    /// Points of the straight cell, among those of the curved one.
    pub(super) points: &'a [usize],
    pub(super) coords: &'a [[f64; D]],
}

impl Division {
    /// The curved cell of which a straight one is a part; `None` where it is straight itself.
    pub(crate) fn on_curve<'a, const D: usize>(
        &'a self,
        straight: usize,
        coords: &'a [[f64; D]],
    ) -> Option<OnCurve<'a, D>> {
        let &Origin { cell, cell_type, place: Place::Child(child) } = self.origins.get(straight)? else { return None };
        let curved = self.curved.iter().find(|curved| curved.numbers().contains(&(cell as usize)))?;
        let (_, children) = self.types.iter().find(|(of_type, _)| *of_type == cell_type)?;
        let cell = cell as usize - curved.numbers().start;
        Some(OnCurve { curved, cell, points: &children[child as usize].nodes, coords })
    }
}

impl<const D: usize> OnCurve<'_, D> {
    /// The mean of some nodes of the straight cell, in the coordinates of the curved one.
    pub(crate) fn mean(&self, nodes: &[usize]) -> [f64; 3] {
        let mut place = [0.0; 3];
        for &node in nodes {
            let at = self.curved.place_of_point(self.points[node]);
            place.iter_mut().zip(at).for_each(|(sum, x)| *sum += x / nodes.len() as f64);
        }
        place
    }

    /// A corner of the curved cell, in its coordinates.
    pub(crate) fn corner(&self, corner: usize) -> [f64; 3] {
        self.curved.place_of_point(corner)
    }

    pub(crate) fn position(&self, place: [f64; 3]) -> Vector<D> {
        self.curved.position(self.cell, place, self.coords)
    }

    /// How fast the position changes from one place towards another.
    pub(crate) fn slope(&self, at: [f64; 3], from: [f64; 3], to: [f64; 3]) -> Vector<D> {
        self.curved.slope((self.cell, at), std::array::from_fn(|axis| to[axis] - from[axis]), self.coords)
    }

    /// The points of the mesh that move a place, with their weights.
    pub(crate) fn weights(&self, place: [f64; 3]) -> impl Iterator<Item = (u32, f64)> {
        self.curved.weights(self.cell, place)
    }
}
