//! Sparse matrices by their entries.

/// Entries of a sparse square matrix; entries at the same place add up.
///
/// A degree of freedom is `node · D + axis`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Triplets {
    /// Number of rows and columns.
    pub size: usize,
    /// Row of every entry.
    pub rows: Vec<u32>,
    /// Column of every entry.
    pub columns: Vec<u32>,
    /// Value of every entry.
    pub values: Vec<f64>,
}

impl Triplets {
    /// Entries as row, column and value.
    pub fn iter(&self) -> impl Iterator<Item = (usize, usize, f64)> {
        self.rows
            .iter()
            .zip(&self.columns)
            .zip(&self.values)
            .map(|((&row, &column), &value)| (row as usize, column as usize, value))
    }

    /// Matrix times vector.
    pub fn product(&self, x: &[f64]) -> Vec<f64> {
        let mut y = vec![0.0; self.size];
        self.iter().for_each(|(row, column, value)| y[row] += value * x[column]);
        y
    }

    /// Adds an entry.
    pub fn push(&mut self, row: usize, column: usize, value: f64) {
        self.rows.push(row as u32);
        self.columns.push(column as u32);
        self.values.push(value);
    }
}
