//! Options of the estimator, shared by the commands.

use anyhow::ensure;
use clap::{Args, ValueEnum};
use fmc_contact::{
    EnergyLaw, EnergyProfile, Estimator, FiberOptions, FiberPattern, LineWeights, Options, PenetrationLaw, Resolution,
};

/// Measure and energy of overlap.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Estimator and energy law")]
pub(crate) struct EstimatorArgs {
    /// How overlap is measured: exactly by clipping (straight-sided meshes only), sampled by fibers, or exactly where that
    /// is possible
    #[arg(long, value_enum, default_value_t)]
    pub(crate) estimator: EstimatorChoice,

    /// How fibers are laid: families of parallel lines, or segments of random start and direction
    #[arg(long, value_enum, default_value_t)]
    pub(crate) pattern: PatternKind,

    /// How the crossings of several line families are combined: least noise in the forces (balance), or forces that
    /// are the exact gradient of the estimated energy (consistent)
    #[arg(long, value_enum, default_value_t)]
    pub(crate) weights: WeightsKind,

    /// Contact energy: "depth" has the pressure k x penetration from the depth below both surfaces: bodies of cells,
    /// measured exactly; "fiber" has the same pressure line by line along the contact normal; "volume" is w = k V^m of each
    /// overlap
    #[arg(long, value_enum, default_value_t)]
    pub(crate) law: LawKind,

    /// Exponent m of the volume law, at least 1 [no unit]
    #[arg(long, value_name = "M", default_value_t = 1.0, value_parser = at_least_one)]
    pub(crate) m: f64,

    /// Makes the fiber law k (sqrt(L^2 + E^2) - E): the pressure grows to k over the length E [length]
    #[arg(long, value_name = "E", value_parser = positive)]
    pub(crate) smoothing_length: Option<f64>,

    /// About this many fibers per pair of bodies [default: from the facets in contact]
    #[arg(long, value_name = "N", conflicts_with = "spacing", value_parser = count)]
    pub(crate) fibers: Option<usize>,

    /// Distance between neighbouring fibers [length, the unit of the mesh; default: from the facets in contact]
    #[arg(long, value_name = "H", value_parser = positive)]
    pub(crate) spacing: Option<f64>,

    /// Length of a segment of the isotropic pattern [length; default: mean size of the facets in contact]
    #[arg(long, value_name = "L", value_parser = positive)]
    pub(crate) fiber_length: Option<f64>,

    /// Another seed is another random shift of the fibers; the same seed gives the same result, bit for bit
    #[arg(long, value_name = "S", default_value_t = 0)]
    pub(crate) seed: u64,

    /// Threads; the result does not depend on them
    #[arg(long, value_name = "T", default_value_t = 1, value_parser = count)]
    pub(crate) threads: usize,

    /// Also look for the overlap of each body with itself
    #[arg(long)]
    pub(crate) self_contact: bool,

    /// Axisymmetry, in 2D: coordinates are (r, z), and forces are those on whole rings
    #[arg(long)]
    pub(crate) axisymmetric: bool,

    /// Leave out the smallest change of the nodal forces that makes their sum and their moment vanish
    #[arg(long)]
    pub(crate) no_momentum_correction: bool,
}

/// `--estimator` of one evaluation.
#[derive(ValueEnum, Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum EstimatorChoice {
    #[default]
    Auto,
    Exact,
    Fibers,
}

/// `--estimator` of commands that have one of two.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum EstimatorKind {
    Fibers,
    Exact,
}

/// `--pattern`
#[derive(ValueEnum, Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum PatternKind {
    #[default]
    Lines,
    Isotropic,
}

/// `--weights`
#[derive(ValueEnum, Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum WeightsKind {
    #[default]
    Balance,
    Consistent,
}

/// `--law`
#[derive(ValueEnum, Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum LawKind {
    #[default]
    Depth,
    Fiber,
    Volume,
}

impl EstimatorArgs {
    /// Refuses options that would have no effect on the one evaluation that was asked for.
    pub(crate) fn check(&self) -> anyhow::Result<()> {
        let volume_law = self.law == LawKind::Volume;
        // Chosen automatically, lines may be needed, but never by the law depth.
        let sampled = match self.estimator {
            EstimatorChoice::Fibers => true,
            EstimatorChoice::Auto => self.law != LawKind::Depth,
            EstimatorChoice::Exact => false,
        };
        ensure!(sampled || self.fibers.is_none(), "--fibers has an effect with --estimator fibers only");
        ensure!(sampled || self.spacing.is_none(), "--spacing has an effect with --estimator fibers only");
        let isotropic = self.pattern == PatternKind::Isotropic;
        ensure!(
            !isotropic || self.estimator == EstimatorChoice::Fibers,
            "--pattern isotropic needs --estimator fibers"
        );
        let fiber_law = self.law == LawKind::Fiber;
        ensure!(fiber_law || self.smoothing_length.is_none(), "--smoothing-length needs --law fiber");
        ensure!(volume_law || self.m == 1.0, "--m has an effect with --law volume only");
        ensure!(isotropic || self.fiber_length.is_none(), "--fiber-length needs --pattern isotropic");
        Ok(())
    }

    /// Options of an evaluation with this stiffness.
    pub(crate) fn options(&self, stiffness: f64) -> Options {
        let profile = self
            .smoothing_length
            .map_or(EnergyProfile::Quadratic, |smoothing_length| EnergyProfile::Linear { smoothing_length });
        let law = match self.law {
            LawKind::Volume => EnergyLaw::Volume { stiffness, exponent: self.m },
            LawKind::Depth => EnergyLaw::depth(stiffness),
            LawKind::Fiber => EnergyLaw::Fiber(PenetrationLaw { stiffness, profile }),
        };
        Options {
            estimator: match self.estimator {
                EstimatorChoice::Fibers => Estimator::Fibers(self.fiber_options()),
                EstimatorChoice::Exact => Estimator::Exact,
                EstimatorChoice::Auto => Estimator::Auto(self.fiber_options()),
            },
            threads: self.threads,
            self_contact: self.self_contact,
            axisymmetric: self.axisymmetric,
            ..Options::new(law)
        }
    }

    /// Options of the sampled estimator, whether or not it is the one asked for.
    pub(crate) fn fiber_options(&self) -> FiberOptions {
        FiberOptions {
            pattern: match self.pattern {
                PatternKind::Lines => FiberPattern::Lines,
                PatternKind::Isotropic => FiberPattern::Isotropic { length: self.fiber_length },
            },
            weights: match self.weights {
                WeightsKind::Balance => LineWeights::Balance,
                WeightsKind::Consistent => LineWeights::Consistent,
            },
            resolution: match (self.fibers, self.spacing) {
                (Some(count), _) => Resolution::Count(count),
                (None, Some(spacing)) => Resolution::Spacing(spacing),
                (None, None) => Resolution::Auto,
            },
            seed: self.seed,
            momentum_correction: !self.no_momentum_correction,
        }
    }
}

/// Parses a positive, finite number.
pub(crate) fn positive(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() && value > 0.0 => Ok(value),
        Ok(_) => Err("it must be positive and finite".into()),
        Err(_) => Err("it is not a number".into()),
    }
}

fn at_least_one(text: &str) -> Result<f64, String> {
    positive(text).and_then(|value| if value >= 1.0 { Ok(value) } else { Err("it must be at least 1".into()) })
}

fn count(text: &str) -> Result<usize, String> {
    match text.parse() {
        Ok(0) => Err("it must be at least 1".into()),
        Ok(count) => Ok(count),
        Err(_) => Err("it is not a whole number of at least 1".into()),
    }
}
