//! What an evaluation returns.

use crate::overlap::{Partner, Warning};

/// Resultant on one body of the mesh or on one obstacle.
#[derive(Clone, Debug, PartialEq)]
pub struct Resultant<const D: usize> {
    /// Id of the body as given (or its number among the connected components); for an obstacle its index.
    pub id: i64,
    /// Sum of the contact forces on it.
    pub force: [f64; D],
    /// Moment of the contact forces on it about the origin of space; in 2D only the last entry differs from zero.
    pub moment: [f64; 3],
    /// Nodes of its surface; 0 for an obstacle.
    pub node_count: usize,
}

/// One overlapping pair.
#[derive(Clone, Debug, PartialEq)]
pub struct PairForces {
    /// First side.
    pub a: Partner,
    /// Second side; equal to `a` for a body that overlaps itself.
    pub b: Partner,
    /// Overlap volume (2D: area).
    pub volume: f64,
    /// Standard error of the volume.
    pub standard_error: f64,
    /// Energy w(V).
    pub energy: f64,
    /// Traction dw/dV.
    pub pressure: f64,
    /// Area of contact.
    pub contact_area: f64,
    /// Extent of the overlap along its mean normal.
    pub penetration: f64,
    /// Spacing of the fibers; 0 for `exact`. Given back as `Resolution::Spacing`, it keeps the pattern.
    pub spacing: f64,
}

/// Contact forces and what belongs to them.
///
/// Units follow from the coordinates and from k: with lengths in m and k in Pa (m = 1), forces are N in 3D and N/m (per
/// unit thickness) in 2D.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactForces<const D: usize> {
    /// Force on every node, `[node_count, D]`, in the order of the coordinates: −∂w/∂x. It pushes bodies apart.
    pub forces: Vec<[f64; D]>,
    /// Overlap volume, summed over the pairs.
    pub volume: f64,
    /// Standard error of that sum.
    pub standard_error: f64,
    /// Contact energy, summed over the pairs.
    pub energy: f64,
    /// Area of contact, summed over the pairs.
    pub contact_area: f64,
    /// Largest penetration of any pair.
    pub penetration: f64,
    /// Fibers laid.
    pub fiber_count: usize,
    /// Crossings that bound an overlap.
    pub crossing_count: usize,
    /// Facets that bound an overlap.
    pub facet_count: usize,
    /// Resultants on the bodies, ordered by id.
    pub bodies: Vec<Resultant<D>>,
    /// Resultants on the obstacles.
    pub obstacles: Vec<Resultant<D>>,
    /// The overlapping pairs.
    pub pairs: Vec<PairForces>,
    /// What the user should know.
    pub warnings: Vec<Warning>,
}
