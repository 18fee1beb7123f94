//! Whether what a host gives is a symmetric matrix, and a list of its equations.

use super::Lower;
use crate::Error;
use crate::sparse::Compressed;

/// Part of the diagonal's geometric mean by which mirrored entries may differ: sums of the same parts in another order.
const SYMMETRY: f64 = 1e-10;

impl Compressed<'_> {
    /// Its lower triangle. Errors: [`Error::Length`], [`Error::DofOutOfRange`], [`Error::NonFiniteStiffness`],
    /// [`Error::Unsymmetric`].
    pub(super) fn lower(&self) -> Result<Lower, Error> {
        let count = self.values.len();
        let ends = self.offsets.iter().try_fold(0, |before, &offset| (before <= offset).then_some(offset));
        if self.offsets.first().is_some_and(|first| *first != 0) || ends != Some(count as i64) {
            let found = self.offsets.last().map_or(0, |last| usize::try_from(*last).unwrap_or(0));
            return Err(Error::Length { array: "row_offsets", expected: count, found });
        }
        let size = self.size();
        if let Some(&dof) = self.columns.iter().find(|column| !(0..size as i64).contains(column)) {
            return Err(Error::DofOutOfRange { dof, count: size });
        }
        if let Some(entry) = self.values.iter().position(|value| !value.is_finite()) {
            return Err(Error::NonFiniteStiffness { array: "values", entry });
        }
        let entries = || {
            (0..size).flat_map(|row| {
                let places = self.offsets[row] as usize..self.offsets[row + 1] as usize;
                places.map(move |place| (row, self.columns[place] as usize, self.values[place]))
            })
        };
        let lower = Lower::new(size, entries());
        if entries().any(|(row, column, _)| column > row) {
            let upper = Lower::new(size, entries().map(|(row, column, value)| (column, row, value)));
            if let Some((row, column)) = difference(&lower, &upper) {
                return Err(Error::Unsymmetric { row, column });
            }
        }
        Ok(lower)
    }
}

/// Equations that ascend and exist.
pub(super) fn checked_list(list: &[usize], count: usize) -> Result<(), Error> {
    for (place, &dof) in list.iter().enumerate() {
        if dof >= count {
            return Err(Error::DofOutOfRange { dof: dof as i64, count });
        }
        if place > 0 && list[place - 1] >= dof {
            return Err(Error::RepeatedDof { dof });
        }
    }
    Ok(())
}

/// Row and column at which two triangles differ, what one of them lacks being zero.
fn difference(lower: &Lower, upper: &Lower) -> Option<(usize, usize)> {
    let mut diagonal = vec![0.0f64; lower.size()];
    lower.entries().filter(|(row, column, _)| row == column).for_each(|(row, _, value)| diagonal[row] = value.abs());
    let (mut one, mut other) = (lower.entries().peekable(), upper.entries().peekable());
    loop {
        let place = |entry: &(usize, usize, f64)| (entry.1, entry.0);
        let at = [one.peek().map(place), other.peek().map(place)].into_iter().flatten().min()?;
        let value = |entries: &mut std::iter::Peekable<_>| -> f64 {
            entries.next_if(|entry| place(entry) == at).map_or(0.0, |entry: (usize, usize, f64)| entry.2)
        };
        let (a, b) = (value(&mut one), value(&mut other));
        let (column, row) = at;
        if (a - b).abs() > SYMMETRY * (diagonal[row].sqrt() * diagonal[column].sqrt()).max(f64::MIN_POSITIVE) {
            return Some((row, column));
        }
    }
}
