//! Bodies whose stiffness is factorised once, down to the equations that feel contact.

use super::symmetric::checked_list;
use super::{Factorisation, Lower};
use crate::Error;
use crate::sparse::Compressed;
use std::cmp::Ordering::Greater;

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
    /// Number of equations, `None` without factors, those that are kept, and the springs on them. Springs do not touch what elimination makes of
    /// the others; with them there are factors where contact alone holds a body.
    size: Option<usize>,
    kept: Vec<usize>,
    springs: Vec<f64>,
}

impl Condensation {
    /// Of matrices whose equations are at these places: by them the order of elimination is found.
    pub fn new(places: Vec<[f64; 3]>) -> Self {
        Self { factorisation: Factorisation::new(places), ..Self::default() }
    }

    /// Factorises a matrix; `kept` ascends. Where it is not positive definite, there are no factors then.
    ///
    /// Errors: [`Error::Length`], [`Error::DofOutOfRange`], [`Error::RepeatedDof`], [`Error::NonFiniteStiffness`],
    /// [`Error::Unsymmetric`] for what is given; [`Error::NotPositiveDefinite`]; [`Error::Overflow`].
    pub fn factorise(&mut self, matrix: &Compressed, kept: &[usize]) -> Result<(), Error> {
        checked_list(kept, matrix.size())?;
        self.factorise_lower(matrix.lower()?, kept)
    }

    /// The same for a lower triangle.
    ///
    /// Errors: [`Error::DofOutOfRange`], [`Error::RepeatedDof`]; [`Error::NotPositiveDefinite`]; [`Error::Overflow`].
    pub fn factorise_lower(&mut self, lower: Lower, kept: &[usize]) -> Result<(), Error> {
        checked_list(kept, lower.size())?;
        self.size = None;
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
        // A pivot that is no number is loose, too.
        let is_loose = |&(equation, pivot): &(usize, f64)| {
            !matches!(pivot.partial_cmp(&(ROUNDING * own[equation])), Some(Greater))
        };
        let loose = self.factorisation.pivots().find(is_loose);
        if let Some((equation, _)) = loose.filter(|(equation, _)| !is_kept[*equation]) {
            return Err(Error::NotPositiveDefinite { equation });
        }
        self.springs = kept.iter().map(|&equation| springs[equation]).collect();
        self.kept = kept.to_vec();
        finite("Schur complement", self.complement_of(kept.len()))?;
        self.size = Some(own.len());
        Ok(())
    }

    /// The factors of the last matrix with springs on what is kept, for hosts that follow a part of it alone. What is condensed does not
    /// feel the springs.
    ///
    /// Errors: [`Error::NotFactorised`].
    pub fn factors(&self) -> Result<&Factorisation, Error> {
        self.size().map(|_| &self.factorisation)
    }

    /// Number of equations of the last matrix. Errors: [`Error::NotFactorised`].
    pub fn size(&self) -> Result<usize, Error> {
        self.size.ok_or(Error::NotFactorised)
    }

    /// Those that were kept. Errors: [`Error::NotFactorised`].
    pub fn kept(&self) -> Result<&[usize], Error> {
        self.size().map(|_| &*self.kept)
    }

    /// S on the kept equations, row by row. Errors: [`Error::NotFactorised`].
    pub fn complement(&self) -> Result<Vec<f64>, Error> {
        let count = self.kept()?.len();
        Error::check_room("a dense matrix", count.saturating_mul(count).saturating_mul(2 * size_of::<f64>()))?;
        Ok(self.complement_of(count))
    }

    fn complement_of(&self, count: usize) -> Vec<f64> {
        let mut complement = self.factorisation.complement().matrix();
        complement.truncate(count * count);
        for (place, spring) in self.springs.iter().enumerate().take(count) {
            complement[place * (count + 1)] -= spring;
        }
        complement
    }

    /// `b_c − K_cr K_rr⁻¹ b_r` of a right side.
    ///
    /// Errors: [`Error::NotFactorised`], [`Error::Length`], [`Error::NonFiniteStiffness`], [`Error::Overflow`].
    pub fn condense(&self, right: &[f64]) -> Result<Vec<f64>, Error> {
        self.check("right", right, self.size()?)?;
        finite(
            "condensed right side",
            self.factorisation.condense(right).map_or_else(Vec::new, |condensed| condensed.kept),
        )
    }

    /// Solution x of `K x = b` in the other equations, `x_r = K_rr⁻¹ (b_r − K_rc x_c)`, where the kept ones are what is given.
    ///
    /// Errors: as [`condense`](Self::condense).
    pub fn expand(&self, right: &[f64], kept: &[f64]) -> Result<Vec<f64>, Error> {
        let size = self.size()?;
        self.check("right", right, size)?;
        self.check("kept", kept, self.kept.len())?;
        // Nothing is left of nothing: half of the work.
        let inner = match right.iter().all(|value| *value == 0.0) {
            true => vec![0.0; size - self.kept.len()],
            false => self.factorisation.condense(right).map_or_else(Vec::new, |condensed| condensed.inner),
        };
        finite("solution", self.factorisation.follow(inner.into_iter(), kept).unwrap_or_default())
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

/// Results that a double can hold, or the first that it cannot.
fn finite(quantity: &'static str, values: Vec<f64>) -> Result<Vec<f64>, Error> {
    match values.iter().find(|value| !value.is_finite()) {
        Some(&value) => Err(Error::Overflow { quantity, value }),
        None => Ok(values),
    }
}

#[cfg(test)]
mod tests;
