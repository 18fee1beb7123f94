//! Forces with friction in one call.

use crate::capi::boundary::dimension::checked_dimension;
use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::pointer::{Output, check, copy_list, reference, slice};
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::{FMC_ERROR_LENGTH, FMC_ERROR_RESERVED_FIELD, FMC_ERROR_STRUCT_SIZE};
use crate::capi::calls::mesh::creation::session_of_cells;
use crate::capi::structs::mesh::{Block, fmc_cell_block, fmc_cell_block_i64};
use crate::capi::structs::options::fmc_options;
use crate::capi::structs::view::{fmc_coords, fmc_forces};
use std::ptr::{null, null_mut};

/// A step with friction, for `fmc_contact_force_step`. `fmc_friction_step_init` sets what need not be given.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct fmc_friction_step {
    /// Set by `fmc_friction_step_init`, so that a struct that was not initialised is recognised.
    pub struct_size: usize,
    /// Coordinates at which the step began, (node_count, dim).
    pub start: *const f64,
    /// Coordinates without deformation, (node_count, dim), from which the law "depth" has its depths; NULL, the default:
    /// `start`.
    pub reference: *const f64,
    /// Elastic slip that was carried into the step, (facets, dim); NULL, the default: none.
    pub slip: *const f64,
    /// Receives the elastic slip that is carried into the next step, (facets, dim), if the end of this one is accepted;
    /// may be `slip` itself. NULL, the default: not wanted.
    pub next_slip: *mut f64,
    /// Numbers in either, `dim` times the number of facets.
    pub slip_length: usize,
    /// Written as soon as it is known, also where `slip_length` is refused: the number of facets.
    pub facet_count: usize,
    /// Zero. Room for later versions.
    pub reserved: [u64; 8],
}

impl Default for fmc_friction_step {
    fn default() -> Self {
        let (numbers, output) = (null(), null_mut());
        Self {
            struct_size: size_of::<Self>(),
            start: numbers,
            reference: numbers,
            slip: numbers,
            next_slip: output,
            slip_length: 0,
            facet_count: 0,
            reserved: [0; 8],
        }
    }
}

impl fmc_friction_step {
    fn check(&self) -> Result<(), Failure> {
        let (found, expected) = (self.struct_size, size_of::<Self>());
        if found != expected {
            let text = format!(
                "fmc_friction_step has struct_size {found}, expected {expected}: call fmc_friction_step_init first"
            );
            return Err(Failure::new(FMC_ERROR_STRUCT_SIZE, text));
        }
        if self.reserved != [0; 8] {
            let text = "a reserved field of fmc_friction_step is not zero: one of a later version of the library";
            return Err(Failure::new(FMC_ERROR_RESERVED_FIELD, text));
        }
        Ok(())
    }
}

/// Sets every field to its default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_friction_step_init(step: *mut fmc_friction_step) -> fmc_status {
    entry(|| {
        let output = Output::required("step", step)?;
        // SAFETY: the host passes a struct that may be written.
        unsafe { output.write(fmc_friction_step::default()) };
        Ok(())
    })
}

/// `fmc_contact_force` with friction, at the end `coords` of a step: forces, and the elastic slip that is carried into the
/// next. The host keeps that; a step that it rejects it does not keep. The bits are those of a context made at
/// `step->reference` that goes through `fmc_context_begin_step`, `fmc_context_set_slip`, `fmc_context_evaluate` and
/// `fmc_context_commit_step`.
///
/// Outputs are written only on success, but for `step->facet_count`, from which a host learns the length of its slip.
///
/// Errors: those of `fmc_contact_force` and of these calls; `FMC_ERROR_STRUCT_SIZE`, `FMC_ERROR_RESERVED_FIELD`, and
/// `FMC_ERROR_LENGTH` for another `slip_length`. Threads: any, also at once.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_contact_force_step(
    dim: i32,
    coords: *const f64,
    node_count: usize,
    cell_type: i32,
    conn: *const i32,
    cell_count: usize,
    body_ids: *const i32,
    options: *const fmc_options,
    step: *mut fmc_friction_step,
    forces: *mut f64,
    volume: *mut f64,
) -> fmc_status {
    let block = fmc_cell_block { cell_type, conn, cell_count };
    // SAFETY: the host passes what the parameters say.
    entry(|| unsafe { force_step(dim, (coords, node_count), block, body_ids, options, step, (forces, volume)) })
}

