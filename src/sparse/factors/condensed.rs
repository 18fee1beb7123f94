//! Right sides and solutions by the equations that are kept.

use super::triangle::{backward, forward};
use faer::sparse::linalg::cholesky::supernodal::SupernodalLltRef;

/// A right side after the forward substitution of all equations that are not kept.
#[derive(Clone, Debug, PartialEq)]
pub struct Condensed {
    /// L⁻¹ b of the others, in the order of elimination.
    pub inner: Vec<f64>,
    /// What is left of b on the kept ones, in their order: the right side of the system with the Schur complement.
    pub kept: Vec<f64>,
}

/// Forward substitution of the first `count` equations in the order of elimination.
pub(super) fn eliminate(factors: &SupernodalLltRef<usize, f64>, count: usize, y: &mut [f64]) {
    let mut local = Vec::new();
    for number in 0..factors.symbolic().n_supernodes() {
        let supernode = factors.supernode(number);
        let (block, start, below) = (supernode.val(), supernode.start(), supernode.pattern());
        let own = start..start + block.ncols();
        if start >= count {
            break;
        }
        local.clear();
        local.extend_from_slice(&y[own.clone()]);
        local.resize(block.nrows(), 0.0);
        forward(block, block.ncols().min(count - start), &mut local);
        let (at_own, at_below) = local.split_at(block.ncols());
        y[own].copy_from_slice(at_own);
        below.iter().zip(at_below).for_each(|(&row, change)| y[row] += change);
    }
}

/// Backward substitution of the same, the others being solved; of those supernodes alone that `is_wanted`.
pub(super) fn follow(
    factors: &SupernodalLltRef<usize, f64>,
    count: usize,
    y: &mut [f64],
    is_wanted: impl Fn(usize) -> bool,
) {
    let mut local = Vec::new();
    for number in (0..factors.symbolic().n_supernodes()).rev().filter(|number| is_wanted(*number)) {
        let supernode = factors.supernode(number);
        let (block, start, below) = (supernode.val(), supernode.start(), supernode.pattern());
        if start >= count {
            continue;
        }
        local.clear();
        local.extend_from_slice(&y[start..start + block.ncols()]);
        local.extend(below.iter().map(|&row| y[row]));
        let columns = block.ncols().min(count - start);
        backward(block, columns, &mut local);
        y[start..start + columns].copy_from_slice(&local[..columns]);
    }
}
