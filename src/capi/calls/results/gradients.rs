//! Derivatives of energy and forces.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::list::Room;
use crate::capi::boundary::pointer::{Output, copy_list, optional, reference, slice};
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, write};
use crate::capi::structs::directions::fmc_directions;
use crate::capi::structs::gradients::{fmc_gradients, fmc_pair_gradient};
use crate::capi::structs::view::fmc_coords;

/// Requests no output: all pointers are NULL.
///
/// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_gradients_init(gradients: *mut fmc_gradients) -> fmc_status {
    entry(|| {
        let output = Output::required("gradients", gradients)?;
        // SAFETY: the host passes a struct of the header's size, which may be written.
        unsafe { output.write(fmc_gradients::default()) };
        Ok(())
    })
}

/// The derivatives of `energy` * w + `adjoint` . F at `coords`, by the variables that `gradients` names: w is the contact energy, and
/// F are the nodal forces. F includes friction, w does not. `adjoint` has the shape of `coords`; NULL: zeros. A host that minimises
/// J(x) with contact in equilibrium passes the solution of the adjoint system, with `energy` 0.
///
/// All are exact partial derivatives: all other variables are held, including the slip at the start of the step, which has a separate
/// derivative. Where two faces are equally near to a node, the depth has a kink, and the derivative is one-sided.
///
/// `count` becomes the number of pairs that touch, 0 without a request for pairs; `pairs` has room for `capacity`.
///
/// Errors: as `fmc_context_tangent`; `FMC_ERROR_LENGTH`, `FMC_ERROR_STRUCT_SIZE`, `FMC_ERROR_RESERVED_FIELD`, `FMC_ERROR_UNKNOWN_FLAG` and
/// `FMC_ERROR_BUFFER_TOO_SMALL`; for `slip_adjoint` as `fmc_context_set_slip`. `FMC_ERROR_UNSUPPORTED` for a derivative that is not known,
/// never a zero. By coordinates and poses: with the law "fiber" unless patches are kept; of sampled energies unless weights are
/// "consistent" and `momentum_correction` is 0. Also of forces: sampled ones, between curved faces in 3D, and frictional ones unless
/// friction is frozen. By the reference: with axisymmetry, friction, curved faces, hanging nodes, ranks, and of forces with a gap offset
/// between bodies. By gap offset: of frictional forces; by stiffness: of these with cohesion or a shear limit, or frozen. By slip: with
/// static friction, or frozen; of the slip at the end of the step: by coordinates, poses and gap offsets. By gap offsets: of pairs other
/// than bodies with half-spaces. By the coefficient of friction: where it is 0, and with static friction, cohesion or a shear limit. By
/// rotations: with the law "fiber", and with axisymmetry. No output is then written. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_vjp(
    context: *mut fmc_context,
    coords: *const fmc_coords,
    energy: f64,
    adjoint: *const fmc_coords,
    gradients: *const fmc_gradients,
    pairs: *mut fmc_pair_gradient,
    capacity: usize,
    count: *mut usize,
) -> fmc_status {
    entry(|| {
        let room = Room::new(capacity, count)?;
        // SAFETY: the host passes a struct.
        let to = *unsafe { reference("gradients", gradients) }?;
        let request = to.request()?;
        let slip_room = Room::new(to.slip_capacity, to.slip_count)?;
        // SAFETY: the host passes a context and views.
        let lists = unsafe {
            write(context, |state| {
                let slip = slice("slip_adjoint", to.slip_adjoint, to.slip_adjoint_count, 1)?;
                let of = (energy, optional("adjoint", adjoint)?, slip);
                let base = state.index_base;
                in_either!(&mut state.session, one => one.vjp(reference("coords", coords)?, of, &request, base))
            })
        }?;
        slip_room.is_asked("numbers of the slip", &[to.slip.is_null()], lists.slip.len())?;
        let found = if to.of_pairs == 0 { &[][..] } else { &lists.pairs };
        // SAFETY: the host guarantees that the outputs, where given, have room for what they are said to have.
        unsafe {
            room.write("pairs", "pairs", found, pairs)?;
            to.write(&lists);
            slip_room.write("numbers of the slip", "slip", &lists.slip, to.slip)?;
        }
        Ok(())
    })
}

/// All rates 0.
///
/// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_directions_init(directions: *mut fmc_directions) -> fmc_status {
    entry(|| {
        let output = Output::required("directions", directions)?;
        // SAFETY: the host passes a struct of the header's size, which may be written.
        unsafe { output.write(fmc_directions::default()) };
        Ok(())
    })
}

/// Rates of energy and nodal forces at `coords` along rates of their variables: the transpose of `fmc_context_vjp`. With the same
/// parameters moved by d, energy * `energy` + adjoint . `forces` here is d times the derivatives there. The energy does not include
/// friction; the slip at the start of the step changes only with the rate in `directions`.
///
/// `energy` becomes the rate of the contact energy; `forces` has room for n * dim numbers, the rates of the force on every node in dense
/// rows. Either may be NULL.
///
/// Errors: as `fmc_context_vjp` with an adjoint, for all variables with a rate; `FMC_ERROR_LENGTH`, `FMC_ERROR_NON_FINITE_STIFFNESS` with
/// the place of a rate, `FMC_ERROR_STRUCT_SIZE`, `FMC_ERROR_RESERVED_FIELD`; `FMC_ERROR_INDEX_OUT_OF_RANGE` for a pair that does not exist;
/// for `slip` as `fmc_context_set_slip`. There are no rates along coordinates without deformation. No output is then written. Threads: one
/// call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_jvp(
    context: *mut fmc_context,
    coords: *const fmc_coords,
    directions: *const fmc_directions,
    energy: *mut f64,
    forces: *mut f64,
) -> fmc_status {
    entry(|| {
        let (energy, _) = (Output::optional("energy", energy)?, Output::optional("forces", forces)?);
        // SAFETY: the host passes a context, views and a struct whose arrays are as long as they are said to be.
        let (rate, rates) = unsafe {
            write(context, |state| {
                let (at, along) = (reference("coords", coords)?, reference("directions", directions)?);
                let base = state.index_base;
                in_either!(&mut state.session, one => one.jvp(at, along, base))
            })
        }?;
        // SAFETY: the host guarantees that the outputs, where given, have room.
        unsafe {
            energy.write(rate);
            if !forces.is_null() {
                copy_list("forces", &rates, forces)?;
            }
        }
        Ok(())
    })
}
