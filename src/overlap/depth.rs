//! The law `depth`, which asks no estimator: it is exact, but for quadrature in rigid obstacles that are curved or not convex.
//!
//! ```text
//! J_B = ∫_{A∩B} g_B dx        δJ_B(v) = ∫_{∂A∩B} g_B v_A·n dA − ∫_{A∩B} ∇g_B·v_B dx
//! ```
//!
//! The first integral is over the facets of A inside the pieces of B on which g_B is linear; the second, and J_B itself,
//! need the first two moments of A in every such piece.
//!
//! `deep_bodies` (two of cells, or one with itself) · `cell_pieces` (the pieces near by) · `facet_blocks`, `facet_sums` and
//! `point_sums` (over facets) · `cell_integrals` (over the overlap) · `obstacles` (a rigid partner)

pub(crate) mod cell_integrals;
pub(crate) mod cell_pieces;
pub(crate) mod deep_bodies;
pub(crate) mod facet_blocks;
pub(crate) mod facet_sums;
mod obstacles;
pub(crate) mod point_sums;
pub(crate) mod simplex_parts;

pub(crate) use deep_bodies::DeepBodies;
