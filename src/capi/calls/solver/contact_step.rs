//! Equilibrium of the contact with condensed bodies.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::given_struct::check_struct;
use crate::capi::boundary::pointer::{Output, check, copy_list, optional, reference, slice};
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::{
    FMC_ERROR_BAD_VALUE, FMC_ERROR_DOF_OUT_OF_RANGE, FMC_ERROR_NOT_POSITIVE,
};
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, write};
use crate::capi::structs::placement::{Placement, fmc_place};
use crate::capi::structs::view::fmc_coords;
use crate::contact::{CondensedBodies, ContactStepOptions, ContactStepState};
use std::ffi::c_void;

/// When a step of `fmc_context_contact_step` ends. Initialise it with `fmc_contact_step_options_init`.
///
/// New fields take the place of reserved ones; the size of the struct does not change.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_contact_step_options {
    /// Set by `fmc_contact_step_options_init`, so that the library recognises an uninitialised struct.
    pub struct_size: usize,
    /// Relative residual at which a step has converged. The reference is the norm of the given residual or of the contact
    /// forces on the list, whichever is larger. Default 1e-10.
    pub tolerance: f64,
    /// Norm of the residual, a force, at which it has converged too; 0, the default: none. For nonlinear bodies a part of
    /// their linearisation error suffices.
    pub absolute_tolerance: f64,
    /// Relative residual below which the full tangent is taken, above it the semidefinite one. Default 0.1.
    pub full_below: f64,
    /// Iterations, at most, at least 1. Default 80.
    pub max_iterations: i32,
    /// Trials along a direction, at most, at least 1. Default 12.
    pub max_trials: i32,
    /// 1: softer contacts come first if the first full step of Newton's method would not lower the energy (without an energy, the
    /// residual) or would invert a cell. The first contact is no stiffer than the bodies at any degree of freedom of the list, the
    /// next one is ten times as stiff, and so on. Each may take `max_iterations`. Results refer to the true contact. 0, the default:
    /// off.
    pub soft_start: i32,
    /// Zero. Room for switches of later versions.
    pub reserved_flags: i32,
    /// Zero. Room for options of later versions.
    pub reserved: [u64; 7],
}

impl Default for fmc_contact_step_options {
    fn default() -> Self {
        let defaults = ContactStepOptions::default();
        Self {
            struct_size: size_of::<Self>(),
            tolerance: defaults.tolerance,
            absolute_tolerance: defaults.absolute_tolerance,
            full_below: defaults.full_below,
            max_iterations: defaults.max_iterations as i32,
            max_trials: defaults.max_trials as i32,
            soft_start: defaults.soft_start.into(),
            reserved_flags: 0,
            reserved: [0; 7],
        }
    }
}

impl fmc_contact_step_options {
    fn to_options(self) -> Result<ContactStepOptions, Failure> {
        check_struct::<Self>(
            "fmc_contact_step_options",
            self.struct_size,
            self.reserved.into_iter().chain([self.reserved_flags as u64]),
        )?;
        let count = |name, value: i32| {
            let text = || format!("'{name}' is {value}, which is not allowed");
            usize::try_from(value).map_err(|_| Failure::new(FMC_ERROR_NOT_POSITIVE, text()))
        };
        Ok(ContactStepOptions {
            tolerance: self.tolerance,
            absolute_tolerance: self.absolute_tolerance,
            full_below: self.full_below,
            max_iterations: count("max_iterations", self.max_iterations)?,
            max_trials: count("max_trials", self.max_trials)?,
            soft_start: match self.soft_start {
                0 => false,
                1 => true,
                other => {
                    let text = format!("'soft_start' is {other}, not 0 or 1");
                    return Err(Failure::new(FMC_ERROR_BAD_VALUE, text));
                }
            },
        })
    }
}

/// How a step of `fmc_context_contact_step` ended.
#[repr(C)]
pub enum fmc_contact_step_state {
    /// In equilibrium.
    FMC_STEP_CONVERGED = 0,
    /// Contact acts on degrees of freedom that are neither on the list nor fixed, and a longer list is needed. The
    /// displacement is the last one.
    FMC_STEP_OUTSIDE = 1,
    /// The iterations have run out, or the residual could not be lowered further; the displacement is the last one.
    FMC_STEP_NOT_CONVERGED = 2,
}

/// Results of a step.
///
/// New fields take the place of reserved ones; the size of the struct does not change.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_contact_step_result {
    /// Size of this struct, as the library wrote it.
    pub struct_size: usize,
    /// A value of `fmc_contact_step_state`.
    pub state: i32,
    /// Linear systems solved.
    pub iterations: i32,
    /// Evaluations of the contact forces alone, without evaluations of the tangent.
    pub evaluation_count: usize,
    /// Degrees of freedom outside the list on which contact acts.
    pub outside_count: usize,
    /// Norm of the residual at the start.
    pub residual_at_start: f64,
    /// Norm of the residual at the end.
    pub residual: f64,
    /// Reference of the residual: the norm of the given residual or of the contact forces on the list, whichever is
    /// larger.
    pub scale: f64,
    /// Zero.
    pub reserved: [u64; 8],
}

/// Sets all options of a contact step to their defaults.
///
/// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_contact_step_options_init(options: *mut fmc_contact_step_options) -> fmc_status {
    entry(|| {
        let output = Output::required("options", options)?;
        // SAFETY: the host passes a struct of the header's size, which may be written.
        unsafe { output.write(fmc_contact_step_options::default()) };
        Ok(())
    })
}

