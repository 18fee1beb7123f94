//! The bodies' matrix where degrees of freedom are joined or follow others.

use super::equations::Equations;
use std::collections::BTreeMap;

/// Part of the terms of a sum that is rounding: a rigid body resists no motion of all of it.
const ROUNDED: f64 = 1e-12;

/// Entries of a matrix on both sides of its diagonal, each at the degrees of freedom that stand for its own. Sums that are rounding are 0.
pub(super) fn led(
    equations: &Equations,
    entries: impl Iterator<Item = (usize, usize, f64)>,
) -> Vec<(usize, usize, f64)> {
    let (mut own, mut sums) = (Vec::new(), BTreeMap::<(usize, usize), [f64; 2]>::new());
    for (row, column, value) in equations.by_unknowns(entries) {
        match equations.leads(row) || equations.leads(column) {
            true => {
                let [sum, size] = sums.entry((row, column)).or_default();
                (*sum, *size) = (*sum + value, *size + value.abs());
            }
            false => own.push((row, column, value)),
        }
    }
    let rounded = |([sum, size], place): ([f64; 2], (usize, usize))| {
        (place.0, place.1, if sum.abs() > ROUNDED * size { sum } else { 0.0 })
    };
    own.extend(sums.into_iter().map(|(place, sums)| rounded((sums, place))));
    own
}

/// The diagonal of a matrix: for each degree of freedom the sum over those that it stands for, each alone.
pub(super) fn own_diagonal(equations: &Equations, entries: impl Iterator<Item = (usize, usize, f64)>) -> Vec<f64> {
    let mut diagonal = vec![0.0; equations.free().len()];
    let on_it = entries.filter(|(row, column, _)| row == column);
    for (row, _, value) in on_it {
        equations.terms(row).for_each(|(unknown, weight)| diagonal[unknown] += weight * weight * value);
    }
    diagonal
}
