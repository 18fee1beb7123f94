//! Options of a pair whose friction is not the same in all directions.

use super::pair_options::{fmc_pair_options, set_options, tell_options};
use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::given_struct::check_struct;
use crate::capi::boundary::pointer::{Output, reference};
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::FMC_ERROR_BAD_VALUE;
use crate::capi::context::state::fmc_context;
use crate::contact::{OrthotropicFriction, PairOptions};

/// Friction of a pair that has its coefficient along a direction only, as a surface with machining marks, a grain or fibres.
/// `fmc_orthotropic_friction_init` sets all of it.
///
/// With the coefficient of friction m1 of the pair, tractions (t1, t2) along the direction and across it lie in the ellipse
/// sqrt((t1/m1)^2 + (t2/m2)^2) <= p. The slip maximises the dissipation: it is normal to the ellipse, mostly not along the traction.
/// With a `static_coefficient` both limits are larger by the same factor.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_orthotropic_friction {
    /// Set by `fmc_orthotropic_friction_init`, so that the library recognises an uninitialised struct.
    pub struct_size: usize,
    /// Coefficient m2 across the direction, at least 0 and finite. Default 0.
    pub transverse_coefficient: f64,
    /// The direction, of any length but 0 and of either sign: on a body without deformation, on an obstacle in its frame. It is projected
    /// into the plane of each facet there, and moves along as the facet deforms and turns. A facet to which it is perpendicular, up to 0.06
    /// degrees, has the transverse coefficient for all slip, and `FMC_WARNING_NO_FRICTION_DIRECTION` reports it. Default 0: none.
    pub direction: [f64; 3],
    /// The partner to which the direction belongs, in the order of the call: 0, the default, to `a`; 1 to `b`.
    pub direction_of: i32,
    /// Zero.
    pub unused: i32,
    /// Zero. Room for options of later versions.
    pub reserved: [u64; 4],
}

impl Default for fmc_orthotropic_friction {
    fn default() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            transverse_coefficient: 0.0,
            direction: [0.0; 3],
            direction_of: 0,
            unused: 0,
            reserved: [0; 4],
        }
    }
}

impl From<Option<OrthotropicFriction>> for fmc_orthotropic_friction {
    fn from(found: Option<OrthotropicFriction>) -> Self {
        let Some(OrthotropicFriction { transverse_coefficient, direction, of_second }) = found else {
            return Self::default();
        };
        Self { transverse_coefficient, direction, direction_of: of_second.into(), ..Self::default() }
    }
}

impl fmc_orthotropic_friction {
    /// That of the crate, which checks the numbers.
    fn to_orthotropic(self) -> Result<OrthotropicFriction, Failure> {
        let Self { struct_size, transverse_coefficient, direction, direction_of, unused, reserved } = self;
        let unused = u64::from(unused != 0);
        check_struct::<Self>("fmc_orthotropic_friction", struct_size, reserved.into_iter().chain([unused]))?;
        let of_second = match direction_of {
            0 => false,
            1 => true,
            other => {
                let text = format!("option 'direction_of' has no value {other}: expected 0 or 1");
                return Err(Failure::new(FMC_ERROR_BAD_VALUE, text));
            }
        };
        Ok(OrthotropicFriction { transverse_coefficient, direction, of_second })
    }
}

/// Sets isotropic friction, as `fmc_context_orthotropic_pair` returns it for a pair whose friction is the same in all
/// directions.
///
/// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_orthotropic_friction_init(friction: *mut fmc_orthotropic_friction) -> fmc_status {
    entry(|| {
        let output = Output::required("friction", friction)?;
        // SAFETY: the host passes a struct of the header's size, which may be written.
        unsafe { output.write(fmc_orthotropic_friction::default()) };
        Ok(())
    })
}

/// Sets the options of a pair as `fmc_context_set_pair_options` does, with another coefficient of friction across a direction. In 3D, of
/// two bodies or of a body and an obstacle. `fmc_context_set_pair_options` takes it back.
///
/// Errors: as `fmc_context_set_pair_options`; `FMC_ERROR_NOT_POSITIVE` for a coefficient that is negative or not finite, for an entry of
/// the direction that is not finite, which the text names, and for a direction of length 0. `FMC_ERROR_BAD_VALUE` for a `direction_of`
/// other than 0 and 1. `FMC_ERROR_UNSUPPORTED` in 2D, for a body with itself, for a direction of a body without cells, and in a mesh in
/// parts. The same with an infinite coefficient, a cohesion, a shear limit, or a `static_coefficient` without a `friction_coefficient`.
/// The earlier options are then kept. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_orthotropic_pair(
    context: *mut fmc_context,
    a_kind: i32,
    a: usize,
    b_kind: i32,
    b: usize,
    options: *const fmc_pair_options,
    friction: *const fmc_orthotropic_friction,
) -> fmc_status {
    // SAFETY: the host passes a context, options, and friction.
    unsafe {
        set_options(context, [(a_kind, a), (b_kind, b)], || {
            let options = reference("options", options)?.to_pair_options()?;
            let orthotropic = Some(reference("friction", friction)?.to_orthotropic()?);
            Ok(Some(PairOptions { orthotropic, ..options }))
        })
    }
}

/// The coefficient of friction of a pair across a direction, as `fmc_context_set_orthotropic_pair` has set it, with `direction_of` in the
/// order of this call. Of a pair whose friction is the same in all directions the direction is 0.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BODY_OUT_OF_RANGE`, `FMC_ERROR_OBSTACLE_OUT_OF_RANGE`,
/// `FMC_ERROR_OBSTACLE_REMOVED`, `FMC_ERROR_BAD_VALUE` for an unknown kind, `FMC_ERROR_UNSUPPORTED` for two
/// obstacles, `FMC_ERROR_BUSY`. Threads: several at once on one context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_orthotropic_pair(
    context: *const fmc_context,
    a_kind: i32,
    a: usize,
    b_kind: i32,
    b: usize,
    friction: *mut fmc_orthotropic_friction,
) -> fmc_status {
    // SAFETY: the host passes a context, and an output that may be written.
    unsafe {
        tell_options(context, [(a_kind, a), (b_kind, b)], ("friction", friction), |found| found.orthotropic.into())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::capi::boundary::status::fmc_status::{FMC_ERROR_RESERVED_FIELD, FMC_ERROR_STRUCT_SIZE};

    #[test]
    fn friction_comes_back_as_it_was_set() {
        for of_second in [false, true] {
            let friction = OrthotropicFriction { of_second, ..OrthotropicFriction::new(0.25, [1.0, -2.0, 0.5]) };
            assert_eq!(fmc_orthotropic_friction::from(Some(friction)).to_orthotropic().unwrap(), friction);
        }
        assert_eq!(fmc_orthotropic_friction::from(None), fmc_orthotropic_friction::default());
    }

    #[test]
    fn what_has_no_meaning_is_refused() {
        for (change, wanted) in [
            ((|f| f.struct_size = 0) as fn(&mut fmc_orthotropic_friction), FMC_ERROR_STRUCT_SIZE),
            (|f| f.unused = 1, FMC_ERROR_RESERVED_FIELD),
            (|f| f.reserved[3] = 1, FMC_ERROR_RESERVED_FIELD),
            (|f| f.direction_of = 2, FMC_ERROR_BAD_VALUE),
            (|f| f.direction_of = -1, FMC_ERROR_BAD_VALUE),
        ] {
            let mut friction = fmc_orthotropic_friction::default();
            change(&mut friction);
            assert_eq!(friction.to_orthotropic().unwrap_err().status, wanted);
        }
    }
}
