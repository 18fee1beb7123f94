//! What was gathered of a mesh in parts.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::pointer::{Output, check, copy_list};
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::FMC_ERROR_BUFFER_TOO_SMALL;
use crate::capi::context::state::{fmc_context, read};
use crate::capi::structs::in_parts::{fmc_carried_slip, no_parts};

/// How much of a mesh in parts was gathered: the same on all ranks, but for the own cells.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct fmc_gathered_counts {
    /// Nodes and cells that every rank has.
    pub node_count: u64,
    pub cell_count: u64,
    /// Boundary facets that every rank has, and those of the whole mesh.
    pub facet_count: u64,
    pub whole_facet_count: u64,
    /// Cells that this rank gave.
    pub own_cell_count: u64,
    /// How often cells were gathered.
    pub gather_count: u64,
}

/// How much of a mesh in parts was gathered.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_UNSUPPORTED` for a context of a whole mesh, `FMC_ERROR_BUSY`. Threads: several at once
/// on one context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_gathered_counts(
    context: *const fmc_context,
    counts: *mut fmc_gathered_counts,
) -> fmc_status {
    entry(|| {
        let output = Output::required("counts", counts)?;
        // SAFETY: the host passes a context.
        let state = unsafe { read(context) }?;
        let parts = state.session.parts().ok_or_else(no_parts)?;
        let found = parts.counts();
        let counts = fmc_gathered_counts {
            node_count: parts.node_numbers().len() as u64,
            cell_count: found.gathered_cell_count as u64,
            facet_count: found.gathered_facet_count as u64,
            whole_facet_count: found.facet_count as u64,
            own_cell_count: found.own_cell_count as u64,
            gather_count: found.gather_count,
        };
        // SAFETY: the host guarantees room for a struct.
        unsafe { output.write(counts) };
        Ok(())
    })
}

/// The nodes gathered, in the order in which the context counts them: `numbers`, their numbers in the whole mesh, ascending;
/// `own_nodes`, which of this rank's own nodes each is, counted from the option `index_base`, or one less than that where it is a
/// node of other ranks alone; `coords`, where they are, `dim` numbers each in dense rows. Each may be NULL, and has room for
/// `capacity` nodes, of which there are as many as `fmc_context_counts` says. Evaluations are at these coordinates; forces, rows
/// and columns are those of these nodes.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_MISALIGNED_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_UNSUPPORTED`,
/// `FMC_ERROR_BUSY`. Threads: several at once on one context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_gathered_nodes(
    context: *const fmc_context,
    numbers: *mut i64,
    own_nodes: *mut i32,
    coords: *mut f64,
    capacity: usize,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context.
        let state = unsafe { read(context) }?;
        let parts = state.session.parts().ok_or_else(no_parts)?;
        let before = i64::from(state.index_base) - 1;
        let found: Vec<i64> = parts.node_numbers().iter().map(|number| *number as i64).collect();
        let own = |node: &Option<u32>| node.map_or(before, |node| before + 1 + i64::from(node)) as i32;
        let own: Vec<i32> = parts.own_nodes().iter().map(own).collect();
        check_room(capacity, found.len())?;
        // SAFETY: the host guarantees room for `capacity` nodes in each array that is not NULL.
        unsafe {
            copy_wanted("numbers", &found, numbers)?;
            copy_wanted("own_nodes", &own, own_nodes)?;
            copy_wanted("coords", parts.coords(), coords)
        }
    })
}

/// The numbers in the whole mesh of the cells gathered, ascending, to `numbers`, which has room for `capacity`.
///
/// Errors: as `fmc_context_gathered_nodes`. Threads: as that.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_gathered_cells(
    context: *const fmc_context,
    numbers: *mut i64,
    capacity: usize,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context.
        let state = unsafe { read(context) }?;
        let parts = state.session.parts().ok_or_else(no_parts)?;
        let found: Vec<i64> = parts.cell_numbers().iter().map(|number| *number as i64).collect();
        check_room(capacity, found.len())?;
        // SAFETY: the host guarantees room for `capacity` numbers.
        unsafe { copy_list("numbers", &found, numbers) }
    })
}

/// The elastic slip that was carried into the step, of all facets of a mesh in parts where it is not zero: the same list on all
/// ranks, ascending by cell, face and part. `count` becomes its length; `carried`, which may be NULL to ask for that alone, has room
/// for `capacity`. With the coordinates and poses at which the step began it is all that a restart needs, on any number of ranks.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_NO_STEP`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_UNSUPPORTED`, `FMC_ERROR_BUSY`. Threads:
/// several at once on one context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_carried_slip(
    context: *const fmc_context,
    carried: *mut fmc_carried_slip,
    capacity: usize,
    count: *mut usize,
) -> fmc_status {
    entry(|| {
        let output = Output::required("count", count)?;
        // SAFETY: the host passes a context.
        let state = unsafe { read(context) }?;
        let found = state.session.parts().ok_or_else(no_parts)?.carried_slip()?;
        if !carried.is_null() {
            check_room(capacity, found.len())?;
        }
        // SAFETY: the host guarantees room for `capacity` structs if there is an array, and for the count.
        unsafe {
            copy_wanted("carried", &found, carried)?;
            output.write(found.len());
        }
        Ok(())
    })
}

fn check_room(capacity: usize, count: usize) -> Result<(), Failure> {
    if capacity < count {
        let text = format!("there is room for {capacity} entries, and there are {count}");
        return Err(Failure::new(FMC_ERROR_BUFFER_TOO_SMALL, text));
    }
    Ok(())
}

/// Writes a list to an array of the host, unless that is NULL.
///
/// # Safety
/// The host guarantees room for the list.
unsafe fn copy_wanted<T: Copy>(name: &str, list: &[T], output: *mut T) -> Result<(), Failure> {
    if output.is_null() {
        return Ok(());
    }
    check(name, output.cast_const())?;
    // SAFETY: passed on to the caller.
    unsafe { copy_list(name, list, output) }
}
