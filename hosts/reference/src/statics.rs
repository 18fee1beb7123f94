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
//! [`Equilibrium`] is solved by Newton's method with a line search on Π, see [`NewtonSettings`]. An iteration linearises
//! the bodies and solves for the contact as it is, on the equations on which it acts: sparse factors of the bodies, once for
//! linear ones, leave a dense Schur complement there. [`Path`] leads there in load steps that halve and grow. Bodies that
//! only contact holds are first brought into light contact. [`Equilibrium::continue_smoothing`] makes the linear fiber law
//! sharp, and [`NewtonSettings::penetration`] is as little as is wanted, whatever the stiffness. [`FixedPoint`] is the loop
//! of Wang, Xu and Xue (Algorithm 2), to compare.
//!
//! Friction has no energy, since its limit follows the pressure: [`FrictionPressure`] says how its equilibrium is found. A load
//! step is a step of friction, committed where the path accepts it; a step that is halved leaves nothing behind.
//!
//! For the fiber law the lines are kept during a solve, so that the forces are those of one energy; its forces are not
//! corrected to balance, for the same reason.

mod approach;
mod balance;
mod contact_model;
mod contact_step;
mod continuation;
mod current_pressure;
mod equilibrium;
mod error;
mod fixed_point;
mod friction;
mod iteration;
mod kept;
mod kept_equations;
mod line_search;
mod linearised;
mod motion;
mod newton;
mod newton_settings;
mod noise;
mod path;
mod penetration;
mod pressure;
mod problem;
mod soft_contact;
mod stiffness;
mod turn;

pub use balance::Balance;
pub use equilibrium::Equilibrium;
pub use error::StaticsError;
pub use fixed_point::{FixedPoint, FixedPointEnd};
pub use iteration::{Iteration, Tangent};
pub use linearised::Linearised;
pub use newton_settings::{FrictionPressure, NewtonSettings};
pub use path::Path;
pub use pressure::{NodalPressure, nodal_pressures, nodal_tractions};
pub use problem::Problem;
