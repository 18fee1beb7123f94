//! Host arrays that end where readable memory ends: whoever reads or writes beyond the last entry is stopped there.

use std::cell::RefCell;
use std::collections::HashMap;
use std::ptr::NonNull;

/// `len` entries, the last of which is the last before a page that nobody may touch.
#[derive(Debug)]
pub struct Guarded<T> {
    base: NonNull<u8>,
    needed: usize,
    data: NonNull<T>,
    len: usize,
}

const PAGE: usize = 4096;

/// Mappings of one size that are kept for the next array: a mapping costs three calls of the system, more than most calls of
/// the library.
const MOST_KEPT: usize = 64;

/// Every so many arrays one is given back to the system, so that whoever reads it after its end is stopped there too.
const GIVEN_BACK: u64 = 16;

/// What is left in an array that has ended: no number, and no index.
const ENDED: u8 = 0xff;

#[derive(Default)]
struct Kept {
    /// By the bytes before the closed page.
    mappings: HashMap<usize, Vec<NonNull<u8>>>,
    ended: u64,
}

thread_local! {
    static KEPT: RefCell<Kept> = RefCell::default();
}

/// So many bytes, whole pages, and a closed page behind them.
fn mapping(needed: usize) -> NonNull<u8> {
    if let Some(kept) = KEPT.with_borrow_mut(|kept| kept.mappings.get_mut(&needed).and_then(Vec::pop)) {
        return kept;
    }
    // SAFETY: a new anonymous mapping, the last page of which is closed.
    unsafe {
        let base = libc::mmap(
            std::ptr::null_mut(),
            needed + PAGE,
            libc::PROT_READ | libc::PROT_WRITE,
            libc::MAP_PRIVATE | libc::MAP_ANONYMOUS,
            -1,
            0,
        );
        assert!(base != libc::MAP_FAILED, "room for a small array");
        let base = base.cast::<u8>();
        assert_eq!(libc::mprotect(base.add(needed).cast(), PAGE, libc::PROT_NONE), 0);
        NonNull::new_unchecked(base)
    }
}

impl<T: Copy> Guarded<T> {
    /// A copy of `values`.
    pub fn new(values: &[T]) -> Self {
        let needed = size_of_val(values).div_ceil(PAGE) * PAGE;
        let base = mapping(needed);
        // SAFETY: the values end at the closed page, and are aligned there as a page is a multiple of any alignment and the
        // size of `T` of its own.
        let data = unsafe {
            let data = base.add(needed - size_of_val(values)).cast::<T>();
            std::ptr::copy_nonoverlapping(values.as_ptr(), data.as_ptr(), values.len());
            data
        };
        Self { base, needed, data, len: values.len() }
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
        // SAFETY: the bytes that `new` filled.
        unsafe { std::ptr::write_bytes(self.data.as_ptr().cast::<u8>(), ENDED, self.len * size_of::<T>()) };
        let is_kept = KEPT.try_with(|kept| {
            let mut kept = kept.borrow_mut();
            kept.ended += 1;
            let is_due = kept.ended.is_multiple_of(GIVEN_BACK);
            let of_this_size = kept.mappings.entry(self.needed).or_default();
            let has_room = of_this_size.len() < MOST_KEPT && self.needed <= 16 * PAGE && !is_due;
            if has_room {
                of_this_size.push(self.base);
            }
            has_room
        });
        if !is_kept.unwrap_or(false) {
            // SAFETY: a mapping of this size.
            unsafe { libc::munmap(self.base.as_ptr().cast(), self.needed + PAGE) };
        }
    }
}