/// `fmc_contact_force_step` with 64-bit node numbers and body ids.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_contact_force_step_i64(
    dim: i32,
    coords: *const f64,
    node_count: usize,
    cell_type: i32,
    conn: *const i64,
    cell_count: usize,
    body_ids: *const i64,
    options: *const fmc_options,
    step: *mut fmc_friction_step,
    forces: *mut f64,
    volume: *mut f64,
) -> fmc_status {
    let block = fmc_cell_block_i64 { cell_type, conn, cell_count };
    // SAFETY: the host passes what the parameters say.
    entry(|| unsafe { force_step(dim, (coords, node_count), block, body_ids, options, step, (forces, volume)) })
}

/// # Safety
/// As `fmc_contact_force_step`.
unsafe fn force_step<B: Block>(
    dim: i32,
    (coords, node_count): (*const f64, usize),
    block: B,
    body_ids: *const B::Id,
    options: *const fmc_options,
    step: *mut fmc_friction_step,
    (forces, volume): (*mut f64, *mut f64),
) -> Result<(), Failure> {
    let dim = checked_dimension(dim)?;
    let volume = Output::optional("volume", volume)?;
    if node_count > 0 {
        check("forces", forces)?;
    }
    // SAFETY: the host passes a struct, and arrays as long as they are said to be.
    unsafe {
        let given = *reference("step", step)?;
        given.check()?;
        let options = reference("options", options)?;
        let view = |data: *const f64| fmc_coords { data, node_count, node_stride: 0, axis_stride: 0 };
        let at_rest = view(if given.reference.is_null() { given.start } else { given.reference });
        let mut session = match dim {
            2 => session_of_cells::<B, 2>(&at_rest, &[block], body_ids, options),
            _ => session_of_cells::<B, 3>(&at_rest, &[block], body_ids, options),
        }?;
        let (base, coords, start) = (options.index_base, view(coords), view(given.start));
        session.begin_step(&start, base)?;
        let length = session.slip()?.len();
        (*step).facet_count = length / dim;
        let carried = carried(&given, length)?;
        session.set_slip(&carried)?;
        let mut next_slip = Vec::new();
        if !given.next_slip.is_null() {
            session.commit_step(&coords, base)?;
            next_slip.extend(session.slip()?);
            session.begin_step(&start, base)?;
            session.set_slip(&carried)?;
        }
        let output = fmc_forces { data: forces, node_count, node_stride: 0, axis_stride: 0 };
        let evaluation = session.evaluate(&coords, Some(&output), false, base)?;
        volume.write(evaluation.result.volume);
        copy_list("next_slip", &next_slip, given.next_slip)
    }
}

/// The slip that was carried into a step, a copy since the host may have the next one written over it.
///
/// # Safety
/// The host guarantees the arrays of the step.
unsafe fn carried(step: &fmc_friction_step, length: usize) -> Result<Vec<f64>, Failure> {
    if step.slip.is_null() && step.next_slip.is_null() {
        return Ok(vec![0.0; length]);
    }
    if step.slip_length != length {
        let found = step.slip_length;
        let text = format!("the slip of the step has {found} numbers, and {length} are expected: dim for every facet");
        return Err(Failure::new(FMC_ERROR_LENGTH, text));
    }
    if !step.next_slip.is_null() {
        check("next_slip", step.next_slip.cast_const())?;
    }
    if step.slip.is_null() {
        return Ok(vec![0.0; length]);
    }
    // SAFETY: passed on to the caller.
    unsafe { slice("slip", step.slip, length, 1) }.map(<[f64]>::to_vec)
}
