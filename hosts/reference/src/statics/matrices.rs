//! The bodies' matrix, and systems with it and the contact's tangent.

use super::condensed::Condensed;
use super::equations::Equations;
use fmc_contact::contact::TangentPart;
use fmc_contact::sparse::{Entries, Factorisation, Lower, solve_unsymmetric};
use std::sync::Arc;

/// Matrices and factors of a problem's bodies.
pub(super) struct Matrices {
    pub(super) equations: Equations,
    /// K on all degrees of freedom, held ones too, and the displacement that it is of; that of linear bodies is of any.
    pub(super) elastic: Option<(Arc<Lower>, Vec<f64>)>,
    pub(super) system: Factorisation,
    /// What the factors of the system are of.
    factors_of: Option<Of>,
    pub(super) condensed: Condensed,
}

/// Displacement, part of the contact's tangent, and part of the diagonal.
type Of = (Vec<f64>, TangentPart, f64);

impl Matrices {
    pub(super) fn new(equations: Equations, places: Vec<[f64; 3]>) -> Self {
        let (system, condensed) = (Factorisation::new(places.clone()), Condensed::new(places));
        Self { equations, elastic: None, system, factors_of: None, condensed }
    }

    /// Factorises the bodies' matrix alone. `false` if it is not positive definite.
    pub(super) fn factorise_bodies(&mut self, elastic: &Lower) -> bool {
        self.factors_of = None;
        let entries = self.equations.entries(elastic.entries());
        let matrix = Lower::new(self.equations.count(), entries);
        self.system.factorise(&matrix, &[])
    }

    /// Solution of a system that the factors of now are of, if they are.
    pub(super) fn known(&self, of: &Of, right: &[f64]) -> Option<Vec<f64>> {
        self.factors_of.as_ref().filter(|known| *known == of)?;
        self.system.solve(right)
    }

    /// Solution with the contact's tangent, by Cholesky's factors where there are any, else by those of Gauss; `None` for a singular
    /// matrix. `touching` has entries on both sides of the diagonal.
    pub(super) fn solve(
        &mut self,
        (elastic, touching): (&Lower, Entries),
        of: Of,
        is_symmetric: bool,
        right: &[f64],
    ) -> Option<Vec<f64>> {
        let (count, shift) = (self.equations.count(), of.2);
        let shifted = |(row, column, value): (usize, usize, f64)| {
            (row, column, if row == column { (1.0 + shift) * value } else { value })
        };
        let bodies: Vec<_> = self.equations.entries(elastic.entries()).map(shifted).collect();
        if !is_symmetric {
            return solve_unsymmetric(&Lower::new(count, bodies.into_iter()), &touching, right);
        }
        let whole = Lower::new(count, bodies.into_iter().chain(touching));
        self.factors_of = None;
        if self.system.factorise(&whole, &[]) {
            self.factors_of = Some(of);
            return self.system.solve(right);
        }
        solve_unsymmetric(&whole, &Entries::new(), right)
    }
}
