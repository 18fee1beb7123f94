//! Options of a pair whose cohesive interface follows the law of Park, Paulino and Roesler.

use super::pair_options::{fmc_pair_options, set_options, tell_options};
use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::given_struct::check_struct;
use crate::capi::boundary::pointer::{Output, reference};
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::FMC_ERROR_OPTIONS_CONFLICT;
use crate::capi::context::state::fmc_context;
use crate::contact::{Cohesive, Interface, PairOptions, Ppr, Softening};

/// Shapes and initial slopes of the law of Park, Paulino and Roesler (J. Mech. Phys. Solids 57, 2009), of a cohesive interface with
/// `FMC_SOFTENING_PPR`. `fmc_ppr_init` sets all of it.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_ppr {
    /// Set by `fmc_ppr_init`, so that the library recognises an uninitialised struct.
    pub struct_size: usize,
    /// Shape alpha of softening in opening, above 1: below 2 the traction falls late, about 2 along a line, above it early with a long
    /// tail. Default 2.
    pub normal_shape: f64,
    /// Shape beta of sliding. Default 2.
    pub shear_shape: f64,
    /// Opening at the strength / opening at which the traction ends, above 0 and at most 1/sqrt(2 alpha - 1). Default 0.05.
    pub normal_slope: f64,
    /// The same in sliding, with beta. Default 0.05.
    pub shear_slope: f64,
    /// Zero. Room for options of later versions.
    pub reserved: [u64; 4],
}

impl Default for fmc_ppr {
    fn default() -> Self {
        Ppr::default().into()
    }
}

impl From<Ppr> for fmc_ppr {
    fn from(Ppr { normal_shape, shear_shape, normal_slope, shear_slope }: Ppr) -> Self {
        Self { struct_size: size_of::<Self>(), normal_shape, shear_shape, normal_slope, shear_slope, reserved: [0; 4] }
    }
}

impl fmc_ppr {
    /// That of the crate, which checks the numbers.
    fn to_ppr(self) -> Result<Ppr, Failure> {
        let Self { struct_size, normal_shape, shear_shape, normal_slope, shear_slope, reserved } = self;
        check_struct::<Self>("fmc_ppr", struct_size, reserved)?;
        Ok(Ppr { normal_shape, shear_shape, normal_slope, shear_slope })
    }
}

/// The options of a pair with these shapes.
fn shaped(options: PairOptions, ppr: Ppr) -> Result<PairOptions, Failure> {
    match options.interface {
        Interface::Cohesive(own @ Cohesive { softening: Softening::Ppr(_), .. }) => {
            let interface = Interface::Cohesive(Cohesive { softening: Softening::Ppr(ppr), ..own });
            Ok(PairOptions { interface, ..options })
        }
        _ => {
            let text = "shapes of the law 'ppr' belong to the softening 'ppr' of the interface 'cohesive'";
            Err(Failure::new(FMC_ERROR_OPTIONS_CONFLICT, text))
        }
    }
}

/// Sets shapes and slopes to the defaults.
///
/// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_ppr_init(ppr: *mut fmc_ppr) -> fmc_status {
    entry(|| {
        let output = Output::required("ppr", ppr)?;
        // SAFETY: the host passes a struct of the header's size, which may be written.
        unsafe { output.write(fmc_ppr::default()) };
        Ok(())
    })
}

/// Sets the options of a pair as `fmc_context_set_pair_options` does, whose interface is `FMC_INTERFACE_COHESIVE` and whose softening is
/// `FMC_SOFTENING_PPR`, with other shapes and initial slopes than the default ones.
///
/// Errors: as `fmc_context_set_pair_options`; `FMC_ERROR_NOT_POSITIVE` and `FMC_ERROR_UNSUPPORTED` for impossible shapes and slopes, which
/// the text names; `FMC_ERROR_OPTIONS_CONFLICT` for another interface or softening. The earlier options are then kept. Threads: one call at
/// a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_ppr_pair(
    context: *mut fmc_context,
    a_kind: i32,
    a: usize,
    b_kind: i32,
    b: usize,
    options: *const fmc_pair_options,
    ppr: *const fmc_ppr,
) -> fmc_status {
    // SAFETY: the host passes a context, options, and shapes.
    unsafe {
        set_options(context, [(a_kind, a), (b_kind, b)], || {
            let options = reference("options", options)?.to_pair_options()?;
            shaped(options, reference("ppr", ppr)?.to_ppr()?).map(Some)
        })
    }
}

/// Shapes and slopes of a pair with `FMC_SOFTENING_PPR`; of any other pair the default ones.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BODY_OUT_OF_RANGE`, `FMC_ERROR_OBSTACLE_OUT_OF_RANGE`,
/// `FMC_ERROR_OBSTACLE_REMOVED`, `FMC_ERROR_BAD_VALUE` for an unknown kind, `FMC_ERROR_UNSUPPORTED` for two
/// obstacles, `FMC_ERROR_BUSY`. Threads: several at once on one context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_ppr_pair(
    context: *const fmc_context,
    a_kind: i32,
    a: usize,
    b_kind: i32,
    b: usize,
    ppr: *mut fmc_ppr,
) -> fmc_status {
    let told = |found: PairOptions| match found.interface {
        Interface::Cohesive(Cohesive { softening: Softening::Ppr(ppr), .. }) => ppr.into(),
        _ => fmc_ppr::default(),
    };
    // SAFETY: the host passes a context, and an output that may be written.
    unsafe { tell_options(context, [(a_kind, a), (b_kind, b)], ("ppr", ppr), told) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::capi::boundary::status::fmc_status::{FMC_ERROR_RESERVED_FIELD, FMC_ERROR_STRUCT_SIZE};

    #[test]
    fn shapes_come_back_as_they_were_set() {
        let ppr = Ppr { normal_shape: 5.0, shear_shape: 1.6, normal_slope: 0.1, shear_slope: 0.2 };
        assert_eq!(fmc_ppr::from(ppr).to_ppr().unwrap(), ppr);
        let of = |softening| PairOptions::with_cohesive(Cohesive { softening, ..Cohesive::new(2.0, 0.1) });
        let found = shaped(of(Softening::Ppr(Ppr::default())), ppr).unwrap();
        assert_eq!(found, of(Softening::Ppr(ppr)));
        for other in [PairOptions::default(), of(Softening::Linear)] {
            assert_eq!(shaped(other, ppr).unwrap_err().status, FMC_ERROR_OPTIONS_CONFLICT);
        }
    }

    #[test]
    fn what_was_not_initialised_is_refused() {
        let of = |change: fn(&mut fmc_ppr)| {
            let mut ppr = fmc_ppr::default();
            change(&mut ppr);
            ppr.to_ppr().unwrap_err().status
        };
        assert_eq!(of(|ppr| ppr.struct_size = 0), FMC_ERROR_STRUCT_SIZE);
        assert_eq!(of(|ppr| ppr.reserved[3] = 1), FMC_ERROR_RESERVED_FIELD);
    }
}
