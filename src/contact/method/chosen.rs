//! The law and the estimator that the options name, for one dimension.

use super::options::Options;
use crate::Error;
use crate::contact::laws::{PairLaw, pair_law};
use crate::geometry::{Surface, Weighting};
use crate::overlap::PairEstimator;

/// Options in force, and what they name.
pub(crate) struct Method<const D: usize> {
    options: Options,
    /// Of the pairs that have none of their own.
    pub(crate) law: Box<dyn PairLaw<D>>,
    pub(crate) estimator: PairEstimator<D>,
    /// Whether tangents have the rotations of the obstacles.
    pub(crate) obstacle_rotations: bool,
}

impl<const D: usize> Method<D> {
    /// By options that have been checked.
    pub(crate) fn new(options: Options) -> Self {
        let (law, estimator) = (pair_law(&options.law), PairEstimator::new(&options.estimator));
        Self { options, law, estimator, obstacle_rotations: false }
    }

    /// The same with other options.
    pub(crate) fn with(&self, options: Options) -> Self {
        Self { obstacle_rotations: self.obstacle_rotations, ..Self::new(options) }
    }

    /// Checks options for the bodies of a surface.
    ///
    /// # Errors
    /// [`Error::NotPositive`], [`Error::Unsupported`].
    pub(crate) fn check(options: &Options, surface: &Surface<D>) -> Result<(), Error> {
        options.check()?;
        if D == 3 && options.axisymmetric {
            return Err(Error::Unsupported { what: "axisymmetry in 3D: its coordinates are (r, z)" });
        }
        check_depth(surface, options)
    }

    pub(crate) fn options(&self) -> &Options {
        &self.options
    }

    /// What measures count for.
    pub(crate) fn weighting(&self) -> Weighting {
        self.options.weighting()
    }
}

/// Refuses at once what no evaluation could measure: depth is that of cells.
fn check_depth<const D: usize>(surface: &Surface<D>, options: &Options) -> Result<(), Error> {
    let between_bodies = surface.body_count() > 1 || options.self_contact;
    if options.law.needs_depth() && between_bodies && surface.cells.is_none() {
        let what = "the law depth between bodies given by facets, since depth needs cells: give cells, or set the law \
            fiber or volume";
        return Err(Error::Unsupported { what });
    }
    let is_rubbed = options.friction.is_active() && !options.law.needs_depth() && !options.law.is_fiber();
    if is_rubbed && between_bodies && surface.cells.is_none() {
        let what = "friction with the law volume between bodies given by facets: give cells, or set the law fiber";
        return Err(Error::Unsupported { what });
    }
    Ok(())
}
