//! Options of the context, as a struct and by name.

use super::Host;
use super::array::checked;
use crate::interface::*;
use crate::program::Options;
use std::ffi::{CStr, CString};

/// Options as the library takes them, for bodies that are ordinary or not: fibers that can be counted in a moment.
pub(super) fn options(from: &Options, is_ordinary: bool) -> fmc_options {
    let mut options = std::mem::MaybeUninit::<fmc_options>::zeroed();
    // SAFETY: zeros are a value of every field.
    let mut options = unsafe {
        if from.is_raw != 7 {
            assert_eq!(fmc_options_init(options.as_mut_ptr()), OK);
        }
        options.assume_init()
    };
    options.stiffness = from.stiffness.0;
    options.exponent = from.exponent.map_or(options.exponent, |x| x.0);
    options.smoothing_length = from.smoothing_length.map_or(0.0, |x| x.0);
    options.friction_coefficient = from.friction.map_or(0.0, |x| x.0);
    options.friction_stiffness = from.friction_stiffness.map_or(0.0, |x| x.0);
    options.cohesion = from.cohesion.map_or(0.0, |x| x.0);
    options.memoryless_slip = if from.friction_stiffness.is_none() { options.cohesion } else { 0.0 };
    options.fiber_length = from.fiber_length.map_or(0.0, |x| x.0);
    options.seed = from.seed;
    let choice = |which: u32| i32::from((from.choices >> (2 * which)) & 3) - 1;
    // No value at all is one of the four; the default, being the first, is two of them.
    let choices = [0, 1, 2, 3, 4, 5, 6].map(|which| if choice(which) < 0 { None } else { Some(choice(which)) });
    let fields = [
        &mut options.law,
        &mut options.estimator,
        &mut options.pattern,
        &mut options.weights,
        &mut options.momentum_correction,
        &mut options.self_contact,
        &mut options.check_cells,
    ];
    for (field, choice) in fields.into_iter().zip(choices) {
        *field = choice.unwrap_or(*field);
    }
    match from.choices >> 14 {
        2 => options.shear_limit = 0.5,
        3 => options.axisymmetric = 1,
        1 => (options.static_coefficient, options.weakening_slip) = (options.friction_coefficient + 0.25, 0.125),
        _ => {}
    }
    options.index_base = i32::from(from.index_base);
    options.threads = if from.is_threaded { 2 } else { 1 };
    options.fiber_count = u64::from(from.fiber_count.unwrap_or(100)) * 4;
    match from.spacing {
        Some(spacing) if is_ordinary => {
            options.fiber_count = 0;
            // In space as many lines again lie behind those of the plane.
            options.spacing = if spacing.0.abs() < 0.2 { 0.2 } else { spacing.0 };
        }
        Some(spacing) if !spacing.0.is_finite() || spacing.0 < 0.0 => options.spacing = spacing.0,
        _ => {}
    }
    // What would have no effect is refused; often enough it is left out.
    if !from.seed.is_multiple_of(8) {
        let (is_sampled, is_volume, is_isotropic) = (options.estimator != 1, options.law == 0, options.pattern == 1);
        if options.estimator != 0 {
            options.pattern = 0;
        }
        if !is_sampled {
            (options.spacing, options.fiber_count, options.seed, options.pattern) = (0.0, 0, 0, 0);
        }
        if !is_sampled || !is_volume || is_isotropic {
            options.weights = 0;
        }
        if !is_sampled || !is_isotropic {
            options.fiber_length = 0.0;
        }
    }
    // By themselves they lie an eighth as far apart, which takes seconds in space.
    if options.weights == 1 && options.spacing == 0.0 && options.fiber_count == 0 {
        options.fiber_count = 400;
    }
    options
}

impl Host {
    pub(super) fn set_options(&mut self, options: &fmc_options) {
        // SAFETY: the host's own context and options.
        if checked(unsafe { fmc_context_set_options(self.context, options) }) == OK {
            self.options = *options;
        }
    }

    pub(super) fn set_by_name(&mut self, key: u8, value: &[u8; 6]) {
        const KEYS: [&CStr; 18] = [
            c"stiffness",
            c"exponent",
            c"smoothing_length",
            c"spacing",
            c"fiber_length",
            c"fiber_count",
            c"seed",
            c"law",
            c"estimator",
            c"pattern",
            c"weights",
            c"momentum_correction",
            c"self_contact",
            c"check_cells",
            c"threads",
            c"index_base",
            c" law ",
            c"no option",
        ];
        const VALUES: [&CStr; 8] = [c"1", c"0", c"2.5d6", c"exact", c"fibers", c"fiber", c"volume", c"consistent"];
        let end = value.iter().position(|b| *b == 0).unwrap_or(6);
        let own = CString::new(&value[..end]).expect("no zero within");
        let value = if value[0] < 64 { VALUES[value[0] as usize % 8] } else { &own };
        let mut options = self.options;
        // SAFETY: a struct of the header's size, and texts that end in zero.
        let status =
            checked(unsafe { fmc_options_set(&raw mut options, KEYS[key as usize % 18].as_ptr(), value.as_ptr()) });
        // Fine lines and many threads are a matter of time, not of soundness.
        if status == OK && (1..=2).contains(&options.threads) && options.fiber_count <= 1_000 {
            let is_fine = options.spacing > 0.0 && (options.spacing < 0.2 || !self.mesh.is_ordinary());
            let is_automatic = options.spacing == 0.0 && options.fiber_count == 0;
            if !is_fine && !is_automatic {
                self.set_options(&options);
            }
        }
    }
}
