//! Options of single pairs.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::pointer::{Output, optional};
use crate::capi::boundary::status::fmc_status;
use crate::capi::calls::options::pair_interface::{fmc_interface, fmc_softening};
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, read, write};
use crate::capi::structs::partner::partner;
use crate::contact::PairOptions;
use crate::overlap::Partner;

/// Value of `law` in `fmc_pair_options`: the pair follows the law of the context's options, with its stiffness, also
/// after they change.
pub const FMC_PAIR_LAW_OF_CONTEXT: i32 = -1;

/// Value of `friction_coefficient` in `fmc_pair_options`: the pair takes the coefficient of the context's options, also
/// after it changes.
pub const FMC_PAIR_FRICTION_OF_CONTEXT: i32 = -1;

/// Options of one pair of partners, in place of the context's. `fmc_pair_options_init` sets all of them to their
/// defaults.
///
/// New options take the place of reserved fields; the size of the struct does not change.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_pair_options {
    /// Set by `fmc_pair_options_init`, so that the library recognises an uninitialised struct.
    pub struct_size: usize,
    /// k > 0 of the law of this pair, in the units of `stiffness` in `fmc_options`; only with `law`, and then without a default. With
    /// `FMC_INTERFACE_COHESIVE`, and without `law`: traction / opening without damage, and in compression. 0: damage begins at a hundredth
    /// of the opening at which a linear softening ends.
    pub stiffness: f64,
    /// m >= 1, for the law "volume" only. Default 1.
    pub exponent: f64,
    /// Smoothing length of the law "fiber"; 0, the default: the quadratic law.
    pub smoothing_length: f64,
    /// Distance at which contact begins, in length; 0, the default: at the surfaces. Penetration, gap and pressure are
    /// counted from there, also in weighted gaps. With an obstacle: its surface lies so much further out (a shell's
    /// thickness, a coating), or, if negative, further in (a clearance). Half-spaces, balls and capsules keep their kind,
    /// and so do cylinders with a negative offset. Any other shape becomes its signed distance minus the offset, with its
    /// outward edges rounded, and is treated as `FMC_SHAPE_SIGNED_DISTANCE`. Between bodies, and of one with itself, only
    /// with the law "depth" and not positive: -c allows either body to penetrate by c before it presses.
    pub gap_offset: f64,
    /// Coefficient of friction, at least 0 or infinite, or `FMC_PAIR_FRICTION_OF_CONTEXT`, the default; with
    /// `FMC_INTERFACE_COHESIVE` the coefficient of the broken part. All other options of friction are taken from the
    /// context.
    pub friction_coefficient: f64,
    /// A value of `fmc_law`, or `FMC_PAIR_LAW_OF_CONTEXT`, the default.
    pub law: i32,
    /// 1: the pair is excluded; it is not measured, and adds nothing to any result. With `surface_a` and `surface_b` these parts are held,
    /// and no other face of the pair is in contact. Default 0.
    pub excluded: i32,
    /// Static coefficient of friction, at least the kinetic one; 0, the default: as in the context's options, or none where
    /// `friction_coefficient` is set.
    pub static_coefficient: f64,
    /// Slip over which it falls to the kinetic coefficient, a length; positive with `static_coefficient`, else 0, the
    /// default.
    pub weakening_slip: f64,
    /// Interface between two bodies, a value of `fmc_interface`. Default `FMC_INTERFACE_CONTACT`.
    pub interface_kind: i32,
    /// A value of `fmc_softening`, with `FMC_INTERFACE_COHESIVE`. Default `FMC_SOFTENING_LINEAR`.
    pub softening: i32,
    /// Largest distance or overlap of faces that are held together, a length, with `FMC_INTERFACE_TIED`,
    /// `FMC_INTERFACE_COHESIVE` and `FMC_INTERFACE_NO_SEPARATION`. 0, the default: a tenth of the mean facet of the body with
    /// the larger facets, including all its faces.
    pub reach: f64,
    /// With `FMC_INTERFACE_COHESIVE`: traction at which damage begins in pure opening, positive.
    pub normal_strength: f64,
    /// The same in pure sliding; 0, the default: as in opening.
    pub shear_strength: f64,
    /// Energy per area that pure opening takes until the interface is broken, positive.
    pub normal_energy: f64,
    /// The same in pure sliding; 0, the default: as in opening.
    pub shear_energy: f64,
    /// Exponent, at least 1, by which the two are mixed (Benzeggagh and Kenane); 0, the default: 2.
    pub mixed_mode_exponent: f64,
    /// With `FMC_INTERFACE_TIED`, `FMC_INTERFACE_COHESIVE` and `FMC_INTERFACE_NO_SEPARATION`: the part of the surface of `a`, a number of
    /// `fmc_context_add_surface`, whose faces may be held; 0, the default: all of it. Held facets of both parts are in no contact; all
    /// other facets of the pair press and rub, by the law "depth". Without parts no other facet of the pair is in contact.
    pub surface_a: i32,
    /// The same of `b`. Both are 0, or neither.
    pub surface_b: i32,
    /// With `FMC_INTERFACE_COHESIVE`: a time by which damage lags behind the law, so that searches pass where a structure snaps; 0, the
    /// default: none. `fmc_context_set_time_step` sets the duration of a step.
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

