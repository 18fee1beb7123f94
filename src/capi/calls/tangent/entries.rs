//! The tangent: found, kept, and given entry by entry.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::index::Places;
use crate::capi::boundary::list::Room;
use crate::capi::boundary::pointer::{Output, check, reference, slice};
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::{
    FMC_ERROR_INDEX_OUT_OF_RANGE, FMC_ERROR_LENGTH, FMC_ERROR_UNKNOWN_FLAG,
};
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, read, write};
use crate::capi::structs::view::fmc_coords;
use crate::contact::TangentPart;
use std::ffi::c_void;

/// Flag of `fmc_context_tangent` and `fmc_context_evaluate_tangent`: without the terms that can be indefinite, for use
/// far from a solution.
pub const FMC_TANGENT_SEMIDEFINITE: u32 = 2;

/// Flag of both: without the unsymmetric part, the growth of frictional forces with the pressure.
pub const FMC_TANGENT_SYMMETRIC: u32 = 32;

/// The part that `flags` ask for, which may hold no other than the `known` ones.
pub(crate) fn part_of(flags: u32, known: u32) -> Result<TangentPart, Failure> {
    if flags & !known != 0 {
        return Err(Failure::new(FMC_ERROR_UNKNOWN_FLAG, format!("unknown flag in {flags:#x}")));
    }
    Ok(match () {
        () if flags & FMC_TANGENT_SEMIDEFINITE != 0 => TangentPart::Semidefinite,
        () if flags & FMC_TANGENT_SYMMETRIC != 0 => TangentPart::Symmetric,
        () => TangentPart::Full,
    })
}

/// Second derivative of the contact energy at `coords`, which is minus the derivative of the nodal forces, to be added
/// to the host's stiffness matrix. It is kept in the context until the next call, for `fmc_context_tangent_csr` and
/// `fmc_context_tangent_entries`.
///
/// The tangent is symmetric without friction. With friction it is UNSYMMETRIC, unless the friction is frozen: take LU or GMRES in
/// place of Cholesky or conjugate gradients. Or ask for `FMC_TANGENT_SYMMETRIC`, with which Newton's method takes more iterations, and
/// fails sooner at large coefficients of friction. Rows and columns are degrees of freedom: axis a of the n-th node is the one number
/// n * dim + a, n and a from 0, counted from the option `index_base`. The translation of obstacle o follows the nodes, as node
/// `node_count + o`. A host that loads an obstacle finds its stiffness there; other hosts ignore these rows and columns.
/// `rank_one_count`, which may be NULL, receives the number of terms of rank one, which couple all nodes of a pair: 0 for the laws
/// "depth" and "fiber".
///
/// With the law "depth" it is the derivative of the forces of `fmc_context_evaluate`; with "fiber" it is with kept patches
/// and `momentum_correction` 0; the momentum correction, which is small, is not differentiated. `flags`: 0,
/// `FMC_TANGENT_SYMMETRIC` or `FMC_TANGENT_SEMIDEFINITE`, which is symmetric too.
///
/// Newton's method, without a line search, with the law "depth" and k = 10 E / h (modulus E, facets of size h): apply prescribed
/// displacements in the first solve, with the tangent of the last equilibrium. If the pressure k * penetration of an iterate exceeds
/// both E / 10 and twice the pressure of the last equilibrium, lower the option `stiffness` until it does not. Then raise it at least
/// fourfold in every iteration, and take `FMC_TANGENT_SEMIDEFINITE` until it is k again. Else take the full tangent. docs/newton.md
/// has the loop, and its iterations on five problems.
///
/// Errors: as `fmc_context_evaluate`; `FMC_ERROR_UNSUPPORTED` for a law or an estimator without tangent. Threads: one
/// call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_tangent(
    context: *mut fmc_context,
    coords: *const fmc_coords,
    flags: u32,
    rank_one_count: *mut usize,
) -> fmc_status {
    entry(|| {
        let parts = Output::optional("rank_one_count", rank_one_count)?;
        let part = part_of(flags, FMC_TANGENT_SEMIDEFINITE | FMC_TANGENT_SYMMETRIC)?;
        // SAFETY: the host passes a context and a view.
        let count = unsafe {
            write(context, |state| {
                let tangent = in_either!(&mut state.session, one => one.tangent(reference("coords", coords)?, part, state.index_base))?;
                state.keep_tangent(tangent);
                Ok(state.tangent.rank_one.len())
            })
        }?;
        // SAFETY: the output, where given, may be written.
        unsafe { parts.write(count) };
        Ok(())
    })
}

