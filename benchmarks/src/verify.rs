//! Verification: overlap and its derivative against closed forms, the benchmarks of the paper's section 2.4.
//!
//! Every case is measured by isotropic fibers (the paper's), by lines and exactly, as a mesh and, where it is one, as an
//! implicit shape, at several θ. The derivative comes from the nodal gradient by the chain rule, dV/dθ = Σ ∂V/∂x·dx/dθ,
//! or from the gradient with respect to the pose of a shape.

mod bounds;
mod case;
mod clip;
mod closed_form;
mod cone;
mod convergence;
mod cube;
mod cubes;
mod disc;
mod half_disc;
mod method;
mod over_theta;
mod row;
mod scene;
mod sketch;
mod sphere;
mod squares;
mod table;
mod verification;

pub use convergence::SEEDS;
pub use method::Method;
pub use row::Row;
pub use sketch::{Sketch, sketch};
pub use table::table;
pub use verification::{NAMES, Verification};
