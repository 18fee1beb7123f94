//! Options of single pairs.

use crate::EnergyLaw;
use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::given_struct::check_struct;
use crate::capi::boundary::pointer::{Output, optional};
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::FMC_ERROR_OPTIONS_CONFLICT;
use crate::capi::calls::options::pair_interface::{InterfaceFields, fmc_interface, fmc_softening, named_surfaces};
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, read, write};
use crate::capi::structs::law::LawFields;
use crate::capi::structs::option_values::{EXCLUDED, static_friction};
use crate::capi::structs::options::{fmc_estimator, fmc_options};
use crate::capi::structs::partner::partner;
use crate::contact::PairOptions;

/// Value of `law` in `fmc_pair_options`: the pair follows the law of the context's options, with its stiffness, also
/// after they change.
pub const FMC_PAIR_LAW_OF_CONTEXT: i32 = -1;

/// Value of `friction_coefficient` in `fmc_pair_options`: the pair has that of the context's options, also after it
/// changes.
pub const FMC_PAIR_FRICTION_OF_CONTEXT: i32 = -1;

/// Options of one pair of partners, in place of the context's. `fmc_pair_options_init` sets all of them to what a pair
/// has without options of its own.
///
/// New options take the place of reserved fields; the size of the struct does not change.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_pair_options {
    /// Set by `fmc_pair_options_init`, so that a struct that was not initialised is recognised.
    pub struct_size: usize,
    /// k > 0 of the law of this pair, in the units of `stiffness` in `fmc_options`; only with `law`, and then without a
    /// default. With `FMC_INTERFACE_COHESIVE`, which has no law beside it: traction by opening without damage, and in compression; 0: so much
    /// that damage begins at a hundredth of the opening at which a linear softening ends.
    pub stiffness: f64,
    /// m >= 1, for the law "volume" only. Default 1.
    pub exponent: f64,
    /// Smoothing length of the law "fiber"; 0, the default: the quadratic law.
    pub smoothing_length: f64,
    /// Distance at which contact begins, in length; 0, the default: at the surfaces. Penetration, gap and pressure are
    /// counted from there, also in weighted gaps. With an obstacle: its surface is taken to lie so much further out (a
    /// shell's thickness, a coating), or, if negative, further in (a clearance). Half-spaces, balls and capsules stay what
    /// they are, cylinders inwards; any other shape becomes its signed distance less the offset, with its outward edges
    /// rounded, and what holds for `FMC_SHAPE_SIGNED_DISTANCE` holds for it. Between bodies, and of one with itself,
    /// only with the law "depth" and not positive: -c lets either body in by c before it presses.
    pub gap_offset: f64,
    /// Coefficient of friction, at least 0 or infinite, or `FMC_PAIR_FRICTION_OF_CONTEXT`, the default; with
    /// `FMC_INTERFACE_COHESIVE` that of what is broken. All else of the friction is that of the context's options.
    pub friction_coefficient: f64,
    /// A value of `fmc_law`, or `FMC_PAIR_LAW_OF_CONTEXT`, the default.
    pub law: i32,
    /// 1: the pair is left out; it is not measured, and adds nothing to any result. With `surface_a` and `surface_b` these parts are held, and
    /// no other face of the pair is in contact. Default 0.
    pub excluded: i32,
    /// Coefficient of friction of what rests, at least that of what slides; 0, the default: that of the context's options, or none where
    /// `friction_coefficient` is set.
    pub static_coefficient: f64,
    /// Slip over which it falls to that of what slides, a length; positive with `static_coefficient`, else 0, the default.
    pub weakening_slip: f64,
    /// What happens between two bodies, a value of `fmc_interface`. Default `FMC_INTERFACE_CONTACT`.
    pub interface_kind: i32,
    /// A value of `fmc_softening`, with `FMC_INTERFACE_COHESIVE`. Default `FMC_SOFTENING_LINEAR`.
    pub softening: i32,
    /// How far apart faces that belong together may be, or how far they may overlap, a length, with `FMC_INTERFACE_TIED`,
    /// `FMC_INTERFACE_COHESIVE` and `FMC_INTERFACE_NO_SEPARATION`; 0, the default: a tenth of the mean facet of the body with
    /// the larger facets, all its faces included.
    pub reach: f64,
    /// With `FMC_INTERFACE_COHESIVE`: traction at which damage begins in pure opening, positive.
    pub normal_strength: f64,
    /// The same in pure sliding; 0, the default: that of opening.
    pub shear_strength: f64,
    /// Energy by area that pure opening takes until the interface is broken, positive.
    pub normal_energy: f64,
    /// The same of pure sliding; 0, the default: that of opening.
    pub shear_energy: f64,
    /// Exponent, at least 1, by which the two are mixed (Benzeggagh and Kenane); 0, the default: 2.
    pub mixed_mode_exponent: f64,
    /// With `FMC_INTERFACE_TIED`, `FMC_INTERFACE_COHESIVE` and `FMC_INTERFACE_NO_SEPARATION`: the part of the surface of `a`, a number of
    /// `fmc_context_add_surface`, whose faces may be held; 0, the default: all of it. Facets of both parts that are held are in no contact;
    /// all others of the pair press and rub, by the law "depth". Without parts nothing else of the pair is in contact.
    pub surface_a: i32,
    /// The same of `b`. Both are 0, or neither.
    pub surface_b: i32,
    /// With `FMC_INTERFACE_COHESIVE`: a time by which damage lags behind the law, so that searches pass where a structure snaps; 0, the
    /// default: none. `fmc_context_set_time_step` says how long a step takes.
    pub viscosity: f64,
    /// Zero. Room for options of later versions.
    pub reserved: [u64; 3],
}

