//! Functions of the host that the library calls, right or wrong.

use super::array::checked;
use crate::interface::*;
use crate::program::Fault;
use std::ffi::{CStr, c_char, c_void};
use std::ptr::{null, null_mut};

/// What a callback needs; it outlives the context.
pub(super) struct Distance {
    pub(super) dim: usize,
    pub(super) radius: f64,
    pub(super) fault: Fault,
    pub(super) context: *mut fmc_context,
}

/// # Safety
/// As the header says of the callback; `user` is a [`Distance`].
pub(super) unsafe extern "C" fn distance(
    user: *mut c_void,
    n: usize,
    x: *const f64,
    phi: *mut f64,
    grad: *mut f64,
) -> i32 {
    // SAFETY: the library hands on the pointer, and rooms for n points.
    unsafe {
        let this = &*user.cast::<Distance>();
        match this.fault {
            Fault::Returns(status) if status != 0 => return status,
            Fault::WritesNothing => return 0,
            Fault::CallsBack => {
                let status = fmc_context_evaluate(this.context, null(), null(), 0, null_mut());
                assert!(this.context.is_null() || status == FMC_ERROR_BUSY, "status {status} from inside a callback");
            }
            _ => {}
        }
        for point in 0..n {
            let x = std::slice::from_raw_parts(x.add(point * this.dim), this.dim);
            let length = x.iter().map(|x| x * x).sum::<f64>().sqrt();
            let steep = if this.fault == Fault::Steep { 1e3 } else { 1.0 };
            *phi.add(point) = if this.fault == Fault::WritesNan { f64::NAN } else { steep * (length - this.radius) };
            for (axis, x) in x.iter().enumerate() {
                *grad.add(point * this.dim + axis) = if this.fault == Fault::NoGradient { 0.0 } else { *x };
            }
        }
        0
    }
}

/// What places the nodes of a contact step.
pub(super) struct Placed {
    pub(super) context: *mut fmc_context,
    pub(super) fault: Fault,
    pub(super) width: usize,
}

/// # Safety
/// As the header says of the callback; `user` is a [`Placed`].
pub(super) unsafe extern "C" fn place(user: *mut c_void, n: usize, displacement: *const f64, coords: *mut f64) -> i32 {
    // SAFETY: the library hands on the pointer, n numbers, and coordinates of at least one node.
    unsafe {
        let this = &*user.cast::<Placed>();
        match this.fault {
            Fault::Returns(status) => return status,
            Fault::WritesNan => coords.write(f64::NAN),
            Fault::CallsBack => {
                let status = fmc_context_evaluate(this.context, null(), null(), 0, null_mut());
                assert!(status == FMC_ERROR_BUSY, "status {status} from inside a callback");
            }
            Fault::Steep if n > 0 => *coords.add(this.width - 1) += 1e3 * *displacement,
            _ => {}
        }
    }
    0
}

/// # Safety
/// As the header says of the callback; `user` is the context, or NULL.
pub(super) unsafe extern "C" fn log(user: *mut c_void, level: i32, text: *const c_char) {
    // SAFETY: the text is valid during the call, and the context lives.
    unsafe {
        assert!(level == 1 && !CStr::from_ptr(text).to_bytes().is_empty());
        let mut count = 0usize;
        checked(fmc_context_counts(user.cast(), &raw mut count, null_mut(), null_mut()));
    }
}

/// Lets a call go on.
///
/// # Safety
/// As the header says of the callback; `user` is the context, which is busy.
pub(super) unsafe extern "C" fn go_on(user: *mut c_void) -> i32 {
    let mut count = 0usize;
    // SAFETY: the context lives.
    checked(unsafe { fmc_context_counts(user.cast(), &raw mut count, null_mut(), null_mut()) });
    0
}

/// Gathers what this rank sends as if all had sent it.
///
/// # Safety
/// That of `fmc_all_gather`; `user` is the rank and 256 times their number.
pub(crate) unsafe extern "C" fn echo(
    user: *mut c_void,
    send: *const c_void,
    counts: *const u64,
    received: *mut c_void,
) -> i32 {
    // SAFETY: there is one count for every rank, and all are the same.
    unsafe {
        let own = *counts.add(user.addr() % 256) as usize;
        let mut at = received.cast::<u8>();
        for rank in 0..user.addr() / 256 {
            let count = *counts.add(rank) as usize;
            std::ptr::copy_nonoverlapping(send.cast::<u8>(), at, count.min(own));
            at = at.add(count);
        }
    }
    0
}

/// One rank, which sends to itself.
///
/// # Safety
/// That of `fmc_all_to_all`.
pub(crate) unsafe extern "C" fn to_itself(
    _: *mut c_void,
    send: *const c_void,
    send_counts: *const u64,
    received: *mut c_void,
    received_counts: *const u64,
) -> i32 {
    // SAFETY: there is one count of either kind.
    unsafe {
        assert_eq!(*send_counts, *received_counts);
        std::ptr::copy_nonoverlapping(send.cast::<u8>(), received.cast(), *send_counts as usize);
    }
    0
}

/// # Safety
/// That of `fmc_all_gather`.
pub(super) unsafe extern "C" fn fails_to_gather(
    _: *mut c_void,
    _: *const c_void,
    _: *const u64,
    _: *mut c_void,
) -> i32 {
    3
}
