//! A sparse matrix of the host.

use crate::Error;
use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::given_struct::check_struct;
use crate::capi::boundary::index::IndexSize;
use crate::capi::boundary::pointer::{Output, slice};
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::{FMC_ERROR_BAD_VALUE, FMC_ERROR_LENGTH};
use std::ffi::c_void;
use std::ptr::null;

/// A sparse matrix of the host in compressed rows (CSR): row r has the entries from `row_offsets[r]` to `row_offsets[r + 1]`, in any
/// order; entries at one place add up. Initialise it with `fmc_csr_init`, then set all fields.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct fmc_csr {
    /// Set by `fmc_csr_init`, so that the library recognises an uninitialised struct.
    pub struct_size: usize,
    /// Number of rows.
    pub row_count: usize,
    /// Bytes of an offset and of a column, 4 or 8.
    pub index_size: i32,
    /// First number of offsets, rows and columns, 0 or 1.
    pub index_base: i32,
    /// Where rows begin, and the last one ends: `row_count` + 1 numbers.
    pub row_offsets: *const c_void,
    /// Column of every entry.
    pub cols: *const c_void,
    /// Value of every entry.
    pub values: *const f64,
    /// Zero. Room for later versions.
    pub reserved: [u64; 4],
}

impl Default for fmc_csr {
    fn default() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            row_count: 0,
            index_size: 0,
            index_base: 0,
            row_offsets: null(),
            cols: null(),
            values: null(),
            reserved: [0; 4],
        }
    }
}

/// Sets all fields to zero and NULL.
///
/// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_csr_init(matrix: *mut fmc_csr) -> fmc_status {
    entry(|| {
        let output = Output::required("matrix", matrix)?;
        // SAFETY: the host passes a struct that may be written.
        unsafe { output.write(fmc_csr::default()) };
        Ok(())
    })
}

/// The matrix with offsets and columns counted from zero. Columns may be beyond it, or negative.
pub(crate) struct Matrix<'a> {
    pub(crate) offsets: Vec<i64>,
    pub(crate) cols: Vec<i64>,
    pub(crate) values: &'a [f64],
}

impl fmc_csr {
    /// Width of its numbers, where it was initialised.
    pub(crate) fn checked_size(&self) -> Result<IndexSize, Failure> {
        check_struct::<Self>("fmc_csr", self.struct_size, self.reserved)?;
        if !(0..=1).contains(&self.index_base) {
            let text = format!("the index_base of fmc_csr is {}, not 0 or 1", self.index_base);
            return Err(Failure::new(FMC_ERROR_BAD_VALUE, text));
        }
        IndexSize::new("fmc_csr", self.index_size)
    }

    /// Reads it; offsets ascend from zero.
    ///
    /// # Safety
    /// The host guarantees the arrays, unchanged for `'a`.
    pub(crate) unsafe fn read<'a>(&self, row_count: usize) -> Result<Matrix<'a>, Failure> {
        let size = self.checked_size()?;
        if self.row_count != row_count {
            let text = format!("the matrix has {} rows, and {row_count} are expected", self.row_count);
            return Err(Failure::new(FMC_ERROR_LENGTH, text));
        }
        let zero_based = |number: &i64| number.saturating_sub(self.index_base.into());
        let mut offsets = vec![0];
        if row_count > 0 {
            // SAFETY: passed on to the caller.
            let given = unsafe { size.list("row_offsets", self.row_offsets, row_count.saturating_add(1), 1) }?;
            offsets = Error::collected("row offsets", given.iter().map(zero_based))?;
        }
        if offsets[0] != 0 || !offsets.is_sorted() {
            let text = format!("the row offsets do not ascend from {}", self.index_base);
            return Err(Failure::new(FMC_ERROR_LENGTH, text));
        }
        let count = offsets[row_count] as usize;
        // SAFETY: passed on to the caller.
        let (cols, values) =
            unsafe { (size.list("cols", self.cols, count, 1)?, slice("values", self.values, count, 1)?) };
        Ok(Matrix { offsets, cols: Error::collected("columns", cols.iter().map(zero_based))?, values })
    }
}
