//! Values of the options, checked, and as options of the crate.

use super::choice::Choice;
use super::law::{LAW, LawFields};
use super::options::{fmc_estimator, fmc_options, fmc_pattern, fmc_weights};
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::given_struct::check_struct;
use crate::capi::boundary::status::fmc_status::FMC_ERROR_OPTIONS_CONFLICT;
use crate::contact::{Friction, StaticFriction};
use crate::{EnergyLaw, Error, Estimator, FiberOptions, FiberPattern, LineWeights, Options, Resolution};

const SWITCH: &[(i32, &str)] = &[(0, "0"), (1, "1")];

pub(crate) const ESTIMATOR: Choice = Choice {
    key: "estimator",
    values: &[
        (fmc_estimator::FMC_ESTIMATOR_FIBERS as i32, "fibers"),
        (fmc_estimator::FMC_ESTIMATOR_EXACT as i32, "exact"),
        (fmc_estimator::FMC_ESTIMATOR_AUTO as i32, "auto"),
    ],
};
pub(crate) const PATTERN: Choice = Choice {
    key: "pattern",
    values: &[
        (fmc_pattern::FMC_PATTERN_LINES as i32, "lines"),
        (fmc_pattern::FMC_PATTERN_ISOTROPIC as i32, "isotropic"),
    ],
};
pub(crate) const WEIGHTS: Choice = Choice {
    key: "weights",
    values: &[
        (fmc_weights::FMC_WEIGHTS_BALANCE as i32, "balance"),
        (fmc_weights::FMC_WEIGHTS_CONSISTENT as i32, "consistent"),
    ],
};
pub(crate) const MOMENTUM_CORRECTION: Choice = Choice { key: "momentum_correction", values: SWITCH };
pub(crate) const SELF_CONTACT: Choice = Choice { key: "self_contact", values: SWITCH };
pub(crate) const CHECK_CELLS: Choice = Choice { key: "check_cells", values: SWITCH };
pub(crate) const AXISYMMETRIC: Choice = Choice { key: "axisymmetric", values: SWITCH };
pub(crate) const INDEX_BASE: Choice = Choice { key: "index_base", values: SWITCH };
/// Of a pair.
pub(crate) const EXCLUDED: Choice = Choice { key: "excluded", values: SWITCH };

/// Friction of what rests, if either is set.
pub(crate) fn static_friction(coefficient: f64, weakening_slip: f64) -> Option<StaticFriction> {
    (coefficient != 0.0 || weakening_slip != 0.0).then_some(StaticFriction { coefficient, weakening_slip })
}

impl fmc_options {
    /// Whether the struct was initialised, and asks for nothing that only a later version knows.
    pub(crate) fn check_struct(&self) -> Result<(), Failure> {
        check_struct::<Self>("fmc_options", self.struct_size, self.reserved)
    }

    /// Number of the first node.
    pub(crate) fn checked_index_base(&self) -> Result<i32, Failure> {
        self.check_struct()?;
        INDEX_BASE.name(self.index_base).map(|_| self.index_base)
    }

    /// The options of the crate, which checks the numbers.
    pub(crate) fn to_options(self) -> Result<Options, Failure> {
        self.checked_index_base()?;
        self.check_effects()?;
        let law = self.law()?;
        let estimator = match ESTIMATOR.name(self.estimator)? {
            "exact" => Estimator::Exact,
            "auto" => Estimator::Auto(self.fibers()?),
            _ => Estimator::Fibers(self.fibers()?),
        };
        let threads = usize::try_from(self.threads)
            .map_err(|_| Error::NotPositive { name: "threads", value: self.threads.into() })?;
        Ok(Options {
            estimator,
            threads,
            self_contact: SELF_CONTACT.is_on(self.self_contact)?,
            check_cells: CHECK_CELLS.is_on(self.check_cells)?,
            axisymmetric: AXISYMMETRIC.is_on(self.axisymmetric)?,
            friction: self.friction(),
            ..Options::new(law)
        })
    }

