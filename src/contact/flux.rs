//! Scalar fields through contact: heat that flows between bodies that touch, are tied, or are near one another.
//!
//! `conductance` (by pressure and gap) · `of_bodies`, `of_obstacle`, `of_held` (what a pair conducts) · `shares` (a flux at points, summed at
//! nodes) · `request`, `found` (what hosts ask and get)

mod conductance;
mod found;
mod of_bodies;
mod of_held;
mod of_obstacle;
mod request;
mod shares;

pub use conductance::Conductance;
pub use found::ContactFlux;
pub(crate) use of_bodies::of_bodies;
pub(crate) use of_held::{HeldSurfaces, of_cohesion, of_glide, of_governed, of_tie};
pub(crate) use of_obstacle::of_obstacle;
pub use request::FluxRequest;
