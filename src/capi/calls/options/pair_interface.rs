//! What happens between two bodies, as options of a pair.

use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::status::fmc_status::FMC_ERROR_OPTIONS_CONFLICT;
use crate::capi::structs::choice::Choice;
use crate::contact::{Cohesive, Interface, Ppr, Softening};

/// Interface between two bodies.
#[repr(C)]
pub enum fmc_interface {
    /// They press and rub where they touch.
    FMC_INTERFACE_CONTACT = 0,
    /// They are tied where their faces face one another without deformation, within `reach` and up to an angle of 60 degrees. They are in
    /// no contact, neither there nor elsewhere. A gap or an overlap within reach is kept. Not with an obstacle, the law "volume", or a mesh
    /// in parts. See `fmc_context_tie`. Key value "tied".
    FMC_INTERFACE_TIED = 1,
    /// They are held together where tied bodies would be, by an interface that opens, slides and breaks. They are in no contact: the
    /// interface carries compression without damage, also where it is broken, at the points that initially faced one another. See
    /// `fmc_context_cohesive`. Key value "cohesive".
    FMC_INTERFACE_COHESIVE = 2,
    /// They slide on one another without friction, and do not separate, where tied bodies would be held: the normal part of a tie, also in
    /// compression. They are in no other contact. `fmc_context_begin_step`, `fmc_context_commit_step` and `fmc_context_augment` search
    /// again for the points that face one another. The rules for ties apply. Key value "no_separation".
    FMC_INTERFACE_NO_SEPARATION = 3,
    /// They press and open as in contact, and never slide where they touch: an infinite coefficient of friction. Key value "rough".
    FMC_INTERFACE_ROUGH = 4,
    /// They are held together where a cohesive interface would hold them, by a law of the host, and are in no contact: the law has to
    /// resist compression. Set by `fmc_context_set_law_pair`. Key value "law".
    FMC_INTERFACE_LAW = 5,
}

/// How the traction of a cohesive interface falls as it opens.
#[repr(C)]
pub enum fmc_softening {
    /// Along a straight line. Key value "linear".
    FMC_SOFTENING_LINEAR = 0,
    /// Exponentially: it never quite ends. Key value "exponential".
    FMC_SOFTENING_EXPONENTIAL = 1,
    /// By the potential of Park, Paulino and Roesler, which also gives its rise, and mixes opening and sliding: without `stiffness`,
    /// `mixed_mode_exponent` and `viscosity`. `fmc_context_set_ppr_pair` sets other shapes than the default ones. Key value "ppr".
    FMC_SOFTENING_PPR = 2,
}

const SOFTENING: Choice = Choice {
    key: "softening",
    values: &[
        (fmc_softening::FMC_SOFTENING_LINEAR as i32, "linear"),
        (fmc_softening::FMC_SOFTENING_EXPONENTIAL as i32, "exponential"),
        (fmc_softening::FMC_SOFTENING_PPR as i32, "ppr"),
    ],
};

const INTERFACE: Choice = Choice {
    key: "interface_kind",
    values: &[
        (fmc_interface::FMC_INTERFACE_CONTACT as i32, "contact"),
        (fmc_interface::FMC_INTERFACE_TIED as i32, "tied"),
        (fmc_interface::FMC_INTERFACE_COHESIVE as i32, "cohesive"),
        (fmc_interface::FMC_INTERFACE_NO_SEPARATION as i32, "no_separation"),
        (fmc_interface::FMC_INTERFACE_ROUGH as i32, "rough"),
        (fmc_interface::FMC_INTERFACE_LAW as i32, "law"),
    ],
};

/// What of the options of a pair says what happens between the two.
pub(super) struct InterfaceFields {
    pub(super) interface_kind: i32,
    pub(super) softening: i32,
    pub(super) stiffness: f64,
    pub(super) reach: f64,
    pub(super) normal_strength: f64,
    pub(super) shear_strength: f64,
    pub(super) normal_energy: f64,
    pub(super) shear_energy: f64,
    pub(super) mixed_mode_exponent: f64,
    pub(super) viscosity: f64,
}

impl Default for InterfaceFields {
    fn default() -> Self {
        Self {
            interface_kind: fmc_interface::FMC_INTERFACE_CONTACT as i32,
            softening: fmc_softening::FMC_SOFTENING_LINEAR as i32,
            stiffness: 0.0,
            reach: 0.0,
            normal_strength: 0.0,
            shear_strength: 0.0,
            normal_energy: 0.0,
            shear_energy: 0.0,
            mixed_mode_exponent: 0.0,
            viscosity: 0.0,
        }
    }
}

