//! Surfaces that belong together: where they face one another, and what holds them there.
//!
//! `between` (which facets) · `common_pieces` (of facets that face one another) · `visible` (with `near_facets`) (what hides them) · `facing_points` (quadrature on these) · `place` (a place of a facet, by the points that
//! move it) · `opposite` (points of a piece, and what lies opposite) · `covered` (what of facets pieces cover) · `frame` (how the normal of a
//! facet turns) · `hold` (by which side) · `tie` (the rows of a tie) · `tie_energy` (its energy, forces and tangent) · `supported` (rows of a tie where supports hold both sides) · `cohesive_law` (how an
//! interface breaks) · `ppr_law` (another way) · `point_state` (what its points carry on) · `broken_friction` (where it is broken) · `cohesion` (its points) · `cohesive_energy` (as of a tie) · `glide` (surfaces that slide and do not separate) ·
//! `glide_energy` (as of a tie) · `interface_law` (a law of the host), `law_check` (whether it is one) · `governed` (an interface that follows one), `governed_energy` (as of a tie), with `axes` (normal and axes of a
//! facet) · `square` (second derivatives by the nodes of a piece) · `sums_by_node` (of a row)

mod axes;
mod between;
mod broken_friction;
mod cohesion;
mod cohesive_energy;
mod cohesive_law;
mod common_pieces;
mod covered;
mod facing_points;
mod frame;
mod glide;
mod glide_energy;
mod governed;
mod governed_energy;
mod hold;
mod interface_law;
mod law_check;
mod near_facets;
mod opposite;
mod place;
mod point_state;
mod ppr_law;
mod square;
mod sums_by_node;
mod supported;
mod tie;
mod tie_energy;
mod visible;

pub(crate) use between::{Between, HeldFacets};
pub(crate) use broken_friction::BrokenFriction;
pub(crate) use cohesion::Cohesion;
pub(crate) use cohesive_energy::{CohesionAt, Softened};
pub(crate) use cohesive_law::CohesiveLaw;
pub use cohesive_law::{Cohesive, Softening};
pub(crate) use facing_points::{FacingSurfaces, normal_of, shape_at};
pub(crate) use glide::{Glide, GlideRow};
pub(crate) use glide_energy::GlideAt;
pub(crate) use governed::{Governed, LawFields};
pub(crate) use governed_energy::GovernedAt;
pub use interface_law::{InterfaceLaw, LawFailure, LawPoints, LawResponse};
pub use law_check::{LawCheck, LawReport, check_law};
pub(crate) use law_check::{ROUNDED, alike};
pub(crate) use point_state::PointState;
pub use point_state::{PointDamage, PointHistory};
pub use ppr_law::Ppr;
pub(crate) use tie::{Tie, TieRow};
pub(crate) use tie_energy::{Curvature, TieAt};
