//! The adjoint of an equilibrium.

use crate::Error;
use crate::capi::boundary::entry::entry;
use crate::capi::boundary::list::Room;
use crate::capi::boundary::pointer::{Output, copy_list, optional, reference, slice};
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, write};
use crate::capi::structs::equilibrium::fmc_equilibrium_problem;
use crate::capi::structs::gradients::{fmc_gradients, fmc_pair_gradient};

/// Derivatives of a number J(x, F) of an equilibrium by its parameters, F being the contact forces on nodes. It takes two calls, and one
/// linear solve of the host between them. R are internal minus external forces, K = dR/dx, T is the contact's full tangent and a = dJ/dF.
/// The adjoint b is zero at unknowns that are not free, and solves (K + T)^T b = dJ/dx - T^T a in the free rows.
///
/// With `balance` NULL `right` becomes dJ/dx - T^T a. With `balance` = b, the arrays of `gradients` become total derivatives of J, as
/// `fmc_context_vjp` writes them, and `right` becomes dJ/dx - T^T (a + b). Minus K^T b it is the derivative by the value of an unknown that
/// is not free. The host's part of dJ/dp is -b . dR/dp; a load has the derivative b. `coords` of `gradients` is the derivative by
/// additional motions of the nodes, x held.
///
/// `problem`: the unknowns as for `fmc_equilibrium_new`, its `x` the equilibrium, found by any solver; `prescribed` is not read. `by_x`:
/// dJ/dx, `unknown_count` numbers, also of unknowns that are not free. `by_forces`: dJ/dF, `row_count * dim` numbers by row; NULL for
/// zeros. `right` has room for `unknown_count` numbers, or is NULL. `gradients` NULL: only `right` is written. `pairs`, `capacity` and
/// `count` as for `fmc_context_vjp`.
///
/// Errors: as `fmc_equilibrium_new` for the problem and as `fmc_context_vjp` with an adjoint; `FMC_ERROR_NON_FINITE_STIFFNESS` with the
/// place in an array. `FMC_ERROR_UNSUPPORTED` with multipliers, which the search sets if it found the stiffness or a `penetration` was
/// given; with friction; for `slip` and `slip_adjoint`. No output is then written. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_equilibrium_adjoint(
    context: *mut fmc_context,
    problem: *const fmc_equilibrium_problem,
    by_x: *const f64,
    by_forces: *const f64,
    balance: *const f64,
    right: *mut f64,
    gradients: *const fmc_gradients,
    pairs: *mut fmc_pair_gradient,
    capacity: usize,
    count: *mut usize,
) -> fmc_status {
    entry(|| {
        let room = Room::new(capacity, count)?;
        Output::optional("right", right)?;
        // SAFETY: the host passes structs, or NULL for what it does not ask for.
        let (to, problem) = unsafe {
            let to = optional("gradients", gradients)?.copied().unwrap_or_default();
            (to, reference("problem", problem)?)
        };
        let request = to.request()?;
        if !to.slip_adjoint.is_null() || to.slip_adjoint_count > 0 {
            return Err(Error::Unsupported { what: "the adjoint of an equilibrium with factors of the slip" }.into());
        }
        let unknown_count = problem.unknown_count;
        // SAFETY: the host passes a context, a problem with its arrays, and arrays as long as the header says.
        let (found, lists) = unsafe {
            write(context, |state| {
                let by_x = slice("by_x", by_x, unknown_count, 1)?;
                let balance = match balance.is_null() {
                    true => None,
                    false => Some(slice("balance", balance, unknown_count, 1)?),
                };
                let (size, base) = (state.index_size, state.index_base);
                in_either!(&mut state.session, one => one.adjoint((problem, size, base), (by_x, by_forces), balance, &request))
            })
        }?;
        let found_pairs = if to.of_pairs == 0 { &[][..] } else { &lists.pairs };
        // SAFETY: the host guarantees that the outputs, where given, have room for what they are said to have.
        unsafe {
            room.write("pairs", "pairs", found_pairs, pairs)?;
            to.write(&lists);
            if !right.is_null() {
                copy_list("right", &found, right)?;
            }
        }
        Ok(())
    })
}
