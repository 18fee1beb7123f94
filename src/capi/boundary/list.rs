//! Arrays of the host for as many rows as the library finds: `(rows, capacity, &count)`.

use super::failure::Failure;
use super::pointer::{Output, check};
use super::status::fmc_status::FMC_ERROR_BUFFER_TOO_SMALL;

/// Room for rows, and where their number goes.
pub(crate) struct Room {
    capacity: usize,
    count: Output<usize>,
}

impl Room {
    /// `count` may be NULL for a host that knows it.
    pub(crate) fn new(capacity: usize, count: *mut usize) -> Result<Self, Failure> {
        Ok(Self { capacity, count: Output::optional("count", count)? })
    }

    /// Whether `needed` rows are to be written: not where none of the arrays is there, and no room, which asks for the number alone.
    pub(crate) fn is_asked(&self, what: &str, arrays: &[bool], needed: usize) -> Result<bool, Failure> {
        if self.capacity == 0 && arrays.iter().all(|is_null| *is_null) {
            return Ok(false);
        }
        if self.capacity < needed {
            let text = format!("there is room for {} {what}, and there are {needed}", self.capacity);
            return Err(Failure::new(FMC_ERROR_BUFFER_TOO_SMALL, text));
        }
        Ok(true)
    }

    /// Tells the number, after all else.
    ///
    /// # Safety
    /// The host guarantees that it may be written.
    pub(crate) unsafe fn tell(self, count: usize) {
        // SAFETY: passed on to the caller.
        unsafe { self.count.write(count) };
    }

    /// Writes rows of one array, and their number.
    ///
    /// # Safety
    /// The host guarantees room for `capacity` rows.
    pub(crate) unsafe fn write<T: Copy>(self, what: &str, name: &str, list: &[T], rows: *mut T) -> Result<(), Failure> {
        let is_asked = self.is_asked(what, &[rows.is_null()], list.len())?;
        if is_asked && !list.is_empty() {
            check(name, rows.cast_const())?;
            // SAFETY: not NULL and aligned; room for the list as just checked, which is our own and cannot overlap it.
            unsafe { std::ptr::copy_nonoverlapping(list.as_ptr(), rows, list.len()) };
        }
        // SAFETY: passed on to the caller.
        unsafe { self.tell(list.len()) };
        Ok(())
    }
}
