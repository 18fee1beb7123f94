//! The tangent in compressed rows, of numbers or of blocks, on a pattern that may be kept.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::pointer::{Output, check};
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::{
    FMC_ERROR_BAD_VALUE, FMC_ERROR_BUFFER_TOO_SMALL, FMC_ERROR_LENGTH, FMC_ERROR_UNKNOWN_FLAG,
};
use crate::capi::context::state::{State, fmc_context, read, write};
use crate::contact::CompressedRows;

/// Flag of `fmc_context_tangent_csr`: entries are blocks of dim x dim (BSR), rows and columns nodes.
pub const FMC_CSR_BLOCKS: u32 = 4;

/// Flag of `fmc_context_tangent_csr`: with rows and columns of the obstacles' translations, after those of the nodes.
pub const FMC_CSR_OBSTACLES: u32 = 8;

/// Flag of `fmc_context_tangent_csr`: `row_offsets` and `cols` count from 1, as in Fortran.
pub const FMC_FROM_ONE: u32 = 16;

/// The rows that a host has asked for.
struct Rows<'a> {
    dim: usize,
    /// Numbers that a node has in a row: 1 of blocks, `dim` of numbers.
    per_node: usize,
    base: usize,
    blocks: CompressedRows<Option<&'a [f64]>>,
}

impl<'a> Rows<'a> {
    fn new(state: &'a State, flags: u32) -> Result<Self, Failure> {
        if flags & !(FMC_CSR_BLOCKS | FMC_CSR_OBSTACLES | FMC_FROM_ONE) != 0 {
            return Err(Failure::new(FMC_ERROR_UNKNOWN_FLAG, format!("unknown flag in {flags:#x}")));
        }
        let kept = &state.tangent;
        let obstacles = if flags & FMC_CSR_OBSTACLES != 0 { kept.obstacle_count } else { 0 };
        Ok(Self {
            dim: kept.dim,
            per_node: if flags & FMC_CSR_BLOCKS != 0 { 1 } else { kept.dim },
            base: if flags & FMC_FROM_ONE != 0 { 1 } else { 0 },
            blocks: kept.rows(kept.node_count + obstacles, state.pattern.as_ref()),
        })
    }

    fn row_count(&self) -> usize {
        (self.blocks.offsets.len() - 1) * self.per_node
    }

    fn entry_count(&self) -> usize {
        self.blocks.cols.len() * self.per_node * self.per_node
    }

    /// Calls `offset` for every row and `put` for every entry: its place, its column, and its value or values, `None`
    /// for zeros.
    fn visit(&self, mut offset: impl FnMut(usize, usize), mut put: impl FnMut(usize, usize, Option<&[f64]>)) {
        let CompressedRows { offsets, cols, values } = &self.blocks;
        let (per, width) = (self.per_node, self.dim * self.dim / self.per_node.max(1));
        for (node, ends) in offsets.windows(2).enumerate() {
            let row = ends[0]..ends[1];
            for axis in 0..per {
                let begin = (row.start * per + axis * row.len()) * per;
                offset(node * per + axis, begin + self.base);
                for (place, block) in row.clone().enumerate() {
                    // Row `axis` of the block, or all of it.
                    let numbers = values[block].map(|values| &values[axis * width..(axis + 1) * width]);
                    for of_col in 0..per {
                        let each = numbers.map(|numbers| if per == 1 { numbers } else { &numbers[of_col..=of_col] });
                        put(begin + place * per + of_col, cols[block] as usize * per + of_col + self.base, each);
                    }
                }
            }
        }
        offset(self.row_count(), self.entry_count() + self.base);
    }
}

/// Sizes of the last tangent in compressed rows, for `fmc_context_tangent_csr` with the same flags: rows, those without
/// entries included, and entries, which are numbers, or blocks with `FMC_CSR_BLOCKS`. Either output may be NULL. Before the
/// first tangent there are no rows.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_UNKNOWN_FLAG`, `FMC_ERROR_BUSY`. Threads: several
/// at once on one context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_tangent_csr_size(
    context: *const fmc_context,
    flags: u32,
    row_count: *mut usize,
    entry_count: *mut usize,
) -> fmc_status {
    entry(|| {
        let row_output = Output::optional("row_count", row_count)?;
        let entry_output = Output::optional("entry_count", entry_count)?;
        // SAFETY: the host passes a context.
        let state = unsafe { read(context) }?;
        let rows = Rows::new(&state, flags)?;
        // SAFETY: the outputs, where given, may be written.
        unsafe {
            row_output.write(rows.row_count());
            entry_output.write(rows.entry_count());
        }
        Ok(())
    })
}

