//! Options of pairs of the C interface as those of the crate, and back.

use crate::EnergyLaw;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::given_struct::check_struct;
use crate::capi::boundary::status::fmc_status::FMC_ERROR_OPTIONS_CONFLICT;
use crate::capi::calls::options::pair_interface::{InterfaceFields, fmc_interface, named_surfaces};
use crate::capi::calls::options::pair_options::{
    FMC_PAIR_FRICTION_OF_CONTEXT, FMC_PAIR_LAW_OF_CONTEXT, fmc_pair_options,
};
use crate::capi::structs::law::LawFields;
use crate::capi::structs::option_values::{EXCLUDED, static_friction};
use crate::capi::structs::options::{fmc_estimator, fmc_options};
use crate::contact::PairOptions;

impl From<PairOptions> for fmc_pair_options {
    fn from(options: PairOptions) -> Self {
        let friction_coefficient = options.friction_coefficient.unwrap_or(FMC_PAIR_FRICTION_OF_CONTEXT.into());
        let (excluded, gap_offset) = (options.excluded.into(), options.gap_offset);
        let [static_coefficient, weakening_slip] =
            options.static_friction.map_or([0.0; 2], |own| [own.coefficient, own.weakening_slip]);
        let own = Self { excluded, friction_coefficient, gap_offset, ..Self::default() };
        let InterfaceFields {
            interface_kind,
            softening,
            stiffness,
            reach,
            normal_strength,
            shear_strength,
            normal_energy,
            shear_energy,
            mixed_mode_exponent,
            viscosity,
        } = options.interface.into();
        let number = |surface: usize| i32::try_from(surface).unwrap_or(i32::MAX);
        let [surface_a, surface_b] = options.surfaces.map_or([0; 2], |both| both.map(number));
        let own = Self { surface_a, surface_b, ..own };
        let own = Self { static_coefficient, weakening_slip, interface_kind, softening, stiffness, reach, ..own };
        let own = Self {
            normal_strength,
            shear_strength,
            normal_energy,
            shear_energy,
            mixed_mode_exponent,
            viscosity,
            ..own
        };
        match options.law.map(LawFields::from) {
            None => own,
            Some(LawFields { law, stiffness, exponent, smoothing_length }) => {
                Self { law, stiffness, exponent, smoothing_length, ..own }
            }
        }
    }
}

impl fmc_pair_options {
    /// The options of the crate, which checks the numbers.
    pub(super) fn to_pair_options(self) -> Result<PairOptions, Failure> {
        check_struct::<Self>("fmc_pair_options", self.struct_size, self.reserved)?;
        let coefficient = self.friction_coefficient;
        let friction_coefficient = (coefficient != f64::from(FMC_PAIR_FRICTION_OF_CONTEXT)).then_some(coefficient);
        Ok(PairOptions {
            friction_law: false,
            excluded: EXCLUDED.is_on(self.excluded)?,
            law: self.law()?,
            friction_coefficient,
            static_friction: static_friction(self.static_coefficient, self.weakening_slip),
            gap_offset: self.gap_offset,
            interface: self.interface_fields().interface()?,
            surfaces: named_surfaces([self.surface_a, self.surface_b])?,
            orthotropic: None,
            // What a pair wears by is set by itself.
            wear_coefficients: [0.0; 2],
        })
    }

    fn interface_fields(&self) -> InterfaceFields {
        InterfaceFields {
            interface_kind: self.interface_kind,
            softening: self.softening,
            stiffness: self.stiffness,
            reach: self.reach,
            normal_strength: self.normal_strength,
            shear_strength: self.shear_strength,
            normal_energy: self.normal_energy,
            shear_energy: self.shear_energy,
            mixed_mode_exponent: self.mixed_mode_exponent,
            viscosity: self.viscosity,
        }
    }

