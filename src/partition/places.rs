//! Where the bodies are.

use super::own_mesh::OwnMesh;
use crate::Error;
use crate::geometry::Vector;
use crate::geometry::primitives::aabb::Aabb;
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
        // Plain loops: of iterators that are flattened twice valgrind says that they jump on what was not set.
        let mut moved = 0.0f64;
        if let Some(since) = since {
            for (from, to) in since.as_flattened().iter().zip(coords.as_flattened()) {
                moved = moved.max((to - from).abs());
            }
        }
        sent.push([Vector::zeros(), Vector::repeat(moved)]);
        let mut places = Self { boxes: vec![Aabb::empty(); own.body_ids.len()], moved: 0.0 };
        for of_rank in ranks.gather_lists(&sent)? {
            for (number, [min, max]) in of_rank.into_iter().enumerate() {
                match places.boxes.get_mut(number) {
                    Some(aabb) => *aabb = aabb.union(&Aabb { min, max }),
                    // The last is no box.
                    None => places.moved = places.moved.max(max[0]),
                }
            }
        }
        Ok(places)
    }
}
