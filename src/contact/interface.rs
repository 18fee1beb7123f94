//! What hosts call: `contact` (the functions of [`Contact`](crate::Contact)) · `obstacles` · `steps` (friction, patches) · `gradients` (its derivatives) · `flux` (of scalar fields) ·
//! `ties` (of bodies that are tied) · `added_ties` (those beside the options of pairs) · `cohesive` (of interfaces that break) · `governed` (of those by a law of the host) · `friction_law` (of friction by one) · `offsets` (of surfaces beside their nodes) · `surfaces` (named
//! parts of them) · `wear` · `stateless` (all in one call) · `instances` (for other crates)

mod added_ties;
mod cohesive;
mod contact;
mod flux;
mod friction_law;
mod governed;
mod gradients;
mod instances;
mod obstacles;
mod offsets;
mod stateless;
mod steps;
mod surfaces;
mod ties;
mod wear;

pub use stateless::{FrictionStep, contact_force, contact_force_step};
