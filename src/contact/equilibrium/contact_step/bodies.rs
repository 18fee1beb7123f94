//! Bodies without contact, as a linear system on some degrees of freedom.

use super::options::ContactStepOptions;
use crate::Error;
use nalgebra::{DMatrix, DVector};

/// Stiffness and residual of bodies, condensed on some degrees of freedom.
#[derive(Clone, Copy, Debug)]
pub struct CondensedBodies<'a> {
    /// The list: degrees of freedom `node * D + axis`, ascending.
    pub freedoms: &'a [usize],
    /// Degrees of freedom that do not move, on which contact may act: ascending, none of the list.
    pub held: &'a [usize],
    /// S, row by row; symmetric.
    pub stiffness: &'a [f64],
    /// r, internal less external forces at the coordinates of the start, without contact.
    pub residual: &'a [f64],
}

/// The same once it was looked at.
pub(super) struct Checked<'a> {
    pub(super) freedoms: &'a [usize],
    /// As given.
    pub(super) stiffness: DMatrix<f64>,
    /// The mean of it and its transpose, which an energy has.
    pub(super) symmetric: DMatrix<f64>,
    pub(super) residual: DVector<f64>,
}

impl<'a> Checked<'a> {
    pub(super) fn new(bodies: &CondensedBodies<'a>, freedom_count: usize) -> Result<Self, Error> {
        let CondensedBodies { freedoms, held, stiffness, residual } = *bodies;
        check_list(freedoms, freedom_count)?;
        check_list(held, freedom_count)?;
        if let Some(&freedom) = held.iter().find(|freedom| freedoms.binary_search(freedom).is_ok()) {
            return Err(Error::RepeatedFreedom { freedom });
        }
        let count = freedoms.len();
        let length = |array, expected, found| match expected == found {
            true => Ok(()),
            false => Err(Error::Length { array, expected, found }),
        };
        length("residual", count, residual.len())?;
        length("stiffness", count.saturating_mul(count), stiffness.len())?;
        for (array, values) in [("stiffness", stiffness), ("residual", residual)] {
            if let Some(entry) = values.iter().position(|value| !value.is_finite()) {
                return Err(Error::NonFiniteStiffness { array, entry });
            }
        }
        let stiffness = DMatrix::from_row_slice(count, count, stiffness);
        let symmetric = (&stiffness + stiffness.transpose()) * 0.5;
        Ok(Self { freedoms, stiffness, symmetric, residual: DVector::from_column_slice(residual) })
    }

    pub(super) fn count(&self) -> usize {
        self.freedoms.len()
    }

    /// Residual at which a step has converged, and what residuals are compared with.
    pub(super) fn goal(&self, options: &ContactStepOptions, forces: &DVector<f64>) -> (f64, f64) {
        let scale = self.residual.norm().max(forces.norm());
        (options.goal.max(options.tolerance * scale), scale)
    }
}

fn check_list(freedoms: &[usize], count: usize) -> Result<(), Error> {
    if let Some(&freedom) = freedoms.iter().find(|freedom| **freedom >= count) {
        return Err(Error::FreedomOutOfRange { freedom: freedom as i64, count });
    }
    match freedoms.windows(2).find(|pair| pair[0] >= pair[1]) {
        Some(pair) => Err(Error::RepeatedFreedom { freedom: pair[1] }),
        None => Ok(()),
    }
}
