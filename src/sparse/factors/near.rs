//! Which equations lie near those that are kept.

use super::Lower;
use faer::sparse::linalg::cholesky::supernodal::SymbolicSupernodalCholesky;

/// Steps from one equation to the next that shares an entry with it, from what is kept.
const STEPS: usize = 2;

/// Supernodes by which the equations near those that are kept are found from these: their own, and what they depend on.
pub(super) fn supernodes_near(
    matrix: &Lower,
    kept: &[usize],
    order: &[usize],
    factors: &SymbolicSupernodalCholesky<usize>,
) -> Vec<bool> {
    let mut is_near = vec![false; matrix.size()];
    kept.iter().for_each(|&equation| is_near[equation] = true);
    for _ in 0..STEPS {
        let before = is_near.clone();
        for column in 0..matrix.size() {
            for &row in matrix.rows_of(column) {
                if before[row] || before[column] {
                    (is_near[row], is_near[column]) = (true, true);
                }
            }
        }
    }
    let (starts, ends) = (factors.supernode_begin(), factors.supernode_end());
    let mut is_wanted: Vec<bool> = starts
        .iter()
        .zip(ends)
        .map(|(&start, &end)| order[start..end].iter().any(|&equation| is_near[equation]))
        .collect();
    for number in 0..is_wanted.len() {
        // All that it depends on is beyond the next one of these, or is that.
        if is_wanted[number]
            && let Some(&row) = factors.supernode(number).pattern().first()
        {
            is_wanted[starts.partition_point(|start| *start <= row) - 1] = true;
        }
    }
    is_wanted
}
