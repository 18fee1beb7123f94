//! How many pieces a projection may be cut into.
//!
//! Facets that lie in layers, each seen through the gaps of the last, fall apart into more pieces than there are facets:
//! with their square for a body that is tangled with itself all through. Bodies in contact need a few for each facet.
//! What needs more than the limit is refused while it is counted, and not after hours.

use crate::ranks::Sharing;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Pieces for every facet that is seen, and pieces that are always allowed, a few seconds' work. Bodies that overlap need
/// fewer than a hundred for each facet; a mesh at random that is folded through itself, tens of thousands.
const PER_FACET: usize = 400;
const LEAST: usize = 4_000_000;

/// Pieces of a projection so far, and facets that were asked whether they hide one. The sum does not depend on the order in
/// which threads add to it, nor does whether it passes the limit.
pub(crate) struct Work {
    pieces: AtomicUsize,
    /// Those of them that every rank counted, of work that was not shared.
    common: AtomicUsize,
    pub(crate) limit: usize,
}

impl Work {
    pub(super) fn new(facets: usize) -> Self {
        Self {
            pieces: AtomicUsize::new(0),
            common: AtomicUsize::new(0),
            limit: LEAST.max(PER_FACET.saturating_mul(facets)),
        }
    }

    /// Adds to the pieces; false once there are more than the limit.
    pub(super) fn allows(&self, pieces: usize) -> bool {
        self.pieces.fetch_add(pieces, Ordering::Relaxed).saturating_add(pieces) <= self.limit
    }

    /// Whether there are more than the limit already.
    pub(super) fn is_over(&self) -> bool {
        self.pieces.load(Ordering::Relaxed) > self.limit
    }

    /// Whether there are more in the end, those of all ranks together.
    pub(super) fn is_over_on_ranks(&self, sharing: &Sharing) -> bool {
        let [all, common] = [&self.pieces, &self.common].map(|count| count.load(Ordering::Relaxed));
        sharing.total(all - common).saturating_add(common) > self.limit
    }

    /// Does work that every rank does.
    pub(super) fn in_common<T>(&self, work: impl FnOnce() -> T) -> T {
        let before = self.pieces.load(Ordering::Relaxed);
        let found = work();
        self.common.fetch_add(self.pieces.load(Ordering::Relaxed) - before, Ordering::Relaxed);
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Vector;
    use crate::overlap::normal_lines::projected::contact_points::Rule;
    use crate::overlap::normal_lines::projected::projected_pair::ProjectedPair;
    use crate::overlap::pair::of_meshes::with_pair;
    use crate::sampling::Family;
    use fmc_shapes::{Mesh, cuboid_surface, icosphere};

    /// Pieces for every facet in the region of contact, and of these, seen along the last axis.
    fn pieces_per_facet(a: &Mesh<3>, b: &Mesh<3>) -> f64 {
        with_pair(a, b, |pair| {
            let exact = ProjectedPair { pair };
            let reached = exact.reached_facets().expect("facets").expect("an overlap");
            let family = Family::<3>::along(Vector::<3>::new(0.0, 0.0, 1.0), 0, 0);
            let seen = exact.projection(&family, &reached, None);
            let points = exact.in_order(&seen.work, seen.facets.len(), |entered, scratch, found: &mut Vec<f64>| {
                let (along, between) = ((&family, None), (entered, None));
                exact.points_between(&seen, along, between, Rule::Middle, scratch, |point| found.push(point.length));
            });
            assert!(!points.is_empty());
            exact.silhouettes(&seen, &exact.edge_sides(&seen), &family, None);
            seen.work.pieces.load(Ordering::Relaxed) as f64 / seen.facets.len() as f64
        })
    }

    /// The number grows with the facets, not with their square, also where a few large ones face many small ones.
    #[test]
    fn pieces_are_as_many_as_facets_that_meet() {
        let plate = cuboid_surface([-1.0, -1.0, -1.0], [2.0, 2.0, 0.01], [1; 3]);
        let block = |n: usize| cuboid_surface([0.0; 3], [1.0; 3], [n, n, 1]).rotated([0.0, 0.0, 1.0], 0.3);
        let on_plate = [8, 16, 32].map(|n| pieces_per_facet(&plate, &block(n)));
        let balls = [2, 3, 4].map(|n| {
            let ball = icosphere(1.0, n);
            pieces_per_facet(&ball, &ball.clone().rotated([1.0, 2.0, 3.0], 0.4).translated([0.3, 0.2, 1.1]))
        });
        for found in [on_plate, balls] {
            println!("{found:?}");
            assert!(found.iter().all(|pieces| *pieces < 200.0), "{found:?}");
            assert!(found[2] < 1.5 * found[0], "{found:?}");
        }
    }
}