/// The last tangent in compressed rows (CSR), without its terms of rank one, which `fmc_context_tangent_rank_one` gives:
/// the entries of row r are those from `row_offsets[r]` to `row_offsets[r + 1]`, in ascending order of their columns
/// `cols`, each column once. Rows and columns are degrees of freedom, `node * dim + axis`.
///
/// `flags`: `FMC_CSR_BLOCKS`, for entries that are blocks, `values[(entry * dim + i) * dim + j]`, and rows and columns that
/// are nodes; `FMC_CSR_OBSTACLES`; `FMC_FROM_ONE`. As elsewhere in the tangent, the option `index_base` has no effect.
/// `row_offsets` has room for one number more than there are rows, `cols` for `capacity` entries, and `values` for as
/// many, or, with `FMC_CSR_BLOCKS`, `capacity * dim * dim` numbers.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_UNKNOWN_FLAG`, `FMC_ERROR_BUFFER_TOO_SMALL`,
/// `FMC_ERROR_LENGTH` where a number does not fit into 32 bits, `FMC_ERROR_BUSY`. Threads: several at once on one
/// context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_tangent_csr(
    context: *const fmc_context,
    flags: u32,
    row_offsets: *mut i32,
    cols: *mut i32,
    values: *mut f64,
    capacity: usize,
) -> fmc_status {
    // SAFETY: the host passes what the parameters say.
    entry(|| unsafe { write_rows(context, flags, row_offsets, cols, values, capacity) })
}

/// `fmc_context_tangent_csr` with 64-bit offsets and columns.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_tangent_csr_i64(
    context: *const fmc_context,
    flags: u32,
    row_offsets: *mut i64,
    cols: *mut i64,
    values: *mut f64,
    capacity: usize,
) -> fmc_status {
    // SAFETY: the host passes what the parameters say.
    entry(|| unsafe { write_rows(context, flags, row_offsets, cols, values, capacity) })
}

/// A number of the host's width.
fn number<Id: TryFrom<usize>>(number: usize) -> Result<Id, Failure> {
    Id::try_from(number).map_err(|_| {
        let text = format!("{number} entries, rows or columns cannot be numbered in {} bits", 8 * size_of::<Id>());
        Failure::new(FMC_ERROR_LENGTH, text)
    })
}

/// # Safety
/// As `fmc_context_tangent_csr`.
unsafe fn write_rows<Id: TryFrom<usize>>(
    context: *const fmc_context,
    flags: u32,
    row_offsets: *mut Id,
    cols: *mut Id,
    values: *mut f64,
    capacity: usize,
) -> Result<(), Failure> {
    // SAFETY: passed on to the caller.
    let state = unsafe { read(context) }?;
    let rows = Rows::new(&state, flags)?;
    let (row_count, entry_count) = (rows.row_count(), rows.entry_count());
    if capacity < entry_count {
        let text = format!("there is room for {capacity} entries, the rows of the tangent have {entry_count}");
        return Err(Failure::new(FMC_ERROR_BUFFER_TOO_SMALL, text));
    }
    number::<Id>(row_count.max(entry_count) + rows.base)?;
    check("row_offsets", row_offsets.cast_const())?;
    if entry_count > 0 {
        check("cols", cols.cast_const())?;
        check("values", values.cast_const())?;
    }
    let width = if rows.per_node == 1 { rows.dim * rows.dim } else { 1 };
    // No other number is larger than the one that was tried.
    let put_number = |pointer: *mut Id, place: usize, value: usize| {
        if let Ok(value) = Id::try_from(value) {
            // SAFETY: the host guarantees one place more than there are rows, and `capacity` entries.
            unsafe { pointer.add(place).write(value) };
        }
    };
    rows.visit(
        |row, begin| put_number(row_offsets, row, begin),
        |place, col, numbers| {
            put_number(cols, place, col);
            for k in 0..width {
                // SAFETY: the host guarantees as many numbers for each of `capacity` entries.
                unsafe { values.add(place * width + k).write(numbers.map_or(0.0, |numbers| numbers[k])) };
            }
        },
    );
    Ok(())
}

/// Keeps the pattern of `fmc_context_tangent_csr`, with `keep` 1: from the last tangent on it only grows, places that
/// have no entry any more hold zeros, and as long as `fmc_context_tangent_csr_size` gives the same numbers, the pattern
/// is the same too. So a host's matrix and its symbolic factorisation can stay during a load step. 0 releases it: every
/// tangent has its own pattern, which is the default. Values, and the other functions of the tangent, do not change.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BAD_VALUE` for another number, `FMC_ERROR_BUSY`. Threads: one call
/// at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_keep_pattern(context: *mut fmc_context, keep: i32) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context.
        unsafe {
            write(context, |state| match keep {
                0 => {
                    state.pattern = None;
                    Ok(())
                }
                1 => {
                    state.pattern.get_or_insert_default().add(state.tangent.places.iter().copied());
                    Ok(())
                }
                _ => Err(Failure::new(FMC_ERROR_BAD_VALUE, format!("'keep' is {keep}, not 0 or 1"))),
            })
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_that_do_not_fit_are_refused() {
        assert_eq!(number::<i32>(i32::MAX as usize).ok(), Some(i32::MAX));
        let refused = number::<i32>(1 << 31).err().map(|failure| (failure.status, failure.text));
        let text = "2147483648 entries, rows or columns cannot be numbered in 32 bits".to_owned();
        assert_eq!(refused, Some((FMC_ERROR_LENGTH, text)));
        assert_eq!(number::<i64>(1 << 31).ok(), Some(1 << 31));
    }
}
