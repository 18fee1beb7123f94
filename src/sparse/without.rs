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

    /// No equations.
    pub fn size(&self) -> usize {
        0
    }

    /// None.
    pub fn kept(&self) -> &[usize] {
        &[]
    }

    /// Nothing.
    pub fn complement(&self) -> Vec<f64> {
        Vec::new()
    }

    /// Nothing.
    pub fn condense(&self, _: &[f64]) -> Result<Vec<f64>, Error> {
        Ok(Vec::new())
    }

    /// Nothing.
    pub fn expand(&self, _: &[f64], _: &[f64]) -> Result<Vec<f64>, Error> {
        Ok(Vec::new())
    }
}
