//! Where a host puts nodes that follow others.

use crate::Error;
use std::ffi::c_void;

/// Places the nodes for a displacement of the degrees of freedom on the list of `fmc_context_contact_step`.
///
/// Read `displacement`, (n). `coords` are dense rows, one for every node: the coordinates of the start, with the
/// displacement added on the list. Move the nodes that follow, and none on the list. `user` is the pointer given with the
/// function.
///
/// Return 0; any other value makes the step fail with `FMC_ERROR_PLACE`. It is called on the thread that called for the step. It
/// must not call a function of the same context (it would get `FMC_ERROR_BUSY`), throw, or jump out.
pub type fmc_place =
    Option<unsafe extern "C" fn(user: *mut c_void, n: usize, displacement: *const f64, coords: *mut f64) -> i32>;

/// A host's function and its pointer.
#[derive(Clone, Copy)]
pub(crate) struct Placement {
    pub(crate) function: unsafe extern "C" fn(*mut c_void, usize, *const f64, *mut f64) -> i32,
    pub(crate) user: *mut c_void,
}

impl Placement {
    /// # Safety
    /// The host guarantees a function that keeps to its contract.
    pub(crate) unsafe fn call(self, displacement: &[f64], coords: &mut [f64]) -> Result<(), Error> {
        // SAFETY: both arrays are as long as the contract says, and the caller guarantees the function.
        let code =
            unsafe { (self.function)(self.user, displacement.len(), displacement.as_ptr(), coords.as_mut_ptr()) };
        if code == 0 { Ok(()) } else { Err(Error::Place { code }) }
    }
}
