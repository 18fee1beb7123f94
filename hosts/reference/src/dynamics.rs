//! Explicit dynamics of deformable bodies in contact: the kick-drift-kick leapfrog of the paper (Eq. leapfrog_kdk and
//! Algorithm 1) with lumped mass.
//!
//! A [`Simulation`] is started from a [`Setup`] and advanced step by step; every step returns a [`Sample`] with energies,
//! resultants and costs. The scheme is of second order, reversible in time and symplectic; with forces that have a
//! potential the total energy oscillates within O(Δt²) and does not drift. What it does not guarantee:
//!
//! 1. A force that jumps (law w = k V with m = 1, whose traction is k or nothing) does work at the jump that no step
//!    size removes entirely; the error of the energy still falls, roughly with the square of the step.
//! 2. A sampled contact force with balance weights, or corrected to ΣF = 0, is not the gradient of one energy.
//!
//! 3. Friction takes energy out: what is lost and what the stick stores are accounted for, to the order of the scheme.
//!
//! The step is bounded by the structure and by the contact's stiffness ([`StepLimit`]). There is no damping unless the
//! setup asks for it. A simulation can be saved and resumed bit for bit ([`Simulation::save`]).

mod advance;
mod checkpoint;
mod contact_frequency;
mod error;
mod evaluation;
mod fingerprint;
mod friction;
mod friction_step;
mod sample;
mod setup;
mod simulation;
mod stable_step;
mod state;
mod step_limit;
mod surface_area;

pub use error::{CheckpointError, DynamicsError};
pub use sample::Sample;
pub use setup::{Setup, Step};
pub use simulation::Simulation;
pub use state::State;
pub use step_limit::StepLimit;
