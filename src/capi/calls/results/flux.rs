//! Scalar fields through contact, and the heat of friction.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::list::{MatrixRoom, Room};
use crate::capi::boundary::pointer::{Output, check, copy_list, reference};
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, read, write};
use crate::capi::structs::conductance::fmc_conductance;
use crate::capi::structs::view::fmc_coords;
use std::ffi::c_void;

/// Nothing conducts: no tables.
///
/// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_conductance_init(conductance: *mut fmc_conductance) -> fmc_status {
    entry(|| {
        let output = Output::required("conductance", conductance)?;
        // SAFETY: the host passes a struct of the header's size, which may be written.
        unsafe { output.write(fmc_conductance::default()) };
        Ok(())
    })
}

/// Flux of heat or charge through the contact at `coords`: the integral of N h (T - T_other) dA out of every node. T is a field, and
/// T_other the field at the facing point of the other side. The flux is positive if heat leaves the node, and its sum over all nodes and
/// obstacles is zero. The conductance h depends on the pressure of the law. Bodies that are tied, glued or do not separate conduct where
/// they are held. With axisymmetry dA is the area of rings.
///
/// `fields` has `field_count` fields, one after the other, with a value for every row of `coords`; `flux` has room for as many.
/// `of_obstacles` has as many fields, with a value for every obstacle, removed ones included; `obstacle_flux` has room for them. NULL for
/// `of_obstacles`: there is no flux into obstacles; `obstacle_flux` may be NULL, too. With `field_count` 0 only the matrix is computed, for
/// `fmc_context_flux_matrix`.
///
/// Errors: as `fmc_context_evaluate`, except for friction; `FMC_ERROR_STRUCT_SIZE`, `FMC_ERROR_RESERVED_FIELD`; `FMC_ERROR_UNSUPPORTED` for
/// a mesh in parts; `FMC_ERROR_UNTIED` as `fmc_context_tie`. `FMC_ERROR_NOT_POSITIVE` for an entry of a field or table that is not finite,
/// a negative entry of a table, or places that do not ascend. No output is then written. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_flux(
    context: *mut fmc_context,
    coords: *const fmc_coords,
    conductance: *const fmc_conductance,
    field_count: usize,
    fields: *const f64,
    of_obstacles: *const f64,
    flux: *mut f64,
    obstacle_flux: *mut f64,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context, a view, tables, and arrays of the lengths that follow from `field_count`.
        unsafe {
            write(context, |state| {
                let coords = reference("coords", coords)?;
                let tables = reference("conductance", conductance)?.tables()?;
                let given = (field_count, fields, of_obstacles);
                let found = in_either!(&mut state.session, one => one.flux(coords, &tables, given, state.index_base))?;
                write_both(("flux", &found.flux, flux), ("obstacle_flux", &found.of_obstacles, obstacle_flux))?;
                state.flux = found.matrix;
                Ok(())
            })
        }
    })
}

/// The derivative of the flux by the field at the last `fmc_context_flux`, the same for every field, in compressed rows: symmetric,
/// positive semidefinite, and independent of the field. Rows and columns are nodes, then obstacles. Row r has the entries from
/// `row_offsets[r]` to `row_offsets[r + 1]`, in ascending order of their columns. Offsets and columns count from the option `index_base`.
///
/// `offset_count` becomes the number of offsets, one more than there are rows, and `count` the number of entries. `row_offsets` has
/// room for `offset_capacity`, `cols` and `values` for `capacity`. An array that is NULL with capacity 0 is not written: only its
/// number is returned.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_LENGTH` where a number does not fit into the context's
/// numbers, `FMC_ERROR_BUSY`; no output is then written. Threads: several at once on one context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_flux_matrix(
    context: *const fmc_context,
    row_offsets: *mut c_void,
    offset_capacity: usize,
    offset_count: *mut usize,
    cols: *mut c_void,
    values: *mut f64,
    capacity: usize,
    count: *mut usize,
) -> fmc_status {
    entry(|| {
        let (offsets, entries) = (Room::new(offset_capacity, offset_count)?, Room::new(capacity, count)?);
        // SAFETY: the host passes a context.
        let state = unsafe { read(context) }?;
        let room = MatrixRoom { row_offsets, offsets, cols, values, entries, size: state.index_size };
        let found = &state.flux;
        let rows = found.offsets.len().saturating_sub(1);
        // SAFETY: the host guarantees the room that it says.
        unsafe {
            room.write(
                &found.offsets,
                found.cols.iter().map(|col| *col as usize),
                rows,
                &found.values,
                state.index_base,
            )
        }
    })
}

/// The energy that friction has dissipated since the step began, as heat at nodes and obstacles: its sum is the dissipation of all pairs.
/// Heat / duration of the step is a power. With cells of second order some nodes may have a negative part.
///
/// `effusivities`: one for every body, then one for every obstacle, removed ones included, not negative. Each side of a pair takes a part
/// of the heat in proportion to its effusivity, sqrt(conductivity * density * heat capacity); with 0 it takes none. NULL: halves. `heat`
/// has room for a number for every row of `coords`, `obstacle_heat` for every obstacle; it may be NULL.
///
/// Errors: as `fmc_context_evaluate`; `FMC_ERROR_NOT_POSITIVE` for an effusivity that is negative or not finite; `FMC_ERROR_UNSUPPORTED`
/// for a mesh in parts. No output is then written. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_friction_heat(
    context: *mut fmc_context,
    coords: *const fmc_coords,
    effusivities: *const f64,
    heat: *mut f64,
    obstacle_heat: *mut f64,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context, a view, and arrays of the lengths that follow from it.
        unsafe {
            write(context, |state| {
                let coords = reference("coords", coords)?;
                let base = state.index_base;
                let found = in_either!(&mut state.session, one => one.friction_heat(coords, effusivities, base))?;
                write_both(("heat", &found.nodes, heat), ("obstacle_heat", &found.of_obstacles, obstacle_heat))
            })
        }
    })
}

/// Writes a list, and another unless it goes nowhere.
///
/// # Safety
/// The host guarantees room for both.
unsafe fn write_both(
    (name, list, to): (&str, &[f64], *mut f64),
    (other_name, other, other_to): (&str, &[f64], *mut f64),
) -> Result<(), Failure> {
    let is_wanted = !other_to.is_null();
    if is_wanted && !other.is_empty() {
        check(other_name, other_to.cast_const())?;
    }
    // SAFETY: passed on to the caller.
    unsafe {
        copy_list(name, list, to)?;
        if is_wanted { copy_list(other_name, other, other_to) } else { Ok(()) }
    }
}
