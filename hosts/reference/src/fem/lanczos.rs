//! Largest eigenvalue of a symmetric operator, by Lanczos' iteration.

use fmc_shapes::Splitmix;

/// The iteration ends when the residual of the Ritz vector is this part of its value: the frequency, its root, is then
/// known to half of that. Smaller values cost steps (about the inverse root of it) and no time step is longer by them.
const RESIDUAL: f64 = 1e-3;

/// Steps after which it gives up; 40 to 120 are usual.
const MOST_STEPS: usize = 400;

/// Upper estimate of the largest eigenvalue of A, `apply` writing A x to its second argument.
///
/// The largest Ritz value θ lies below the eigenvalue. For a Ritz vector y with |A y − θ y| ≤ r |y| there is an
/// eigenvalue within r of θ; the estimate is θ + r. It can only be too low if the start vector, which is random and
/// always the same, has next to no part of the largest eigenvector. `None` if the iteration does not converge or meets
/// values that are not finite.
pub(super) fn largest_eigenvalue(size: usize, mut apply: impl FnMut(&[f64], &mut [f64])) -> Option<f64> {
    let mut random = Splitmix::new(0);
    let mut q: Vec<f64> = (0..size).map(|_| random.between(-1.0, 1.0)).collect();
    let norm = dot(&q, &q).sqrt();
    q.iter_mut().for_each(|q| *q /= norm);
    let mut previous = vec![0.0; size];
    let mut w = vec![0.0; size];
    let (mut alphas, mut betas) = (Vec::new(), Vec::<f64>::new());
    for step in 1..=MOST_STEPS {
        apply(&q, &mut w);
        let beta = betas.last().copied().unwrap_or(0.0);
        let alpha = dot(&q, &w);
        (0..size).for_each(|i| w[i] -= alpha * q[i] + beta * previous[i]);
        alphas.push(alpha);
        let beta = dot(&w, &w).sqrt();
        if !(alpha.is_finite() && beta.is_finite()) {
            return None;
        }
        if step % 8 == 0 || beta == 0.0 || step == size {
            let (value, last) = largest_ritz_pair(&alphas, &betas);
            if beta * last <= RESIDUAL * value.abs() {
                return Some(value + beta * last);
            }
        }
        betas.push(beta);
        std::mem::swap(&mut previous, &mut q);
        (0..size).for_each(|i| q[i] = w[i] / beta);
    }
    None
}

/// Largest eigenvalue of the tridiagonal matrix and the last component, in size, of its unit eigenvector.
fn largest_ritz_pair(alphas: &[f64], betas: &[f64]) -> (f64, f64) {
    let beta = |row: usize| betas.get(row).copied().unwrap_or(0.0);
    let reach = |row: usize| beta(row) + if row > 0 { beta(row - 1) } else { 0.0 };
    let mut low = alphas.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let mut high = (0..alphas.len()).map(|row| alphas[row] + reach(row)).fold(f64::NEG_INFINITY, f64::max);
    // λ is above all eigenvalues if all pivots of T − λ I are negative (Sturm).
    let pivots = |shift: f64| {
        let mut pivot = f64::NEG_INFINITY;
        alphas
            .iter()
            .enumerate()
            .map(move |(row, alpha)| {
                let coupling = if row > 0 { betas[row - 1] * betas[row - 1] / pivot } else { 0.0 };
                pivot = alpha - shift - coupling;
                pivot
            })
            .collect::<Vec<f64>>()
    };
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if pivots(middle).iter().all(|&pivot| pivot < 0.0) { high = middle } else { low = middle }
    }
    // Inverse iteration just above the eigenvalue, where the pivots stay negative.
    let shift = high + 1e-12 * high.abs();
    let pivots = pivots(shift);
    let mut s = vec![1.0; alphas.len()];
    for _ in 0..3 {
        (1..s.len()).for_each(|row| s[row] -= betas[row - 1] / pivots[row - 1] * s[row - 1]);
        for row in (0..s.len()).rev() {
            let next = if row + 1 < s.len() { betas[row] * s[row + 1] } else { 0.0 };
            s[row] = (s[row] - next) / pivots[row];
        }
        let norm = dot(&s, &s).sqrt();
        s.iter_mut().for_each(|s| *s /= norm);
    }
    (high, s.last().map_or(0.0, |s| s.abs()))
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Second differences on n points: eigenvalues 2 − 2 cos(kπ/(n + 1)).
    #[test]
    fn largest_eigenvalue_of_second_differences() {
        for n in [1usize, 2, 3, 10, 100, 1000] {
            let apply = |x: &[f64], y: &mut [f64]| {
                for i in 0..n {
                    let left = if i > 0 { x[i - 1] } else { 0.0 };
                    y[i] = 2.0 * x[i] - left - x.get(i + 1).copied().unwrap_or(0.0);
                }
            };
            let exact = 2.0 + 2.0 * (std::f64::consts::PI / (n + 1) as f64).cos();
            let estimate = largest_eigenvalue(n, apply).unwrap();
            assert!(estimate >= exact * (1.0 - 1e-9) && estimate <= exact * (1.0 + 1.1e-3), "{n}: {estimate} {exact}");
        }
    }
}
