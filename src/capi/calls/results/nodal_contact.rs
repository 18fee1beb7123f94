//! The contact at the nodes, for output and for the host's own use.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::pointer::{Output, reference};
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, write};
use crate::capi::structs::nodal_lists::fmc_nodal_contact;
use crate::capi::structs::view::fmc_coords;

/// Requests no output: all pointers are NULL.
///
/// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_nodal_contact_init(nodal: *mut fmc_nodal_contact) -> fmc_status {
    entry(|| {
        let output = Output::required("nodal", nodal)?;
        // SAFETY: the host passes a struct of the header's size, which may be written.
        unsafe { output.write(fmc_nodal_contact::default()) };
        Ok(())
    })
}

/// The contact at every node of the mesh at `coords`, in the order of the coordinates; zero without contact. `nodal` holds the
/// output arrays. The nodal force without its friction is -pressure * area * normal, to rounding.
///
/// With cells of second order a node has the values of its point of the division, with the straight shape function of this
/// point. Shape functions of second order are negative in places, and have no mean at a corner. Forces at points,
/// -pressure * area * normal, then differ from the forces at nodes. They do not add up to the resultant where faces have no node in
/// their middle, because points without a node are not written.
///
/// It measures the contact again, with the current pressure even where friction is frozen, and changes no other result of the
/// context. Errors: as `fmc_context_evaluate`, `FMC_ERROR_STRUCT_SIZE` and `FMC_ERROR_RESERVED_FIELD`; no output is then
/// written. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_nodal_contact(
    context: *mut fmc_context,
    coords: *const fmc_coords,
    nodal: *const fmc_nodal_contact,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a struct.
        let to = *unsafe { reference("nodal", nodal) }?;
        to.check()?;
        // SAFETY: the host passes a context and a view.
        let lists = unsafe {
            write(
                context,
                |state| in_either!(&mut state.session, one => one.nodal_contact(reference("coords", coords)?, state.index_base)),
            )
        }?;
        // SAFETY: the host guarantees that the outputs, where given, have room for the nodes of the mesh.
        unsafe { to.write(&lists) };
        Ok(())
    })
}
