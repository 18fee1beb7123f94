//! What an estimator returns.

use crate::geometry::{Vector, Weighting};
use crate::overlap::pair::partner::Partner;
use crate::overlap::pair::warning::Warning;

/// Derivative of an overlap with respect to the pose of a rigid partner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoseGradient<const D: usize> {
    /// ∂V/∂position.
    pub position: Vector<D>,
    /// ∂V/∂(rotation about the origin of space), as a vector of three; in 2D only the last entry differs from zero, with
    /// axisymmetry none.
    pub rotation: [f64; 3],
    /// ∂V/∂scale; a gap offset of the pair is scaled too.
    pub scale: f64,
}

impl<const D: usize> PoseGradient<D> {
    /// Bodies of revolution do not turn.
    pub(crate) fn in_weighting(self, weighting: Weighting) -> Self {
        if weighting.is_plain() { self } else { Self { rotation: [0.0; 3], ..self } }
    }
}

/// Derivative with respect to the motion of a rigid partner, of what is not asked for by its scale.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MotionGradient<const D: usize> {
    pub(crate) position: Vector<D>,
    /// By a rotation about the origin of space.
    pub(crate) rotation: [f64; 3],
}

impl<const D: usize> MotionGradient<D> {
    /// Every derivative times a factor.
    pub(crate) fn scaled(&self, factor: f64) -> Self {
        Self { position: self.position * factor, rotation: self.rotation.map(|m| m * factor) }
    }
}

impl<const D: usize> From<PoseGradient<D>> for MotionGradient<D> {
    fn from(PoseGradient { position, rotation, .. }: PoseGradient<D>) -> Self {
        Self { position, rotation }
    }
}

/// Overlap of one pair: what both estimators return.
#[derive(Clone, Debug, PartialEq)]
pub struct Overlap<const D: usize> {
    /// First side; always a body of the mesh. Equal to `b` for the overlap of a body with itself.
    pub a: Partner,
    /// Second side.
    pub b: Partner,
    /// Volume (2D: area) of the overlap; of [`Contact::overlaps`](crate::Contact::overlaps) with the law `fiber` the sum
    /// over its lines, which measure a place once for every direction that serves it.
    pub volume: f64,
    /// Standard error of the volume from the spread of independent shifts; 0 for `exact`.
    pub standard_error: f64,
    /// Nodes whose gradient may differ from zero, ascending; a node that both sides share appears once for each.
    pub nodes: Vec<u32>,
    /// ∂V/∂x of those nodes.
    pub gradient: Vec<Vector<D>>,
    /// Whether those nodes belong to the second side.
    pub of_b: Vec<bool>,
    /// ∂V/∂pose where `b` is an obstacle.
    pub pose_gradient: Option<PoseGradient<D>>,
    /// Half of the measure of the overlap's boundary: the area of contact where it is thin.
    pub contact_area: f64,
    /// The longest line of the law `fiber`, the largest depth of the law `depth`, the extent of the overlap along its mean
    /// normal of the law `volume`: more than the depth where it is curved, or has several patches.
    pub penetration: f64,
    /// Fibers laid.
    pub fiber_count: usize,
    /// Crossings that bound the overlap (for `exact`: clipped pieces).
    pub crossing_count: usize,
    /// Facets that bound the overlap.
    pub facet_count: usize,
    /// Spacing of the fibers; 0 for `exact`.
    pub spacing: f64,
    /// Warnings.
    pub warnings: Vec<Warning>,
}

impl<const D: usize> Overlap<D> {
    /// Whether there is an overlap.
    pub(crate) fn has_volume(&self) -> bool {
        self.volume > 0.0
    }

    /// Whether there is an overlap, or something to say about its absence.
    pub(crate) fn has_content(&self) -> bool {
        self.has_volume() || !self.warnings.is_empty()
    }
}
