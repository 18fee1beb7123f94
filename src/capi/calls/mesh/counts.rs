//! How large a mesh is.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::pointer::Output;
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, read};

/// Number of nodes of the mesh, of its boundary facets, and of its bodies. A quadrilateral face in 3D counts as four facets;
/// of second order an edge counts as two, a triangle as four, a quadrilateral as sixteen. Any of the outputs may be NULL.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUSY`. Threads: several at once on one context, as long as no call
/// changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_counts(
    context: *const fmc_context,
    node_count: *mut usize,
    facet_count: *mut usize,
    body_count: *mut usize,
) -> fmc_status {
    entry(|| {
        let nodes = Output::optional("node_count", node_count)?;
        let facets = Output::optional("facet_count", facet_count)?;
        let bodies = Output::optional("body_count", body_count)?;
        // SAFETY: the host passes a context.
        let counts = in_either!(&unsafe { read(context) }?.session, one => one.counts());
        // SAFETY: the outputs, where given, may be written.
        unsafe {
            nodes.write(counts.nodes);
            facets.write(counts.facets);
            bodies.write(counts.bodies);
        }
        Ok(())
    })
}

/// Number of nodes that the option `weld` has removed: as many as merging would remove; 0 without it.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUSY`. Threads: several at once on one context, as long as no call
/// changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_welded_node_count(context: *const fmc_context, count: *mut usize) -> fmc_status {
    entry(|| {
        let output = Output::required("count", count)?;
        // SAFETY: the host passes a context, and an output that may be written.
        unsafe {
            let state = read(context)?;
            output.write(in_either!(&state.session, one => one.welded_node_count()));
        }
        Ok(())
    })
}
