//! Friction: tractions along the surfaces, on the facets on which a law presses.
//!
//! ```text
//! s = e + g      g: slip of two material points that face one another, since the step began, without what both bodies
//!                turned together; e: elastic slip carried into the step
//! q = k_T s      while that is below the limit μ p (stick), else the limit along s (slip)
//! ```
//!
//! `options` · `return_mapping` (from slip to `traction`) · `orthotropic`, `ellipse`, `direction` (limits that are other ones along a direction) · `past_points`, `step` (the state when
//! the step began) · `moved_out` (surfaces that multipliers move out) · `side_motion` (how one side moved since) · `turn` (arcs of sides that turn) · `touch` (the part of the step during which a facet bears) · `carried` (elastic slip from one step to the next) · `carriers` (the facets on which a point
//! lies) · `law`, `law_limits`, `law_check` (limits by a law of the host) · `energy` (what a facet has dissipated) · `bore` (limits before) · `facet_sums` (sums over the points of a facet) · `slip_facets` (the facets of a pair with their slip) ·
//! `tractions` (forces, tangent and energies of a pair) · `frozen` (facets and pressure of an earlier iteration), `duals` (and its tractions) ·
//! `at_points` (what hosts see) · `heat` (where dissipated energy goes) · `worn_off` (by what slides)

mod at_points;
mod bore;
mod carried;
mod carriers;
mod direction;
mod duals;
mod ellipse;
mod energy;
mod facet_sums;
mod frozen;
mod heat;
mod law;
mod law_check;
mod law_limits;
mod moved_out;
mod options;
mod orthotropic;
mod past_points;
mod return_mapping;
mod side_motion;
mod slip_facets;
mod step;
mod touch;
mod traction;
mod tractions;
mod turn;
mod worn_off;

pub(super) use at_points::{NodalFriction, PointFriction};
pub use carried::FacetSlip;
pub(super) use carried::{CarriedSlip, carried_slip, in_order, list as list_slip, of_list as slip_of_list};
pub(super) use carriers::SliderName;
pub(super) use duals::Duals;
pub(super) use frozen::FrozenFriction;
pub(super) use heat::heat_of_released;
pub use law::{FrictionFacets, FrictionLaw, FrictionResponse};
pub(super) use law::{OwnFriction, OwnLimit};
pub use law_check::{FrictionLawCheck, FrictionLawReport, check_friction_law};
pub(super) use moved_out::{Material, MovedOut};
pub use options::{Friction, StaticFriction};
pub use orthotropic::OrthotropicFriction;
pub(super) use orthotropic::Orthotropy;
pub(super) use past_points::PastPoints;
pub(super) use slip_facets::{SlipFacet, SlipFacets};
pub(super) use step::{Sliding, Step};
pub(super) use touch::FacetBearings;
pub(super) use traction::{Stick, Traction};
pub use tractions::FrictionTotals;
pub(super) use tractions::{Tractions, Undirected};
pub(super) use turn::MOST as MOST_TURN;
