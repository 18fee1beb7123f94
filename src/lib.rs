//! Contact mechanics as a plug-in for any finite element code.
//!
//! The module is given node coordinates and connectivity and returns nodal contact forces, overlap volumes and what
//! belongs to them. It has no master and slave, no pair search and no projection: lines ("fibers") are sent through the
//! bodies, the stretches inside two bodies at once measure their overlap, and the derivative of that measure is the
//! contact force (Fiber Monte Carlo, Wang, Xu and Xue, "Solving contact problems using Fiber Monte Carlo").
//!
//! The floors of the house, each of which imports only from those after it:
//! [`contact`] (energy law, forces) · [`overlap`] (volume and contact points, sampled or exact) ·
//! `configuration` (the bodies at given coordinates) · [`sampling`] (where the fibers lie) · [`geometry`] (surfaces, crossings, obstacles) · [`Error`].
//!
//! Same input, same bits, for any number of threads: there is no clock, no global state and no arrival order anywhere.

mod configuration;
pub mod contact;
mod dimension;
mod error;
pub mod geometry;
pub mod overlap;
pub mod sampling;

#[allow(unsafe_code)]
mod capi;

pub use contact::{Contact, ContactForces, EnergyLaw, FiberProfile, Options, contact_force};
pub use error::Error;
pub use geometry::{Bodies, CellBlock, CellType, HeightField, Obstacle, Pose, Shape, SignedDistance, Surface};
pub use overlap::{Estimator, FiberOptions, LineWeights, Resolution, Warning};
pub use sampling::FiberPattern;

/// The README's Rust code, run by the tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
