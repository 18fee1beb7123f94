//! The distance from the other side, up to a reach.

use super::height_slopes::HeightSlopes;
use crate::Error;
use crate::geometry::Vector;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::convex_piece::place;
use crate::geometry::primitives::nearest_on_facet::nearest;
use crate::overlap::pair::obstacle_distance::{Distance, ObstacleDistance, signed};
use crate::overlap::pair::sides::{Counterpart, Pair};

/// Part of the reach within which the nearest facet is sought first.
const SHORT: f64 = 1.0 / 16.0;

/// The surface of one side, as the other sees it.
pub(crate) struct NearSurface<'a, const D: usize> {
    pair: &'a Pair<'a, D>,
    /// Whether it is that of the second side.
    of_b: bool,
    /// Of an obstacle without facets.
    shape: Option<ObstacleDistance<'a, D>>,
    reach: f64,
}

/// The signed distance at a point, positive outside, and where the nearest point of a body's surface lies.
pub(crate) struct Nearest<const D: usize> {
    pub(crate) distance: Distance<D>,
    /// Vertices of the surface and their weights; `None` on an obstacle.
    pub(crate) foot: Option<([u32; D], [f64; D])>,
    /// How far the curved face for which that surface stands lies outside of it.
    pub(crate) height: f64,
    /// What that height changes by; `None` where it is the same everywhere.
    pub(crate) of_height: Option<HeightSlopes<D>>,
}

impl<'a, const D: usize> NearSurface<'a, D> {
    /// The surface of the second side, or of the first.
    pub(crate) fn of(pair: &'a Pair<'a, D>, of_b: bool, reach: f64) -> Self {
        let shape = match (&pair.counterpart, pair.pose) {
            (Counterpart::Implicit(_), Some(pose)) if of_b => Some(ObstacleDistance::new(&pair.counterpart, pose)),
            _ => None,
        };
        Self { pair, of_b, shape, reach }
    }

    /// Facets of the opposite side that may be within reach, ascending.
    pub(crate) fn facets_opposite(&self) -> Vec<u32> {
        let opposite = self.pair.side(!self.of_b);
        match self.shape {
            Some(_) => self.pair.surface_facets(!self.of_b).collect(),
            None => opposite.facets_in(&self.pair.side(self.of_b).aabb.inflated(self.reach)),
        }
    }

    /// What is nearest to some points; `None` for a point outside that is out of reach.
    ///
    /// # Errors
    /// [`Error::SignedDistance`] where a function of the host fails.
    pub(crate) fn nearest(&self, points: &[Vector<D>]) -> Result<Vec<Option<Nearest<D>>>, Error> {
        let Some(shape) = &self.shape else { return Ok(points.iter().map(|x| self.on_facets(x)).collect()) };
        let within = |distance: Distance<D>| {
            (distance.phi < self.reach).then_some(Nearest { distance, foot: None, height: 0.0, of_height: None })
        };
        Ok(shape.at(points)?.into_iter().map(within).collect())
    }

    fn on_facets(&self, x: &Vector<D>) -> Option<Nearest<D>> {
        let side = self.pair.side(self.of_b);
        let is_inside = side.winding_number(x) != 0;
        let is_rigid = self.of_b && self.pair.pose.is_some();
        // Most points that are within a large reach are far nearer than that.
        let mut radius = SHORT * self.reach;
        loop {
            let around = Aabb { min: *x, max: *x }.inflated(radius);
            let mut best = (f64::INFINITY, Vector::zeros(), 0, [0.0; D]);
            for facet in side.facets_in(&around) {
                let corners = side.corners(facet as usize);
                let weights = nearest(&corners, x);
                let from = x - place(&corners, &weights);
                if from.norm_squared() < best.0 {
                    best = (from.norm_squared(), from, facet, weights);
                }
            }
            let (squared, from, facet, weights) = best;
            if squared.sqrt() < radius {
                let distance = signed(side, x, (squared, from, facet));
                let foot = (!is_rigid).then(|| (side.facets[facet as usize], weights));
                let sag = if is_rigid { None } else { self.pair.sag(self.of_b, facet) };
                let sag = sag.filter(|sag| !sag.is_flat());
                let height = sag.map_or(0.0, |sag| sag.at(&weights));
                let corners = side.corners(facet as usize);
                let of_height = sag.map(|sag| HeightSlopes::new(&corners, &weights, &from, sag.slopes(&weights)));
                return Some(Nearest { distance, foot, height, of_height });
            }
            if radius < self.reach {
                radius = (4.0 * radius).min(self.reach);
                continue;
            }
            // A point inside is as deep as it is; beyond the box there is no more to find.
            if !is_inside || around.contains(&side.aabb) {
                return None;
            }
            radius *= 2.0;
        }
    }
}
