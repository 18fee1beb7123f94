//! The law `depth`.

#[path = "../scene/scene.rs"]
mod scene;

mod by_reference;
mod clearance;
mod coarse;
mod coarse_faces;
mod corners;
mod curved;
mod curves;
mod derivatives;
mod far;
mod fields;
mod flat;
mod flush;
mod gap_offset;
mod itself;
mod noise;
mod numbering;
mod obstacles;
mod points;
mod reference;
mod rigid_meshes;
mod rims;
mod round_obstacles;
mod scans;
mod seams;
mod shells;
mod slices;
mod slopes;
mod smooth_friction;
mod smoothing;
mod swallowed;
mod symmetry;
mod units;

use fmc_contact::EnergyLaw;
use fmc_contact::Options;

/// The law with stiffness k.
fn depth(k: f64) -> Options {
    scene::table::exactly(EnergyLaw::depth(k))
}
