//! Error against the number of fibers.

use super::case::Case;
use super::method::Method;
use crate::chart::{Axis, Mark, Panel, Series};
use fmc_contact::{Error, Resolution};

/// Fibers asked for, up to the paper's 300 000.
const COUNTS: [usize; 8] = [100, 300, 1_000, 3_000, 10_000, 30_000, 100_000, 300_000];

/// Seeds over which the error is averaged.
pub const SEEDS: u64 = 8;

/// Evaluations that one case takes per method and seed, for a progress bar.
pub(super) const EVALUATIONS: u64 = COUNTS.len() as u64;

/// Root mean square errors of value and derivative of the meshed form, as two panels of a picture.
///
/// They are taken against the closed form of the mesh, so that the error of sampling is all that is seen.
pub(super) fn convergence<const D: usize>(
    case: &Case<D>,
    methods: &[Method],
    seeds: u64,
    threads: usize,
    mut tick: impl FnMut(),
) -> Result<Vec<Panel>, Error> {
    let (form, theta) = (&case.forms[0], case.thetas[0]);
    let expected = form.of_the_mesh.unwrap_or(case.closed_form)(theta);
    let scene = (form.scene)(theta);
    let mut contact = scene.contact(threads)?;
    let mut panels = ["value", "derivative"].map(|quantity| Panel {
        x: Axis::log("fibers"),
        y: Axis::log(format!("rms relative error of the {quantity}")),
        series: Vec::new(),
    });
    let (mut fewest, mut most) = (f64::INFINITY, 0f64);
    for &method in methods.iter().filter(|method| **method != Method::Exact) {
        let mut points = [Vec::new(), Vec::new()];
        for count in COUNTS {
            let (mut fibers, mut squares) = (0.0, [0.0; 2]);
            for seed in 0..seeds {
                let estimator = method.estimator(Resolution::Count(count), seed, case.fiber_length);
                let measured = scene.measure(&mut contact, estimator)?;
                fibers += measured.fibers as f64 / seeds as f64;
                squares[0] += (measured.value / expected.value - 1.0).powi(2) / seeds as f64;
                squares[1] += (measured.derivative / expected.derivative - 1.0).powi(2) / seeds as f64;
                tick();
            }
            (fewest, most) = (fewest.min(fibers), most.max(fibers));
            (0..2).for_each(|k| points[k].push((fibers, squares[k].sqrt())));
        }
        for (panel, points) in panels.iter_mut().zip(points) {
            panel.series.push(method.series(Mark::LineAndPoints, points));
        }
    }
    for (panel, error) in panels.iter_mut().zip(case.bounds) {
        let points = vec![(fewest, error), (most, error)];
        let largest = Series::line("largest error in the paper", (110, 110, 110), points);
        panel.series.push(Series { mark: Mark::Dashes, ..largest });
    }
    Ok(panels.into())
}
