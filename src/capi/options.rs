//! Options of an evaluation.

use super::boundary::entry;
use super::failure::Failure;
use super::pointer::Output;
use super::status::fmc_status;
use super::status::fmc_status::{FMC_ERROR_STRUCT_SIZE, FMC_ERROR_UNKNOWN_OPTION};
use crate::{EnergyLaw, Error, Estimator, FiberOptions, FiberPattern, LineWeights, Options, Resolution};

/// Energy of an overlap.
#[repr(C)]
pub enum fmc_law {
    /// w = k V^m for every overlapping pair; k is `stiffness`, m is `exponent`. Key value "volume".
    FMC_LAW_VOLUME = 0,
}

/// How overlap is measured.
#[repr(C)]
pub enum fmc_estimator {
    /// Sampled by fibers: any shape and any obstacle, with a standard error. Key value "fibers".
    FMC_ESTIMATOR_FIBERS = 0,
    /// Exact for straight-sided meshes and flat-sided obstacles. Key value "exact".
    FMC_ESTIMATOR_EXACT = 1,
}

/// How fibers are laid.
#[repr(C)]
pub enum fmc_pattern {
    /// Families of parallel lines. Key value "lines".
    FMC_PATTERN_LINES = 0,
    /// Short segments of random place and direction, as in the paper; the variance of the force is infinite. Key value
    /// "isotropic".
    FMC_PATTERN_ISOTROPIC = 1,
}

/// How line families are combined.
#[repr(C)]
pub enum fmc_weights {
    /// Least noise, but the force is not the gradient of one number. Key value "balance".
    FMC_WEIGHTS_BALANCE = 0,
    /// The force is the exact gradient of the estimated energy. Key value "consistent".
    FMC_WEIGHTS_CONSISTENT = 1,
}

/// Options of an evaluation. `fmc_options_init` sets all of them; only `stiffness` has no default.
///
/// The struct keeps its size while options are added: they take the place of reserved fields, and old hosts keep
/// working. Every option can also be set by its name here, through `fmc_options_set`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_options {
    /// Set by `fmc_options_init`; tells an initialised struct from another.
    pub struct_size: usize,
    /// k > 0, no default. With `exponent` 1 it is a pressure (Pa) in 2D and 3D, and must exceed the peak contact
    /// pressure; in general energy / (length^dim)^m. See `fmc_suggest_stiffness_from_modulus`.
    pub stiffness: f64,
    /// m >= 1. Default 1.
    pub exponent: f64,
    /// Distance between neighbouring lines; 0, the default: found from the facets in contact.
    pub spacing: f64,
    /// Length of an isotropic fiber; 0, the default: the mean size of the facets in contact.
    pub fiber_length: f64,
    /// About so many fibers per pair; 0, the default: found from the facets in contact. Not together with `spacing`.
    pub fiber_count: u64,
    /// Another seed is another random shift of the same pattern. Default 0.
    pub seed: u64,
    /// A value of `fmc_law`. Default `FMC_LAW_VOLUME`.
    pub law: i32,
    /// A value of `fmc_estimator`. Default `FMC_ESTIMATOR_FIBERS`.
    pub estimator: i32,
    /// A value of `fmc_pattern`. Default `FMC_PATTERN_LINES`.
    pub pattern: i32,
    /// A value of `fmc_weights`. Default `FMC_WEIGHTS_BALANCE`.
    pub weights: i32,
    /// 1, the default: the smallest change of the nodal forces that makes their sum and moment vanish. 0: none.
    pub balance: i32,
    /// 1: also the overlap of each body with itself. Default 0.
    pub self_contact: i32,
    /// 1, the default: the orientation of every cell is checked at every evaluation. 0: it is not.
    pub check_cells: i32,
    /// Number of threads, at least 1, the default. The result does not depend on it.
    pub threads: i32,
    /// Number of the first node, 0 or 1. Default 0. Read where node numbers are given; messages count nodes, cells
    /// and facets from it.
    pub index_base: i32,
    /// Zero.
    pub reserved_flags: i32,
    /// Zero. What later versions add stands here.
    pub reserved: [u64; 16],
}

/// An option that takes one of a few values, each with its number and name.
pub(super) struct Choice {
    pub(super) key: &'static str,
    pub(super) values: &'static [(i32, &'static str)],
}

const SWITCH: &[(i32, &str)] = &[(0, "0"), (1, "1")];

pub(super) const LAW: Choice = Choice { key: "law", values: &[(fmc_law::FMC_LAW_VOLUME as i32, "volume")] };
pub(super) const ESTIMATOR: Choice = Choice {
    key: "estimator",
    values: &[
        (fmc_estimator::FMC_ESTIMATOR_FIBERS as i32, "fibers"),
        (fmc_estimator::FMC_ESTIMATOR_EXACT as i32, "exact"),
    ],
};
pub(super) const PATTERN: Choice = Choice {
    key: "pattern",
    values: &[
        (fmc_pattern::FMC_PATTERN_LINES as i32, "lines"),
        (fmc_pattern::FMC_PATTERN_ISOTROPIC as i32, "isotropic"),
    ],
};
pub(super) const WEIGHTS: Choice = Choice {
    key: "weights",
    values: &[
        (fmc_weights::FMC_WEIGHTS_BALANCE as i32, "balance"),
        (fmc_weights::FMC_WEIGHTS_CONSISTENT as i32, "consistent"),
    ],
};
pub(super) const BALANCE: Choice = Choice { key: "balance", values: SWITCH };
pub(super) const SELF_CONTACT: Choice = Choice { key: "self_contact", values: SWITCH };
pub(super) const CHECK_CELLS: Choice = Choice { key: "check_cells", values: SWITCH };
pub(super) const INDEX_BASE: Choice = Choice { key: "index_base", values: SWITCH };