    /// Refuses options that would have no effect beside others: whoever sets one means something by it.
    fn check_effects(&self) -> Result<(), Failure> {
        let estimator = ESTIMATOR.name(self.estimator)?;
        let law = LAW.name(self.law)?;
        // Chosen automatically, lines may be needed, but not by the law "depth".
        let is_sampled = estimator == "fibers" || (estimator == "auto" && law != "depth");
        let is_isotropic = PATTERN.name(self.pattern)? == "isotropic";
        let is_volume = law == "volume";
        let is_weighted = WEIGHTS.name(self.weights)? != "balance";
        let idle = [
            ("exponent", self.exponent != 1.0 && !is_volume, "the law 'volume'"),
            ("smoothing_length", self.smoothing_length != 0.0 && law != "fiber", "the law 'fiber'"),
            ("spacing", self.spacing != 0.0 && !is_sampled, "the estimator 'fibers'"),
            ("fiber_count", self.fiber_count != 0 && !is_sampled, "the estimator 'fibers'"),
            ("seed", self.seed != 0 && !is_sampled, "the estimator 'fibers'"),
            ("pattern", is_isotropic && estimator != "fibers", "the estimator 'fibers'"),
            ("weights", is_weighted && !is_sampled, "the estimator 'fibers'"),
            ("weights", is_weighted && !is_volume, "the law 'volume'"),
            ("weights", is_weighted && is_isotropic, "the pattern 'lines'"),
            ("fiber_length", self.fiber_length != 0.0 && !(is_sampled && is_isotropic), "the pattern 'isotropic'"),
        ];
        match idle.into_iter().find(|(_, is_idle, _)| *is_idle) {
            Some((key, _, owner)) => {
                Err(Failure::new(FMC_ERROR_OPTIONS_CONFLICT, format!("option '{key}' belongs to {owner}")))
            }
            None => Ok(()),
        }
    }

    /// Refuses a tolerance of nodes that are taken as one where there are no cells to merge.
    pub(crate) fn refuse_weld(&self, of: &str) -> Result<(), Failure> {
        match self.weld {
            0.0 => Ok(()),
            _ => Err(Failure::new(FMC_ERROR_OPTIONS_CONFLICT, format!("option 'weld' is not supported for {of}"))),
        }
    }

    fn friction(&self) -> Friction {
        Friction {
            coefficient: self.friction_coefficient,
            at_rest: static_friction(self.static_coefficient, self.weakening_slip),
            stiffness: (self.friction_stiffness != 0.0).then_some(self.friction_stiffness),
            memoryless_slip: (self.memoryless_slip != 0.0).then_some(self.memoryless_slip),
            cohesion: self.cohesion,
            shear_limit: if self.shear_limit == 0.0 { f64::INFINITY } else { self.shear_limit },
        }
    }

    fn law(&self) -> Result<EnergyLaw, Failure> {
        let &Self { law, stiffness, exponent, smoothing_length, .. } = self;
        LawFields { law, stiffness, exponent, smoothing_length }.read()
    }

