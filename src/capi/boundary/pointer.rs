//! From pointers of the host to slices and references, checked for NULL, alignment and length.
//!
//! What no check can find out is promised by the host in the header: that the memory behind a pointer is as long as
//! the call says, is not written by another thread meanwhile, and lives until the call returns.

use super::failure::Failure;
use super::status::fmc_status::{FMC_ERROR_LENGTH, FMC_ERROR_MISALIGNED_POINTER, FMC_ERROR_NULL_POINTER};
use std::ffi::{CStr, c_char};

fn null(name: &str) -> Failure {
    Failure::new(FMC_ERROR_NULL_POINTER, format!("'{name}' is NULL"))
}

/// Refuses NULL and pointers that are not aligned for `T`.
pub(crate) fn check<T>(name: &str, pointer: *const T) -> Result<(), Failure> {
    if pointer.is_null() {
        return Err(null(name));
    }
    if !pointer.is_aligned() {
        let text = format!("'{name}' is not aligned to {} bytes", align_of::<T>());
        return Err(Failure::new(FMC_ERROR_MISALIGNED_POINTER, text));
    }
    Ok(())
}

/// `count · each` elements at `pointer`; none if that is zero, whatever the pointer.
///
/// # Safety
/// The host guarantees that many elements, unchanged for `'a`.
pub(crate) unsafe fn slice<'a, T>(
    name: &str,
    pointer: *const T,
    count: usize,
    each: usize,
) -> Result<&'a [T], Failure> {
    let addressable = isize::MAX as usize / size_of::<T>().max(1);
    let length = count.checked_mul(each).filter(|length| *length <= addressable).ok_or_else(|| {
        Failure::new(FMC_ERROR_LENGTH, format!("'{name}' is said to have {count} times {each} entries"))
    })?;
    if length == 0 {
        return Ok(&[]);
    }
    check(name, pointer)?;
    // SAFETY: not NULL, aligned and of addressable size as just checked; the caller guarantees the elements.
    Ok(unsafe { std::slice::from_raw_parts(pointer, length) })
}

/// Writes a list to an array of the host; an empty one is not written, whatever the pointer.
///
/// # Safety
/// The host guarantees room for the list.
pub(crate) unsafe fn copy_list<T: Copy>(name: &str, list: &[T], output: *mut T) -> Result<(), Failure> {
    if !list.is_empty() {
        check(name, output.cast_const())?;
        // SAFETY: not NULL and aligned as just checked; the caller guarantees the room, and the list is our own and cannot
        // overlap it.
        unsafe { std::ptr::copy_nonoverlapping(list.as_ptr(), output, list.len()) };
    }
    Ok(())
}

/// What `pointer` points to.
///
/// # Safety
/// The host guarantees an object there, unchanged for `'a`.
pub(crate) unsafe fn reference<'a, T>(name: &str, pointer: *const T) -> Result<&'a T, Failure> {
    check(name, pointer)?;
    // SAFETY: not NULL and aligned; the caller guarantees the object.
    Ok(unsafe { &*pointer })
}

/// The same where NULL means "none".
///
/// # Safety
/// As for [`reference`].
pub(crate) unsafe fn optional<'a, T>(name: &str, pointer: *const T) -> Result<Option<&'a T>, Failure> {
    // SAFETY: passed on to the caller.
    if pointer.is_null() { Ok(None) } else { unsafe { reference(name, pointer) }.map(Some) }
}

/// Text of the host.
///
/// # Safety
/// The host guarantees bytes up to and including a zero, unchanged for `'a`.
pub(crate) unsafe fn text<'a>(name: &str, pointer: *const c_char) -> Result<&'a str, Failure> {
    check(name, pointer)?;
    // SAFETY: not NULL; the caller guarantees the terminating zero.
    let bytes = unsafe { CStr::from_ptr(pointer) };
    // No option has a name or value beyond ASCII, so other text is an unknown one, whatever its encoding.
    Ok(bytes.to_str().unwrap_or("(not UTF-8)"))
}

/// Where one value goes: checked before the work, written after it.
pub(crate) struct Output<T> {
    pointer: *mut T,
}

impl<T> Output<T> {
    /// An output that must be there.
    pub(crate) fn required(name: &str, pointer: *mut T) -> Result<Self, Failure> {
        check(name, pointer)?;
        Ok(Self { pointer })
    }

    /// An output that the host may decline with NULL.
    pub(crate) fn optional(name: &str, pointer: *mut T) -> Result<Self, Failure> {
        if pointer.is_null() { Ok(Self { pointer }) } else { Self::required(name, pointer) }
    }

    /// Writes the value, or drops it where the host declined.
    ///
    /// # Safety
    /// The host guarantees that the pointer, if it is not NULL, may be written.
    pub(crate) unsafe fn write(self, value: T) {
        if !self.pointer.is_null() {
            // SAFETY: not NULL, aligned as checked at construction; the caller guarantees that it may be written.
            unsafe { self.pointer.write(value) };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zero_length_makes_the_pointer_irrelevant() {
        let misaligned = std::ptr::without_provenance::<f64>(3);
        for pointer in [std::ptr::null(), misaligned] {
            // SAFETY: nothing is read at length zero.
            assert!(unsafe { slice("coords", pointer, 0, 3) }.unwrap().is_empty());
        }
    }

    #[test]
    fn bad_pointers_and_lengths_are_named() {
        let failure = |pointer: *const f64, count, each| {
            // SAFETY: every pointer here is refused before it is read.
            let failure = unsafe { slice("coords", pointer, count, each) }.unwrap_err();
            (failure.status, failure.text)
        };
        assert_eq!(failure(std::ptr::null(), 1, 1), (FMC_ERROR_NULL_POINTER, "'coords' is NULL".into()));
        let misaligned = std::ptr::without_provenance::<f64>(3);
        assert_eq!(failure(misaligned, 1, 1).0, FMC_ERROR_MISALIGNED_POINTER);
        assert_eq!(failure(misaligned, usize::MAX, 2).0, FMC_ERROR_LENGTH);
        assert_eq!(failure(misaligned, usize::MAX / 8, 1).0, FMC_ERROR_LENGTH);
    }
}
