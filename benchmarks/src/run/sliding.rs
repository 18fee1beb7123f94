//! Figures of a body that is pressed on another and pushed along it.

use super::Figure;
use super::way::LoadStep;
use crate::case::Case;
use fmc_solid::statics::Equilibrium;

/// | key | |
/// | --- | --- |
/// | `force_ratio` | contact force on the body along the first axis, against it, by that along the last |
/// | `force_across` | that along the last axis |
/// | `stick_ratio` | area that sticks by all of the contact |
/// | `stick_error` | that by √(1 − Q/μP) of the forces, less 1: Cattaneo's and Mindlin's line contact |
/// | `dissipated`, `dissipated_least` | energy that friction took out over all load steps, and in that in which it was least |
/// | `steps_failed` | load steps that were halved |
/// | `penetration_max` | largest over the load steps |
pub(super) fn figures<const D: usize>(case: &Case, at: &Equilibrium<D>, steps: &[LoadStep]) -> Vec<Figure> {
    let last = steps.last();
    let across = last.map(|step| step.force[D - 1].abs());
    let ratio = last.map(|step| -step.force[0] / step.force[D - 1].abs());
    let stick = last.map(|step| step.stick[0] / (step.stick[0] + step.stick[1])).filter(|ratio| ratio.is_finite());
    let mindlin = ratio.map(|ratio| (1.0 - ratio.abs() / case.contact.friction_coefficient).sqrt());
    let error = stick.zip(mindlin).map(|(found, exact)| found / exact - 1.0).filter(|error| error.is_finite());
    let dissipated = || steps.iter().map(|step| step.dissipated);
    let (force, energy) = if D == 2 { ("N/m", "J/m") } else { ("N", "J") };
    let figure = |&name: &&'static str| {
        let (value, unit) = match name {
            "force_ratio" => (ratio, ""),
            "force_across" => (across, force),
            "stick_ratio" => (stick, ""),
            "stick_error" => (error, ""),
            "dissipated" => (Some(dissipated().sum()), energy),
            "dissipated_least" => (dissipated().reduce(f64::min), energy),
            "steps_failed" => (Some(at.halvings as f64), ""),
            _ => (Some(steps.iter().map(|step| step.penetration).fold(0.0, f64::max)), "m"),
        };
        Figure { name, value, unit }
    };
    case.figures.kind.keys().iter().map(figure).collect()
}
