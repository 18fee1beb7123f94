//! Energy laws and the forces of all pairs.

mod evaluation;
mod fields;
mod forces;
mod kept_patches;
mod kernels;
mod laws;
mod momentum_correction;
mod options;
mod pairs;
mod rigid;
mod state;
mod stiffness;
mod tangent;

pub use evaluation::{Contact, contact_force};
pub use fields::{NodalContact, NodeStatus, PointOfContact, SideOfPoint};
pub use forces::{ContactForces, PairForces, Resultant};
pub use laws::{EnergyLaw, FiberProfile};
pub use options::Options;
pub use stiffness::{StiffnessFrom, suggest_fiber_stiffness, suggest_stiffness};
pub use tangent::{RankOne, Tangent, TangentPart};
