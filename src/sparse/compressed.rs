//! Sparse matrices as hosts have them.

/// A symmetric matrix in compressed rows, which are its columns too: all entries, or none above the diagonal.
#[derive(Clone, Copy, Debug)]
pub struct Compressed<'a> {
    /// Where each row begins, and where the last one ends.
    pub offsets: &'a [i64],
    /// Column of every entry; entries of one row in any order, those at one place add up.
    pub columns: &'a [i64],
    /// Values.
    pub values: &'a [f64],
}

impl Compressed<'_> {
    /// Number of rows.
    pub fn size(&self) -> usize {
        self.offsets.len().saturating_sub(1)
    }
}
