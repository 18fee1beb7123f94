//! Options by name, for hosts whose language has no pleasant structs, and for input files.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::pointer::{Output, reference, text};
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::{FMC_ERROR_BAD_VALUE, FMC_ERROR_UNKNOWN_OPTION};
use crate::capi::structs::choice::Choice;
use crate::capi::structs::law::LAW;
use crate::capi::structs::option_values::{
    AXISYMMETRIC, CHECK_CELLS, ESTIMATOR, INDEX_BASE, MOMENTUM_CORRECTION, PATTERN, SELF_CONTACT, WEIGHTS,
};
use crate::capi::structs::options::fmc_options;
use std::ffi::c_char;
use std::str::FromStr;

/// The keys, for the message about an unknown one.
const KEYS: &str = "stiffness, exponent, spacing, fiber_length, fiber_count, seed, law, smoothing_length, estimator, pattern, \
                    weights, momentum_correction, self_contact, check_cells, axisymmetric, friction_coefficient, friction_stiffness, cohesion, shear_limit, \
                    memoryless_slip, static_coefficient, weakening_slip, weld, threads, index_base";

fn unknown_value(key: &str, value: &str, wanted: &str) -> Failure {
    Failure::new(FMC_ERROR_BAD_VALUE, format!("option '{key}' has no value '{value}': expected {wanted}"))
}

fn choice(choice: &Choice, value: &str) -> Result<i32, Failure> {
    choice.values.iter().find(|(_, name)| *name == value).map(|(number, _)| *number).ok_or_else(|| {
        let names: Vec<_> = choice.values.iter().map(|(_, name)| *name).collect();
        unknown_value(choice.key, value, &names.join(" or "))
    })
}

fn whole<T: FromStr>(key: &str, value: &str) -> Result<T, Failure> {
    value.parse().map_err(|_| unknown_value(key, value, "a whole number"))
}

/// A number, also with Fortran's exponent letter d.
fn number(key: &str, value: &str) -> Result<f64, Failure> {
    let parsed = value.replace(['d', 'D'], "e").parse().ok().filter(|number: &f64| number.is_finite());
    parsed.ok_or_else(|| unknown_value(key, value, "a finite number"))
}

/// The same, or infinite: `inf`.
fn number_or_infinity(key: &str, value: &str) -> Result<f64, Failure> {
    match value.parse() {
        Ok(f64::INFINITY) => Ok(f64::INFINITY),
        _ => number(key, value),
    }
}

fn set(options: &mut fmc_options, key: &str, value: &str) -> Result<(), Failure> {
    match key {
        "stiffness" => options.stiffness = number(key, value)?,
        "exponent" => options.exponent = number(key, value)?,
        "smoothing_length" => options.smoothing_length = number(key, value)?,
        "friction_coefficient" => options.friction_coefficient = number_or_infinity(key, value)?,
        "friction_stiffness" => options.friction_stiffness = number(key, value)?,
        "cohesion" => options.cohesion = number(key, value)?,
        "shear_limit" => options.shear_limit = number(key, value)?,
        "memoryless_slip" => options.memoryless_slip = number(key, value)?,
        "static_coefficient" => options.static_coefficient = number(key, value)?,
        "weakening_slip" => options.weakening_slip = number(key, value)?,
        "weld" => options.weld = number(key, value)?,
        "spacing" => options.spacing = number(key, value)?,
        "fiber_length" => options.fiber_length = number(key, value)?,
        "fiber_count" => options.fiber_count = whole(key, value)?,
        "seed" => options.seed = whole(key, value)?,
        "threads" => options.threads = whole(key, value)?,
        "law" => options.law = choice(&LAW, value)?,
        "estimator" => options.estimator = choice(&ESTIMATOR, value)?,
        "pattern" => options.pattern = choice(&PATTERN, value)?,
        "weights" => options.weights = choice(&WEIGHTS, value)?,
        "momentum_correction" => options.momentum_correction = choice(&MOMENTUM_CORRECTION, value)?,
        "self_contact" => options.self_contact = choice(&SELF_CONTACT, value)?,
        "axisymmetric" => options.axisymmetric = choice(&AXISYMMETRIC, value)?,
        "check_cells" => options.check_cells = choice(&CHECK_CELLS, value)?,
        "index_base" => options.index_base = choice(&INDEX_BASE, value)?,
        _ => return Err(Failure::new(FMC_ERROR_UNKNOWN_OPTION, format!("no option '{key}'; there are {KEYS}"))),
    }
    Ok(())
}

/// Sets one option by the name of its field, both as text: ("stiffness", "2.5e6"), ("estimator", "exact"),
/// ("momentum_correction", "0"). Blanks around them are ignored, and numbers may be written as in Fortran, "2.5d6".
///
/// Errors: `FMC_ERROR_UNKNOWN_OPTION` for an unknown key, `FMC_ERROR_BAD_VALUE` for an unknown value; ranges are checked
/// where the options are used.
/// Threads: any, on different structs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_options_set(
    options: *mut fmc_options,
    key: *const c_char,
    value: *const c_char,
) -> fmc_status {
    entry(|| {
        let output = Output::required("options", options)?;
        // SAFETY: the host passes a struct of the header's size, and texts that end in zero.
        let (mut changed, key, value) =
            unsafe { (*reference("options", options)?, text("key", key)?, text("value", value)?) };
        changed.check_struct()?;
        set(&mut changed, key.trim(), value.trim())?;
        // SAFETY: the struct may be written.
        unsafe { output.write(changed) };
        Ok(())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_key_of_the_list_sets_a_field() {
        for key in KEYS.split(", ") {
            let mut options = fmc_options { momentum_correction: 0, check_cells: 0, ..fmc_options::default() };
            let before = options;
            let value = match key {
                "law" => "volume",
                "estimator" => "exact",
                "pattern" => "isotropic",
                "weights" => "consistent",
                "threads" => "8",
                "exponent" => "2.0d0",
                _ => "1",
            };
            set(&mut options, key, value).unwrap();
            assert!(options != before, "{key}");
            let failure = set(&mut options, key, "none").unwrap_err();
            assert!(failure.text.starts_with(&format!("option '{key}' has no value 'none'")), "{}", failure.text);
        }
    }

    #[test]
    fn only_friction_may_be_infinite() {
        let mut options = fmc_options::default();
        set(&mut options, "friction_coefficient", "inf").unwrap();
        assert_eq!(options.friction_coefficient, f64::INFINITY);
        for (key, value) in [("friction_coefficient", "-inf"), ("friction_coefficient", "nan"), ("stiffness", "inf")] {
            assert_eq!(set(&mut options, key, value).unwrap_err().status, FMC_ERROR_BAD_VALUE);
        }
    }

    #[test]
    fn unknown_keys_are_refused_by_name() {
        let failure = set(&mut fmc_options::default(), "stifness", "1").unwrap_err();
        assert_eq!(failure.status, FMC_ERROR_UNKNOWN_OPTION);
        assert!(failure.text.starts_with("no option 'stifness'; there are stiffness, "));
    }

    #[test]
    fn numbers_that_are_none_are_refused() {
        for value in ["nan", "inf", "", "1,5", "0x10"] {
            assert!(set(&mut fmc_options::default(), "stiffness", value).is_err(), "{value}");
        }
        assert!(set(&mut fmc_options::default(), "seed", "-1").is_err());
    }
}
