//! Matrices on the equations.

use super::equilibrium::Equilibrium;
use super::error::StaticsError;
use super::iteration::Tangent;
use crate::fem::Law;
use fmc_contact::contact::TangentPart;
use fmc_contact::sparse::{Entries, Lower};
use std::sync::Arc;

impl<const D: usize> Equilibrium<D> {
    /// Stiffness of the bodies at a displacement. That of linear materials is computed once.
    pub(super) fn elastic(&mut self, u: &[[f64; D]]) -> Arc<Lower> {
        if let Some(elastic) = &self.elastic {
            return elastic.clone();
        }
        let elastic = self.problem.model.tangent(u);
        let entries = elastic.iter().filter_map(|entry| self.on_lower(entry));
        let elastic = Arc::new(Lower::new(self.equation_count, entries));
        self.elastic = self.is_linear().then(|| elastic.clone());
        elastic
    }

    /// Whether the bodies' forces are linear in their displacement.
    pub(super) fn is_linear(&self) -> bool {
        self.problem.model.parts().iter().all(|part| part.material.law == Law::LinearElastic)
    }

    /// Stiffness of the contact at a displacement; entries at one place add up.
    pub(super) fn touching(&mut self, u: &[[f64; D]], tangent: Tangent) -> Result<Entries, StaticsError> {
        let part = match tangent {
            Tangent::Elastic | Tangent::Contact => return Ok(Vec::new()),
            Tangent::Semidefinite => TangentPart::Semidefinite,
            Tangent::Full => TangentPart::Full,
        };
        let entries = self.touching_part(u, part)?;
        Ok(entries.into_iter().filter(|(row, column, _)| row >= column).collect())
    }

    /// Stiffness of the contact with what friction makes unsymmetric in it, on both sides of the diagonal.
    pub(super) fn touching_whole(&mut self, u: &[[f64; D]]) -> Result<Entries, StaticsError> {
        self.touching_part(u, TangentPart::Full)
    }

    fn touching_part(&mut self, u: &[[f64; D]], part: TangentPart) -> Result<Entries, StaticsError> {
        let clock = std::time::Instant::now();
        let touch = self.contact.tangent(&self.placed(u), part);
        self.contact_seconds += clock.elapsed().as_secs_f64();
        let touch = touch?;
        let linearised = self.problem.linearised.iter().flat_map(|l| l.tangent(&self.problem.contact.law, u));
        Ok(touch.triplets().chain(linearised).filter_map(|entry| self.on_both(entry)).collect())
    }

    /// Factorises the tangent at a displacement. `false` if it is not positive definite.
    pub(super) fn factorise(&mut self, u: &[[f64; D]], tangent: Tangent) -> Result<bool, StaticsError> {
        let (elastic, touching) = (self.elastic(u), self.touching(u, tangent)?);
        let whole = Lower::new(self.equation_count, elastic.entries().chain(touching));
        Ok(self.system.factorise(&whole, &[]))
    }

    /// Solution of the system with the semidefinite tangent at a displacement: by factors that there are of linear bodies, else by
    /// new ones. `None` if it is not positive definite.
    pub(super) fn semidefinite_step(
        &mut self,
        u: &[[f64; D]],
        right: &[f64],
    ) -> Result<Option<Vec<f64>>, StaticsError> {
        if self.is_linear() && self.ground.is_empty() && self.bulk.is_factorised() {
            let entries = self.touching(u, Tangent::Semidefinite)?;
            if let (Some(change), Some(condensed)) = (self.kept.placed(&entries), self.bulk.condense(right)) {
                let kept = self.bulk.schur().solve_changed(&change, &condensed.kept);
                return Ok(kept.and_then(|kept| self.bulk.follow(condensed.inner.iter().copied(), &kept)));
            }
        }
        Ok(if self.factorise(u, Tangent::Semidefinite)? { self.system.solve(right) } else { None })
    }

    /// An entry by degrees of freedom on the equations, if it is of their lower triangle.
    fn on_lower(&self, entry: (usize, usize, f64)) -> Option<(usize, usize, f64)> {
        self.on_both(entry).filter(|(row, column, _)| row >= column)
    }

    /// An entry by degrees of freedom on the equations.
    fn on_both(&self, (row, column, value): (usize, usize, f64)) -> Option<(usize, usize, f64)> {
        let equation = |freedom: usize| self.equations.get(freedom).copied().filter(|e| *e != u32::MAX);
        Some((equation(row)? as usize, equation(column)? as usize, value))
    }
}
