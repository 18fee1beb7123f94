//! Lists of numbers of the host, 32 or 64 bits wide: nodes, cells, bodies' ids, degrees of freedom.

use super::failure::Failure;
use super::pointer::slice;
use super::status::fmc_status::{
    FMC_ERROR_INDEX_SIZE, FMC_ERROR_LENGTH, FMC_ERROR_MISALIGNED_POINTER, FMC_ERROR_NULL_POINTER,
};
use crate::Error;
use std::borrow::Cow;
use std::ffi::c_void;

/// How wide a number is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum IndexSize {
    Four,
    Eight,
}

impl IndexSize {
    /// From the number of bytes that a host says.
    pub(crate) fn new(of: &str, bytes: i32) -> Result<Self, Failure> {
        match bytes {
            4 => Ok(Self::Four),
            8 => Ok(Self::Eight),
            _ => {
                let text = format!("the index_size of {of} is {bytes}, not 4 or 8");
                Err(Failure::new(FMC_ERROR_INDEX_SIZE, text))
            }
        }
    }

    /// The one that all of a list have; 32 bits of none.
    pub(crate) fn of_all(of: &str, bytes: impl IntoIterator<Item = i32>) -> Result<Self, Failure> {
        let mut found = None;
        for (index, bytes) in bytes.into_iter().enumerate() {
            let size = Self::new(&format!("{of} {index}"), bytes)?;
            if *found.get_or_insert(size) != size {
                let text = format!("{of} {index} has index_size {bytes}, and those before it have another one");
                return Err(Failure::new(FMC_ERROR_INDEX_SIZE, text));
            }
        }
        Ok(found.unwrap_or(Self::Four))
    }

    fn bytes(self) -> usize {
        match self {
            Self::Four => 4,
            Self::Eight => 8,
        }
    }

    /// `count · each` numbers at `pointer`, as they are written there.
    ///
    /// # Safety
    /// The host guarantees that many numbers of this width, unchanged for `'a`.
    pub(crate) unsafe fn list<'a>(
        self,
        name: &str,
        pointer: *const c_void,
        count: usize,
        each: usize,
    ) -> Result<Cow<'a, [i64]>, Failure> {
        // SAFETY: passed on to the caller.
        Ok(match self {
            Self::Four => {
                let given = unsafe { slice(name, pointer.cast::<i32>(), count, each) }?;
                Cow::Owned(Error::collected("numbers of the host", given.iter().map(|&number| number.into()))?)
            }
            Self::Eight => Cow::Borrowed(unsafe { slice(name, pointer.cast::<i64>(), count, each) }?),
        })
    }

    /// Whether a number that goes out fits.
    pub(crate) fn holds(self, largest: usize) -> Result<(), Failure> {
        let fits = match self {
            Self::Four => i32::try_from(largest).is_ok(),
            Self::Eight => i64::try_from(largest).is_ok(),
        };
        if fits {
            return Ok(());
        }
        let text = format!("{largest} entries, rows or columns cannot be numbered in {} bits", 8 * self.bytes());
        Err(Failure::new(FMC_ERROR_LENGTH, text))
    }
}

/// An array of the host for numbers, checked before the work.
#[derive(Clone, Copy)]
pub(crate) struct Places {
    pointer: *mut c_void,
    size: IndexSize,
}

impl Places {
    pub(crate) fn new(name: &str, pointer: *mut c_void, size: IndexSize) -> Result<Self, Failure> {
        if pointer.is_null() {
            return Err(Failure::new(FMC_ERROR_NULL_POINTER, format!("'{name}' is NULL")));
        }
        if !pointer.addr().is_multiple_of(size.bytes()) {
            let text = format!("'{name}' is not aligned to {} bytes", size.bytes());
            return Err(Failure::new(FMC_ERROR_MISALIGNED_POINTER, text));
        }
        Ok(Self { pointer, size })
    }

    /// Writes a number that fits.
    ///
    /// # Safety
    /// The host guarantees room for it.
    pub(crate) unsafe fn put(self, place: usize, number: i64) {
        // SAFETY: not NULL and aligned as checked; the caller guarantees the room.
        unsafe {
            match self.size {
                IndexSize::Four => self.pointer.cast::<i32>().add(place).write(number as i32),
                IndexSize::Eight => self.pointer.cast::<i64>().add(place).write(number),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn either_width_is_read_and_written() {
        let (narrow, wide) = ([1_i32, -2, 3], [1_i64, -2, 1 << 40]);
        // SAFETY: arrays of three numbers.
        unsafe {
            let list = |size: IndexSize, pointer| size.list("nodes", pointer, 3, 1).unwrap().into_owned();
            assert_eq!(list(IndexSize::Four, narrow.as_ptr().cast()), [1, -2, 3]);
            assert_eq!(list(IndexSize::Eight, wide.as_ptr().cast()), wide);
            let mut written = [0_i32; 2];
            Places::new("nodes", written.as_mut_ptr().cast(), IndexSize::Four).unwrap().put(1, -7);
            assert_eq!(written, [0, -7]);
            let mut written = [0_i64; 2];
            Places::new("nodes", written.as_mut_ptr().cast(), IndexSize::Eight).unwrap().put(1, 1 << 40);
            assert_eq!(written, [0, 1 << 40]);
        }
    }

    #[test]
    fn numbers_that_do_not_fit_are_refused() {
        assert!(IndexSize::Four.holds(i32::MAX as usize).is_ok());
        let refused = IndexSize::Four.holds(1 << 31).map_err(|failure| (failure.status, failure.text));
        let text = "2147483648 entries, rows or columns cannot be numbered in 32 bits".to_owned();
        assert_eq!(refused, Err((FMC_ERROR_LENGTH, text)));
        assert!(IndexSize::Eight.holds(1 << 31).is_ok());
    }

    #[test]
    fn widths_that_are_none_or_differ_are_named() {
        let text =
            |sizes: &[i32]| IndexSize::of_all("cell block", sizes.iter().copied()).map_err(|failure| failure.text);
        assert_eq!(text(&[]), Ok(IndexSize::Four));
        assert_eq!(text(&[8, 8]), Ok(IndexSize::Eight));
        assert_eq!(text(&[4, 2]), Err("the index_size of cell block 1 is 2, not 4 or 8".into()));
        assert_eq!(text(&[4, 8]), Err("cell block 1 has index_size 8, and those before it have another one".into()));
    }
}
