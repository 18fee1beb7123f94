//! Contact as a function of the displacement on the list.

use crate::Error;
use crate::contact::tangents::TangentPart;
use nalgebra::{DMatrix, DVector};

/// Multiples of a bit by which sums of some thousand terms differ, and so residuals of equilibria.
pub(super) const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Contact at a displacement.
#[derive(Clone, Debug)]
pub(super) struct Touch {
    /// With that of friction, which is its potential where it is frozen.
    pub(super) energy: f64,
    /// On the list.
    pub(super) forces: DVector<f64>,
    /// Those that are not zero on degrees of freedom that are not on the list, nor held.
    pub(super) outside: Vec<f64>,
}

impl Touch {
    /// Number of degrees of freedom outside on which it acts by more than what may be left of a residual: none if and only if
    /// all together do not.
    pub(super) fn outside(&self, goal: f64) -> usize {
        if DVector::from_column_slice(&self.outside).norm() <= goal {
            return 0;
        }
        // What is smaller everywhere has no larger norm.
        let share = goal / (self.outside.len() as f64).sqrt();
        self.outside.iter().filter(|force| force.abs() > share).count()
    }
}

/// Contact as a function of the displacement.
pub(super) trait Touching {
    fn at(&mut self, displacement: &DVector<f64>) -> Result<Touch, Error>;

    fn tangent(&mut self, displacement: &DVector<f64>, part: TangentPart) -> Result<DMatrix<f64>, Error>;

    /// Number of a degree of freedom of the list among all.
    fn dof(&self, place: usize) -> usize;

    /// Number of its node. What needs sparse factors asks for it.
    #[cfg_attr(not(feature = "solver"), allow(dead_code))]
    fn node(&self, place: usize) -> usize;

    /// Its coordinate at the start.
    fn start(&self, place: usize) -> f64;
}
