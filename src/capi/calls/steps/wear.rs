//! Wear.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::list::Room;
use crate::capi::boundary::pointer::{Output, slice};
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, read, write};
use crate::capi::structs::partner::partner;

/// Sets wear of a pair by Archard's law: `a` that slides by |ds| under the pressure p loses `wear_a` p |ds| of its depth, and `b` loses
/// `wear_b` p |ds|. Both are dimensionless wear coefficient / hardness, in 1/pressure, and at least 0; 0, the default: that side does not
/// wear. Obstacles never wear. With the laws "depth" and "fiber". Partners are named as in `fmc_context_set_pair_options`, and all other
/// options of the pair stay.
///
/// Surfaces wear in `fmc_context_commit_step` alone. Contact then sees the surface recessed by the worn depth; the host's nodes and strains
/// stay. The depth at a node is int N K p |s| dA / int N dA, N being its shape function, so that the body loses the integral of K p |s| dA.
/// With friction the slip counts without its elastic part; without friction all slip since `fmc_context_begin_step` counts.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BODY_OUT_OF_RANGE`, `FMC_ERROR_OBSTACLE_OUT_OF_RANGE`, `FMC_ERROR_OBSTACLE_REMOVED`,
/// `FMC_ERROR_BAD_VALUE` for an unknown kind, `FMC_ERROR_NOT_POSITIVE` for a number that is negative or not finite, `FMC_ERROR_BUSY`.
/// `FMC_ERROR_UNSUPPORTED` for wear of an obstacle, of a body with itself, by the law "volume", of bodies that are held together or never
/// slide, and of a mesh in parts. The earlier coefficients are then kept. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_pair_wear(
    context: *mut fmc_context,
    a_kind: i32,
    a: usize,
    b_kind: i32,
    b: usize,
    wear_a: f64,
    wear_b: f64,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context.
        unsafe {
            write(context, |state| {
                let partners = [partner(a_kind, a)?, partner(b_kind, b)?];
                in_either!(&mut state.session, one => one.set_pair_wear(partners, [wear_a, wear_b]))
            })
        }
    })
}

/// Wear coefficients of a pair, as set by `fmc_context_set_pair_wear`; zeros by default.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BODY_OUT_OF_RANGE`, `FMC_ERROR_OBSTACLE_OUT_OF_RANGE`, `FMC_ERROR_OBSTACLE_REMOVED`,
/// `FMC_ERROR_BAD_VALUE` for an unknown kind, `FMC_ERROR_UNSUPPORTED` for two obstacles, `FMC_ERROR_BUSY`; no output is then
/// written. Threads: several at once on one context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_pair_wear(
    context: *const fmc_context,
    a_kind: i32,
    a: usize,
    b_kind: i32,
    b: usize,
    wear_a: *mut f64,
    wear_b: *mut f64,
) -> fmc_status {
    entry(|| {
        let (of_a, of_b) = (Output::required("wear_a", wear_a)?, Output::required("wear_b", wear_b)?);
        let partners = [partner(a_kind, a)?, partner(b_kind, b)?];
        // SAFETY: the host passes a context, and outputs that may be written.
        unsafe {
            let found = in_either!(&read(context)?.session, one => one.pair_options(partners))?;
            of_a.write(found.wear_coefficients[0]);
            of_b.write(found.wear_coefficients[1]);
        }
        Ok(())
    })
}

/// Worn depth of surfaces (`fmc_context_set_pair_wear`), a length for every node, in the order of `fmc_context_nodal_contact`; 0 at first.
///
/// `count` becomes their number; `depth` has room for `capacity`. NULL with capacity 0: only the number is returned.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_NO_STEP` after `fmc_context_set_worn_facets` before
/// `fmc_context_begin_step`, `FMC_ERROR_UNSUPPORTED` for a mesh in parts, `FMC_ERROR_BUSY`; no output is then written. Threads: several
/// at once on one context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_worn_depth(
    context: *const fmc_context,
    depth: *mut f64,
    capacity: usize,
    count: *mut usize,
) -> fmc_status {
    entry(|| {
        let room = Room::new(capacity, count)?;
        // SAFETY: the host passes a context, and room for `capacity` numbers.
        unsafe {
            let found = in_either!(&read(context)?.session, one => one.wear())?;
            room.write("worn depths", "depth", &found.depth, depth)
        }
    })
}