    fn fibers(&self) -> Result<FiberOptions, Failure> {
        let resolution = match (self.fiber_count, self.spacing) {
            (0, 0.0) => Resolution::Auto,
            (0, spacing) => Resolution::Spacing(spacing),
            (count, 0.0) => Resolution::Count(usize::try_from(count).unwrap_or(usize::MAX)),
            _ => {
                let text = "options 'spacing' and 'fiber_count' exclude one another";
                return Err(Failure::new(FMC_ERROR_OPTIONS_CONFLICT, text));
            }
        };
        let length = (self.fiber_length != 0.0).then_some(self.fiber_length);
        Ok(FiberOptions {
            pattern: match PATTERN.name(self.pattern)? {
                "isotropic" => FiberPattern::Isotropic { length },
                _ => FiberPattern::Lines,
            },
            weights: match WEIGHTS.name(self.weights)? {
                "consistent" => LineWeights::Consistent,
                _ => LineWeights::Balance,
            },
            resolution,
            seed: self.seed,
            momentum_correction: MOMENTUM_CORRECTION.is_on(self.momentum_correction)?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::capi::boundary::status::fmc_status;
    use crate::{EnergyProfile, PenetrationLaw};
    use fmc_status::*;

    fn refused(change: impl FnOnce(&mut fmc_options)) -> (fmc_status, String) {
        let mut options = fmc_options { stiffness: 1.0, ..fmc_options::default() };
        change(&mut options);
        let failure = options.to_options().unwrap_err();
        (failure.status, failure.text)
    }

    #[test]
    fn defaults_are_those_of_the_crate() {
        let options = fmc_options { stiffness: 3.0, ..fmc_options::default() };
        assert_eq!(options.to_options().unwrap(), Options::new(EnergyLaw::depth(3.0)));
    }

    #[test]
    fn friction_has_five_numbers() {
        let options = fmc_options { stiffness: 3.0, friction_coefficient: 0.3, ..fmc_options::default() };
        assert_eq!(options.to_options().unwrap().friction, Friction::coulomb(0.3));
        let options = fmc_options { friction_stiffness: 2.0, cohesion: 1.0, shear_limit: 7.0, ..options };
        let friction = Friction { cohesion: 1.0, shear_limit: 7.0, ..Friction::coulomb(0.3) };
        let spring = Friction { stiffness: Some(2.0), ..friction };
        assert_eq!(options.to_options().unwrap().friction, spring);
        let options = fmc_options { friction_stiffness: 0.0, memoryless_slip: 1e-3, ..options };
        let memoryless = Friction { memoryless_slip: Some(1e-3), ..friction };
        assert_eq!(options.to_options().unwrap().friction, memoryless);
    }

    #[test]
    fn the_fiber_law_has_two_profiles() {
        let mut options = fmc_options { stiffness: 3.0, law: 1, ..fmc_options::default() };
        assert_eq!(options.to_options().unwrap().law, EnergyLaw::fiber(3.0));
        options.smoothing_length = 1e-3;
        let profile = EnergyProfile::Linear { smoothing_length: 1e-3 };
        assert_eq!(options.to_options().unwrap().law, EnergyLaw::Fiber(PenetrationLaw { stiffness: 3.0, profile }));
    }

    #[test]
    fn unknown_values_are_refused() {
        assert_eq!(refused(|o| o.law = 3).1, "option 'law' has no value 3");
        assert_eq!(refused(|o| o.estimator = -1).1, "option 'estimator' has no value -1");
        for change in [
            (|o| o.pattern = 2) as fn(&mut fmc_options),
            |o| o.weights = 2,
            |o| o.momentum_correction = 2,
            |o| o.self_contact = -1,
            |o| o.check_cells = 7,
            |o| o.index_base = 2,
            |o| o.axisymmetric = 2,
        ] {
            assert_eq!(refused(change).0, FMC_ERROR_BAD_VALUE);
        }
        assert_eq!(refused(|o| o.reserved[3] = 1).0, FMC_ERROR_RESERVED_FIELD);
        for change in [
            (|o| (o.law, o.spacing, o.fiber_count) = (1, 0.1, 10)) as fn(&mut fmc_options),
            |o| (o.law, o.smoothing_length) = (0, 1e-3),
            |o| o.smoothing_length = 1e-3,
            |o| o.exponent = 2.0,
        ] {
            assert_eq!(refused(change).0, FMC_ERROR_OPTIONS_CONFLICT);
        }
        for (change, text) in [
            ((|o| (o.estimator, o.spacing) = (1, 0.1)) as fn(&mut fmc_options), "'spacing' belongs to the estimator"),
            (|o| (o.estimator, o.fiber_count) = (1, 9), "'fiber_count' belongs to the estimator 'fibers'"),
            (|o| (o.estimator, o.seed) = (1, 9), "'seed' belongs to the estimator 'fibers'"),
            (|o| (o.estimator, o.pattern) = (1, 1), "'pattern' belongs to the estimator 'fibers'"),
            (|o| (o.law, o.estimator, o.weights) = (0, 1, 1), "'weights' belongs to the estimator 'fibers'"),
            (|o| (o.law, o.weights) = (1, 1), "'weights' belongs to the law 'volume'"),
            (|o| (o.estimator, o.weights) = (0, 1), "'weights' belongs to the law 'volume'"),
            (|o| o.smoothing_length = 0.1, "'smoothing_length' belongs to the law 'fiber'"),
            (|o| o.spacing = 0.1, "'spacing' belongs to the estimator 'fibers'"),
            (|o| (o.law, o.estimator, o.pattern, o.weights) = (0, 0, 1, 1), "'weights' belongs to the pattern 'lines'"),
            (
                |o| (o.law, o.estimator, o.fiber_length) = (1, 0, 0.1),
                "'fiber_length' belongs to the pattern 'isotropic'",
            ),
        ] {
            let (status, found) = refused(change);
            assert!(status == FMC_ERROR_OPTIONS_CONFLICT && found.contains(text), "{found}");
        }
        assert_eq!(refused(|o| o.struct_size = 8).0, FMC_ERROR_STRUCT_SIZE);
        assert_eq!(
            refused(|o| o.threads = -2),
            (FMC_ERROR_NOT_POSITIVE, "'threads' is -2, which is not allowed".into())
        );
    }
}
