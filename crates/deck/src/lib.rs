//! Input files of Abaqus and CalculiX, solved: elastic bodies at rest, in contact, tied, with friction.
//!
//! ```text
//! read       keywords, sets, materials, steps: what the file says, each with its line
//! analysis   bodies, pairs, supports and loads: what it means for the mesh
//! layer      rigid faces as the front of a layer of cells
//! profile    analytical rigid surfaces as faces
//! results    tables, VTU and FRD files of every step
//! ```
//!
//! Nothing is passed over in silence: a keyword, a parameter or a value that is not known is a [`Fault`] with its line. What is taken in
//! another sense than the file may mean is a note.

mod analysis;
mod fault;
mod layer;
mod profile;
mod read;
mod results;

pub use analysis::{Analysis, PairResult, ReferenceResult, SolveOptions, Solved, StepResult, TieResult};
pub use fault::Fault;
pub use read::{Deck, Note};
pub use results::{frd_start, frd_step, step_table, vtu};