/// Finds the displacement d of some degrees of freedom for which `S d + r - f(x + d) = 0`: contact forces f are in equilibrium with
/// bodies. The host has condensed their stiffness S and residual r, both without contact, on these degrees of freedom. The host
/// factorises its bodies once, and iterates the contact, which opens and closes, on a small dense system.
///
/// It uses Newton's method with a line search on the energy `r.d + d.S d / 2 + w(x + d)`. Frozen friction has an energy, too
/// (`fmc_context_freeze_friction`). Friction with the current pressure has none: the matrix is then unsymmetric, and the line
/// search lowers the residual. With the law "fiber" call `fmc_context_keep_patches` before, for one energy.
///
/// `dofs`, the list: `dof_count` degrees of freedom, counted as in `fmc_context_tangent`, ascending; take the movable ones of the tangent's
/// pattern. `fixed_dofs`: `fixed_count` others that do not move and on which contact may act, ascending. `stiffness`: S,
/// `dof_count * dof_count` numbers, row by row, symmetric; `residual`: r, internal minus external forces at `coords`. `options` may be
/// NULL: the defaults. `place`, which may be NULL, moves the nodes that follow the nodes on the list. Bodies that move by more than a part
/// of a cell need it, since cells whose other nodes stay would be inverted. `displacement` has room for `dof_count` numbers. It and
/// `result` are written on success, which is any state of `fmc_contact_step_state`: look at it.
///
/// For a smaller penetration call `fmc_context_augment` at the end of the step, and repeat the step.
///
/// Results and tangent in the context remain those from earlier calls. Dense factors of `dof_count` equations are made in every
/// iteration: some 500 take tenths of a second.
///
/// Errors: as `fmc_context_tangent` at `coords`; `FMC_ERROR_DOF_OUT_OF_RANGE`, `FMC_ERROR_REPEATED_DOF`, `FMC_ERROR_NON_FINITE_STIFFNESS`,
/// `FMC_ERROR_NOT_POSITIVE`, `FMC_ERROR_BAD_VALUE`, `FMC_ERROR_STRUCT_SIZE` and `FMC_ERROR_RESERVED_FIELD` for the options,
/// `FMC_ERROR_SINGULAR_STIFFNESS` and `FMC_ERROR_INDEFINITE_STIFFNESS` for bodies and contact together, `FMC_ERROR_PLACE`. Threads: one
/// call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_contact_step(
    context: *mut fmc_context,
    coords: *const fmc_coords,
    options: *const fmc_contact_step_options,
    dofs: *const c_void,
    dof_count: usize,
    fixed_dofs: *const c_void,
    fixed_count: usize,
    stiffness: *const f64,
    residual: *const f64,
    place: fmc_place,
    user: *mut c_void,
    displacement: *mut f64,
    result: *mut fmc_contact_step_result,
) -> fmc_status {
    entry(|| {
        let output = Output::optional("result", result)?;
        // SAFETY: the host passes a context, a view, options or NULL, arrays of the lengths given, and a function that
        // keeps to its contract.
        let step = unsafe {
            write(context, |state| {
                let coords = reference("coords", coords)?;
                let options = optional("options", options)?.copied().unwrap_or_default().to_options()?;
                let (size, base) = (state.index_size, state.index_base);
                let dofs = numbers(&size.list("dofs", dofs, dof_count, 1)?, base)?;
                let held = numbers(&size.list("fixed_dofs", fixed_dofs, fixed_count, 1)?, base)?;
                let stiffness = slice("stiffness", stiffness, dof_count, dof_count)?;
                let residual = slice("residual", residual, dof_count, 1)?;
                if dof_count > 0 {
                    check("displacement", displacement.cast_const())?;
                }
                let bodies = CondensedBodies { dofs: &dofs, held: &held, stiffness, residual };
                let placement = place.map(|function| Placement { function, user });
                in_either!(&mut state.session, one => one.contact_step(coords, &bodies, &options, placement, base))
            })
        }?;
        let state = match step.state {
            ContactStepState::Converged => fmc_contact_step_state::FMC_STEP_CONVERGED,
            ContactStepState::Outside => fmc_contact_step_state::FMC_STEP_OUTSIDE,
            ContactStepState::NotConverged => fmc_contact_step_state::FMC_STEP_NOT_CONVERGED,
        };
        // SAFETY: the host guarantees room for `dof_count` numbers, and that the result, where given, may be written.
        unsafe {
            copy_list("displacement", &step.displacement, displacement)?;
            output.write(fmc_contact_step_result {
                struct_size: size_of::<fmc_contact_step_result>(),
                state: state as i32,
                iterations: step.iterations as i32,
                evaluation_count: step.evaluations,
                outside_count: step.outside,
                residual_at_start: step.residual_at_start,
                residual: step.residual,
                scale: step.scale,
                reserved: [0; 8],
            });
        }
        Ok(())
    })
}

/// Degrees of freedom as the core counts them; that they are too large it finds itself.
fn numbers(given: &[i64], base: i32) -> Result<Vec<usize>, Failure> {
    let number = |&dof: &i64| {
        let text = || format!("a list names degree of freedom {dof}");
        let zero_based = dof.checked_sub(base.into()).and_then(|dof| usize::try_from(dof).ok());
        zero_based.ok_or_else(|| Failure::new(FMC_ERROR_DOF_OUT_OF_RANGE, text()))
    };
    given.iter().map(number).collect()
}
