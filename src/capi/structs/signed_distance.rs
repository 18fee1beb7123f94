//! Bodies given by a function of the host.

use crate::SignedDistance;
use std::ffi::c_void;

/// Signed distance of a body in the obstacle's own frame, for `n` points at once.
///
/// Read `x`, (n, dim) rows. Write `phi`, (n): negative inside, positive outside, with slope of at most 1. Write `grad`,
/// (n, dim) rows: its gradient, of any length; where phi = 0 it gives the outward normal. An unwritten entry counts as
/// not finite. `user` is the pointer of the same name in the shape.
///
/// Return 0; any other value makes the evaluation fail with `FMC_ERROR_SIGNED_DISTANCE`, naming point i of the batch
/// for the value i + 1. It is called on the thread that evaluates, never from two threads at once. It must not call a
/// function of the same context (it would get `FMC_ERROR_BUSY`), throw, or jump out.
pub type fmc_signed_distance =
    Option<unsafe extern "C" fn(user: *mut c_void, n: usize, x: *const f64, phi: *mut f64, grad: *mut f64) -> i32>;

/// A callback and its user pointer.
#[derive(Clone, Copy)]
pub(crate) struct Callback {
    pub(crate) function: unsafe extern "C" fn(*mut c_void, usize, *const f64, *mut f64, *mut f64) -> i32,
    pub(crate) user: *mut c_void,
}

// SAFETY: the pointer is handed through, never followed, and the function is called by the thread that evaluates the
// context only; the host promises in `fmc_shape` that it may be called from whichever that is.
unsafe impl Send for Callback {}
// SAFETY: as above; evaluations of one context exclude one another.
unsafe impl Sync for Callback {}

impl<const D: usize> SignedDistance<D> for Callback {
    fn evaluate(&self, x: &[[f64; D]], phi: &mut [f64], gradient: &mut [[f64; D]]) -> Result<(), usize> {
        if x.is_empty() {
            return Ok(());
        }
        // An entry that the callback forgets must not pass for a distance.
        phi.fill(f64::NAN);
        gradient.fill([f64::NAN; D]);
        // SAFETY: all three arrays have x.len() rows; the host guarantees a function that keeps to its contract.
        let code = unsafe {
            (self.function)(
                self.user,
                x.len(),
                x.as_ptr().cast(),
                phi.as_mut_ptr().cast(),
                gradient.as_mut_ptr().cast(),
            )
        };
        if code == 0 { Ok(()) } else { Err((usize::try_from(code).unwrap_or(1) - 1).min(x.len() - 1)) }
    }
}
