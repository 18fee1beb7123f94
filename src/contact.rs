//! Energy law, forces and their balance.

mod balance;
mod evaluation;
mod forces;
mod law;
mod options;
mod partners;
mod stiffness;

pub use evaluation::{Contact, contact_force};
pub use forces::{ContactForces, PairForces, Resultant};
pub use law::EnergyLaw;
pub use options::Options;
pub use stiffness::{StiffnessFrom, suggest_stiffness};
