//! Energy law and estimator of a case.

use fmc_contact::contact::Friction;
use fmc_contact::{
    EnergyLaw, EnergyProfile, Estimator, FiberOptions, FiberPattern, LineWeights, Options, PenetrationLaw, Resolution,
};
use serde::{Deserialize, Serialize};

/// `[contact]`
///
/// Options of fibers may stand in a case that is measured exactly. They hold if the estimator is changed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Contact {
    /// Energy of an overlap.
    pub law: LawName,
    /// Stiffness k: for `volume` energy / volumeᵐ (Pa for m = 1), for `fiber` and `depth` pressure / penetration (Pa/m).
    pub stiffness: f64,
    /// Length over which the pressure of `fiber-linear` grows to k, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub smoothing_length: Option<f64>,
    /// Exponent m of `volume`, at least 1.
    #[serde(default = "one")]
    pub exponent: f64,
    /// Coefficient of Coulomb friction, at least 0. The law `volume` needs the estimator `exact` and
    /// a `friction_stiffness`.
    #[serde(default, skip_serializing_if = "is_none")]
    pub friction_coefficient: f64,
    /// Stiffness of sticking contact, Pa/m; the stiffness of the law if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub friction_stiffness: Option<f64>,
    /// Traction without pressure, wherever there is contact, at least 0, Pa.
    #[serde(default, skip_serializing_if = "is_none")]
    pub cohesion: f64,
    /// Largest traction of friction, Pa; no limit if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shear_limit: Option<f64>,
    /// Measurement of the overlap.
    #[serde(default)]
    pub estimator: EstimatorName,
    /// Arrangement of the fibers.
    #[serde(default)]
    pub pattern: PatternName,
    /// Combination of several families of lines.
    #[serde(default)]
    pub weights: WeightsName,
    /// Number of fibers per pair, roughly; not together with `spacing`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fibers: Option<usize>,
    /// Distance between neighbouring fibers, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub spacing: Option<f64>,
    /// Length of a segment of the isotropic pattern, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fiber_length: Option<f64>,
    /// Seed of the random shift of the fibers.
    #[serde(default)]
    pub seed: u64,
    /// Whether every time step has new fibers, as in Wang et al. Constant fibers conserve energy better.
    #[serde(default)]
    pub new_fibers_every_step: bool,
    /// Whether the forces of a sampled overlap are corrected, so that their sum and moment vanish.
    #[serde(default = "yes")]
    pub momentum_correction: bool,
    /// Whether the gap to polygons is taken at the undeformed surface and their force acts along y, as closed forms assume.
    /// Equilibria in 2D only.
    #[serde(default)]
    pub linearised: bool,
    /// Whether a body may touch itself.
    #[serde(default)]
    pub self_contact: bool,
    /// Whether an inverted cell ends the run.
    #[serde(default = "yes")]
    pub check_cells: bool,
}

/// Names of energy laws.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum LawName {
    /// w = k Vᵐ.
    Volume,
    /// Energy ψ = ½ k L² of each fiber: the pressure is k times the penetration.
    Fiber,
    /// The same with ψ = k(√(L² + ε²) − ε): for ε to 0 the pressure is k wherever there is overlap; k in Pa.
    FiberLinear,
    /// w = k/2 ∫ (g_A + g_B) dx over the overlap, with g the depth below the surface of a body: the pressure is k times the
    /// penetration. Measured exactly.
    Depth,
}

/// Names of estimators.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum EstimatorName {
    /// Sampled.
    #[default]
    Fibers,
    /// Clipped.
    Exact,
}

/// Names of fiber patterns.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum PatternName {
    /// Families of parallel lines.
    #[default]
    Lines,
    /// Segments of random start and direction, as in Wang et al.
    Isotropic,
}

/// Names of weights.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum WeightsName {
    /// Least noise in the forces.
    #[default]
    Balance,
    /// Forces are the exact gradient of the estimated energy.
    Consistent,
}

fn one() -> f64 {
    1.0
}

fn yes() -> bool {
    true
}

fn is_none(x: &f64) -> bool {
    *x == 0.0
}

impl Contact {
    /// Options of the module; the result does not depend on `threads`.
    pub fn options(&self, threads: usize) -> Options {
        let law = match self.law {
            LawName::Volume => EnergyLaw::Volume { stiffness: self.stiffness, exponent: self.exponent },
            LawName::Fiber => EnergyLaw::fiber(self.stiffness),
            LawName::Depth => EnergyLaw::depth(self.stiffness),
            LawName::FiberLinear => {
                let profile = EnergyProfile::Linear { smoothing_length: self.smoothing_length.unwrap_or(0.0) };
                EnergyLaw::Fiber(PenetrationLaw { stiffness: self.stiffness, profile })
            }
        };
        let estimator = match self.estimator {
            EstimatorName::Exact => Estimator::Exact,
            EstimatorName::Fibers => Estimator::Fibers(FiberOptions {
                pattern: match self.pattern {
                    PatternName::Lines => FiberPattern::Lines,
                    PatternName::Isotropic => FiberPattern::Isotropic { length: self.fiber_length },
                },
                weights: match self.weights {
                    WeightsName::Balance => LineWeights::Balance,
                    WeightsName::Consistent => LineWeights::Consistent,
                },
                resolution: match (self.fibers, self.spacing) {
                    (Some(count), _) => Resolution::Count(count),
                    (None, Some(spacing)) => Resolution::Spacing(spacing),
                    (None, None) => Resolution::Auto,
                },
                seed: self.seed,
                momentum_correction: self.momentum_correction,
            }),
        };
        let friction = Friction {
            at_rest: None,
            coefficient: self.friction_coefficient,
            stiffness: self.friction_stiffness,
            cohesion: self.cohesion,
            shear_limit: self.shear_limit.unwrap_or(f64::INFINITY),
            ..Friction::default()
        };
        let Self { self_contact, check_cells, .. } = *self;
        Options { estimator, friction, threads, self_contact, check_cells, ..Options::new(law) }
    }

    /// Whether anything resists sliding.
    pub fn has_friction(&self) -> bool {
        self.friction_coefficient > 0.0 || self.cohesion > 0.0
    }

    /// The estimator in a word: `exact`, `lines` or `isotropic`.
    pub fn estimator_word(&self) -> &'static str {
        match (self.estimator, self.pattern) {
            (EstimatorName::Exact, _) => "exact",
            (EstimatorName::Fibers, PatternName::Lines) => "lines",
            (EstimatorName::Fibers, PatternName::Isotropic) => "isotropic",
        }
    }
}
