//! What a file means for its mesh, and its solution.
//!
//! `bodies` (connected parts of the mesh) · `facets` (their sizes) · `mesh_faults` (in labels) · `notes` (what is taken in another sense) ·
//! `equations` (what follows what) · `levers` (reference nodes that turn freely) · `local_axes` (of nodes) · `looks` (of rigid faces) · `outside` (what presses beside the surfaces of pairs) · `pairs` (who touches, rubs or is tied) · `references`, `shares`, `follow`, `points` (reference nodes: what they move and load, and what names stand for) · `timed` (a value over a step) · `state` (what is held
//! and loaded, step after step) · `surfaces` (and their faces) · `spread`, `spread_loads` (loads on faces and volumes: as forces, and over a step) · `symmetry` (planes that supports make) · `thickness` (of bodies of the plane) · `tied_parts` (faces that ties name) · `ties` (how far they reach) · `solve` (equilibria) · `result` (what a step leaves) · `variants` (of elements) · `warnings` (the library's, in words of files)

mod bodies;
mod equations;
mod facets;
mod follow;
mod levers;
mod local_axes;
mod looks;
mod mesh_faults;
mod notes;
mod outside;
mod pairs;
mod points;
mod references;
mod result;
mod shares;
mod solve;
mod spread;
mod spread_loads;
mod state;
mod surfaces;
mod symmetry;
mod thickness;
mod tied_parts;
mod ties;
mod timed;
mod variants;
mod warnings;

pub(crate) use bodies::{Bodies, Places};
pub(crate) use facets::area;
pub use follow::ReferenceResult;
pub use result::{PairResult, StepResult};
pub use solve::{Analysis, SolveOptions, Solved};
pub use ties::TieResult;