impl Choice {
    /// Name of a value, or the failure that there is none.
    fn name(&self, value: i32) -> Result<&'static str, Failure> {
        self.values.iter().find(|(number, _)| *number == value).map(|(_, name)| *name).ok_or_else(|| {
            Failure::new(FMC_ERROR_UNKNOWN_OPTION, format!("option '{}' has no value {value}", self.key))
        })
    }

    fn is_on(&self, value: i32) -> Result<bool, Failure> {
        Ok(self.name(value)? == "1")
    }
}

impl Default for fmc_options {
    fn default() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            stiffness: 0.0,
            exponent: 1.0,
            spacing: 0.0,
            fiber_length: 0.0,
            fiber_count: 0,
            seed: 0,
            law: 0,
            estimator: 0,
            pattern: 0,
            weights: 0,
            balance: 1,
            self_contact: 0,
            check_cells: 1,
            threads: 1,
            index_base: 0,
            reserved_flags: 0,
            reserved: [0; 16],
        }
    }
}

impl fmc_options {
    /// Whether the struct was initialised, and asks for nothing that only a later version knows.
    pub(super) fn check_struct(&self) -> Result<(), Failure> {
        if self.struct_size != size_of::<Self>() {
            let text = format!(
                "fmc_options has struct_size {}, expected {}: call fmc_options_init first",
                self.struct_size,
                size_of::<Self>()
            );
            return Err(Failure::new(FMC_ERROR_STRUCT_SIZE, text));
        }
        if self.reserved_flags != 0 || self.reserved != [0; 16] {
            let text = "a reserved field of fmc_options is not zero: an option of a later version of the library";
            return Err(Failure::new(FMC_ERROR_UNKNOWN_OPTION, text));
        }
        Ok(())
    }

    /// Number of the first node.
    pub(super) fn checked_index_base(&self) -> Result<i32, Failure> {
        self.check_struct()?;
        INDEX_BASE.name(self.index_base).map(|_| self.index_base)
    }

    /// The options of the crate, which checks the numbers.
    pub(super) fn to_options(self) -> Result<Options, Failure> {
        self.checked_index_base()?;
        LAW.name(self.law)?;
        let estimator = match ESTIMATOR.name(self.estimator)? {
            "exact" => Estimator::Exact,
            _ => Estimator::Fibers(self.fibers()?),
        };
        let threads = usize::try_from(self.threads)
            .map_err(|_| Error::NotPositive { name: "threads", value: self.threads.into() })?;
        Ok(Options {
            estimator,
            threads,
            self_contact: SELF_CONTACT.is_on(self.self_contact)?,
            check_cells: CHECK_CELLS.is_on(self.check_cells)?,
            ..Options::new(EnergyLaw::Volume { k: self.stiffness, m: self.exponent })
        })
    }

    fn fibers(&self) -> Result<FiberOptions, Failure> {
        let resolution = match (self.fiber_count, self.spacing) {
            (0, 0.0) => Resolution::Auto,
            (0, spacing) => Resolution::Spacing(spacing),
            (count, 0.0) => Resolution::Count(usize::try_from(count).unwrap_or(usize::MAX)),
            _ => {
                let text = "options 'spacing' and 'fiber_count' exclude one another";
                return Err(Failure::new(FMC_ERROR_UNKNOWN_OPTION, text));
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
            balance: BALANCE.is_on(self.balance)?,
        })
    }
}

/// Sets all options to their defaults. Afterwards set at least `stiffness`.
///
/// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_options_init(options: *mut fmc_options) -> fmc_status {
    entry(|| {
        let output = Output::required("options", options)?;
        // SAFETY: the host passes a struct of the header's size, which may be written.
        unsafe { output.write(fmc_options::default()) };
        Ok(())
    })
}

#[cfg(test)]
mod tests {
    use super::*;
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
        assert_eq!(options.to_options().unwrap(), Options::new(EnergyLaw::volume(3.0)));
    }

    #[test]
    fn unknown_values_are_refused() {
        assert_eq!(refused(|o| o.law = 1).1, "option 'law' has no value 1");
        assert_eq!(refused(|o| o.estimator = -1).1, "option 'estimator' has no value -1");
        for change in [
            (|o| o.pattern = 2) as fn(&mut fmc_options),
            |o| o.weights = 2,
            |o| o.balance = 2,
            |o| o.self_contact = -1,
            |o| o.check_cells = 7,
            |o| o.index_base = 2,
            |o| o.reserved[3] = 1,
            |o| o.reserved_flags = 1,
            |o| (o.spacing, o.fiber_count) = (0.1, 10),
        ] {
            assert_eq!(refused(change).0, FMC_ERROR_UNKNOWN_OPTION);
        }
        assert_eq!(refused(|o| o.struct_size = 8).0, FMC_ERROR_STRUCT_SIZE);
        assert_eq!(
            refused(|o| o.threads = -2),
            (FMC_ERROR_NOT_POSITIVE, "'threads' is -2, which is not allowed".into())
        );
    }
}
