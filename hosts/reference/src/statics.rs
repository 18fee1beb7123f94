//! Bodies at rest: equilibrium of elastic bodies, loads and contact.
//!
//! Sought is the displacement u at which the total energy is least,
//!
//! ```text
//! Π(u) = E(u) + w(x + u) − f·u          strain, contact and work of dead loads
//! r(u) = ∂Π/∂u = f_internal − f_contact − f = 0        on what is not held
//! K(u) = ∂²Π/∂u² = K_elastic + ∂²w/∂x²                 Model::tangent, Contact::tangent
//! ```
//!
//! [`Equilibrium`] is found by the library's search, [`fmc_contact::contact::equilibrium`], to which the bodies are the host that it
//! asks for forces, for products with their matrix and for solutions: as any host's. Bodies are factorised down to the equations on which
//! contact acts, once if they are linear. [`Path`] leads there in load steps that halve and grow.
//! [`Equilibrium::continue_smoothing`] makes the linear fiber law sharp, and [`NewtonSettings::penetration`] is as little as is wanted,
//! whatever the stiffness. [`FixedPoint`] is the loop of Wang, Xu and Xue (Algorithm 2), to compare. [`Linearised`] contact is a part
//! of the bodies to the search.
//!
//! [`Rigid`] bodies are nodes that supports carry along, and degrees of freedom that are joined or follow others.
//!
//! A load step is a step of friction, committed where the path accepts it; a step that is halved leaves nothing behind.
//!
//! For the fiber law the lines are kept during a solve, so that the forces are those of one energy; its forces are not
//! corrected to balance, for the same reason.

mod answers;
mod balance;
mod condensed;
mod condensed_step;
mod continuation;
mod counts;
mod equations;
mod equilibrium;
mod error;
mod fixed_point;
mod follower;
mod iteration;
mod joined;
mod linearised;
mod matrices;
mod named_surfaces;
mod newton_settings;
mod path;
mod pressure;
mod problem;
mod report;
mod rigid;
mod search;
mod turn;
mod unknowns;
mod untouched;

pub use balance::Balance;
pub use equilibrium::Equilibrium;
pub use error::StaticsError;
pub use fixed_point::{FixedPoint, FixedPointEnd};
pub use iteration::{Iteration, Tangent};
pub use linearised::Linearised;
pub use newton_settings::{FrictionPressure, LARGEST_TOLERANCE, NewtonSettings};
pub use path::Path;
pub use pressure::{NodalPressure, nodal_pressures, nodal_tractions};
pub use problem::Problem;
pub use rigid::{Carried, Follower, Rigid, RigidMotion};
