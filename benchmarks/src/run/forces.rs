//! Figures that every equilibrium has.

use super::Figure;
use super::way::LoadStep;
use crate::case::Case;

/// | key | |
/// | --- | --- |
/// | `force_peak`, `force_end` | magnitude of the contact force on the body: the largest over the load steps, and the last |
/// | `penetration_max` | largest over the load steps |
pub(super) fn figures(case: &Case, steps: &[LoadStep]) -> Vec<Figure> {
    let size = |step: &LoadStep| step.force.iter().map(|f| f * f).sum::<f64>().sqrt();
    let unit = if case.dimension == 2 { "N/m" } else { "N" };
    let figure = |&name: &&'static str| {
        let (value, unit) = match name {
            "force_peak" => (steps.iter().map(size).reduce(f64::max), unit),
            "force_end" => (steps.last().map(size), unit),
            _ => (steps.iter().map(|step| step.penetration).reduce(f64::max), "m"),
        };
        Figure { name, value, unit }
    };
    case.figures.kind.keys().iter().map(figure).collect()
}
