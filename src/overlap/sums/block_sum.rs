//! Sums of blocks by row and column.

use crate::geometry::Vector;
use crate::ranks::{Packed, packed};
use rustc_hash::FxHashMap;

/// A block ∂²w/∂x_row ∂x_col.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Block<const D: usize> {
    /// Node of the rows.
    pub row: u32,
    /// Node of the columns.
    pub col: u32,
    /// Entries, row by row.
    pub value: [[f64; D]; D],
}

/// A sparse matrix of blocks that grows as blocks are added; those of one place are summed in the order in which they
/// come. A row has few columns, which are run through: that is faster than any search among so few.
#[derive(Default)]
pub(crate) struct BlockSum<const D: usize> {
    rows: Vec<Row<D>>,
    /// Where among these a node's row is. Never iterated over: its order is not ours.
    place: FxHashMap<u32, u32>,
}

struct Row<const D: usize> {
    node: u32,
    cols: Vec<u32>,
    values: Vec<[[f64; D]; D]>,
}

impl<const D: usize> Row<D> {
    /// Adds several. Nodes of one cell came here together, and mostly stand side by side.
    fn add_all(&mut self, cols: &[u32], values: &[[[f64; D]; D]]) {
        let mut next = 0;
        for (&col, value) in cols.iter().zip(values) {
            if self.cols.get(next) != Some(&col) {
                next = self.place_of(col);
            }
            add_to(&mut self.values[next], value);
            next += 1;
        }
    }

    fn add(&mut self, col: u32, value: &[[f64; D]; D]) {
        let place = self.place_of(col);
        add_to(&mut self.values[place], value);
    }

    fn place_of(&mut self, col: u32) -> usize {
        self.cols.iter().position(|c| *c == col).unwrap_or_else(|| {
            self.cols.push(col);
            self.values.push([[0.0; D]; D]);
            self.cols.len() - 1
        })
    }
}

/// Columns for which a row has room from the start.
const ROOM: usize = 32;

fn add_to<const D: usize>(sum: &mut [[f64; D]; D], value: &[[f64; D]; D]) {
    for (sum, value) in sum.iter_mut().zip(value) {
        for (sum, value) in sum.iter_mut().zip(value) {
            *sum += value;
        }
    }
}

packed!(Row<D> { node, cols, values });

impl<const D: usize> Packed for BlockSum<D> {
    fn pack(&self, bytes: &mut Vec<u8>) {
        self.rows.pack(bytes);
    }

    fn unpack(bytes: &mut &[u8]) -> Option<Self> {
        let rows: Vec<Row<D>> = Vec::unpack(bytes)?;
        let place = rows.iter().map(|row| row.node).zip(0..).collect();
        Some(Self { rows, place })
    }

    fn blank() -> Self {
        Self::default()
    }
}

impl<const D: usize> BlockSum<D> {
    fn row(&mut self, node: u32) -> &mut Row<D> {
        let place = *self.place.entry(node).or_insert_with(|| {
            let (cols, values) = (Vec::with_capacity(ROOM), Vec::with_capacity(ROOM));
            self.rows.push(Row { node, cols, values });
            self.rows.len() as u32 - 1
        });
        &mut self.rows[place as usize]
    }

    /// Adds one block.
    pub(crate) fn add(&mut self, row: u32, col: u32, value: &[[f64; D]; D]) {
        self.row(row).add(col, value);
    }

    /// Adds p qᵀ, times `factor`.
    pub(crate) fn add_product(&mut self, row: u32, col: u32, factor: f64, p: &Vector<D>, q: &Vector<D>) {
        self.add(row, col, &product(factor, p, q));
    }

    /// Adds a square of blocks: `values[r * nodes.len() + c]` in the row of node r and the column of node c.
    pub(crate) fn add_square(&mut self, nodes: &[u32], values: &[[[f64; D]; D]]) {
        self.add_rectangle(nodes, nodes, values);
    }

    /// Adds blocks: `values[r * cols.len() + c]` in the row of node r and the column of node c.
    pub(crate) fn add_rectangle(&mut self, rows: &[u32], cols: &[u32], values: &[[[f64; D]; D]]) {
        for (&node, values) in rows.iter().zip(values.chunks_exact(cols.len().max(1))) {
            self.row(node).add_all(cols, values);
        }
    }