impl Default for fmc_pair_options {
    fn default() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            stiffness: 0.0,
            exponent: 1.0,
            smoothing_length: 0.0,
            gap_offset: 0.0,
            friction_coefficient: FMC_PAIR_FRICTION_OF_CONTEXT.into(),
            law: FMC_PAIR_LAW_OF_CONTEXT,
            excluded: 0,
            static_coefficient: 0.0,
            weakening_slip: 0.0,
            interface_kind: fmc_interface::FMC_INTERFACE_CONTACT as i32,
            softening: fmc_softening::FMC_SOFTENING_LINEAR as i32,
            reach: 0.0,
            normal_strength: 0.0,
            shear_strength: 0.0,
            normal_energy: 0.0,
            shear_energy: 0.0,
            mixed_mode_exponent: 0.0,
            surface_a: 0,
            surface_b: 0,
            viscosity: 0.0,
            reserved: [0; 3],
        }
    }
}

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
            excluded: EXCLUDED.is_on(self.excluded)?,
            law: self.law()?,
            friction_coefficient,
            static_friction: static_friction(self.static_coefficient, self.weakening_slip),
            gap_offset: self.gap_offset,
            interface: self.interface_fields().interface()?,
            surfaces: named_surfaces([self.surface_a, self.surface_b])?,
            orthotropic: None,
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

/// Sets the options of a pair to what it has without options of its own: the law of the context, not left out.
///
/// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_pair_options_init(options: *mut fmc_pair_options) -> fmc_status {
    entry(|| {
        let output = Output::required("options", options)?;
        // SAFETY: the host passes a struct of the header's size, which may be written.
        unsafe { output.write(fmc_pair_options::default()) };
        Ok(())
    })
}

/// Sets the options of a pair: a body with another, with itself, or with an obstacle, in either order. They apply from
/// the next evaluation on; `options` NULL: the pair follows the context's again, as every pair does at first. Friction of the pair is then
/// the same in all directions; for another, call `fmc_context_set_orthotropic_pair` instead.
///
/// `a_kind` and `b_kind` are values of `fmc_partner`; `a` and `b` count bodies as `fmc_context_body_resultant` and obstacles as
/// `fmc_context_obstacle_resultant`. For a body with itself these options decide in place of the context's `self_contact` whether
/// it is evaluated against itself: `excluded` switches that off for this body, and anything else on.
///
/// Errors: `FMC_ERROR_NULL_POINTER`; `FMC_ERROR_BODY_OUT_OF_RANGE`, `FMC_ERROR_OBSTACLE_OUT_OF_RANGE` and
/// `FMC_ERROR_OBSTACLE_REMOVED`, naming the index; `FMC_ERROR_BAD_VALUE` for an unknown kind or value,
/// `FMC_ERROR_OPTIONS_CONFLICT` for an option that would have no effect; `FMC_ERROR_RESERVED_FIELD`; `FMC_ERROR_STRUCT_SIZE`; `FMC_ERROR_NOT_POSITIVE`;
/// `FMC_ERROR_UNSUPPORTED` for two obstacles, for a law that the estimator of the context does not support, and for a
/// gap offset between bodies that is positive or has another law than "depth"; `FMC_ERROR_UNTIED` for bodies that are
/// tied and face one another nowhere within reach, `FMC_ERROR_BUSY`. What was set before then stays. `fmc_context_set_options` refuses an
/// estimator that does not support the law of a pair. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_pair_options(
    context: *mut fmc_context,
    a_kind: i32,
    a: usize,
    b_kind: i32,
    b: usize,
    options: *const fmc_pair_options,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context, and options or NULL.
        unsafe {
            write(context, |state| {
                let partners = [partner(a_kind, a)?, partner(b_kind, b)?];
                let options = optional("options", options)?.map(|options| options.to_pair_options()).transpose()?;
                in_either!(&mut state.session, one => one.set_pair_options(partners, options))
            })
        }
    })
}

/// The options of a pair, named as in `fmc_context_set_pair_options`. Of a pair without options of its own, those that
/// hold for it: for a body with itself `excluded` is 1 unless the context's `self_contact` is on. Another coefficient of friction across a
/// direction is told by `fmc_context_orthotropic_pair`.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BODY_OUT_OF_RANGE`, `FMC_ERROR_OBSTACLE_OUT_OF_RANGE`,
/// `FMC_ERROR_OBSTACLE_REMOVED`, `FMC_ERROR_BAD_VALUE` for an unknown kind, `FMC_ERROR_UNSUPPORTED` for two
/// obstacles, `FMC_ERROR_BUSY`. Threads: several at once on one context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_pair_options(
    context: *const fmc_context,
    a_kind: i32,
    a: usize,
    b_kind: i32,
    b: usize,
    options: *mut fmc_pair_options,
) -> fmc_status {
    entry(|| {
        let output = Output::required("options", options)?;
        let partners = [partner(a_kind, a)?, partner(b_kind, b)?];
        // SAFETY: the host passes a context.
        let found = in_either!(&unsafe { read(context) }?.session, one => one.pair_options(partners))?;
        // SAFETY: the host passes an output that may be written.
        unsafe { output.write(found.into()) };
        Ok(())
    })
}

#[cfg(test)]
mod tests {
    use super::*;
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
            (|o| o.interface_kind = 5, VALUE, "option 'interface_kind' has no value 5"),
            (|o| o.surface_b = 1, conflict, "'surface_a' and 'surface_b' are 0 and 1"),
            (|o| (o.surface_a, o.surface_b) = (1, -1), conflict, "are 1 and -1"),
            (|o| o.softening = 2, VALUE, "option 'softening' has no value 2"),
            (
                |o| o.reach = 0.1,
                conflict,
                "'reach' of a pair belongs to the interface 'tied', 'no_separation' or 'cohesive'",
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