impl From<Interface> for InterfaceFields {
    fn from(interface: Interface) -> Self {
        match interface {
            Interface::Contact => Self::default(),
            Interface::Tied { reach } => {
                Self { interface_kind: fmc_interface::FMC_INTERFACE_TIED as i32, reach, ..Self::default() }
            }
            Interface::NoSeparation { reach } => {
                Self { interface_kind: fmc_interface::FMC_INTERFACE_NO_SEPARATION as i32, reach, ..Self::default() }
            }
            Interface::Rough => Self { interface_kind: fmc_interface::FMC_INTERFACE_ROUGH as i32, ..Self::default() },
            Interface::Law { reach } => {
                Self { interface_kind: fmc_interface::FMC_INTERFACE_LAW as i32, reach, ..Self::default() }
            }
            Interface::Cohesive(own) => Self {
                interface_kind: fmc_interface::FMC_INTERFACE_COHESIVE as i32,
                stiffness: own.stiffness,
                softening: match own.softening {
                    Softening::Linear => fmc_softening::FMC_SOFTENING_LINEAR as i32,
                    Softening::Exponential => fmc_softening::FMC_SOFTENING_EXPONENTIAL as i32,
                    Softening::Ppr(_) => fmc_softening::FMC_SOFTENING_PPR as i32,
                },
                reach: own.reach,
                normal_strength: own.normal_strength,
                shear_strength: own.shear_strength,
                normal_energy: own.normal_energy,
                shear_energy: own.shear_energy,
                mixed_mode_exponent: own.exponent,
                viscosity: own.viscosity,
            },
        }
    }
}

impl InterfaceFields {
    /// What they say; the crate checks the numbers.
    pub(super) fn interface(&self) -> Result<Interface, Failure> {
        let kind = INTERFACE.name(self.interface_kind)?;
        let softening = SOFTENING.name(self.softening)?;
        if kind == "cohesive" {
            let or = |value: f64, default: f64| if value == 0.0 { default } else { value };
            return Ok(Interface::Cohesive(Cohesive {
                normal_strength: self.normal_strength,
                shear_strength: or(self.shear_strength, self.normal_strength),
                normal_energy: self.normal_energy,
                shear_energy: or(self.shear_energy, self.normal_energy),
                exponent: or(self.mixed_mode_exponent, Cohesive::EXPONENT),
                stiffness: self.stiffness,
                softening: match softening {
                    "linear" => Softening::Linear,
                    "exponential" => Softening::Exponential,
                    _ => Softening::Ppr(Ppr::default()),
                },
                reach: self.reach,
                viscosity: self.viscosity,
            }));
        }
        let of_cohesive = [
            ("normal_strength", self.normal_strength != 0.0),
            ("shear_strength", self.shear_strength != 0.0),
            ("normal_energy", self.normal_energy != 0.0),
            ("shear_energy", self.shear_energy != 0.0),
            ("mixed_mode_exponent", self.mixed_mode_exponent != 0.0),
            ("viscosity", self.viscosity != 0.0),
            ("softening", softening != "linear"),
        ];
        let conflict = |key: &str, of: &str| {
            let text = format!("option '{key}' of a pair belongs to the interface {of}");
            Err(Failure::new(FMC_ERROR_OPTIONS_CONFLICT, text))
        };
        match of_cohesive.into_iter().find(|(_, is_set)| *is_set) {
            Some((key, _)) => conflict(key, "'cohesive'"),
            None if kind == "tied" => Ok(Interface::Tied { reach: self.reach }),
            None if kind == "no_separation" => Ok(Interface::NoSeparation { reach: self.reach }),
            None if kind == "law" => Ok(Interface::Law { reach: self.reach }),
            None if self.reach != 0.0 => conflict("reach", "'tied', 'no_separation', 'cohesive' or 'law'"),
            None if kind == "rough" => Ok(Interface::Rough),
            None => Ok(Interface::Contact),
        }
    }
}

/// The named parts of both surfaces, if there are any. A part of one alone would leave it to the reach what is held of the other.
pub(super) fn named_surfaces(both: [i32; 2]) -> Result<Option<[usize; 2]>, Failure> {
    match both.map(usize::try_from) {
        [Ok(0), Ok(0)] => Ok(None),
        [Ok(a @ 1..), Ok(b @ 1..)] => Ok(Some([a, b])),
        _ => {
            let of = "options 'surface_a' and 'surface_b' are";
            let text = format!("{of} {} and {}: both are numbers from 1, or both are 0", both[0], both[1]);
            Err(Failure::new(FMC_ERROR_OPTIONS_CONFLICT, text))
        }
    }
}
