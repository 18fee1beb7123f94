//! Benchmark problems as data: one TOML file per case, read the same by every host.
//!
//! [`Document`] is the file with its lines, variants and overrides; [`Case`] is what it says, checked. A mistake is a
//! [`CaseError`] that names file, line and key. [`library`] holds the cases that the program brings along, and
//! [`Case::parts`] and its neighbours turn a case into a model.
//!
//! All quantities are SI. In 2D everything is plane strain per metre of thickness.

mod body;
mod change;
mod check;
mod contact;
mod description;
mod document;
mod error;
mod expected;
mod key;
pub mod library;
mod load_steps;
mod meshing;
mod obstacle;
mod place;
mod size;
mod time;

pub use body::{Body, CellKind, Material, MaterialLaw, MeshSource, QuadrilateralPart};
pub use change::{Change, Origin};
pub use contact::{Contact, EstimatorName, LawName, PatternName, WeightsName};
pub use description::{Case, FigureKind, Figures, Output, Variant};
pub use document::Document;
pub use error::{CaseError, Problem};
pub use expected::Expected;
pub use key::Key;
pub use load_steps::LoadSteps;
pub use obstacle::{Obstacle, ShapeName};
pub use place::{Axis, Load, Place, Side, Support};
pub use size::{MOST_LOAD_STEPS, MOST_NODES, MOST_STEPS};
pub use time::Time;