    /// Adds all of another sum.
    pub(crate) fn add_sum(&mut self, other: Self) {
        if self.rows.is_empty() {
            *self = other;
            return;
        }
        for Row { node, cols, values } in other.rows {
            self.row(node).add_all(&cols, &values);
        }
    }

    /// The blocks, sorted by row and column, one per place.
    pub(crate) fn into_blocks(mut self) -> Vec<Block<D>> {
        self.rows.sort_unstable_by_key(|row| row.node);
        let mut blocks = Vec::with_capacity(self.rows.iter().map(|row| row.cols.len()).sum());
        let mut order: Vec<(u32, u32)> = Vec::new();
        for Row { node, cols, values } in self.rows {
            order.clear();
            order.extend(cols.iter().copied().zip(0..));
            order.sort_unstable();
            blocks.extend(order.iter().map(|&(col, k)| Block { row: node, col, value: values[k as usize] }));
        }
        blocks
    }
}

/// factor · p qᵀ.
pub(crate) fn product<const D: usize>(factor: f64, p: &Vector<D>, q: &Vector<D>) -> [[f64; D]; D] {
    std::array::from_fn(|i| std::array::from_fn(|j| factor * p[i] * q[j]))
}

/// Sums what several matrices of sorted blocks have at one place.
pub(crate) fn merged<const D: usize>(mut parts: Vec<Vec<Block<D>>>) -> Vec<Block<D>> {
    if parts.len() < 2 {
        return parts.pop().unwrap_or_default();
    }
    // Runs that are sorted already are found by this sort, which leaves blocks of one place in the order of the parts.
    let mut blocks: Vec<Block<D>> = parts.into_iter().flatten().collect();
    blocks.sort_by_key(|block| (block.row, block.col));
    blocks.dedup_by(|next, sum| {
        let same = (next.row, next.col) == (sum.row, sum.col);
        if same {
            add_to(&mut sum.value, &next.value);
        }
        same
    });
    blocks
}

/// The symmetric part of a matrix of sorted blocks; the same bits where it is symmetric but for rounding.
pub(crate) fn symmetric_part<const D: usize>(blocks: Vec<Block<D>>) -> Vec<Block<D>> {
    let largest = blocks.iter().flat_map(|block| block.value.as_flattened()).fold(0.0f64, |m, x| m.max(x.abs()));
    // Row by row, what is looked for in a row comes later and later in it.
    let is_first = |&k: &usize| k == 0 || blocks[k - 1].row != blocks[k].row;
    let mut next: FxHashMap<u32, usize> = (0..blocks.len()).filter(is_first).map(|k| (blocks[k].row, k)).collect();
    let mut is_mirrored = |block: &Block<D>| {
        let mut mirror = None;
        if let Some(next) = next.get_mut(&block.col) {
            let in_row = |k: usize| blocks.get(k).filter(|other| other.row == block.col);
            while in_row(*next).is_some_and(|other| other.col < block.row) {
                *next += 1;
            }
            mirror = in_row(*next).filter(|other| other.col == block.row);
        }
        let at = |i: usize, j: usize| mirror.map_or(0.0, |other| other.value[j][i]);
        (0..D).all(|i| (0..D).all(|j| (block.value[i][j] - at(i, j)).abs() <= SYMMETRIC * largest))
    };
    if blocks.iter().all(&mut is_mirrored) {
        return blocks;
    }
    let half = |value: &[[f64; D]; D]| value.map(|row| row.map(|x| 0.5 * x));
    let transposed = |m: [[f64; D]; D]| std::array::from_fn(|i| std::array::from_fn(|j| m[j][i]));
    let halves = blocks.iter().map(|block| Block { value: half(&block.value), ..*block }).collect();
    let mut mirrored: Vec<Block<D>> = (blocks.iter())
        .map(|block| Block { row: block.col, col: block.row, value: transposed(half(&block.value)) })
        .collect();
    mirrored.sort_unstable_by_key(|block| (block.row, block.col));
    merged(vec![halves, mirrored])
}

/// Two entries that differ by no more than this part of the largest are equal but for rounding.
const SYMMETRIC: f64 = 1e-9;
