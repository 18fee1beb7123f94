//! Which pairs are measured on lines.

use super::layout::FiberPair;
use crate::Error;
use crate::overlap::pair::fiber_trace::FiberTrace;
use crate::overlap::pair::imbalance::Imbalance;
use crate::overlap::pair::options::{Estimator, FiberOptions};
use crate::overlap::pair::sides::{Counterpart, Pair};
use crate::sampling::{Family, FiberPattern};

/// The lines that options ask for.
pub(crate) struct Lines<const D: usize> {
    pub(crate) options: FiberOptions,
    /// The standard families; none for isotropic segments.
    families: Vec<Family<D>>,
}

impl<const D: usize> Lines<D> {
    fn new(options: FiberOptions) -> Self {
        let with_lines = options.pattern == FiberPattern::Lines;
        Self { options, families: if with_lines { Family::all(options.seed) } else { Vec::new() } }
    }

    /// What is expected of the balance of forces: sampling leaves an imbalance, of any size where few lines meet the overlap.
    /// `None` where it is not to be put right.
    pub(crate) fn imbalance(&self) -> Option<Imbalance> {
        self.options.momentum_correction.then_some(Imbalance { rounding: 0.0, doubtful: f64::INFINITY })
    }

    /// A pair on these lines.
    pub(crate) fn of<'a>(&'a self, pair: &'a Pair<'a, D>) -> FiberPair<'a, D> {
        FiberPair { pair, families: &self.families, options: &self.options }
    }
}

/// How each pair is measured by the laws that may be sampled.
pub(crate) enum PairEstimator<const D: usize> {
    /// Exactly, or not at all.
    Exact,
    /// On lines.
    Lines(Lines<D>),
    /// Everything that is bounded by facets or by a plane exactly; what is curved needs lines.
    Auto(Lines<D>),
}

impl<const D: usize> PairEstimator<D> {
    /// The one that the options name.
    pub(crate) fn new(estimator: &Estimator) -> Self {
        match estimator {
            Estimator::Exact => Self::Exact,
            Estimator::Fibers(options) => Self::Lines(Lines::new(*options)),
            Estimator::Auto(options) => Self::Auto(Lines::new(*options)),
        }
    }

    /// The lines on which a pair is measured, if it is not measured exactly.
    pub(crate) fn lines_for(&self, pair: &Pair<D>) -> Option<&Lines<D>> {
        match (self, &pair.counterpart) {
            (Self::Exact, _) => None,
            (Self::Lines(lines), _) => Some(lines),
            (Self::Auto(lines), Counterpart::Implicit(side)) if !side.shape.is_half_space() => Some(lines),
            (Self::Auto(_), _) => None,
        }
    }

    /// Whether obstacles with flat sides are to come as facets where they need not.
    pub(crate) fn prefers_facets(&self) -> bool {
        !matches!(self, Self::Lines(_))
    }

    /// Lines that cross the overlap, to look at; none where there are no lines.
    pub(crate) fn trace(&self, pair: &Pair<D>) -> Result<Vec<FiberTrace<D>>, Error> {
        self.lines_for(pair).map_or_else(|| Ok(Vec::new()), |lines| lines.of(pair).trace())
    }
}
