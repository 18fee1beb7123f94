//! The law `depth` by exact clipping.
//!
//! ```text
//! J_B = ∫_{A∩B} g_B dx        δJ_B(v) = ∫_{∂A∩B} g_B v_A·n dA − ∫_{A∩B} ∇g_B·v_B dx
//! ```
//!
//! The first integral is over facets of A clipped by the pieces of B on which g_B is linear, the second, and J_B itself,
//! need the first two moments of A in every such piece: from pieces of A clipped by pieces of B.
//!
//! `integral` (which of the two it is) · `bodies` (two of cells, or one with itself) · `obstacles` (a rigid partner)

mod bodies;
mod facet_sums;
mod integral;
mod obstacles;
mod simplex_parts;

pub(crate) use integral::depth_integral;
