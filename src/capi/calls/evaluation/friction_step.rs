//! A step with friction of the call without a context.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::given_struct::check_struct;
use crate::capi::boundary::list::Room;
use crate::capi::boundary::pointer::{Output, check, slice};
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::{Session, in_either};
use crate::capi::structs::evaluation::Evaluation;
use crate::capi::structs::view::{fmc_coords, fmc_forces};
use std::ptr::{null, null_mut};

/// A step with friction, for `fmc_contact_force`, which does not write into it. `fmc_friction_step_init` sets the optional fields.
///
/// The host keeps the slip that is carried into the next step, and discards the slip of a rejected step.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct fmc_friction_step {
    /// Set by `fmc_friction_step_init`, so that the library recognises an uninitialised struct.
    pub struct_size: usize,
    /// Coordinates at which the step began, (node_count, dim).
    pub start: *const f64,
    /// Coordinates without deformation, (node_count, dim), from which the law "depth" measures its depths; NULL, the
    /// default: `start`.
    pub reference: *const f64,
    /// Elastic slip that was carried into the step, in rows of 8 numbers, as `fmc_context_slip` writes them; NULL, the default: none.
    pub slip: *const f64,
    /// Numbers in `slip`; 0, the default: none.
    pub slip_count: usize,
    /// Receives the elastic slip for the next step, in such rows, if the host accepts the end of this one; may be `slip`
    /// itself. NULL, the default: no output.
    pub next_slip: *mut f64,
    /// Numbers for which `next_slip` has room.
    pub next_slip_capacity: usize,
    /// Receives their number; NULL, the default: no output. With `next_slip` NULL and no capacity only the number is
    /// returned.
    pub next_slip_count: *mut usize,
    /// Zero. Room for later versions.
    pub reserved: [u64; 8],
}

impl Default for fmc_friction_step {
    fn default() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            start: null(),
            reference: null(),
            slip: null(),
            slip_count: 0,
            next_slip: null_mut(),
            next_slip_capacity: 0,
            next_slip_count: null_mut(),
            reserved: [0; 8],
        }
    }
}

impl fmc_friction_step {
    /// Whether it was initialised.
    pub(crate) fn check(&self) -> Result<(), Failure> {
        check_struct::<Self>("fmc_friction_step", self.struct_size, self.reserved)
    }

    /// Coordinates without deformation.
    pub(crate) fn at_rest(&self, node_count: usize) -> fmc_coords {
        let data = if self.reference.is_null() { self.start } else { self.reference };
        fmc_coords { data, node_count, node_stride: 0, axis_stride: 0 }
    }
}

/// Sets every field to its default.
///
/// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_friction_step_init(step: *mut fmc_friction_step) -> fmc_status {
    entry(|| {
        let output = Output::required("step", step)?;
        // SAFETY: the host passes a struct that may be written.
        unsafe { output.write(fmc_friction_step::default()) };
        Ok(())
    })
}

/// Forces at the end `coords` of a step; forces and slip are written once all has succeeded.
///
/// # Safety
/// The host guarantees the arrays of the step, and both views.
pub(crate) unsafe fn in_step(
    step: &fmc_friction_step,
    session: &mut Session,
    coords: &fmc_coords,
    forces: &fmc_forces,
    base: i32,
) -> Result<Evaluation, Failure> {
    let room = Room::new(step.next_slip_capacity, step.next_slip_count)?;
    let start = fmc_coords { data: step.start, ..*coords };
    // SAFETY: passed on to the caller.
    unsafe {
        in_either!(session, one => one.begin_step(&start, base))?;
        let carried = carried(step)?;
        in_either!(session, one => one.set_slip(&carried))?;
        let mut next_slip = Vec::new();
        if !step.next_slip.is_null() || step.next_slip_capacity > 0 || !step.next_slip_count.is_null() {
            in_either!(session, one => one.commit_step(coords, base))?;
            next_slip.extend(in_either!(session, one => one.slip())?);
            in_either!(session, one => one.begin_step(&start, base))?;
            in_either!(session, one => one.set_slip(&carried))?;
        }
        if room.is_asked("numbers of the slip", &[step.next_slip.is_null()], next_slip.len())? {
            check("next_slip", step.next_slip.cast_const())?;
        }
        let found = in_either!(session, one => one.evaluate(coords, Some(forces), false, base))?;
        room.write("numbers of the slip", "next_slip", &next_slip, step.next_slip)?;
        Ok(found)
    }
}

/// The slip that was carried into a step, a copy since the host may have the next one written over it.
///
/// # Safety
/// The host guarantees the arrays of the step.
unsafe fn carried(step: &fmc_friction_step) -> Result<Vec<f64>, Failure> {
    if step.slip.is_null() {
        return Ok(Vec::new());
    }
    // SAFETY: passed on to the caller.
    unsafe { slice("slip", step.slip, step.slip_count, 1) }.map(<[f64]>::to_vec)
}
