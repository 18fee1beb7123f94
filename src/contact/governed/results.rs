//! What hosts are told of interfaces that follow a law of theirs.

/// A point of such an interface.
#[derive(Clone, Debug, PartialEq)]
pub struct LawPoint<const D: usize> {
    /// The pair, the body of lower index first.
    pub bodies: [usize; 2],
    /// Where it is, on the first body.
    pub position: [f64; D],
    /// The area that it stands for, without deformation.
    pub area: f64,
    /// Normal of the second body and axes in its plane, by rows.
    pub axes: [[f64; D]; D],
    /// Opening and sliding along these.
    pub jump: [f64; D],
    /// Traction along these, force by area: of a bond that is pulled apart positive along the normal.
    pub traction: [f64; D],
    /// Energies by area, as the law tells.
    pub stored: f64,
    /// See `stored`.
    pub dissipated: f64,
    /// The history as it would be after a step that ends here.
    pub history: Vec<f64>,
}
