//! Energy laws and the forces of all pairs.

mod augmentation;
mod contact_step;
pub mod descent;
mod evaluation;
mod explicit;
mod friction;
mod interface;
mod laws;
mod method;
mod multipliers;
mod partners;
mod results;
mod steps;
mod tangents;
mod work;

pub use augmentation::Augmentation;
pub use contact_step::{CondensedBodies, ContactStep, ContactStepOptions, ContactStepState, Place};
pub(crate) use evaluation::{Earlier, Needed};
pub use friction::{Friction, FrictionTotals};
pub use interface::{Contact, FrictionStep, contact_force, contact_force_step};
pub use laws::{EnergyLaw, EnergyProfile, PenetrationLaw, StiffnessFrom, suggest_fiber_stiffness, suggest_stiffness};
pub use method::Options;
pub use multipliers::Multiplier;
pub use partners::PairOptions;
pub use results::{ContactForces, PairForces, Resultant};
pub use results::{GapConstraints, NodalContact, NodeStatus, PointOfContact, SideOfPoint};
pub(crate) use tangents::compressed;
pub use tangents::{CompressedRows, Pattern, RankOne, Tangent, TangentPart};
