//! Bodies whose stiffness is factorised once, down to the equations that feel contact.

use super::Factorisation;
use super::symmetric::checked_list;
use crate::Error;
use crate::sparse::Compressed;

/// Part of an equation's own stiffness below which what elimination leaves of it is rounding: the bodies are not held.
const ROUNDING: f64 = 1e-13;

/// A symmetric sparse matrix K of bodies, factorised with the equations that feel contact kept for the end:
///
/// `S = K_cc − K_cr K_rr⁻¹ K_rc` and `b_c − K_cr K_rr⁻¹ b_r`, with c the kept equations and r the others.
///
/// K_rr has to be positive definite: bodies that are held, or are so by what is kept. What depends on the pattern alone stays for
/// the next matrix of the same pattern. One thread: same input, same bits.
#[derive(Default)]
pub struct Condensation {
    factorisation: Factorisation,
    /// Number of equations, those that are kept, and the springs on them. Springs do not touch what elimination makes of
    /// the others; with them there are factors where contact alone holds a body.
    size: usize,
    kept: Vec<usize>,
    springs: Vec<f64>,
}

impl Condensation {
    /// Factorises a matrix; `kept` ascends. Where it is not positive definite, there are no factors then.
    ///
    /// Errors: [`Error::Length`], [`Error::FreedomOutOfRange`], [`Error::RepeatedFreedom`], [`Error::NonFiniteStiffness`],
    /// [`Error::Unsymmetric`] for what is given; [`Error::NotPositiveDefinite`].
    pub fn factorise(&mut self, matrix: &Compressed, kept: &[usize]) -> Result<(), Error> {
        checked_list(kept, matrix.size())?;
        let lower = matrix.lower()?;
        self.size = 0;
        let mut springs = vec![0.0; lower.size()];
        for (row, column, value) in lower.entries() {
            if row == column {
                springs[row] = value.abs();
            }
        }
        let own = springs.clone();
        let mut is_kept = vec![false; own.len()];
        kept.iter().for_each(|&equation| is_kept[equation] = true);
        springs.iter_mut().zip(&is_kept).for_each(|(spring, is_kept)| *spring *= f64::from(u8::from(*is_kept)));
        let on_springs = lower.with_springs(&springs);
        if !self.factorisation.factorise(&on_springs, kept) {
            let equation = self.factorisation.failed_at().unwrap_or(0);
            return Err(Error::NotPositiveDefinite { equation });
        }
        let loose = self.factorisation.pivots().find(|&(equation, pivot)| pivot <= ROUNDING * own[equation]);
        if let Some((equation, _)) = loose.filter(|(equation, _)| !is_kept[*equation]) {
            return Err(Error::NotPositiveDefinite { equation });
        }
        self.springs = kept.iter().map(|&equation| springs[equation]).collect();
        (self.size, self.kept) = (own.len(), kept.to_vec());
        Ok(())
    }

    /// Number of equations of the last matrix that has factors; 0 before the first.
    pub fn size(&self) -> usize {
        self.size
    }

    /// Those that were kept.
    pub fn kept(&self) -> &[usize] {
        &self.kept[..if self.size > 0 { self.kept.len() } else { 0 }]
    }

    /// S on the kept equations, row by row.
    pub fn complement(&self) -> Vec<f64> {
        let count = self.kept().len();
        let mut complement = self.factorisation.complement().matrix();
        complement.truncate(count * count);
        for (place, spring) in self.springs.iter().enumerate().take(count) {
            complement[place * (count + 1)] -= spring;
        }
        complement
    }

    /// `b_c − K_cr K_rr⁻¹ b_r` of a right side. Errors: [`Error::Length`], [`Error::NonFiniteStiffness`].
    pub fn condense(&self, right: &[f64]) -> Result<Vec<f64>, Error> {
        self.check("right", right, self.size)?;
        Ok(self.factorisation.condense(right).map_or_else(Vec::new, |condensed| condensed.kept))
    }

    /// Solution x of `K x = b` in the other equations, `x_r = K_rr⁻¹ (b_r − K_rc x_c)`, where the kept ones are what is given.
    ///
    /// Errors: as [`condense`](Self::condense).
    pub fn expand(&self, right: &[f64], kept: &[f64]) -> Result<Vec<f64>, Error> {
        self.check("right", right, self.size)?;
        self.check("kept", kept, self.kept().len())?;
        // Nothing is left of nothing: half of the work.
        let inner = match right.iter().all(|value| *value == 0.0) {
            true => vec![0.0; self.size - self.kept().len()],
            false => self.factorisation.condense(right).map_or_else(Vec::new, |condensed| condensed.inner),
        };
        Ok(self.factorisation.follow(inner.into_iter(), kept).unwrap_or_default())
    }

    fn check(&self, array: &'static str, values: &[f64], expected: usize) -> Result<(), Error> {
        if values.len() != expected {
            return Err(Error::Length { array, expected, found: values.len() });
        }
        match values.iter().position(|value| !value.is_finite()) {
            Some(entry) => Err(Error::NonFiniteStiffness { array, entry }),
            None => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests;
