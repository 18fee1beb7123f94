//! Energy laws and the forces of all pairs.

mod compressed_rows;
mod evaluation;
mod fields;
mod forces;
mod gap_constraints;
mod kept_patches;
mod kernels;
mod lanczos;
mod laws;
mod mass_scaled;
mod momentum_correction;
mod obstacles;
mod options;
mod pair_options;
mod pair_table;
mod pairs;
mod pattern;
mod rigid;
mod stable_step;
mod state;
mod stiffness;
mod tangent;

pub use compressed_rows::CompressedRows;
pub(crate) use compressed_rows::compressed;
pub use evaluation::{Contact, contact_force};
pub use fields::{NodalContact, NodeStatus, PointOfContact, SideOfPoint};
pub use forces::{ContactForces, PairForces, Resultant};
pub use gap_constraints::GapConstraints;
pub use laws::{EnergyLaw, FiberProfile};
pub use options::Options;
pub use pair_options::PairOptions;
pub use pattern::Pattern;
pub use stiffness::{StiffnessFrom, suggest_fiber_stiffness, suggest_stiffness};
pub use tangent::{RankOne, Tangent, TangentPart};
