//! Sparse symmetric systems.
//!
//! A crate of its own, since faer's algorithms are compiled where they are first called: here, and not again with every
//! change of the solver and for each of its tests.

use faer::linalg::solvers::Solve;
use faer::sparse::linalg::solvers::{Llt, SymbolicLlt};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Mat, Side};

/// Cholesky factors L Lᵀ of a symmetric positive definite matrix; what depends on the pattern alone is kept for the next
/// matrix of the same pattern.
#[derive(Default)]
pub struct Factorisation {
    pattern: Option<(Pattern, SymbolicLlt<usize>)>,
    factors: Option<Llt<usize, f64>>,
    /// Times that a pattern was new.
    pub analyses: usize,
    /// Matrices factorised.
    pub count: usize,
}

/// Lower triangle, column after column, rows ascending.
#[derive(PartialEq)]
struct Pattern {
    starts: Vec<usize>,
    rows: Vec<usize>,
}

impl Factorisation {
    /// Factorises the matrix of these entries (row, column, value), which add up where they coincide; those above the
    /// diagonal are not looked at. `false` if it is not positive definite.
    pub fn factorise(&mut self, size: usize, entries: impl Iterator<Item = (usize, usize, f64)>) -> bool {
        // What is generic is compiled by the caller: only this line.
        let entries =
            entries.filter(|(row, column, _)| row >= column).map(|(r, c, v)| (r as u32, c as u32, v)).collect();
        self.factorise_lower(size, entries)
    }

    fn factorise_lower(&mut self, size: usize, entries: Vec<(u32, u32, f64)>) -> bool {
        let (pattern, values) = compressed(size, entries);
        self.count += 1;
        self.factors = None;
        if self.pattern.as_ref().is_none_or(|(known, _)| *known != pattern) {
            self.analyses += 1;
            self.pattern =
                SymbolicLlt::try_new(pattern.view(size), Side::Lower).ok().map(|symbolic| (pattern, symbolic));
        }
        let Some((pattern, symbolic)) = &self.pattern else { return false };
        let matrix = SparseColMatRef::new(pattern.view(size), &values);
        self.factors = Llt::try_new_with_symbolic(symbolic.clone(), matrix, Side::Lower).ok();
        self.factors.is_some()
    }

    /// Solution of the system with the last matrix; `None` if it had no factors.
    pub fn solve(&self, right: &[f64]) -> Option<Vec<f64>> {
        let factors = self.factors.as_ref()?;
        let solution = factors.solve(Mat::from_fn(right.len(), 1, |row, _| right[row]));
        Some((0..right.len()).map(|row| solution[(row, 0)]).collect())
    }
}

impl Pattern {
    fn view(&self, size: usize) -> SymbolicSparseColMatRef<'_, usize> {
        SymbolicSparseColMatRef::new_checked(size, size, &self.starts, None, &self.rows)
    }
}

/// Entries sorted by column and row, summed up. Sorted by counting, as there are many.
fn compressed(size: usize, entries: Vec<(u32, u32, f64)>) -> (Pattern, Vec<f64>) {
    let by_row = sorted_by(size, &entries, |entry| entry.0);
    let by_column = sorted_by(size, &by_row, |entry| entry.1);
    let mut pattern = Pattern { starts: vec![0], rows: Vec::new() };
    let mut values: Vec<f64> = Vec::new();
    let mut last = (u32::MAX, u32::MAX);
    for (row, column, value) in by_column {
        if (row, column) == last {
            *values.last_mut().expect("an entry before") += value;
            continue;
        }
        while pattern.starts.len() <= column as usize {
            pattern.starts.push(values.len());
        }
        pattern.rows.push(row as usize);
        values.push(value);
        last = (row, column);
    }
    pattern.starts.resize(size + 1, values.len());
    (pattern, values)
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

#[cfg(test)]
mod tests {
    use super::*;

    /// A chain of springs, held at one end, with entries in pieces and out of order.
    fn chain(size: usize, stiffness: f64) -> Vec<(usize, usize, f64)> {
        let springs = (1..size).flat_map(|k| {
            [(k, k, stiffness), (k - 1, k, -stiffness), (k, k - 1, -stiffness), (k - 1, k - 1, stiffness)]
        });
        springs.chain([(0, 0, stiffness)]).collect()
    }

    #[test]
    fn a_chain_of_springs_is_as_long_as_its_springs() {
        let mut system = Factorisation::default();
        assert!(system.factorise(5, chain(5, 2.0).into_iter().rev()));
        // A force of 1 at the end stretches each spring by ½.
        let u = system.solve(&[0.0, 0.0, 0.0, 0.0, 1.0]).unwrap();
        u.iter().enumerate().for_each(|(k, u)| assert!((u - 0.5 * (k + 1) as f64).abs() < 1e-14));
        assert!(system.factorise(5, chain(5, 1.0).into_iter()));
        assert_eq!((system.analyses, system.count), (1, 2));
        // Not held: no factors, or none that are of any use.
        let loose = chain(5, 1.0).into_iter().take(16);
        let found = system.factorise(5, loose).then(|| system.solve(&[1.0; 5]).unwrap()[0].abs());
        assert!(found.is_none_or(|u| u > 1e10));
    }
}
