//! What a file says: its keywords in their order, each with its line.
//!
//! `deck` (all of it) · `file` (how it is read) · `scope` (which keyword stands where) · `words` (parameters that a keyword may have) · `names` (nodes, elements and
//! their sets) · `elements` (types that are solved, and their faces) · `material`, `section` · `amplitude` · `surface` ·
//! `interaction` (pairs, friction, ties) · `general` (contact of all with all) · `equation`, `mpc` (linear constraints) · `rigid` (nodes of a reference node) · `analytical`, `rigid_elements`, `rigid_faces` (rigid surfaces, as layers) · `step` (supports and loads) · `transform` (local axes) · `rows` (nodes and elements) · `output` (keywords that change nothing) · `note` (what is taken in another sense)

mod amplitude;
mod analytical;
mod deck;
mod elements;
mod equation;
mod file;
mod general;
mod interaction;
mod material;
mod mpc;
mod names;
mod note;
mod output;
mod rigid;
mod rigid_elements;
mod rigid_faces;
mod rows;
mod scope;
mod section;
mod step;
mod surface;
mod transform;
mod words;

pub(crate) use amplitude::Amplitude;
pub use deck::Deck;
pub(crate) use elements::{ElementRow, face_corners};
pub(crate) use equation::{EquationRow, Term};
pub(crate) use interaction::{PairRow, TieRow};
pub(crate) use names::Kind;
pub use note::Note;
pub(crate) use rigid::{Members, RigidKind, RigidRow};
#[cfg(test)]
pub(crate) use scope::Scope;
pub(crate) use section::SectionRow;
pub(crate) use step::{Boundary, Load, LoadKind, Step};
pub(crate) use surface::SurfaceRow;
pub(crate) use transform::TransformRow;
