//! The law `depth`, which asks no estimator: it is exact, but for quadrature in rigid obstacles that are curved, or not
//! convex where the body is.
//!
//! ```text
//! J_B = ∫_{A∩B} g_B dx        δJ_B(v) = ∫_{∂A∩B} g_B v_A·n dA − ∫_{A∩B} ∇g_B·v_B dx
//! ```
//!
//! The first integral is over the facets of A inside the pieces of B on which g_B is linear; the second, and J_B itself,
//! need the first two moments of A in every such piece.
//!
//! `measure` (of a pair) · `integral` (what a law is handed) · `points` (where it presses) · `facet_sums` (over facets) · `curved_faces` (a warning) · `simplex_parts` ·
//! `bodies` (two of cells, or one with itself) · `curves` (two with curved faces) · `obstacles` (a rigid partner)

mod bodies;
mod curved_faces;
mod curves;
pub(crate) mod facet_sums;
pub(crate) mod integral;
pub(crate) mod measure;
mod obstacles;
pub(crate) mod points;
pub(crate) mod simplex_parts;

pub(crate) use bodies::{DepthSeeds, depth_slopes};
