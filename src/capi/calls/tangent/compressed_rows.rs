//! The tangent in compressed rows, of numbers or of blocks, on a pattern that may be kept.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::list::{MatrixRoom, Room};
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::{FMC_ERROR_BAD_VALUE, FMC_ERROR_UNKNOWN_FLAG};
use crate::capi::context::state::{State, fmc_context, read, write};
use crate::contact::CompressedRows;
use std::ffi::c_void;

/// Flag of `fmc_context_tangent_csr`: entries are blocks of dim x dim (BSR), rows and columns nodes.
pub const FMC_CSR_BLOCKS: u32 = 4;

/// Flag of `fmc_context_tangent_csr`: with rows and columns of the obstacles' translations, after the rows of the
/// nodes.
pub const FMC_CSR_OBSTACLES: u32 = 8;

/// The rows that a host has asked for.
struct Rows<'a> {
    dim: usize,
    /// Numbers that a node has in a row: 1 of blocks, `dim` of numbers.
    per_node: usize,
    blocks: CompressedRows<Option<&'a [f64]>>,
}

impl<'a> Rows<'a> {
    fn new(state: &'a State, flags: u32) -> Result<Self, Failure> {
        if flags & !(FMC_CSR_BLOCKS | FMC_CSR_OBSTACLES) != 0 {
            return Err(Failure::new(FMC_ERROR_UNKNOWN_FLAG, format!("unknown flag in {flags:#x}")));
        }
        let kept = &state.tangent;
        let obstacles = if flags & FMC_CSR_OBSTACLES != 0 { kept.obstacle_count } else { 0 };
        Ok(Self {
            dim: kept.dim,
            per_node: if flags & FMC_CSR_BLOCKS != 0 { 1 } else { kept.dim },
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
                offset(node * per + axis, begin);
                for (place, block) in row.clone().enumerate() {
                    // Row `axis` of the block, or all of it.
                    let numbers = values[block].map(|values| &values[axis * width..(axis + 1) * width]);
                    for of_col in 0..per {
                        let each = numbers.map(|numbers| if per == 1 { numbers } else { &numbers[of_col..=of_col] });
                        put(begin + place * per + of_col, cols[block] as usize * per + of_col, each);
                    }
                }
            }
        }
        offset(self.row_count(), self.entry_count());
    }
}

/// The last tangent in compressed rows (CSR), without its terms of rank one (`fmc_context_tangent_rank_one`). Row r has the entries
/// from `row_offsets[r]` to `row_offsets[r + 1]`, in ascending order of their columns `cols`, each column once. Rows and columns are
/// degrees of freedom as in `fmc_context_tangent`; rows without entries are there too. Offsets and columns count from the option
/// `index_base`. Before the first tangent there are no rows.
///
/// `flags`: `FMC_CSR_BLOCKS`, for entries that are blocks, `values[(entry * dim + i) * dim + j]`, and rows and columns that
/// are nodes; `FMC_CSR_OBSTACLES`.
///
/// `offset_count` becomes the number of offsets, one more than there are rows, and `count` the number of entries, which are numbers, or
/// blocks. `row_offsets` has room for `offset_capacity`, `cols` for `capacity`, and `values` for as many, or, with `FMC_CSR_BLOCKS`, for
/// `capacity * dim * dim` numbers. An array that is NULL with capacity 0 is not written: only its number is returned.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_UNKNOWN_FLAG`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_LENGTH` where a number
/// does not fit into the context's numbers, `FMC_ERROR_BUSY`; no output is then written. Threads: several at once on one context,
/// as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_tangent_csr(
    context: *const fmc_context,
    flags: u32,
    row_offsets: *mut c_void,
    offset_capacity: usize,
    offset_count: *mut usize,
    cols: *mut c_void,
    values: *mut f64,
    capacity: usize,
    count: *mut usize,
) -> fmc_status {
    entry(|| {
        let (offsets, entries) = (Room::new(offset_capacity, offset_count)?, Room::new(capacity, count)?);
        // SAFETY: the host passes a context.
        let state = unsafe { read(context) }?;
        let room = MatrixRoom { row_offsets, offsets, cols, values, entries, size: state.index_size };
        let rows = Rows::new(&state, flags)?;
        let (row_count, entry_count) = (rows.row_count(), rows.entry_count());
        let places = room.places(row_count + 1, entry_count, row_count.max(entry_count) + 1)?;
        let width = if rows.per_node == 1 { rows.dim * rows.dim } else { 1 };
        let base = i64::from(state.index_base);
        rows.visit(
            |row, begin| {
                if let Some(offsets) = places.row_offsets {
                    // SAFETY: there is room for one more than there are rows, as checked.
                    unsafe { offsets.put(row, begin as i64 + base) };
                }
            },
            |place, col, numbers| {
                if let Some((cols, values)) = places.cols {
                    // SAFETY: there is room for as many entries, as checked, and as many numbers for each.
                    unsafe {
                        cols.put(place, col as i64 + base);
                        for k in 0..width {
                            values.add(place * width + k).write(numbers.map_or(0.0, |numbers| numbers[k]));
                        }
                    }
                }
            },
        );
        // SAFETY: the counts, where asked for, may be written.
        unsafe { room.tell(row_count + 1, entry_count) };
        Ok(())
    })
}

