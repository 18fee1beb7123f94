//! Axisymmetry: bodies of revolution by their sections.

#[path = "../scene/scene.rs"]
mod scene;

mod derivatives;
mod differences;
mod flat;
mod friction;
mod itself;
mod refused;
mod revolved;
mod sections;
mod volumes;

use fmc_contact::Options;
use fmc_contact::{EnergyLaw, Estimator};

/// A law, exactly integrated, in axisymmetry.
fn exactly(law: EnergyLaw) -> Options {
    Options { estimator: Estimator::Exact, axisymmetric: true, ..Options::new(law) }
}

/// The law depth in axisymmetry.
fn depth(k: f64) -> Options {
    exactly(EnergyLaw::depth(k))
}
