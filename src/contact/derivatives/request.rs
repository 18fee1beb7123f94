//! What is differentiated, and by what.

use crate::contact::friction::SliderName;
use std::collections::BTreeMap;

/// By what [`Contact::vjp`](crate::Contact::vjp) differentiates; by nothing at first. What is not asked for is not computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct GradientRequest {
    /// The coordinates.
    pub coords: bool,
    /// The coordinates without deformation, from which the law `depth` has its depths. Laws without depths do not depend on them.
    pub reference: bool,
    /// The stiffness of every pair that touches.
    pub stiffness: bool,
    /// The gap offset of every pair that touches, of bodies with half-spaces.
    pub gap_offsets: bool,
    /// The coefficient of friction of every pair that touches, with what was carried into the step held.
    pub friction: bool,
    /// The positions of the obstacles.
    pub positions: bool,
    /// The rotations of the obstacles about their positions.
    pub rotations: bool,
    /// The elastic slip carried into the step, of every facet that friction acts on.
    pub slip: bool,
}

impl GradientRequest {
    /// Whether the derivative of forces takes their tangent.
    pub(crate) fn needs_tangent(&self) -> bool {
        self.coords || self.needs_poses()
    }

    /// Whether that of obstacles is asked for.
    pub(crate) fn needs_poses(&self) -> bool {
        self.positions || self.rotations || self.gap_offsets
    }

    /// Whether anything is asked for that the laws answer.
    pub(crate) fn needs_answers(&self) -> bool {
        self.needs_tangent() || self.stiffness || self.friction
    }
}

/// What is differentiated: `energy` · w + `forces` · F + `slip` · s, s being the elastic slip at the end of the step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Seeds<'a, const D: usize> {
    pub(crate) energy: f64,
    /// By node of the straight mesh; `None` for zeros.
    pub(crate) forces: Option<&'a [[f64; D]]>,
    /// By the elastic slip that the step ends with.
    pub(crate) slip: &'a SlipSeeds,
}

/// Derivatives by the elastic slip of sliders; in 2D the last entry is 0.
pub(crate) type SlipSeeds = BTreeMap<SliderName, [f64; 3]>;

impl<const D: usize> Seeds<'_, D> {
    /// Whether anything hangs on friction.
    pub(crate) fn reaches_friction(&self) -> bool {
        self.forces.is_some() || !self.slip.is_empty()
    }
}