/// Sets the options of a pair to their defaults: the law of the context, not excluded.
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

/// Sets the options of a pair: a body with another, with itself, or with an obstacle, in either order. They apply from the next evaluation
/// on; `options` NULL: the pair follows the options of the context again, as every pair does at first. Friction of the pair is then the
/// same in all directions; for another, call `fmc_context_set_orthotropic_pair` instead. The wear coefficients of the pair are kept; with
/// NULL they are removed.
///
/// `a_kind` and `b_kind` are values of `fmc_partner`; `a` and `b` count bodies as `fmc_context_body_resultant` and obstacles as
/// `fmc_context_obstacle_resultant`. For a body with itself these options override the context's `self_contact`: `excluded`
/// switches self-contact of this body off, and any other options switch it on.
///
/// Errors: `FMC_ERROR_NULL_POINTER`; `FMC_ERROR_BODY_OUT_OF_RANGE`, `FMC_ERROR_OBSTACLE_OUT_OF_RANGE` and
/// `FMC_ERROR_OBSTACLE_REMOVED`, naming the index; `FMC_ERROR_BAD_VALUE` for an unknown kind or value, `FMC_ERROR_OPTIONS_CONFLICT` for an
/// option that would have no effect; `FMC_ERROR_RESERVED_FIELD`; `FMC_ERROR_STRUCT_SIZE`; `FMC_ERROR_NOT_POSITIVE`. `FMC_ERROR_UNSUPPORTED`
/// for two obstacles, for a law that the estimator of the context does not support, and for a gap offset between bodies that is positive or
/// has another law than "depth". The same for a pair with wear coefficients (`fmc_context_set_pair_wear`) that cannot wear with these
/// options. `FMC_ERROR_UNTIED` for tied bodies that face one another nowhere within reach, `FMC_ERROR_BUSY`. The earlier options are then
/// kept. `fmc_context_set_options` refuses an estimator that does not support the law of a pair. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_pair_options(
    context: *mut fmc_context,
    a_kind: i32,
    a: usize,
    b_kind: i32,
    b: usize,
    options: *const fmc_pair_options,
) -> fmc_status {
    let pair = [(a_kind, a), (b_kind, b)];
    // SAFETY: the host passes a context, and options or NULL.
    unsafe {
        set_options(context, pair, || {
            optional("options", options)?.map(|options| options.to_pair_options()).transpose()
        })
    }
}

/// The options of a pair, named as in `fmc_context_set_pair_options`. For a pair without separate options, these are the options in force:
/// for a body with itself `excluded` is 1 unless the context's `self_contact` is on. `fmc_context_orthotropic_pair` returns another
/// coefficient of friction across a direction.
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
    // SAFETY: the host passes a context, and an output that may be written.
    unsafe { tell_options(context, [(a_kind, a), (b_kind, b)], ("options", options), |found| found.into()) }
}

/// Sets the options of a pair, each partner by kind and number.
///
/// # Safety
/// As for every call: a context of this library, or NULL.
pub(super) unsafe fn set_options(
    context: *mut fmc_context,
    pair: [(i32, usize); 2],
    options: impl FnOnce() -> Result<Option<PairOptions>, Failure>,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context.
        unsafe {
            write(context, |state| {
                let (partners, options) = (named(pair)?, options()?);
                in_either!(&mut state.session, one => one.set_pair_options(partners, options))
            })
        }
    })
}

/// Writes what is `told` of the options of a pair into an output of this name.
///
/// # Safety
/// As for [`set_options`]; the output may be written, or is NULL.
pub(super) unsafe fn tell_options<T>(
    context: *const fmc_context,
    pair: [(i32, usize); 2],
    (name, output): (&'static str, *mut T),
    told: impl FnOnce(PairOptions) -> T,
) -> fmc_status {
    entry(|| {
        let (output, partners) = (Output::required(name, output)?, named(pair)?);
        // SAFETY: the host passes a context.
        let found = in_either!(&unsafe { read(context) }?.session, one => one.pair_options(partners))?;
        // SAFETY: the host passes an output that may be written.
        unsafe { output.write(told(found)) };
        Ok(())
    })
}

pub(super) fn named([a, b]: [(i32, usize); 2]) -> Result<[Partner; 2], Failure> {
    Ok([partner(a.0, a.1)?, partner(b.0, b.1)?])
}
