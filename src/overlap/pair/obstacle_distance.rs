//! The signed distance of any obstacle, in space.

use super::distance_slopes::{STEEP, steep};
use super::sides::{Counterpart, ImplicitSide};
use crate::Error;
use crate::configuration::FacetSide;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::convex_piece::place;
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::primitives::nearest_on_facet::nearest;
use crate::geometry::primitives::tree::Tree;
use crate::geometry::shapes::{ConvexShape, HalfSpace, ImplicitShape};
use crate::geometry::{Pose, SignedDistance, Vector};
use std::cell::Cell;

/// What the distance of an obstacle comes from.
pub(crate) struct ObstacleDistance<'a, const D: usize> {
    source: Source<'a, D>,
    pose: &'a Pose<D>,
}

enum Source<'a, const D: usize> {
    Convex(&'a dyn ConvexShape<D>),
    Function { function: &'a dyn SignedDistance<D>, obstacle: usize },
    Facets { side: &'a FacetSide<'a, D>, tree: Tree<D> },
}

/// The signed distance at a point and its gradient there.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Distance<const D: usize> {
    pub(crate) phi: f64,
    pub(crate) gradient: Vector<D>,
}

impl<'a, const D: usize> ObstacleDistance<'a, D> {
    /// That of an obstacle which stands against a body.
    pub(crate) fn new(counterpart: &'a Counterpart<'a, D>, pose: &'a Pose<D>) -> Self {
        let source = match counterpart {
            Counterpart::Facets(side) => {
                let boxes: Vec<Aabb<D>> = (0..side.facets.len()).map(|facet| side.facet_box(facet)).collect();
                Source::Facets { side, tree: Tree::new(&boxes) }
            }
            Counterpart::Implicit(ImplicitSide { shape: ImplicitShape::Function(function), obstacle, .. }) => {
                Source::Function { function: function.as_ref(), obstacle: *obstacle }
            }
            Counterpart::Implicit(ImplicitSide { shape: ImplicitShape::Convex(shape), .. }) => {
                Source::Convex(shape.as_ref())
            }
            Counterpart::Itself => Source::Convex(&HalfSpace),
        };
        let pose = if let Counterpart::Implicit(side) = counterpart { side.pose } else { pose };
        Self { source, pose }
    }

    /// At some points.
    ///
    /// # Errors
    /// [`Error::SignedDistance`] where a function of the host fails.
    pub(crate) fn at(&self, points: &[Vector<D>]) -> Result<Vec<Distance<D>>, Error> {
        let in_space = |phi: f64, gradient: &Vector<D>| Distance {
            phi: phi * self.pose.scale,
            gradient: self.pose.rotate(gradient),
        };
        match &self.source {
            Source::Convex(shape) => Ok(points
                .iter()
                .map(|x| {
                    let (phi, gradient) = shape.signed_distance(&self.pose.unplace(x));
                    in_space(phi, &gradient)
                })
                .collect()),
            Source::Facets { side, tree } => Ok(points.iter().map(|x| distance_from_facets(side, tree, x)).collect()),
            Source::Function { function, obstacle } => {
                let x: Vec<[f64; D]> = points.iter().map(|x| self.pose.unplace(x).into()).collect();
                let (mut phi, mut gradient) = (vec![f64::NAN; x.len()], vec![[f64::NAN; D]; x.len()]);
                let failed = |point| Error::SignedDistance { obstacle: *obstacle, point };
                function.evaluate(&x, &mut phi, &mut gradient).map_err(failed)?;
                let found: Vec<Distance<D>> =
                    phi.iter().zip(&gradient).map(|(phi, gradient)| in_space(*phi, &(*gradient).into())).collect();
                let is_finite = |at: &Distance<D>| at.phi.is_finite() && at.gradient.iter().all(|g| g.is_finite());
                match found.iter().position(|at| !is_finite(at)) {
                    Some(point) => Err(failed(point)),
                    None => Ok(found),
                }
            }
        }
    }

    /// Checks that the distance changes from a place to a point no more than they are apart: what is taken to be out of
    /// reach would else be missed.
    ///
    /// # Errors
    /// [`Error::SteepDistance`] if it does.
    pub(crate) fn check(&self, x: &Vector<D>, phi: f64, y: &Vector<D>, other: f64) -> Result<(), Error> {
        let Source::Function { obstacle, .. } = self.source else { return Ok(()) };
        let rounding = STEEP * STEEP * (x.amax() + phi.abs());
        if (phi - other).abs() > (x - y).norm() * (1.0 + STEEP) + rounding {
            return Err(steep(obstacle, [*x, *y], [phi, other]));
        }
        Ok(())
    }
}

/// Distance from the nearest facet, negative where the facets lie around the point.
pub(crate) fn distance_from_facets<const D: usize>(side: &FacetSide<D>, tree: &Tree<D>, x: &Vector<D>) -> Distance<D> {
    let found = Cell::new((f64::INFINITY, Vector::zeros(), 0));
    tree.least_squared_distance(x, f64::INFINITY, |facet, least| {
        let corners = side.corners(facet as usize);
        let from = x - place(&corners, &nearest(&corners, x));
        let squared = Some(from.norm_squared()).filter(|squared| *squared < least)?;
        found.set((squared, from, facet));
        Some(squared)
    });
    signed(side, x, found.get())
}

/// With its sign and gradient, given the squared distance from the nearest facet, the way from there, and the facet.
pub(crate) fn signed<const D: usize>(
    side: &FacetSide<D>,
    x: &Vector<D>,
    (squared, from, facet): (f64, Vector<D>, u32),
) -> Distance<D> {
    let sign = if side.winding_number(x) == 0 { 1.0 } else { -1.0 };
    let phi = sign * squared.sqrt();
    // The direction to a point that is as near as rounding is made of rounding.
    let gradient = if phi.abs() > side.aabb.rounding() {
        from / phi
    } else {
        area_vector(&side.corners(facet as usize)).try_normalize(0.0).unwrap_or_else(Vector::zeros)
    };
    Distance { phi, gradient }
}
