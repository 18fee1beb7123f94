//! Gaps closed and overlaps removed without strain.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::list::Room;
use crate::capi::boundary::pointer::{Output, reference, slice};
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, read, write};
use crate::capi::structs::view::fmc_coords;
use crate::contact::Adjustment;

/// Gaps closed and overlaps removed by `fmc_context_adjust`.
///
/// New fields take the place of reserved ones; the size of the struct does not change.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_adjustment {
    /// Size of this struct, as the library wrote it.
    pub struct_size: usize,
    /// Largest mean gap of a surface point that was closed, a length.
    pub closed: f64,
    /// Largest mean overlap of a surface point that was removed, a length.
    pub removed: f64,
    /// Largest remaining mean gap or overlap of these points, which non-matching meshes cause.
    pub left: f64,
    /// Number of points that were moved.
    pub count: usize,
    /// Zero.
    pub reserved: [u64; 4],
}

impl From<Adjustment> for fmc_adjustment {
    fn from(found: Adjustment) -> Self {
        let Adjustment { closed, removed, left, count } = found;
        Self { struct_size: size_of::<Self>(), closed, removed, left, count, reserved: [0; 4] }
    }
}

/// Closes gaps and removes overlaps at `coords` without strain. It applies where the mean gap of a surface point to a partner
/// (`fmc_context_gap_constraints`) is at most `close`, or its overlap at most `remove`, both lengths. There the surface is offset from its
/// nodes from then on, with two bodies each by half of the distance. Nodes and their strains stay. It works with any law, friction and
/// self-contact. All later results of the context, including gaps, refer to the offset surfaces. A later call adds to the offsets of an
/// earlier one.
///
/// Apply an interference fit in steps: adjust, then before each load step set a smaller part of `fmc_context_offsets` by
/// `fmc_context_set_offsets`, and none in the last. Offsets do not turn with bodies.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_NOT_POSITIVE` for a length that is negative or NaN, `FMC_ERROR_UNSUPPORTED` for a mesh
/// in parts or for bodies that are tied or glued across a gap, `FMC_ERROR_BUSY`; else as `fmc_context_gap_constraints`. The context
/// is then unchanged. Adjust bodies before you tie them: a tie keeps its gap. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_adjust(
    context: *mut fmc_context,
    coords: *const fmc_coords,
    close: f64,
    remove: f64,
    adjustment: *mut fmc_adjustment,
) -> fmc_status {
    entry(|| {
        let output = Output::optional("adjustment", adjustment)?;
        // SAFETY: the host passes a context and a view, and a struct that may be written or NULL.
        unsafe {
            let found = write(context, |state| {
                let coords = reference("coords", coords)?;
                in_either!(&mut state.session, one => one.adjust(coords, [close, remove], state.index_base))
            })?;
            output.write(found.into());
        }
        Ok(())
    })
}

/// Offset of the surface from its nodes: `dim` numbers in dense rows for every node, with cells of second order for every point
/// (`fmc_context_point_weights`), a length.
///
/// `count` becomes their number; `offsets` has room for `capacity`. NULL with capacity 0: only the number is returned.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_BUSY`; no output is then written. Threads: several at once
/// on one context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_offsets(
    context: *const fmc_context,
    offsets: *mut f64,
    capacity: usize,
    count: *mut usize,
) -> fmc_status {
    entry(|| {
        let room = Room::new(capacity, count)?;
        // SAFETY: the host passes a context, and room for `capacity` numbers.
        unsafe {
            let state = read(context)?;
            let found = in_either!(&state.session, one => one.offsets());
            room.write("numbers of the offsets", "offsets", &found, offsets)
        }
    })
}

/// Sets the offset of the surface from its nodes: `count` numbers, as `fmc_context_offsets` writes them; none: no offset. This causes no
/// slip.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_LENGTH`, `FMC_ERROR_NON_FINITE_STIFFNESS` for a number that is not finite,
/// `FMC_ERROR_UNSUPPORTED` for a mesh in parts, `FMC_ERROR_BUSY`; the old offsets are then kept. Threads: one call at a time on a
/// context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_offsets(
    context: *mut fmc_context,
    offsets: *const f64,
    count: usize,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context and `count` numbers.
        unsafe {
            write(context, |state| {
                let offsets = slice("offsets", offsets, count, 1)?;
                in_either!(&mut state.session, one => one.set_offsets(offsets))
            })
        }
    })
}