/// The entries of the tangent, one for each pair of row and column: entry i is `values[i]` at row `rows[i]` and column `cols[i]`,
/// ordered by row and column of their nodes.
///
/// `count` becomes their number; the arrays have room for `capacity`. All three NULL with capacity 0: only the number is returned.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_LENGTH` where there are more degrees of freedom
/// than the context's numbers have room for, `FMC_ERROR_BUSY`; no output is then written. Threads: several at once on one
/// context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_tangent_entries(
    context: *const fmc_context,
    rows: *mut c_void,
    cols: *mut c_void,
    values: *mut f64,
    capacity: usize,
    count: *mut usize,
) -> fmc_status {
    entry(|| {
        let room = Room::new(capacity, count)?;
        // SAFETY: the host passes a context.
        let state = unsafe { read(context) }?;
        let (kept, base) = (&state.tangent, i64::from(state.index_base));
        let needed = kept.entry_count();
        let arrays = [rows.is_null(), cols.is_null(), values.is_null()];
        if room.is_asked("entries", &arrays, needed)? && needed > 0 {
            state.index_size.holds((kept.node_count + kept.obstacle_count) * kept.dim + 1)?;
            let rows = Places::new("rows", rows, state.index_size)?;
            let cols = Places::new("cols", cols, state.index_size)?;
            check("values", values.cast_const())?;
            for (index, (row, col, value)) in kept.entries().enumerate() {
                // SAFETY: the host guarantees `capacity` entries, of which there are no more than that.
                unsafe {
                    rows.put(index, row as i64 + base);
                    cols.put(index, col as i64 + base);
                    values.add(index).write(value);
                }
            }
        }
        // SAFETY: the count, where asked for, may be written.
        unsafe { room.tell(needed) };
        Ok(())
    })
}

/// Product of the tangent, terms of rank one included, with `x`: `length` numbers, `dim` for every node, then, if
/// `length` includes them, for every obstacle. `y` may be `x`.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_LENGTH` for fewer than `dim` times the number of nodes,
/// `FMC_ERROR_BUSY`. Threads: several at once on one context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_tangent_product(
    context: *const fmc_context,
    x: *const f64,
    y: *mut f64,
    length: usize,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context and `length` numbers.
        let (state, x) = unsafe { (read(context)?, slice("x", x, length, 1)?) };
        if length < state.tangent.dof_count() {
            let dofs = state.tangent.dof_count();
            let text = format!("'x' has {length} entries, the mesh has {dofs} degrees of freedom");
            return Err(Failure::new(FMC_ERROR_LENGTH, text));
        }
        if length == 0 {
            return Ok(());
        }
        let product = state.tangent.product(x);
        check("y", y.cast_const())?;
        for (index, value) in product.into_iter().enumerate() {
            // SAFETY: the host guarantees `length` entries.
            unsafe { y.add(index).write(value) };
        }
        Ok(())
    })
}

/// A term of rank one of the tangent, factor · g gᵀ: writes the factor, and g to `vector`, with room for `length`
/// numbers laid out as in `fmc_context_tangent_product`.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_INDEX_OUT_OF_RANGE`, `FMC_ERROR_LENGTH`, `FMC_ERROR_BUSY`. Threads:
/// several at once on one context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_tangent_rank_one(
    context: *const fmc_context,
    index: usize,
    factor: *mut f64,
    vector: *mut f64,
    length: usize,
) -> fmc_status {
    entry(|| {
        let output = Output::required("factor", factor)?;
        // SAFETY: the host passes a context.
        let state = unsafe { read(context) }?;
        let kept = &state.tangent;
        let (value, g) = kept.rank_one.get(index).ok_or_else(|| {
            let text = format!("there is no part {index} of rank one, only {}", kept.rank_one.len());
            Failure::new(FMC_ERROR_INDEX_OUT_OF_RANGE, text)
        })?;
        if length < kept.dof_count() {
            let text = format!("'vector' has {length} entries, the mesh has {} degrees of freedom", kept.dof_count());
            return Err(Failure::new(FMC_ERROR_LENGTH, text));
        }
        check("vector", vector.cast_const())?;
        // SAFETY: the host guarantees `length` entries, and the factor.
        unsafe {
            for dof in 0..length {
                vector.add(dof).write(0.0);
            }
            for &(dof, g) in g.iter().filter(|(dof, _)| *dof < length) {
                vector.add(dof).write(g);
            }
            output.write(*value);
        }
        Ok(())
    })
}
