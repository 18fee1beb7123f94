//! How an overlap is measured.

use crate::sampling::FiberPattern;

/// Which estimator.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Estimator {
    /// Sampled by fibers: any shape, any obstacle, with a standard error.
    Fibers(FiberOptions),
    /// Exact for straight-sided meshes and flat-sided obstacles, by clipping facets with cells.
    Exact,
    /// Pair by pair: exact between bodies and with obstacles that are bounded by planes, sampled by lines with curved
    /// obstacles, for which these options are. The default.
    Auto(FiberOptions),
}

impl Default for Estimator {
    fn default() -> Self {
        Estimator::Auto(FiberOptions::default())
    }
}

/// How many fibers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Resolution {
    /// From the facets in contact: some 16 lines per edge (2D) or 10 per triangle (3D), and at least 512 or 1 024 per
    /// family; errors of nodal forces are then near 1 %. The spacing is rounded down to a power of √2 so that the
    /// pattern stays as it is while facets change a little.
    #[default]
    Auto,
    /// About this many fibers per pair. The spacing then depends on the region of contact, and so on the coordinates.
    Count(usize),
    /// Distance between neighbouring lines of a family; the pattern then does not depend on the coordinates.
    /// For isotropic fibers: one fiber start per volume of this edge length.
    Spacing(f64),
}

/// How the crossings of several line families are combined.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LineWeights {
    /// A crossing with normal n weighs n / Σ_k ρ_k |d_k·n|, whichever family found it (balance heuristic): bounded for
    /// every n, the force with the least noise, but not the gradient of an energy. The default.
    #[default]
    Balance,
    /// One weight per line: the force is the exact gradient of the estimated energy on the same lines. For line
    /// searches and for the conservation of energy.
    Consistent,
}

/// Options of [`Estimator::Fibers`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FiberOptions {
    /// How fibers are laid.
    pub pattern: FiberPattern,
    /// How the families of [`FiberPattern::Lines`] are combined.
    pub weights: LineWeights,
    /// How many fibers.
    pub resolution: Resolution,
    /// A fiber is a pure function of seed, family and index; another seed is another random shift.
    pub seed: u64,
    /// The smallest change of the nodal forces that makes their sum and their moment vanish, per pair. On by default.
    pub momentum_correction: bool,
}

impl Default for FiberOptions {
    fn default() -> Self {
        Self {
            pattern: FiberPattern::default(),
            weights: LineWeights::default(),
            resolution: Resolution::default(),
            seed: 0,
            momentum_correction: true,
        }
    }
}
