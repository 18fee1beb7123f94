//! Options of single pairs.

use super::Host;
use super::array::{checked, unless};
use crate::interface::*;
use crate::program::{Hole, PairOptions};
use std::ffi::c_void;

impl Host {
    pub(super) fn set_pair(&mut self, from: &PairOptions, hole: Hole) {
        let [(a_kind, a), (b_kind, b)] = from.sides.map(|side| (i32::from(side % 5 / 2), usize::from(side / 5 % 4)));
        let context = self.context;
        let none = fmc_pair_options {
            struct_size: 77,
            stiffness: 0.0,
            exponent: 0.0,
            smoothing_length: 0.0,
            gap_offset: 0.0,
            friction_coefficient: 0.0,
            law: 77,
            excluded: 77,
            static_coefficient: 0.0,
            weakening_slip: 0.0,
            interface_kind: 77,
            softening: 77,
            reach: 0.0,
            normal_strength: 0.0,
            shear_strength: 0.0,
            normal_energy: 0.0,
            shear_energy: 0.0,
            mixed_mode_exponent: 0.0,
            viscosity: 0.0,
            surface_a: 77,
            surface_b: 77,
            reserved: [77; 3],
        };
        // SAFETY: the host's own context, and structs of the header's size.
        unsafe {
            let found = || {
                let mut found = none;
                let status = checked(fmc_context_pair_options(context, a_kind, a, b_kind, b, &raw mut found));
                assert!(status == OK || found == none, "an error writes outputs");
                (status, found)
            };
            let before = found();
            let mut options = none;
            assert_eq!(fmc_pair_options_init(&raw mut options), OK);
            options.law = i32::from(from.law % 6) - 1;
            // What belongs to a law is refused without one; often enough it is left out.
            if options.law >= 0 || from.law >= 250 {
                options.stiffness = from.stiffness.0;
                options.exponent = from.exponent.map_or(1.0, |x| x.0);
                options.smoothing_length = from.smoothing_length.map_or(0.0, |x| x.0);
            }
            options.excluded = i32::from(from.excluded % 3);
            // All kinds, and one that is none.
            options.interface_kind = i32::from(from.excluded / 37);
            let has_reach = (1..4).contains(&options.interface_kind) || options.interface_kind == FMC_INTERFACE_LAW;
            options.reach = if has_reach { from.stiffness.0 } else { 0.0 };
            if options.interface_kind == FMC_INTERFACE_COHESIVE {
                // All are said, so that all come back.
                (options.normal_strength, options.shear_strength) = (1.0, from.stiffness.0);
                (options.normal_energy, options.shear_energy) = (0.1, 0.2);
                options.viscosity = f64::from(from.excluded % 2);
                options.mixed_mode_exponent = from.exponent.map_or(2.0, |x| x.0);
                (options.reach, options.softening) = (0.5, i32::from(from.law % 4));
            }
            if from.excluded % 5 == 4 {
                // Parts that are there if some were named, one alone, and one that is none.
                (options.surface_a, options.surface_b) = (1, i32::from(from.law % 3));
            }
            options.gap_offset = from.gap_offset.map_or(0.0, |x| x.0);
            if from.law % 7 == 6 {
                checked(fmc_context_set_pair_wear(context, a_kind, a, b_kind, b, from.stiffness.0, 0.0));
                let (mut of_a, mut of_b) = (77.0, 77.0);
                checked(fmc_context_pair_wear(context, a_kind, a, b_kind, b, &raw mut of_a, &raw mut of_b));
            }
            let given = unless(hole, 0, &raw mut options).cast_const();
            let status = checked(fmc_context_set_pair_options(context, a_kind, a, b_kind, b, given));
            let after = found();
            if status == OK {
                assert!(after.0 == OK && (given.is_null() || after.1 == options), "{after:?}");
            } else {
                assert_eq!(before, after);
            }
            if from.law % 4 == 3 {
                set_orthotropic_pair(context, from, [(a_kind, a), (b_kind, b)], &raw const options);
            }
            if from.law % 4 == 2 {
                set_ppr_pair(context, from, [(a_kind, a), (b_kind, b)], &raw const options);
            }
            if from.law % 4 == 1 {
                let kind = if from.excluded % 4 == 3 { options.interface_kind } else { FMC_INTERFACE_LAW };
                let options = fmc_pair_options { interface_kind: kind, ..options };
                let mut law = std::mem::MaybeUninit::<fmc_own_law>::zeroed().assume_init();
                assert_eq!(fmc_own_law_init(&raw mut law), OK);
                law.history_count = 1;
                law.respond = Some(spring);
                let before = found();
                let given = unless(hole, 1, &raw mut law).cast_const();
                let (dim, scale) = (usize::from(from.excluded % 5), from.stiffness.0);
                checked(fmc_own_law_check(given, dim, scale, std::ptr::null(), 0, 0.0, None, std::ptr::null_mut()));
                let status =
                    checked(fmc_context_set_law_pair(context, a_kind, a, b_kind, b, &raw const options, given));
                assert!(if status == OK { found() == (OK, options) } else { found() == before });
            }
            if from.law % 8 == 7 {
                set_friction_law_pair(context, from, [(a_kind, a), (b_kind, b)], (&options, hole));
            }
        }
    }
}

