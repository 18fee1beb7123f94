//! What was gathered of a mesh in parts.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::index::Places;
use crate::capi::boundary::list::Room;
use crate::capi::boundary::pointer::{Output, check, copy_list};
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, read};
use crate::capi::structs::in_parts::{fmc_carried_slip, no_parts};
use std::ffi::c_void;

/// Gathered part of a mesh in parts: the same on all ranks, except for the own cells.
///
/// New fields take the place of reserved ones; the size of the struct does not change.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct fmc_gathered_counts {
    /// Size of this struct, as the library wrote it.
    pub struct_size: usize,
    /// Nodes and cells that every rank has.
    pub node_count: u64,
    pub cell_count: u64,
    /// Boundary facets that every rank has, and boundary facets of the whole mesh.
    pub facet_count: u64,
    pub whole_facet_count: u64,
    /// Cells that this rank gave.
    pub own_cell_count: u64,
    /// Number of times that cells were gathered.
    pub gather_count: u64,
    /// Zero.
    pub reserved: [u64; 4],
}

/// Sizes of the gathered part of a mesh in parts.
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
        let parts = in_either!(&state.session, one => one.parts()).ok_or_else(no_parts)?;
        let found = parts.counts();
        let counts = fmc_gathered_counts {
            struct_size: size_of::<fmc_gathered_counts>(),
            node_count: parts.node_numbers().len() as u64,
            cell_count: found.gathered_cell_count as u64,
            facet_count: found.gathered_facet_count as u64,
            whole_facet_count: found.facet_count as u64,
            own_cell_count: found.own_cell_count as u64,
            gather_count: found.gather_count,
            reserved: [0; 4],
        };
        // SAFETY: the host guarantees room for a struct.
        unsafe { output.write(counts) };
        Ok(())
    })
}

/// The gathered nodes, in the order in which the context counts them. `numbers` are their numbers in the whole mesh, ascending.
/// `own_nodes` are their places among this rank's own nodes, -1 for a node that only other ranks have. Both count from the
/// option `index_base`. `coords` are their coordinates, `dim` numbers each in dense rows. Each may be NULL, and has room for
/// `capacity` nodes; `count` becomes their number. All three NULL with capacity 0: only the number is returned. Evaluations are
/// at these coordinates; forces, rows and columns refer to these nodes.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_MISALIGNED_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_UNSUPPORTED`,
/// `FMC_ERROR_BUSY`. Threads: several at once on one context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_gathered_nodes(
    context: *const fmc_context,
    numbers: *mut c_void,
    own_nodes: *mut c_void,
    coords: *mut f64,
    capacity: usize,
    count: *mut usize,
) -> fmc_status {
    entry(|| {
        let room = Room::new(capacity, count)?;
        // SAFETY: the host passes a context.
        let state = unsafe { read(context) }?;
        let parts = in_either!(&state.session, one => one.parts()).ok_or_else(no_parts)?;
        let (size, base) = (state.index_size, i64::from(state.index_base));
        let needed = parts.node_numbers().len();
        let arrays = [numbers.is_null(), own_nodes.is_null(), coords.is_null()];
        if room.is_asked("nodes", &arrays, needed)? && needed > 0 {
            let wanted =
                |name, array: *mut c_void| (!array.is_null()).then(|| Places::new(name, array, size)).transpose();
            let (numbers, own_nodes) = (wanted("numbers", numbers)?, wanted("own_nodes", own_nodes)?);
            if !coords.is_null() {
                check("coords", coords.cast_const())?;
            }
            let own = |node: &Option<u32>| node.map_or(-1, |node| i64::from(node) + base);
            // SAFETY: the host guarantees room for `capacity` nodes in each array that is not NULL.
            unsafe {
                if let Some(numbers) = numbers {
                    put_all(numbers, parts.node_numbers().iter().map(|&number| number as i64 + base));
                }
                if let Some(own_nodes) = own_nodes {
                    put_all(own_nodes, parts.own_nodes().iter().map(own));
                }
                if !coords.is_null() {
                    copy_list("coords", parts.coords(), coords)?;
                }
            }
        }
        // SAFETY: the count, where asked for, may be written.
        unsafe { room.tell(needed) };
        Ok(())
    })
}

/// # Safety
/// The host guarantees the room.
unsafe fn put_all(places: Places, numbers: impl Iterator<Item = i64>) {
    // SAFETY: passed on to the caller.
    numbers.enumerate().for_each(|(place, number)| unsafe { places.put(place, number) });
}

/// The numbers in the whole mesh of the cells gathered, ascending, counted from the option `index_base`. `count` becomes their number;
/// `numbers` has room for `capacity`. NULL with capacity 0: only the number is returned.
///
/// Errors: as `fmc_context_gathered_nodes`. Threads: as there.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_gathered_cells(
    context: *const fmc_context,
    numbers: *mut c_void,
    capacity: usize,
    count: *mut usize,
) -> fmc_status {
    entry(|| {
        let room = Room::new(capacity, count)?;
        // SAFETY: the host passes a context.
        let state = unsafe { read(context) }?;
        let found = in_either!(&state.session, one => one.parts()).ok_or_else(no_parts)?.cell_numbers();
        let base = i64::from(state.index_base);
        // SAFETY: the host guarantees room for `capacity` numbers, and that the count, where asked for, may be written.
        unsafe {
            if room.is_asked("cells", &[numbers.is_null()], found.len())? && !found.is_empty() {
                let places = Places::new("numbers", numbers, state.index_size)?;
                put_all(places, found.iter().map(|&number| number as i64 + base));
            }
            room.tell(found.len());
        }
        Ok(())
    })
}

/// The elastic slip carried into the step, of all facets of a mesh in parts with slip: the same list on all ranks, ascending by cell,
/// face and part. `count` becomes its length; `carried` has room for `capacity`. NULL with capacity 0: only the length is returned. A
/// restart, on any number of ranks, needs it and the coordinates and poses at which the step began.
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
        let room = Room::new(capacity, count)?;
        // SAFETY: the host passes a context.
        let state = unsafe { read(context) }?;
        let found =
            in_either!(&state.session, one => one.parts()).ok_or_else(no_parts)?.carried_slip(state.index_base)?;
        // SAFETY: the host guarantees room for `capacity` structs, and that the count, where asked for, may be written.
        unsafe { room.write("facets", "carried", &found, carried) }
    })
}
