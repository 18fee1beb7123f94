//! Bodies without contact, as a linear system on some degrees of freedom.

use super::options::ContactStepOptions;
use crate::Error;
use nalgebra::{DMatrix, DVector};

/// Stiffness and residual of bodies, condensed on some degrees of freedom.
#[derive(Clone, Copy, Debug)]
pub struct CondensedBodies<'a> {
    /// The list: degrees of freedom `node * D + axis`, ascending.
    pub dofs: &'a [usize],
    /// Degrees of freedom that do not move, on which contact may act: ascending, none of the list.
    pub held: &'a [usize],
    /// S, row by row; symmetric.
    pub stiffness: &'a [f64],
    /// r, internal less external forces at the coordinates of the start, without contact.
    pub residual: &'a [f64],
}

/// The same once it was looked at.
pub(super) struct Checked<'a> {
    pub(super) dofs: &'a [usize],
    /// As given.
    pub(super) stiffness: DMatrix<f64>,
    /// The mean of it and its transpose, which an energy has.
    pub(super) symmetric: DMatrix<f64>,
    pub(super) residual: DVector<f64>,
}

impl<'a> Checked<'a> {
    pub(super) fn new(bodies: &CondensedBodies<'a>, dof_count: usize) -> Result<Self, Error> {
        let CondensedBodies { dofs, held, stiffness, residual } = *bodies;
        check_list(dofs, dof_count)?;
        check_list(held, dof_count)?;
        if let Some(&dof) = held.iter().find(|dof| dofs.binary_search(dof).is_ok()) {
            return Err(Error::RepeatedDof { dof });
        }
        let count = dofs.len();
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
        Ok(Self { dofs, stiffness, symmetric, residual: DVector::from_column_slice(residual) })
    }

    pub(super) fn count(&self) -> usize {
        self.dofs.len()
    }

    /// Residual at which a step has converged, and what residuals are compared with.
    pub(super) fn goal(&self, options: &ContactStepOptions, forces: &DVector<f64>) -> (f64, f64) {
        let scale = self.residual.norm().max(forces.norm());
        (options.absolute_tolerance.max(options.tolerance * scale), scale)
    }
}

fn check_list(dofs: &[usize], count: usize) -> Result<(), Error> {
    if let Some(&dof) = dofs.iter().find(|dof| **dof >= count) {
        return Err(Error::DofOutOfRange { dof: dof as i64, count });
    }
    match dofs.windows(2).find(|pair| pair[0] >= pair[1]) {
        Some(pair) => Err(Error::RepeatedDof { dof: pair[1] }),
        None => Ok(()),
    }
}