/// The same options with a law of friction: refused, all is as it was.
///
/// # Safety
/// `context` is the host's own, or NULL.
unsafe fn set_friction_law_pair(
    context: *mut fmc_context,
    from: &PairOptions,
    [(a_kind, a), (b_kind, b)]: [(i32, usize); 2],
    (options, hole): (&fmc_pair_options, Hole),
) {
    // SAFETY: structs of the header's size.
    unsafe {
        let mut law = std::mem::MaybeUninit::<fmc_friction_law>::zeroed().assume_init();
        assert_eq!(fmc_friction_law_init(&raw mut law), OK);
        law.history_count = usize::from(from.excluded % 3);
        law.limit = Some(rub);
        let given = unless(hole, 1, &raw mut law).cast_const();
        let (dim, scale) = (usize::from(from.excluded % 5), from.stiffness.0);
        checked(fmc_friction_law_check(given, dim, scale, scale, 0.1, None, std::ptr::null_mut()));
        checked(fmc_context_set_friction_law_pair(context, a_kind, a, b_kind, b, std::ptr::from_ref(options), given));
    }
}

/// A law of friction of the host: a coefficient that falls with the slip, or what is no number under large pressures.
///
/// # Safety
/// The library passes arrays as long as it says.
unsafe extern "C" fn rub(
    _: *mut c_void,
    facets: *const fmc_friction_facets,
    response: *const fmc_friction_response,
) -> i32 {
    // SAFETY: as above.
    unsafe {
        let (of, to) = (&*facets, &*response);
        for facet in 0..of.count {
            let pressure = *of.pressure.add(facet);
            to.limit.add(facet).write(if pressure > 1e9 { f64::NAN } else { 0.3 * pressure });
            to.by_pressure.add(facet).write(0.3);
            for place in facet * of.history_count..(facet + 1) * of.history_count {
                to.history.add(place).write(*of.history.add(place) + 1.0);
            }
        }
    }
    0
}

/// A law of the host: springs, with the largest opening, or what is no number where they are pulled far apart.
///
/// # Safety
/// The library passes arrays as long as it says.
unsafe extern "C" fn spring(_: *mut c_void, points: *const fmc_law_points, response: *const fmc_law_response) -> i32 {
    // SAFETY: as above.
    unsafe {
        let (of, to) = (&*points, &*response);
        for place in 0..of.count * of.dim {
            let jump = *of.jump.add(place);
            to.traction.add(place).write(if jump > 1e3 { f64::NAN } else { 3.0 * jump });
            for column in 0..of.dim {
                let is_own = place % of.dim == column;
                to.tangent.add(place * of.dim + column).write(if is_own { 3.0 } else { 0.0 });
            }
        }
        for point in 0..of.count {
            let (before, now) = (*of.history.add(point), *of.jump.add(point * of.dim));
            to.history.add(point).write(before.max(now));
        }
    }
    0
}

/// The same options with a direction, which come back or leave what was there.
///
/// # Safety
/// The context and the options are the host's own.
unsafe fn set_orthotropic_pair(
    context: *mut fmc_context,
    from: &PairOptions,
    [(a_kind, a), (b_kind, b)]: [(i32, usize); 2],
    options: *const fmc_pair_options,
) {
    let none = fmc_orthotropic_friction {
        struct_size: 77,
        transverse_coefficient: 0.0,
        direction: [0.0; 3],
        direction_of: 77,
        unused: 77,
        reserved: [77; 4],
    };
    // SAFETY: structs of the header's size; all else the caller vouches for.
    unsafe {
        let found = || {
            let mut found = none;
            let status = checked(fmc_context_orthotropic_pair(context, a_kind, a, b_kind, b, &raw mut found));
            assert!(status == OK || found == none, "an error writes outputs");
            (status, found)
        };
        let before = found();
        let mut friction = none;
        assert_eq!(fmc_orthotropic_friction_init(&raw mut friction), OK);
        friction.transverse_coefficient = from.stiffness.0;
        friction.direction = [1.0, from.exponent.map_or(0.0, |x| x.0), from.gap_offset.map_or(0.0, |x| x.0)];
        // Both sides, and one that is none.
        friction.direction_of = i32::from(from.excluded % 3);
        let given = &raw const friction;
        let status = checked(fmc_context_set_orthotropic_pair(context, a_kind, a, b_kind, b, options, given));
        let after = found();
        let is_kept = if status == OK { after == (OK, friction) } else { after == before };
        assert!(is_kept, "{status:?}: {before:?} {after:?}");
    }
}

/// The same options with shapes of a cohesive law, which come back or leave what was there.
///
/// # Safety
/// The context and the options are the host's own.
unsafe fn set_ppr_pair(
    context: *mut fmc_context,
    from: &PairOptions,
    [(a_kind, a), (b_kind, b)]: [(i32, usize); 2],
    options: *const fmc_pair_options,
) {
    // SAFETY: structs of the header's size; all else the caller vouches for.
    unsafe {
        let found = || {
            let mut found = fmc_ppr::default();
            let status = checked(fmc_context_ppr_pair(context, a_kind, a, b_kind, b, &raw mut found));
            assert!(status == OK || found == fmc_ppr::default(), "an error writes outputs");
            (status, found)
        };
        let before = found();
        let mut ppr = fmc_ppr::default();
        assert_eq!(fmc_ppr_init(&raw mut ppr), OK);
        ppr.normal_shape = from.exponent.map_or(2.0, |x| x.0);
        ppr.shear_slope = from.stiffness.0;
        let status = checked(fmc_context_set_ppr_pair(context, a_kind, a, b_kind, b, options, &raw const ppr));
        let after = found();
        let is_kept = if status == OK { after == (OK, ppr) } else { after == before };
        assert!(is_kept, "{status:?}: {before:?} {after:?}");
    }
}