/// Keeps the pattern of `fmc_context_tangent_csr`, with `keep` 1: from the last tangent on it only grows, and places
/// that no longer have an entry hold zeros. While the numbers of rows and entries stay the same, the pattern is the
/// same too. So a host's matrix and its symbolic factorisation can stay during a load step. 0 releases it: every
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
    use crate::capi::boundary::status::fmc_status::FMC_OK;
    use crate::capi::calls::mesh::creation::fmc_context_new_from_cells;
    use crate::capi::calls::mesh::release::fmc_context_free;
    use crate::capi::calls::tangent::entries::fmc_context_tangent;
    use crate::capi::structs::mesh::{fmc_cell_block, fmc_cell_type};
    use crate::capi::structs::options::fmc_options;
    use crate::capi::structs::view::fmc_coords;
    use std::ptr::{null, null_mut};

    /// Two squares, the second this far to the right of where it meets the first.
    fn squares(apart: f64) -> [[f64; 2]; 8] {
        let x = 0.9 + apart;
        [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [x, 0.1], [x + 1.0, 0.1], [x + 1.0, 1.1], [x, 1.1]]
    }

    /// Numbers of rows and of blocks of the tangent at these coordinates.
    fn sizes(context: *mut fmc_context, coords: &[[f64; 2]; 8]) -> [usize; 2] {
        let view = fmc_coords { data: coords.as_ptr().cast(), node_count: 8, node_stride: 2, axis_stride: 1 };
        let (mut offsets, mut blocks) = (0, 0);
        // SAFETY: a living context, a view of eight nodes, and no room but for the counts.
        unsafe {
            assert_eq!(fmc_context_tangent(context, &view, 0, null_mut()), FMC_OK);
            let (cols, values) = (null_mut(), null_mut());
            let status = fmc_context_tangent_csr(
                context,
                FMC_CSR_BLOCKS,
                null_mut(),
                0,
                &mut offsets,
                cols,
                values,
                0,
                &mut blocks,
            );
            assert_eq!(status, FMC_OK);
        }
        [offsets - 1, blocks]
    }

    #[test]
    fn a_pattern_is_kept_until_it_is_released() {
        let (together, apart) = (squares(0.0), squares(3.0));
        let conn = [0, 1, 2, 3, 4, 5, 6, 7i32];
        let block = fmc_cell_block {
            cell_type: fmc_cell_type::FMC_QUAD4 as i32,
            index_size: 4,
            conn: conn.as_ptr().cast(),
            cell_count: 2,
        };
        let view = fmc_coords { data: together.as_ptr().cast(), node_count: 8, node_stride: 2, axis_stride: 1 };
        let options = fmc_options { stiffness: 1e3, ..fmc_options::default() };
        let mut context = null_mut();
        // SAFETY: all arguments live through the call.
        unsafe {
            let status = fmc_context_new_from_cells(2, &view, &block, 1, null(), &options, &mut context);
            assert_eq!(status, FMC_OK);
            let met = sizes(context, &together);
            assert!(met[0] == 8 && met[1] > 0);
            assert_eq!(sizes(context, &apart), [8, 0]);
            sizes(context, &together);
            assert_eq!(fmc_context_keep_pattern(context, 1), FMC_OK);
            assert_eq!(sizes(context, &apart), met);
            assert_eq!(fmc_context_keep_pattern(context, 0), FMC_OK);
            assert_eq!(sizes(context, &apart), [8, 0]);
            assert_eq!(sizes(context, &together), met);
            // Another number changes nothing.
            assert_eq!(fmc_context_keep_pattern(context, 2), FMC_ERROR_BAD_VALUE);
            assert_eq!(sizes(context, &apart), [8, 0]);
            assert_eq!(fmc_context_free(&mut context), FMC_OK);
        }
    }
}
