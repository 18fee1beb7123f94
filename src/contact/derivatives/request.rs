//! What is differentiated, and by what.

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

/// What is differentiated: `energy` · w + `forces` · F.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Seeds<'a, const D: usize> {
    pub(crate) energy: f64,
    /// By node of the straight mesh; `None` for zeros.
    pub(crate) forces: Option<&'a [[f64; D]]>,
}
