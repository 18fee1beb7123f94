//! Where the bodies are.

use super::own_mesh::OwnMesh;
use crate::Error;
use crate::geometry::Vector;
use crate::geometry::aabb::Aabb;
use crate::ranks::Ranks;

/// What all ranks know of the whole mesh at some coordinates.
pub(super) struct Places<const D: usize> {
    /// Boxes of the bodies' surfaces.
    pub(super) boxes: Vec<Aabb<D>>,
    /// How far any node has moved along any axis since the cells were gathered.
    pub(super) moved: f64,
}

impl<const D: usize> Places<D> {
    /// Of the own coordinates of all ranks; `since`: those at which cells were gathered.
    pub(super) fn gather(
        own: &OwnMesh<D>,
        coords: &[[f64; D]],
        since: Option<&[[f64; D]]>,
        ranks: &Ranks,
    ) -> Result<Self, Error> {
        let mut sent: Vec<[Vector<D>; 2]> = Vec::with_capacity(own.body_ids.len() + 1);
        sent.extend(own.boxes(coords)?.iter().map(|aabb| [aabb.min, aabb.max]));
        let ways =
            since.into_iter().flatten().flatten().zip(coords.iter().flatten()).map(|(from, to)| (to - from).abs());
        sent.push([Vector::zeros(), Vector::repeat(ways.fold(0.0, f64::max))]);
        let mut places = Self { boxes: vec![Aabb::empty(); own.body_ids.len()], moved: 0.0 };
        for mut of_rank in ranks.gather_lists(&sent)? {
            places.moved = of_rank.pop().map_or(places.moved, |[_, moved]| places.moved.max(moved[0]));
            for (aabb, [min, max]) in places.boxes.iter_mut().zip(of_rank) {
                *aabb = aabb.union(&Aabb { min, max });
            }
        }
        Ok(places)
    }
}
