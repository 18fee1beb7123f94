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
    /// Of both sides, the points of the mesh that a point hangs on, with their shares.
    pub(super) sides: Vec<[Weights; 2]>,
}

/// Fields of the host at the points of the mesh, all of a point together.
#[derive(Clone, Debug, Default)]
pub(crate) struct LawFields {
    pub(crate) count: usize,
    pub(crate) values: Vec<f64>,
}

impl<const D: usize> Governed<D> {
    /// Fields on both sides of all points.
    pub(super) fn fields(&self, of: &LawFields) -> Vec<f64> {
        let at = |side: &Weights, field: usize| -> f64 {
            side.iter().map(|(node, share)| share * of.values[*node as usize * of.count + field]).sum()
        };
        let sides = self.sides.iter().flatten();
        sides.flat_map(|side| (0..of.count).map(move |field| at(side, field))).collect()
    }

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
        let sides = found.points.iter().map(|point| found.sides(point)).collect();
        Ok(Self { points: found, axes, references, areas, sides })
    }
}
