//! What the law "depth" takes a body for without deformation.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::pointer::reference;
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, write};
use crate::capi::structs::view::fmc_coords;
use std::ffi::c_void;

/// Sets the coordinates of all nodes without deformation, from which the law "depth" measures its depths. By default
/// they are the coordinates at which the context was created.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_UNSUPPORTED` for a surface without cells, `FMC_ERROR_LENGTH`,
/// `FMC_ERROR_NON_FINITE_COORDINATE`, `FMC_ERROR_INVERTED_CELL`, `FMC_ERROR_ZERO_MEASURE`; the old coordinates are then kept.
/// Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_reference(context: *mut fmc_context, coords: *const fmc_coords) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context and a view.
        unsafe {
            write(
                context,
                |state| in_either!(&mut state.session, one => one.set_reference(reference("coords", coords)?, state.index_base)),
            )
        }
    })
}

/// Sets `count` planes of symmetry: `points` and `normals` are dense rows of `dim` numbers, a point in each plane and its normal, of any
/// length. For the law "depth" a face without deformation in one of them is no surface, since the body continues behind it. The host
/// holds the nodes of such faces in their plane. Replaces earlier planes and nodes of symmetry; `count` 0: there is no symmetry, and
/// flush faces cause no warning. With a mesh in parts all ranks pass the same planes.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_NOT_POSITIVE` for a normal without length, `FMC_ERROR_UNSUPPORTED` for a body
/// that would have no surface left; earlier planes and nodes are then kept. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_symmetry_planes(
    context: *mut fmc_context,
    points: *const f64,
    normals: *const f64,
    count: usize,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context and `count` rows.
        unsafe {
            write(
                context,
                |state| in_either!(&mut state.session, one => one.set_symmetry_planes(points, normals, count)),
            )
        }
    })
}

/// Names `count` nodes, counted from the option `index_base`, that lie in planes of symmetry, instead of the planes of
/// `fmc_context_set_symmetry_planes`. The planes are found from the faces whose nodes are all named: they are the fewest planes that hold
/// all these nodes. A face of the contact surface in a corner between two planes does not count. In a slice one cell thick all nodes lie in
/// the planes of the slice: name further planes by `fmc_context_set_symmetry_planes`. With cells of second order name the nodes in the
/// middle of edges and faces, too.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_NODE_OUT_OF_RANGE` naming the entry, `FMC_ERROR_UNSUPPORTED` for a body that would have no
/// surface left, or for nodes of a curved surface; earlier planes and nodes are then kept. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_symmetry_nodes(
    context: *mut fmc_context,
    nodes: *const c_void,
    count: usize,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context and `count` numbers.
        unsafe {
            write(context, |state| {
                let nodes = state.index_size.list("nodes", nodes, count, 1)?;
                in_either!(&mut state.session, one => one.set_symmetry_nodes(&nodes, state.index_base))
            })
        }
    })
}

/// Measures straight faces as the round surfaces that they represent: where they meet at less than `feature_angle` degrees, the surface
/// between them is smooth. Its normal at a node follows from the faces around the node. For the law "depth" between two bodies; 0, the
/// default: faces are flat. Curved faces of second order are measured as curved in any case, and straight ones of second order in the same
/// body as flat. At a larger angle faces meet at an edge of the body: 30 is usual. A round body needs some 40 facets around it.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_NOT_POSITIVE` for an angle that is negative, NaN, or at least 90,
/// `FMC_ERROR_UNSUPPORTED` for a surface without cells and for a mesh in parts; the earlier angle is then kept. Threads: one call at a
/// time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_surface_smoothing(
    context: *mut fmc_context,
    feature_angle: f64,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context.
        unsafe {
            write(context, |state| in_either!(&mut state.session, one => one.set_surface_smoothing(feature_angle)))
        }
    })
}
