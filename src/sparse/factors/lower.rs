//! Symmetric sparse matrices.

use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};

/// Row, column and value, row ≥ column; entries at one place add up.
pub type Entries = Vec<(usize, usize, f64)>;

/// Lower triangle of a symmetric matrix: column after column, rows ascending, no place twice.
#[derive(Clone, Debug, PartialEq)]
pub struct Lower {
    size: usize,
    starts: Vec<usize>,
    rows: Vec<usize>,
    values: Vec<f64>,
}

impl Lower {
    /// Matrix of `size` rows of these entries (row, column, value), which add up where they coincide; those above the
    /// diagonal are not looked at.
    pub fn new(size: usize, entries: impl Iterator<Item = (usize, usize, f64)>) -> Self {
        // What is generic is compiled by the caller: only this line.
        let entries =
            entries.filter(|(row, column, _)| row >= column).map(|(r, c, v)| (r as u32, c as u32, v)).collect();
        compressed(size, entries)
    }

    /// Number of rows.
    pub fn size(&self) -> usize {
        self.size
    }

    /// Entries as row, column and value.
    pub fn entries(&self) -> impl Iterator<Item = (usize, usize, f64)> {
        (0..self.size).flat_map(move |column| {
            let places = self.starts[column]..self.starts[column + 1];
            places.map(move |place| (self.rows[place], column, self.values[place]))
        })
    }

    /// The same with springs on its diagonal, where there is an entry.
    pub(super) fn with_springs(mut self, springs: &[f64]) -> Self {
        for (column, spring) in springs.iter().enumerate() {
            let first = self.starts[column];
            if first < self.starts[column + 1] && self.rows[first] == column {
                self.values[first] += spring;
            }
        }
        self
    }

    /// The whole matrix times a vector.
    pub fn product(&self, x: &[f64]) -> Vec<f64> {
        let mut y = vec![0.0; self.size];
        for (row, column, value) in self.entries() {
            y[row] += value * x[column];
            if row != column {
                y[column] += value * x[row];
            }
        }
        y
    }

    /// Rows of a column, ascending.
    pub(crate) fn rows_of(&self, column: usize) -> &[usize] {
        &self.rows[self.starts[column]..self.starts[column + 1]]
    }

    pub(crate) fn has_pattern_of(&self, other: &Self) -> bool {
        self.starts == other.starts && self.rows == other.rows
    }

    pub(crate) fn pattern(&self) -> SymbolicSparseColMatRef<'_, usize> {
        SymbolicSparseColMatRef::new_checked(self.size, self.size, &self.starts, None, &self.rows)
    }

    pub(crate) fn view(&self) -> SparseColMatRef<'_, usize, f64> {
        SparseColMatRef::new(self.pattern(), &self.values)
    }
}

/// Entries sorted by column and row, summed up. Sorted by counting, as there are many.
fn compressed(size: usize, entries: Vec<(u32, u32, f64)>) -> Lower {
    let by_row = sorted_by(size, &entries, |entry| entry.0);
    let by_column = sorted_by(size, &by_row, |entry| entry.1);
    let mut lower = Lower { size, starts: vec![0], rows: Vec::new(), values: Vec::new() };
    let mut last = (u32::MAX, u32::MAX);
    for (row, column, value) in by_column {
        if (row, column) == last {
            *lower.values.last_mut().expect("an entry before") += value;
            continue;
        }
        while lower.starts.len() <= column as usize {
            lower.starts.push(lower.values.len());
        }
        lower.rows.push(row as usize);
        lower.values.push(value);
        last = (row, column);
    }
    lower.starts.resize(size + 1, lower.values.len());
    lower
}

/// Counting sort that keeps the order of equals.
fn sorted_by(size: usize, entries: &[(u32, u32, f64)], key: impl Fn(&(u32, u32, f64)) -> u32) -> Vec<(u32, u32, f64)> {
    let mut next = vec![0; size + 1];
    entries.iter().for_each(|entry| next[key(entry) as usize + 1] += 1);
    (0..size).for_each(|k| next[k + 1] += next[k]);
    let mut sorted = vec![(0, 0, 0.0); entries.len()];
    for entry in entries {
        let place = &mut next[key(entry) as usize];
        sorted[*place] = *entry;
        *place += 1;
    }
    sorted
}
