//! The bodies, factorised down to the equations on which contact acts.

use super::equations::Equations;
use fmc_contact::Error;
use fmc_contact::sparse::{Condensation, Factorisation, Lower};
use std::collections::BTreeSet;
use std::sync::Arc;

/// Factors of the bodies with the equations on which contact acts kept for the end.
#[derive(Default)]
pub(super) struct Condensed {
    factors: Condensation,
    /// Equations on which contact acts.
    kept: BTreeSet<usize>,
    /// The matrix that the factors are of.
    of: Option<Arc<Lower>>,
    /// Condensed matrix, row by row.
    pub(super) stiffness: Vec<f64>,
    /// Matrices factorised.
    pub(super) factorisations: usize,
}

impl Condensed {
    /// Of matrices whose equations are at these places.
    pub(super) fn new(places: Vec<[f64; 3]>) -> Self {
        Self { factors: Condensation::new(places), ..Self::default() }
    }

    /// Number of equations that are kept.
    pub(super) fn count(&self) -> usize {
        self.kept.len()
    }

    /// No equation is known to feel contact.
    pub(super) fn forget(&mut self) {
        (self.kept, self.of) = (BTreeSet::new(), None);
    }

    /// Keeps more equations; whether any of them is new.
    pub(super) fn keep(&mut self, equations: impl IntoIterator<Item = usize>) -> bool {
        let before = self.kept.len();
        self.kept.extend(equations);
        if self.kept.len() > before {
            self.of = None;
        }
        self.kept.len() > before
    }

    /// Degrees of freedom of the kept equations.
    pub(super) fn freedoms(&self, equations: &Equations) -> Vec<usize> {
        self.kept.iter().map(|&equation| equations.freedom(equation)).collect()
    }

    /// Factors of a matrix, of now if it has none.
    pub(super) fn factors_of(&mut self, elastic: &Arc<Lower>, equations: &Equations) -> Result<&Factorisation, Error> {
        if !self.of.as_ref().is_some_and(|of| Arc::ptr_eq(of, elastic)) {
            self.of = None;
            let matrix = Lower::new(equations.count(), equations.entries(elastic.entries()));
            let kept: Vec<usize> = self.kept.iter().copied().collect();
            self.factorisations += 1;
            self.factors.factorise_lower(matrix, &kept)?;
            self.stiffness = self.factors.complement()?;
            self.of = Some(Arc::clone(elastic));
        }
        self.factors.factors()
    }

    /// Substitutions through the whole of the factors.
    pub(super) fn passes(&self) -> usize {
        self.factors.factors().map_or(0, |factors| factors.passes.get())
    }
}
