//! An interface that follows a law of the host, at the points that a cohesive interface has.

use super::axes::shares_of_axis;
use super::between::Between;
use super::cohesion::Cohesion;
use super::place::Weights;
use crate::Error;
use crate::geometry::{Surface, Vector, Weighting};

/// Two bodies that a law of the host holds together.
pub(crate) struct Governed<const D: usize> {
    pub(crate) points: Cohesion<D>,
    /// By facet of the second body what combination of its corners the first axis is.
    pub(super) axes: Vec<[f64; D]>,
    /// Where the points are without deformation, and their areas.
    pub(super) references: Vec<f64>,
    pub(super) areas: Vec<f64>,
}

impl<const D: usize> Governed<D> {
    /// As [`Cohesion::new`].
    pub(crate) fn new(
        surface: &Surface<D>,
        points: &[[f64; D]],
        weighting: Weighting,
        between: &Between,
    ) -> Result<Self, Error> {
        let found = Cohesion::new(surface, points, weighting, between)?;
        let at = |weights: &Weights| {
            weights.iter().fold(Vector::<D>::zeros(), |x, &(node, weight)| {
                x + Vector::from(points[found.nodes[node as usize] as usize]) * weight
            })
        };
        let axes = found.frames.iter().map(|corners| shares_of_axis(&corners.each_ref().map(at))).collect();
        let references =
            found.points.iter().flat_map(|point| <[f64; D]>::from(found.position(point, points))).collect();
        let areas = found.points.iter().map(|point| point.measure).collect();
        Ok(Self { points: found, axes, references, areas })
    }
}
