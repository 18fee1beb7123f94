//! Host arrays that end where readable memory ends: whoever reads or writes beyond the last entry is stopped there.

use std::ptr::NonNull;

/// `len` entries, the last of which is the last before a page that nobody may touch.
#[derive(Debug)]
pub struct Guarded<T> {
    base: NonNull<u8>,
    bytes: usize,
    data: NonNull<T>,
    len: usize,
}

const PAGE: usize = 4096;

impl<T: Copy> Guarded<T> {
    /// A copy of `values`.
    pub fn new(values: &[T]) -> Self {
        let needed = size_of_val(values).div_ceil(PAGE) * PAGE;
        let bytes = needed + PAGE;
        // SAFETY: a new anonymous mapping; the last page is closed; the values end at that page, and are aligned there as a
        // page is a multiple of any alignment and the size of `T` of its own.
        unsafe {
            let base = libc::mmap(
                std::ptr::null_mut(),
                bytes,
                libc::PROT_READ | libc::PROT_WRITE,
                libc::MAP_PRIVATE | libc::MAP_ANONYMOUS,
                -1,
                0,
            );
            assert!(base != libc::MAP_FAILED, "room for a small array");
            let base = base.cast::<u8>();
            assert_eq!(libc::mprotect(base.add(needed).cast(), PAGE, libc::PROT_NONE), 0);
            let data = base.add(needed - size_of_val(values)).cast::<T>();
            std::ptr::copy_nonoverlapping(values.as_ptr(), data, values.len());
            Self { base: NonNull::new_unchecked(base), bytes, data: NonNull::new_unchecked(data), len: values.len() }
        }
    }

    /// The first entry.
    pub fn ptr(&self) -> *mut T {
        self.data.as_ptr()
    }

    /// All entries as they are now.
    pub fn values(&self) -> Vec<T> {
        // SAFETY: `new` made so many; the library that wrote them has returned.
        unsafe { std::slice::from_raw_parts(self.data.as_ptr(), self.len) }.to_vec()
    }
}

impl<T> Drop for Guarded<T> {
    fn drop(&mut self) {
        // SAFETY: the mapping of `new`.
        unsafe { libc::munmap(self.base.as_ptr().cast(), self.bytes) };
    }
}
