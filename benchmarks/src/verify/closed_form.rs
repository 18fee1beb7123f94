//! What a case should give.

/// Overlap and its derivative with respect to the parameter θ of a case.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ClosedForm {
    /// Overlap: area in 2D, volume in 3D.
    pub value: f64,
    /// d(overlap)/dθ.
    pub derivative: f64,
    /// ∫ |v·n| dA over the moving surfaces that bound the overlap, v = dx/dθ: the derivative is what comes in less what
    /// goes out, this is the sum of both. It measures the error of a derivative that is zero, or nearly.
    pub flux: f64,
}

impl ClosedForm {
    /// Where all that moves moves outwards, or all inwards.
    pub(super) fn one_way(value: f64, derivative: f64) -> Self {
        Self { value, derivative, flux: derivative.abs() }
    }

    /// The same times a positive factor that does not depend on θ.
    pub(super) fn times(self, factor: f64) -> Self {
        Self { value: factor * self.value, derivative: factor * self.derivative, flux: factor * self.flux }
    }
}

/// Area of a regular polygon of so many edges as a fraction of its circle's: sin α / α, α = 2π / edges.
pub(super) fn polygon_fraction(edges: usize) -> f64 {
    let angle = std::f64::consts::TAU / edges as f64;
    angle.sin() / angle
}
