//! Rms errors of nodal forces over seeds, and the order at which they fall with the number of crossings.

use crate::scene::{Scene, distance, exact, lines, norm};

/// What one spacing costs and gives.
pub(crate) struct Sample {
    /// Mean number of crossings that bound the overlap.
    pub(crate) crossings: f64,
    /// Root of the mean over the seeds of the squared error of all nodal forces, relative to their norm.
    pub(crate) error: f64,
}

/// Spacing at which a pair has about this many crossings: they go with the (D − 1)th power of 1/spacing.
pub(crate) fn spacing_for<const D: usize>(scene: &Scene<D>, crossings: f64, trial: f64) -> f64 {
    let counted = scene.evaluate(lines(trial, 0)).crossing_count as f64;
    trial * (counted / crossings).powf(1.0 / (D as f64 - 1.0))
}

/// Error of the default estimate (balanced) with this spacing.
pub(crate) fn sample<const D: usize>(scene: &Scene<D>, spacing: f64, seeds: u64) -> Sample {
    let mut contact = scene.contact(exact());
    let reference = contact.evaluate(&scene.coords).unwrap().forces;
    let (mut crossings, mut squares) = (0.0, 0.0);
    for seed in 0..seeds {
        contact.set_options(lines(spacing, seed)).unwrap();
        let found = contact.evaluate(&scene.coords).unwrap();
        crossings += found.crossing_count as f64;
        squares += (distance(&found.forces, &reference) / norm(&reference)).powi(2);
    }
    Sample { crossings: crossings / seeds as f64, error: (squares / seeds as f64).sqrt() }
}

/// Slope of −log(error) over log(crossings), by least squares.
pub(crate) fn order(samples: &[Sample]) -> f64 {
    let points: Vec<[f64; 2]> = samples.iter().map(|s| [s.crossings.ln(), s.error.ln()]).collect();
    let n = points.len() as f64;
    let mean = |i: usize| points.iter().map(|p| p[i]).sum::<f64>() / n;
    let (x, y) = (mean(0), mean(1));
    let covariance: f64 = points.iter().map(|p| (p[0] - x) * (p[1] - y)).sum();
    -covariance / points.iter().map(|p| (p[0] - x).powi(2)).sum::<f64>()
}
