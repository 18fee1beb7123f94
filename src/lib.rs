//! Contact mechanics as a plug-in for any finite element code.
//!
//! The module takes node coordinates and connectivity and returns nodal contact forces, overlap volumes and energies.
//! There is no master and slave, and meshes need not match: every overlap has an energy, and its derivative by the
//! coordinates is the contact force. By default the energy is k/2 times the integral, over what is inside both bodies, of
//! the depths below both surfaces, measured exactly on straight cells. Overlaps can also be sampled by lines ("fibers"), as
//! in Wang, Xu and Xue, "Solving contact problems using Fiber Monte Carlo", from which the module comes.
//!
//! The floors of the code, each of which imports only from those to its right:
//!
//! ```text
//! capi  ->  partition  ->  contact  ->  interfaces  ->  overlap, sparse  ->  configuration, depth_field, sampling  ->  ranks  ->  geometry  ->  error
//! ```
//!
//! `capi` (the C interface) · `partition` (meshes that ranks hold in parts) · [`contact`] (energy law, forces) · `interfaces` (surfaces that are tied, or held until they break) · [`overlap`]
//! (volume and contact points, sampled or exact) · [`sparse`] (matrices of hosts, factorised) · `configuration` (the bodies at
//! given coordinates) · `depth_field` (how deep their cells lie below their surfaces) · [`sampling`] (where the fibers lie) · `ranks`
//! (work that is shared) · [`geometry`] (surfaces, crossings, obstacles) · [`Error`]. `ARCHITECTURE.md` has the drawing, the path of a coordinate and a glossary.
//!
//! Same input, same bits, for any number of threads: there is no clock, no global state and no arrival order anywhere.

mod configuration;
pub mod contact;
mod depth_field;
mod error;
pub mod geometry;
mod interfaces;
pub mod overlap;
mod partition;
mod ranks;
pub mod sampling;
pub mod sparse;

#[allow(unsafe_code)]
mod capi;

pub use contact::{Contact, ContactForces, EnergyLaw, EnergyProfile, Options, PenetrationLaw, contact_force};
pub use error::{Error, FrictionFault, LawFault, MapPoint};
pub use geometry::{
    Basis, Bodies, BoundaryFacet, CellBlock, CellType, FacetBlock, FacetType, HeightField, Measures, Obstacle,
    PointWeights, Pose, Shape, ShapeKind, SignedDistance, Surface,
};
pub use overlap::{Estimator, FiberOptions, LineWeights, Resolution, Warning};
pub use partition::{CarriedSlip, GatheredCounts, MeshPart, PartitionedContact};
pub use ranks::{AllToAll, Asked, Communicator, RankCounts};
pub use sampling::FiberPattern;

/// The documentation's Rust code, run by the tests.
#[cfg(doctest)]
#[doc = include_str!("../docs/first-contact.md")]
struct FirstContact;
