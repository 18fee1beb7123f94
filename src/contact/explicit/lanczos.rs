//! Bounds of the eigenvalues of a symmetric operator, by Lanczos' iteration.

use crate::sampling::uniforms;

/// Margin above the largest eigenvalue, in parts of it, at which the iteration ends.
const MARGIN: f64 = 0.05;

/// Steps after which it ends in any case; 64 are enough for a bound where no eigenvalue is negative, 40 to 120 for a residual of a
/// thousandth.
const MAX_STEPS: usize = 400;

/// The largest eigenvalue found in k steps falls short by more than the part (REACH / (2k − 1))² of the spread of all
/// eigenvalues with a probability below 1.648 √n exp(−REACH), n unknowns and a random start (Kuczyński and Woźniakowski,
/// SIAM J. Matrix Anal. Appl. 13, 1992): for a million unknowns below 1e-9.
const REACH: f64 = 28.39;

/// A residual of this part of the largest coefficient is rounding: all eigenvectors of the start have been found.
const EXHAUSTED: f64 = 1e-12;

/// Streams 0 and upwards of seed 0 are those of sampling; this one is far from them.
const STREAM: u64 = 1 << 40;

/// When the iteration ends, and what it returns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Accuracy {
    /// An upper bound, above the eigenvalue by 5 % at most, or, where others are negative and far larger, by a thousandth of their
    /// spread. It could only be wrong for an operator made for its start vector.
    Bound,
    /// The largest Ritz value θ and its residual r, once r is this part of θ: there is an eigenvalue within r of θ, since
    /// |A y − θ y| ≤ r |y| for the Ritz vector y. Sharper than a bound, and too low if the start vector has next to no part of the
    /// largest eigenvector.
    Residual(f64),
}

/// The largest eigenvalue of a symmetric operator, from above. `start` is a random vector, `apply` the operator.
///
/// `None` where the operator leaves the range of a double, or the residual stays larger than asked for in 400 steps.
pub fn largest_eigenvalue<const D: usize>(
    start: Vec<[f64; D]>,
    accuracy: Accuracy,
    mut apply: impl FnMut(&[[f64; D]]) -> Vec<[f64; D]>,
) -> Option<f64> {
    let (mut q, mut previous) = (start, Vec::new());
    let norm = dot(&q, &q).sqrt();
    q.as_flattened_mut().iter_mut().for_each(|q| *q /= norm);
    previous.resize(q.len(), [0.0; D]);
    let (mut alphas, mut betas) = (Vec::new(), Vec::<f64>::new());
    for step in 1..=MAX_STEPS {
        let mut w = apply(&q);
        let alpha = dot(&q, &w);
        let beta = betas.last().copied().unwrap_or(0.0);
        add(&mut w, -alpha, &q);
        add(&mut w, -beta, &previous);
        alphas.push(alpha);
        let beta = dot(&w, &w).sqrt();
        if !(alpha.is_finite() && beta.is_finite()) {
            return None;
        }
        let largest = alphas.iter().chain(&betas).fold(0.0f64, |m, x| m.max(x.abs()));
        let is_exhausted = beta <= EXHAUSTED * largest;
        match accuracy {
            Accuracy::Bound if is_exhausted => {
                let [lowest, highest] = ends(&alphas, &betas);
                return Some(highest + MARGIN * highest.max(0.0) + EXHAUSTED * (highest - lowest));
            }
            Accuracy::Bound if step % 16 == 0 => {
                let [lowest, highest] = ends(&alphas, &betas);
                let shortfall = (REACH / (2 * step - 1) as f64).powi(2) * (highest - lowest);
                if shortfall <= MARGIN * highest || step == MAX_STEPS {
                    return Some(highest + shortfall);
                }
            }
            Accuracy::Residual(part) if step % 8 == 0 || beta == 0.0 || step == q.as_flattened().len() => {
                let value = largest_of_tridiagonal(&alphas, &betas);
                let residual = beta * last_of_eigenvector(&alphas, &betas, value);
                if residual <= part * value.abs() {
                    return Some(value + residual);
                }
            }
            _ => {}
        }
        betas.push(beta);
        w.as_flattened_mut().iter_mut().for_each(|w| *w /= beta);
        previous = std::mem::replace(&mut q, w);
    }
    None
}

/// Least and largest eigenvalue of the tridiagonal matrix.
fn ends(alphas: &[f64], betas: &[f64]) -> [f64; 2] {
    let negative: Vec<f64> = alphas.iter().map(|alpha| -alpha).collect();
    [-largest_of_tridiagonal(&negative, betas), largest_of_tridiagonal(alphas, betas)]
}

/// A vector of random direction, always the same: sums of uniform numbers are close enough to normal ones.
pub(crate) fn random_start<const D: usize>(count: usize) -> Vec<[f64; D]> {
    let centred = |index: usize| uniforms::<8>(0, STREAM, index as u64).iter().sum::<f64>() - 4.0;
    (0..count).map(|node| std::array::from_fn(|axis| centred(node * D + axis))).collect()
}

