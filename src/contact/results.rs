//! What a contact returns.
//!
//! `forces` · `friction_heat` · `nodal_contact` (the contact at nodes) · `point_of_contact`, `points` (contact points with both their sides) ·
//! `gap_constraints` · `rotation` (of obstacles, in the tangent) · `onto_nodes` (results at points of cells of second order, as the nodes have them)

mod forces;
mod friction_heat;
mod gap_constraints;
mod nodal_contact;
mod onto_nodes;
mod point_of_contact;
mod points;
mod rotation;

pub use forces::{ContactForces, PairForces, Resultant};
pub use friction_heat::FrictionHeat;
pub use gap_constraints::GapConstraints;
pub use nodal_contact::{NodalContact, NodeStatus};
pub(super) use onto_nodes::OntoNodes;
pub use point_of_contact::{PointOfContact, SideOfPoint};
pub(super) use points::points_of_contact;
pub(super) use rotation::add_rotation;
