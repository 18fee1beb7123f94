//! Parts of the surface that a host names.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::pointer::{Output, slice};
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, write};

/// Names a part of the surface, so that options of a pair can refer to it (`surface_a`, `surface_b`).
///
/// `facets` are `count` facets, each by its place in `fmc_context_boundary_facets` always from 0, in any order; of a quadrilateral face
/// all four, of one of second order all its parts. They may belong to several bodies. `surface` becomes the number of the part: 1, 2,
/// ... It does not depend on the reference coordinates.
///
/// Errors: `FMC_ERROR_NULL_POINTER`; `FMC_ERROR_BAD_VALUE` for a facet that does not exist, naming its entry; `FMC_ERROR_UNSUPPORTED`
/// without facets and for a mesh in parts, `FMC_ERROR_BUSY`. The context is then unchanged. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_add_surface(
    context: *mut fmc_context,
    facets: *const usize,
    count: usize,
    surface: *mut i32,
) -> fmc_status {
    entry(|| {
        let output = Output::required("surface", surface)?;
        // SAFETY: the host passes a context and `count` numbers.
        let number = unsafe {
            write(context, |state| {
                let facets = slice("facets", facets, count, 1)?;
                in_either!(&mut state.session, one => one.add_surface(facets))
            })
        }?;
        // SAFETY: the host passes an output that may be written.
        unsafe { output.write(i32::try_from(number).unwrap_or(i32::MAX)) };
        Ok(())
    })
}
