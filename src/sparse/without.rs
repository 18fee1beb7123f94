//! What stands for the factors in a library without them.

use super::Compressed;
use crate::Error;

/// Bodies condensed on what feels contact: this library is built without the feature "solver", and every matrix is refused.
#[derive(Default)]
pub struct Condensation;

impl Condensation {
    /// Errors: [`Error::Unsupported`].
    pub fn factorise(&mut self, _: &Compressed, _: &[usize]) -> Result<(), Error> {
        Err(Error::Unsupported { what: "factors of sparse matrices: this library is built without 'solver'" })
    }

    /// Errors: [`Error::NotFactorised`], as everything below.
    pub fn size(&self) -> Result<usize, Error> {
        Err(Error::NotFactorised)
    }

    /// No equations are kept.
    pub fn kept(&self) -> Result<&[usize], Error> {
        Err(Error::NotFactorised)
    }

    /// No complement.
    pub fn complement(&self) -> Result<Vec<f64>, Error> {
        Err(Error::NotFactorised)
    }

    /// No right hand side is condensed.
    pub fn condense(&self, _: &[f64]) -> Result<Vec<f64>, Error> {
        Err(Error::NotFactorised)
    }

    /// No solution is expanded.
    pub fn expand(&self, _: &[f64], _: &[f64]) -> Result<Vec<f64>, Error> {
        Err(Error::NotFactorised)
    }
}
