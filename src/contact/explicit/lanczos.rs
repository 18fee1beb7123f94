//! Bounds of the eigenvalues of a symmetric operator, by Lanczos' iteration.

use crate::sampling::uniforms;

/// Margin above the largest eigenvalue, in parts of it, at which the iteration ends.
const MARGIN: f64 = 0.05;

/// Steps after which it ends in any case; 64 are enough where no eigenvalue is negative.
const MOST_STEPS: usize = 400;

/// Steps between two looks at the eigenvalues.
const LOOK: usize = 16;

/// The largest eigenvalue found in k steps falls short by more than the part (REACH / (2k − 1))² of the spread of all
/// eigenvalues with a probability below 1.648 √n exp(−REACH), n unknowns and a random start (Kuczyński and Woźniakowski,
/// SIAM J. Matrix Anal. Appl. 13, 1992): for a million unknowns below 1e-9.
const REACH: f64 = 28.39;

/// A residual of this part of the largest coefficient is rounding: all eigenvectors of the start have been found.
const EXHAUSTED: f64 = 1e-12;

/// Streams 0 and upwards of seed 0 are those of sampling; this one is far from them.
const STREAM: u64 = 1 << 40;

/// An upper bound of the largest eigenvalue of a symmetric operator on `count` vectors: above it by [`MARGIN`] at most,
/// or, where others are negative and far larger, by a thousandth of their spread. `apply` must not leave the range of a
/// double.
///
/// The start is random and always the same; the bound could only be wrong for an operator made for it, see [`REACH`].
pub(crate) fn bound<const D: usize>(count: usize, apply: impl Fn(&[[f64; D]]) -> Vec<[f64; D]>) -> f64 {
    let mut q = start::<D>(count);
    let mut previous = vec![[0.0; D]; count];
    let (mut alphas, mut betas) = (Vec::new(), Vec::<f64>::new());
    for step in 1..=MOST_STEPS {
        let mut w = apply(&q);
        let alpha = dot(&q, &w);
        let beta = betas.last().copied().unwrap_or(0.0);
        add(&mut w, -alpha, &q);
        add(&mut w, -beta, &previous);
        alphas.push(alpha);
        let beta = dot(&w, &w).sqrt();
        let largest = alphas.iter().chain(&betas).fold(0.0f64, |m, x| m.max(x.abs()));
        if beta <= EXHAUSTED * largest {
            break;
        }
        if step % LOOK == 0 {
            let [lowest, highest] = ends(&alphas, &betas);
            let shortfall = (REACH / (2 * step - 1) as f64).powi(2) * (highest - lowest);
            if shortfall <= MARGIN * highest || step == MOST_STEPS {
                return highest + shortfall;
            }
        }
        betas.push(beta);
        w.as_flattened_mut().iter_mut().for_each(|w| *w /= beta);
        previous = std::mem::replace(&mut q, w);
    }
    let [lowest, highest] = ends(&alphas, &betas);
    highest + MARGIN * highest.max(0.0) + EXHAUSTED * (highest - lowest)
}

/// Least and largest eigenvalue of the tridiagonal matrix.
fn ends(alphas: &[f64], betas: &[f64]) -> [f64; 2] {
    let negative: Vec<f64> = alphas.iter().map(|alpha| -alpha).collect();
    [-largest_of_tridiagonal(&negative, betas), largest_of_tridiagonal(alphas, betas)]
}

/// A unit vector of random direction: sums of uniform numbers are close enough to normal ones.
fn start<const D: usize>(count: usize) -> Vec<[f64; D]> {
    let centred = |index: usize| uniforms::<8>(0, STREAM, index as u64).iter().sum::<f64>() - 4.0;
    let mut q: Vec<[f64; D]> = (0..count).map(|node| std::array::from_fn(|axis| centred(node * D + axis))).collect();
    let norm = dot(&q, &q).sqrt();
    q.as_flattened_mut().iter_mut().for_each(|q| *q /= norm);
    q
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