/// Volume that every body has lost by wear, in 2D per unit thickness, with axisymmetry the volume of rings. It is the integral of K p |s|
/// dA over all accepted steps.
///
/// `count` becomes the number of bodies; `volumes` has room for `capacity`. NULL with capacity 0: only the number is
/// returned.
///
/// Errors: as `fmc_context_worn_depth`. Threads: several at once on one context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_worn_volumes(
    context: *const fmc_context,
    volumes: *mut f64,
    capacity: usize,
    count: *mut usize,
) -> fmc_status {
    entry(|| {
        let room = Room::new(capacity, count)?;
        // SAFETY: the host passes a context, and room for `capacity` numbers.
        unsafe {
            let found = in_either!(&read(context)?.session, one => one.wear())?;
            room.write("worn volumes", "volumes", &found.volumes, volumes)
        }
    })
}

/// State of wear, for a restart: a row for every worn facet and each of the points that move it. A row is 4 numbers: facet, node,
/// depth against the normal of the facet, and volume. The facet is its place in `fmc_context_boundary_facets`. With cells of second
/// order the node is a point (`fmc_context_point_weights`). Both count always from 0. Rows ascend by facet and point.
///
/// `count` becomes their number; `worn` has room for `capacity`. NULL with capacity 0: only the number is returned.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_BUSY`; no output is then written. Threads: several at once
/// on one context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_worn_facets(
    context: *const fmc_context,
    worn: *mut f64,
    capacity: usize,
    count: *mut usize,
) -> fmc_status {
    entry(|| {
        let room = Room::new(capacity, count)?;
        // SAFETY: the host passes a context, and room for `capacity` numbers.
        unsafe {
            let found = in_either!(&read(context)?.session, one => one.worn_facets());
            room.write("numbers of the worn facets", "worn", &found, worn)
        }
    })
}

/// Sets the state of wear: `count` numbers, in rows as `fmc_context_worn_facets` writes them. Facets without a row are not worn. Pass no
/// rows after the host has moved its nodes to the worn surface. For a restart call it before `fmc_context_begin_step` and
/// `fmc_context_set_slip`: the results are bit-for-bit identical to the unbroken run.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_LENGTH` where the last row is not whole, `FMC_ERROR_INDEX_OUT_OF_RANGE` for a row that
/// names a facet that does not exist, a point that does not move it, or both twice. `FMC_ERROR_NOT_POSITIVE` for a depth or volume that is
/// negative or not finite, `FMC_ERROR_UNSUPPORTED` for a mesh in parts, `FMC_ERROR_BUSY`. The old state is then kept. Threads: one call at
/// a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_worn_facets(
    context: *mut fmc_context,
    worn: *const f64,
    count: usize,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context and `count` numbers.
        unsafe {
            write(context, |state| {
                let worn = slice("worn", worn, count, 1)?;
                in_either!(&mut state.session, one => one.set_worn_facets(worn))
            })
        }
    })
}

/// Sets how many cycles each step represents from now on, 1 at first: the wear of a step is multiplied by this number. Wear is explicit,
/// and surfaces do not change within a step: `FMC_WARNING_LARGE_WEAR` reports too many cycles.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_NOT_POSITIVE` unless positive and finite, `FMC_ERROR_BUSY`. Threads: one call at a time on
/// a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_wear_cycles(context: *mut fmc_context, cycles: f64) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context.
        unsafe { write(context, |state| in_either!(&mut state.session, one => one.set_wear_cycles(cycles))) }
    })
}
