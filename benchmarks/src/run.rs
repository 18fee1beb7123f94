//! Cases carried out: from a case to its history, fields, pictures and figures.
//!
//! ```text
//! OUT/history.csv      every step: energies, contact forces, velocities, overlap    (streamed)
//! OUT/fields.pvd       the series of OUT/fields/NNNN.vtu, for ParaView              (streamed)
//! OUT/energies.png     and .svg: kinetic, strain, contact and total energy over time
//! OUT/forces.png       and .svg: contact forces on bodies and obstacles over time
//! OUT/animation.gif    the deformed bodies coloured by von Mises stress (2D, where the case asks for it)
//! OUT/summary.json     figures and checks
//! OUT/checkpoint.*     where a run stands; what it has cost only until it is at its end
//! OUT/iterations.csv   every iteration of an equilibrium
//! OUT/equilibrium.vtu  its fields
//! OUT/fibers.vtu       fibers through the contact, their stretches inside both bodies, and their crossings as points
//! OUT/load_steps.csv   every equilibrium on the way; OUT/reactions.* its forces, where there are several
//! OUT/pressure.*       pressure on the contact surface, beside the closed form: CSV, PNG and SVG
//! ```
//!
//! Everything but the seconds follows from the case: a run that was interrupted and resumed leaves the same files as one
//! that was not, and figures and pictures are made from `history.csv` and the fields alone.

#[cfg(feature = "plots")]
mod animation;
#[cfg(feature = "plots")]
mod canvas;
mod driven;
mod equilibrium;
mod fibers;
mod fields;
mod figures;
mod forces;
mod frames;
mod hertz;
mod history;
mod indentation;
mod patch;
mod plots;
mod profile;
mod runner;
mod sliding;
mod summary;
mod way;

pub use equilibrium::{Solved, run_at_rest, solve};
pub use fibers::traces;
pub use figures::{Figure, Motion};
pub use hertz::HertzLine;
pub use history::History;
pub use profile::Profile;
pub use runner::{Ending, Progress, RunOptions, run};
pub use summary::{Check, Reference, Summary};
pub use way::LoadStep;
