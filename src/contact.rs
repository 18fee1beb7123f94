//! Energy laws and the forces of all pairs.

mod changes;
mod cohesive;
mod derivatives;
pub mod equilibrium;
mod evaluation;
mod explicit;
mod flux;
mod friction;
mod glides;
mod governed;
mod held;
mod history;
mod interface;
mod laws;
mod mesh;
mod method;
mod partners;
mod results;
mod tangents;
mod ties;
mod wear;
mod work;

pub use crate::interfaces::{
    Cohesive, InterfaceLaw, LawCheck, LawFailure, LawPoints, LawReport, LawResponse, PointDamage, PointHistory, Ppr,
    Softening, check_law,
};
pub use changes::Adjustment;
pub(crate) use changes::poses::with_poses;
pub use cohesive::{CohesivePoint, CohesiveSummary};
pub use derivatives::{Directions, GradientRequest, Gradients, PairGradient, Slopes};
pub use equilibrium::{Augmentation, CondensedBodies, ContactStep, ContactStepOptions, ContactStepState, Place};
pub use evaluation::Contact;
pub(crate) use evaluation::{Needed, hash_in_common, needed};
pub use explicit::{Accuracy, largest_eigenvalue};
pub use flux::{Conductance, ContactFlux, FluxRequest};
pub use friction::{
    FacetSlip, Friction, FrictionFacets, FrictionLaw, FrictionLawCheck, FrictionLawReport, FrictionResponse,
    FrictionTotals, OrthotropicFriction, StaticFriction, check_friction_law,
};
pub use governed::LawPoint;
pub use history::Multiplier;
pub use interface::{FrictionStep, contact_force, contact_force_step};
pub use laws::{EnergyLaw, EnergyProfile, PenetrationLaw, StiffnessFrom, suggest_fiber_stiffness, suggest_stiffness};
pub use method::Options;
pub(crate) use partners::Poses;
pub use partners::{Interface, LayerStiffness, PairOptions};
pub use results::{ContactForces, PairForces, Resultant};
pub use results::{FrictionHeat, GapConstraints, NodalContact, NodeStatus, PointOfContact, SideOfPoint};
pub(crate) use tangents::compressed;
pub use tangents::{CompressedRows, Pattern, RankOne, Tangent, TangentPart};
pub use ties::{TieConstraints, TieNode, TieSummary};
pub use wear::{Wear, WornFacet};