    fn law(&self) -> Result<Option<EnergyLaw>, Failure> {
        let &Self { law, stiffness, exponent, smoothing_length, .. } = self;
        if law == FMC_PAIR_LAW_OF_CONTEXT {
            // Whoever sets one of these means something by it.
            let is_cohesive = self.interface_kind == fmc_interface::FMC_INTERFACE_COHESIVE as i32;
            let set = [("stiffness", stiffness != 0.0 && !is_cohesive), ("exponent", exponent != 1.0)];
            let set =
                set.into_iter().chain([("smoothing_length", smoothing_length != 0.0)]).find(|(_, is_set)| *is_set);
            return match set {
                None => Ok(None),
                Some((key, _)) => {
                    let text = format!("option '{key}' of a pair belongs to a law: set 'law' of the pair, too");
                    Err(Failure::new(FMC_ERROR_OPTIONS_CONFLICT, text))
                }
            };
        }
        if self.interface_kind == fmc_interface::FMC_INTERFACE_COHESIVE as i32 {
            let text = "option 'law' of a pair has no effect with the interface 'cohesive', which has its own";
            return Err(Failure::new(FMC_ERROR_OPTIONS_CONFLICT, text));
        }
        // What holds for the law of a context holds here. Of the estimators, "exact" has no options of its own.
        let estimator = fmc_estimator::FMC_ESTIMATOR_EXACT as i32;
        let alike = fmc_options { law, stiffness, exponent, smoothing_length, estimator, ..fmc_options::default() };
        Ok(Some(alike.to_options()?.law))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::capi::boundary::status::fmc_status;
    use crate::capi::boundary::status::fmc_status::FMC_ERROR_STRUCT_SIZE;
    use crate::contact::{Cohesive, Interface, Softening, StaticFriction};
    use crate::{EnergyProfile, PenetrationLaw};

    fn refused(change: impl FnOnce(&mut fmc_pair_options)) -> (fmc_status, String) {
        let mut options = fmc_pair_options::default();
        change(&mut options);
        let failure = options.to_pair_options().unwrap_err();
        (failure.status, failure.text)
    }

    #[test]
    fn options_come_back_as_they_were_set() {
        assert_eq!(fmc_pair_options::default().to_pair_options().unwrap(), PairOptions::default());
        let linear = EnergyProfile::Linear { smoothing_length: 1e-3 };
        for law in [
            EnergyLaw::Volume { stiffness: 3.0, exponent: 1.5 },
            EnergyLaw::fiber(3.0),
            EnergyLaw::Fiber(PenetrationLaw { stiffness: 3.0, profile: linear }),
            EnergyLaw::depth(3.0),
        ] {
            for excluded in [false, true] {
                for friction_coefficient in [None, Some(0.0), Some(0.3)] {
                    let gap_offset = friction_coefficient.unwrap_or(-0.2);
                    let own = |mu: f64| StaticFriction { coefficient: 1.5 * mu, weakening_slip: 0.1 };
                    let static_friction = friction_coefficient.filter(|mu| *mu > 0.0).map(own);
                    let law = Some(law);
                    let of_kind =
                        [Interface::Tied { reach: 0.25 }, Interface::NoSeparation { reach: 0.5 }, Interface::Rough];
                    let interface = if excluded {
                        Interface::Contact
                    } else {
                        of_kind[friction_coefficient.map_or(0, |mu| 1 + usize::from(mu > 0.0))]
                    };
                    let surfaces = (interface != Interface::Contact).then_some([3, 7]);
                    let options = PairOptions {
                        excluded,
                        law,
                        friction_coefficient,
                        static_friction,
                        gap_offset,
                        interface,
                        surfaces,
                        orthotropic: None,
                        friction_law: false,
                        wear_coefficients: [0.0; 2],
                    };
                    assert_eq!(fmc_pair_options::from(options).to_pair_options().unwrap(), options);
                }
            }
        }
    }

    #[test]
    fn a_cohesive_interface_has_its_own_stiffness_and_that_of_opening_by_default() {
        let interface = Interface::Cohesive(Cohesive {
            shear_strength: 3.0,
            shear_energy: 0.5,
            stiffness: 1e4,
            softening: Softening::Exponential,
            reach: 0.1,
            ..Cohesive::new(2.0, 0.25)
        });
        let options = PairOptions { interface, ..PairOptions::default() };
        assert_eq!(fmc_pair_options::from(options).to_pair_options().unwrap(), options);
        let interface_kind = fmc_interface::FMC_INTERFACE_COHESIVE as i32;
        let plain =
            fmc_pair_options { interface_kind, normal_strength: 2.0, normal_energy: 0.25, ..Default::default() };
        let expected = PairOptions::with_cohesive(Cohesive::new(2.0, 0.25));
        assert_eq!(plain.to_pair_options().unwrap(), expected);
    }

    #[test]
    fn what_has_no_effect_or_no_meaning_is_refused() {
        use fmc_status::FMC_ERROR_BAD_VALUE as VALUE;
        let (conflict, reserved) = (FMC_ERROR_OPTIONS_CONFLICT, fmc_status::FMC_ERROR_RESERVED_FIELD);
        for (change, wanted, text) in [
            ((|o| o.stiffness = 1.0) as fn(&mut fmc_pair_options), conflict, "'stiffness' of a pair belongs to a law"),
            (|o| o.exponent = 2.0, conflict, "'exponent' of a pair belongs to a law"),
            (|o| o.smoothing_length = f64::NAN, conflict, "'smoothing_length' of a pair belongs to a law"),
            (|o| (o.law, o.exponent) = (1, 2.0), conflict, "'exponent' belongs to the law 'volume'"),
            (|o| (o.law, o.smoothing_length) = (0, 1.0), conflict, "'smoothing_length' belongs to the law 'fiber'"),
            (|o| (o.law, o.smoothing_length) = (2, 1.0), conflict, "'smoothing_length' belongs to the law 'fiber'"),
            (|o| o.law = 3, VALUE, "option 'law' has no value 3"),
            (|o| o.excluded = 2, VALUE, "option 'excluded' has no value 2"),
            (|o| o.reserved[0] = 1, reserved, "later version"),
            (|o| o.interface_kind = 6, VALUE, "option 'interface_kind' has no value 6"),
            (|o| o.surface_b = 1, conflict, "'surface_a' and 'surface_b' are 0 and 1"),
            (|o| (o.surface_a, o.surface_b) = (1, -1), conflict, "are 1 and -1"),
            (|o| o.softening = 3, VALUE, "option 'softening' has no value 3"),
            (
                |o| o.reach = 0.1,
                conflict,
                "'reach' of a pair belongs to the interface 'tied', 'no_separation', 'cohesive' or 'law'",
            ),
            (|o| (o.interface_kind, o.shear_energy) = (1, 2.0), conflict, "'shear_energy' of a pair belongs to"),
            (|o| o.softening = 1, conflict, "'softening' of a pair belongs to the interface 'cohesive'"),
        ] {
            let (status, found) = refused(change);
            assert!(status == wanted && found.contains(text), "{found}");
        }
        assert_eq!(refused(|o| o.struct_size = 0).0, FMC_ERROR_STRUCT_SIZE);
    }
}
