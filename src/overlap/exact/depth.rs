//! The law `depth` by exact clipping.
//!
//! ```text
//! J_B = ∫_{A∩B} g_B dx        δJ_B(v) = ∫_{∂A∩B} g_B v_A·n dA − ∫_{A∩B} ∇g_B·v_B dx
//! ```
//!
//! The first integral is over facets of A clipped by the pieces of B on which g_B is linear, the second, and J_B itself,
//! need the first two moments of A in every such piece: from pieces of A clipped by pieces of B.
//!
//! `cell_pieces` (the pieces of a body near by) · `facet_clip` and `facet_integrals` (the first integral and its
//! derivative) · `piece_moments` (the second) · `integral` (both sides together) · `obstacle` (a rigid partner, with
//! `convex_solid`, `convex_facets` and `convex_volume` where it is convex and has flat faces, and `obstacle_distance`,
//! `adaptive` and `obstacle_quadrature` where it is not).

mod adaptive;
mod body_facet;
mod cell_integrals;
mod cell_pieces;
mod convex_facets;
mod convex_solid;
mod convex_volume;
mod facet_clip;
mod facet_integrals;
mod facet_moments;
mod integral;
mod least_of;
mod node_sums;
mod obstacle;
mod obstacle_distance;
mod obstacle_quadrature;
mod piece_moments;
mod simplex_parts;

pub(crate) use integral::depth_integral;
