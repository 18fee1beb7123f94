//! The tangent as solvers want it: row by row.

use super::pattern::Pattern;
use super::tangent::Tangent;

/// A sparse matrix in compressed rows: row r has the columns `cols[offsets[r]..offsets[r + 1]]`, ascending, and at the
/// same places its values. With blocks for values, this is the format called BSR, and rows and columns are nodes.
#[derive(Clone, Debug, PartialEq)]
pub struct CompressedRows<V> {
    /// Where rows begin in the other two, one number more than there are rows, the last being their length.
    pub offsets: Vec<usize>,
    /// Columns.
    pub cols: Vec<u32>,
    /// Values.
    pub values: Vec<V>,
}

impl<const D: usize> Tangent<D> {
    /// Places (row, column) of the blocks, sorted.
    pub fn places(&self) -> impl Iterator<Item = (u32, u32)> {
        self.blocks.iter().map(|block| (block.row, block.col))
    }

    /// The blocks in compressed rows, rows without blocks included; the rank-one parts are not in them.
    ///
    /// The first `row_count` rows and columns: with the number of nodes that is the matrix of the mesh, with the number
    /// of obstacles added to it, that with the obstacles' translations. Places of `pattern` at which there is no block
    /// get one of zeros.
    pub fn compressed_rows(&self, row_count: usize, pattern: Option<&Pattern>) -> CompressedRows<[[f64; D]; D]> {
        let blocks = self.blocks.iter().map(|block| ((block.row, block.col), block.value));
        compressed(row_count, pattern, blocks, [[0.0; D]; D])
    }
}

/// Compressed rows of `blocks`, sorted by their places; `zero` where `pattern` has a place and `blocks` have none.
pub(crate) fn compressed<V: Copy>(
    row_count: usize,
    pattern: Option<&Pattern>,
    blocks: impl Iterator<Item = ((u32, u32), V)>,
    zero: V,
) -> CompressedRows<V> {
    let mut rows = CompressedRows { offsets: Vec::with_capacity(row_count + 1), cols: Vec::new(), values: Vec::new() };
    let mut put = |(row, col): (u32, u32), value: V| {
        if (row as usize) < row_count && (col as usize) < row_count {
            let begun = rows.offsets.len().max(row as usize + 1);
            rows.offsets.resize(begun, rows.cols.len());
            rows.cols.push(col);
            rows.values.push(value);
        }
    };
    let mut places = pattern.map_or(&[][..], Pattern::places).iter().copied().peekable();
    for (place, value) in blocks {
        while let Some(empty) = places.next_if(|other| *other < place) {
            put(empty, zero);
        }
        places.next_if_eq(&place);
        put(place, value);
    }
    places.for_each(|empty| put(empty, zero));
    rows.offsets.resize(row_count + 1, rows.cols.len());
    rows
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::overlap::Block;

    fn tangent() -> Tangent<2> {
        let block = |row, col, x: f64| Block { row, col, value: [[x, x + 1.0], [x + 2.0, x + 3.0]] };
        Tangent {
            blocks: vec![block(1, 1, 1.0), block(1, 4, 10.0), block(3, 0, 20.0), block(4, 1, 30.0)],
            rank_one: Vec::new(),
        }
    }

    #[test]
    fn rows_without_blocks_are_there_and_those_beyond_are_not() {
        let rows = tangent().compressed_rows(4, None);
        assert_eq!(rows.offsets, [0, 0, 1, 1, 2]);
        assert_eq!(rows.cols, [1, 0]);
        assert_eq!(rows.values, [[[1.0, 2.0], [3.0, 4.0]], [[20.0, 21.0], [22.0, 23.0]]]);
        let all = tangent().compressed_rows(6, None);
        assert_eq!((all.offsets.as_slice(), all.cols.as_slice()), (&[0, 0, 2, 2, 3, 4, 4][..], &[1, 4, 0, 1][..]));
        assert_eq!(tangent().compressed_rows(0, None).offsets, [0]);
        assert_eq!(Tangent::<3>::default().compressed_rows(2, None).offsets, [0, 0, 0]);
    }

    #[test]
    fn a_pattern_grows_and_is_filled_with_zeros() {
        let mut pattern = Pattern::default();
        assert!(pattern.is_empty());
        pattern.add([(5, 5), (1, 1), (1, 0)]);
        pattern.add(tangent().places());
        assert_eq!(pattern.len(), 6);
        let rows = tangent().compressed_rows(6, Some(&pattern));
        assert_eq!(rows.offsets, [0, 0, 3, 3, 4, 5, 6]);
        assert_eq!(rows.cols, [0, 1, 4, 0, 1, 5]);
        assert_eq!([rows.values[0], rows.values[5]], [[[0.0; 2]; 2]; 2]);
        assert_eq!(rows.values[1], tangent().blocks[0].value);
        // What the pattern lacks is not lost.
        let mut narrow = Pattern::default();
        narrow.add([(0, 0)]);
        assert_eq!(tangent().compressed_rows(6, Some(&narrow)).cols, [0, 1, 4, 0, 1]);
    }
}
