//! Arrays of the host for as many rows as the library finds: `(rows, capacity, &count)`; matrices in compressed rows are two of them.

use super::failure::Failure;
use super::index::{IndexSize, Places};
use super::pointer::{Output, check};
use super::status::fmc_status::FMC_ERROR_BUFFER_TOO_SMALL;
use std::ffi::c_void;

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

/// Where a matrix in compressed rows goes: an array of offsets, and columns with their values.
pub(crate) struct MatrixRoom {
    pub(crate) row_offsets: *mut c_void,
    pub(crate) offsets: Room,
    pub(crate) cols: *mut c_void,
    pub(crate) values: *mut f64,
    pub(crate) entries: Room,
    pub(crate) size: IndexSize,
}

/// The arrays that are wanted, checked for what goes into them.
pub(crate) struct MatrixPlaces {
    pub(crate) row_offsets: Option<Places>,
    pub(crate) cols: Option<(Places, *mut f64)>,
}

impl MatrixRoom {
    /// Checks the room for so many offsets and entries, of which no number is larger than `largest`.
    pub(crate) fn places(&self, offsets: usize, entries: usize, largest: usize) -> Result<MatrixPlaces, Failure> {
        let mut found = MatrixPlaces { row_offsets: None, cols: None };
        if self.offsets.is_asked("row offsets", &[self.row_offsets.is_null()], offsets)? {
            found.row_offsets = Some(Places::new("row_offsets", self.row_offsets, self.size)?);
        }
        if self.entries.is_asked("entries", &[self.cols.is_null(), self.values.is_null()], entries)? && entries > 0 {
            check("values", self.values.cast_const())?;
            found.cols = Some((Places::new("cols", self.cols, self.size)?, self.values));
        }
        self.size.holds(largest)?;
        Ok(found)
    }

    /// Tells both numbers, after all else.
    ///
    /// # Safety
    /// The host guarantees that they may be written.
    pub(crate) unsafe fn tell(self, offsets: usize, entries: usize) {
        // SAFETY: passed on to the caller.
        unsafe {
            self.offsets.tell(offsets);
            self.entries.tell(entries);
        }
    }

    /// Writes a matrix of numbers: rows that begin at `starts`, columns counted from zero, and values.
    ///
    /// # Safety
    /// The host guarantees the room that it says.
    pub(crate) unsafe fn write(
        self,
        starts: &[usize],
        cols: impl ExactSizeIterator<Item = usize>,
        col_count: usize,
        values: &[f64],
        base: i32,
    ) -> Result<(), Failure> {
        let entries = cols.len();
        let base = i64::from(base);
        let places = self.places(starts.len(), entries, entries.max(col_count) + 1)?;
        // SAFETY: room for as many as was checked.
        unsafe {
            if let Some(offsets) = places.row_offsets {
                starts.iter().enumerate().for_each(|(row, &start)| offsets.put(row, start as i64 + base));
            }
            if let Some((to, numbers)) = places.cols {
                for (place, (col, value)) in cols.zip(values).enumerate() {
                    to.put(place, col as i64 + base);
                    numbers.add(place).write(*value);
                }
            }
            self.tell(starts.len(), entries);
        }
        Ok(())
    }
}