/// Largest eigenvalue, from above, by bisection.
fn largest_of_tridiagonal(alphas: &[f64], betas: &[f64]) -> f64 {
    let beta = |row: usize| betas.get(row).copied().unwrap_or(0.0);
    let reach = |row: usize| beta(row) + if row > 0 { beta(row - 1) } else { 0.0 };
    let mut low = alphas.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let mut high = (0..alphas.len()).map(|row| alphas[row] + reach(row)).fold(f64::NEG_INFINITY, f64::max);
    // All eigenvalues are below a shift if all pivots of T − shift are negative (Sturm).
    let is_above = |shift: f64| {
        let mut pivot = -1.0;
        (0..alphas.len()).all(|row| {
            let coupling = if row > 0 { beta(row - 1) * beta(row - 1) / pivot } else { 0.0 };
            pivot = alphas[row] - shift - coupling;
            // One as small as this would overflow in the next coupling; it stands for 0.
            pivot < -1e-150
        })
    };
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if is_above(middle) { high = middle } else { low = middle }
    }
    high
}

/// Last component, in size, of the unit eigenvector of the largest eigenvalue: inverse iteration just above it, where all pivots are
/// negative.
fn last_of_eigenvector(alphas: &[f64], betas: &[f64], eigenvalue: f64) -> f64 {
    let shift = eigenvalue + 1e-12 * eigenvalue.abs();
    let (mut pivots, mut pivot) = (Vec::with_capacity(alphas.len()), f64::NEG_INFINITY);
    for (row, alpha) in alphas.iter().enumerate() {
        let coupling = if row > 0 { betas[row - 1] * betas[row - 1] / pivot } else { 0.0 };
        pivot = alpha - shift - coupling;
        pivots.push(pivot);
    }
    let mut s = vec![1.0; alphas.len()];
    for _ in 0..3 {
        (1..s.len()).for_each(|row| s[row] -= betas[row - 1] / pivots[row - 1] * s[row - 1]);
        for row in (0..s.len()).rev() {
            let next = if row + 1 < s.len() { betas[row] * s[row + 1] } else { 0.0 };
            s[row] = (s[row] - next) / pivots[row];
        }
        let norm = s.iter().map(|s| s * s).sum::<f64>().sqrt();
        s.iter_mut().for_each(|s| *s /= norm);
    }
    s.last().map_or(0.0, |s| s.abs())
}

fn dot<const D: usize>(a: &[[f64; D]], b: &[[f64; D]]) -> f64 {
    a.as_flattened().iter().zip(b.as_flattened()).map(|(a, b)| a * b).sum()
}

/// a += factor b.
fn add<const D: usize>(a: &mut [[f64; D]], factor: f64, b: &[[f64; D]]) {
    a.as_flattened_mut().iter_mut().zip(b.as_flattened()).for_each(|(a, b)| *a += factor * b);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bound<const D: usize>(count: usize, apply: impl Fn(&[[f64; D]]) -> Vec<[f64; D]>) -> f64 {
        largest_eigenvalue(random_start(count), Accuracy::Bound, apply).expect("a finite operator")
    }

    /// Second differences on n points: eigenvalues 2 − 2 cos(kπ/(n + 1)), within [0, 4].
    #[test]
    fn second_differences() {
        for n in [1usize, 2, 3, 10, 100, 20_000] {
            for sign in [1.0, -1.0] {
                let apply = |x: &[[f64; 1]]| {
                    let at = |i: usize| x.get(i).map_or(0.0, |x| x[0]);
                    let before = |i: usize| if i > 0 { at(i - 1) } else { 0.0 };
                    (0..n).map(|i| [sign * (2.0 * at(i) - before(i) - at(i + 1))]).collect()
                };
                let cosine = (std::f64::consts::PI / (n + 1) as f64).cos();
                let (largest, spread) = (sign * 2.0 + 2.0 * cosine, 4.0 * cosine);
                let sharp = largest_eigenvalue(random_start(n), Accuracy::Residual(1e-3), apply);
                if let Some(sharp) = sharp.filter(|_| sign > 0.0) {
                    assert!(sharp >= largest * (1.0 - 1e-9) && sharp <= largest * (1.0 + 1.1e-3), "{n}: {sharp}");
                }
                assert!(sharp.is_some() || sign < 0.0);
                let found = bound(n, apply);
                // What is not positive is found to rounding, or to a thousandth of the spread.
                let margin = f64::max(0.0501 * largest, 2e-3 * spread);
                assert!(found >= largest - 1e-12 && found <= largest + margin + 1e-9, "{n}: {found}");
            }
        }
    }

    /// One positive eigenvalue among a thousand, the others being negative and up to a hundred times as large.
    #[test]
    fn a_small_one_above_large_negative_ones() {
        let eigenvalue = |i: usize| if i == 500 { 1.0 } else { -(i as f64) / 10.0 };
        let apply = |x: &[[f64; 1]]| x.iter().enumerate().map(|(i, x)| [eigenvalue(i) * x[0]]).collect();
        let found = bound(1000, apply);
        assert!((1.0..=1.13).contains(&found), "{found}");
    }

    #[test]
    fn an_operator_of_rank_one_and_none() {
        let n = 30;
        let along = |x: &[[f64; 2]]| x.iter().enumerate().map(|(i, x)| x[0] * i as f64).sum::<f64>();
        let one = |x: &[[f64; 2]]| (0..n).map(|i| [along(x) * i as f64, 0.0]).collect::<Vec<_>>();
        let exact: f64 = (0..n).map(|i| (i * i) as f64).sum();
        assert!((bound(n, one) / exact - 1.05).abs() < 1e-9);
        assert_eq!(bound(n, |x: &[[f64; 2]]| vec![[0.0; 2]; x.len()]), 0.0);
    }
}
