//! Energy law, forces and their balance.

mod balance;
mod candidate;
mod evaluation;
mod forces;
mod kept_patches;
mod law;
mod options;
mod pair_energy;
mod partners;
mod stiffness;
mod tangent;

pub use evaluation::{Contact, contact_force};
pub use forces::{ContactForces, PairForces, Resultant};
pub use law::{EnergyLaw, FiberProfile};
pub use options::Options;
pub use stiffness::{StiffnessFrom, suggest_fiber_stiffness, suggest_stiffness};
pub use tangent::{RankOne, Tangent, TangentPart};
