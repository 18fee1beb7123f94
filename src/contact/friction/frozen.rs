//! Friction with the facets and the pressure of an earlier iteration: the forces are then those of a convex potential.

use super::carriers::SliderName;
use super::past_points::PastPoints;
use super::slip_facets::SlipFacets;
use super::traction::Stick;
use crate::geometry::{Pose, Vector};
use crate::overlap::Partner;

/// The facets of all pairs, and where all stood when they were taken.
#[derive(Clone)]
pub(crate) struct FrozenFriction<const D: usize> {
    pairs: Vec<SlipFacets<D>>,
    /// Points of the mesh.
    pub(crate) coords: PastPoints<D>,
    /// Where the obstacles stood.
    pub(crate) poses: Vec<Option<Pose<D>>>,
    /// Which coordinates these are, of a mesh that is given in parts.
    pub(crate) epoch: u64,
}

impl<const D: usize> FrozenFriction<D> {
    /// Freezes the facets as they are.
    pub(crate) fn new(
        mut pairs: Vec<SlipFacets<D>>,
        coords: PastPoints<D>,
        poses: Vec<Option<Pose<D>>>,
        epoch: u64,
    ) -> Self {
        // A frozen limit does not change, nor does the part of the step that counts.
        for SlipFacets { facets, rows, .. } in &mut pairs {
            rows.iter_mut().for_each(|row| row.limit = Vector::zeros());
            facets.iter_mut().for_each(|facet| {
                facet.by_approach = Vector::zeros();
                facet.is_frozen = true;
            });
        }
        Self { pairs, coords, poses, epoch }
    }

    /// The facets as they are here, with limits that grow with the pressure, but some of those with memory stick whatever their limit is.
    pub(crate) fn holding(
        mut pairs: Vec<SlipFacets<D>>,
        (coords, poses, epoch): (PastPoints<D>, Vec<Option<Pose<D>>>, u64),
        is_held: impl Fn(&SliderName) -> bool,
    ) -> Self {
        for SlipFacets { partners, facets, .. } in &mut pairs {
            let facets = facets.iter_mut().filter(|facet| matches!(facet.slider.stick, Stick::Spring(_)));
            for facet in facets.filter(|facet| is_held(&(*partners, facet.of_b, facet.facet))) {
                facet.slider.limit = f64::INFINITY;
            }
        }
        Self { pairs, coords, poses, epoch }
    }

    /// Releases the pairs of which this holds: those against what is gone, or left out.
    pub(crate) fn release(&mut self, is_released: impl Fn(&[Partner; 2]) -> bool) {
        self.pairs.retain(|pair| !is_released(&pair.partners));
    }

    /// The facets with the slip that displacements since then have added; nothing else of them changes.
    pub(crate) fn at(&self, coords: &[[f64; D]], poses: &[Option<Pose<D>>]) -> Vec<SlipFacets<D>> {
        let mut pairs = self.pairs.clone();
        for SlipFacets { partners, facets, rows, .. } in &mut pairs {
            for facet in facets {
                let mut slip = Vector::zeros();
                // How an obstacle turned is in how its point has moved.
                for row in rows[facet.rows.clone()].iter().filter(|row| !row.mover.turns) {
                    let node = row.mover.node as usize;
                    let moved = match (coords.get(node), partners[1]) {
                        (Some(x), _) => Vector::from(*x) - Vector::from(self.coords[node]),
                        (None, Partner::Obstacle(o)) => self.moved_with(o, &poses[o], &facet.position),
                        _ => Vector::zeros(),
                    };
                    slip += row.slip * moved;
                }
                facet.trial += (slip - facet.normal * facet.normal.dot(&slip)) * facet.counted;
            }
        }
        pairs
    }

    /// How far a point of an obstacle has moved.
    fn moved_with(&self, obstacle: usize, pose: &Option<Pose<D>>, x: &Vector<D>) -> Vector<D> {
        match (&self.poses.get(obstacle).copied().flatten(), pose) {
            (Some(old), Some(new)) => new.place(&old.unplace(x)) - x,
            _ => Vector::zeros(),
        }
    }
}
