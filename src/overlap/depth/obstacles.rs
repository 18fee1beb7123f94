//! A body and a rigid obstacle, which has the depth.
//!
//! Obstacles with flat faces in closed form: `convex_solid` · `locally_convex` (that are convex where the body is) ·
//! `facet_part` · `convex_facets` (over facets) · `convex_volume` (over the overlap). Convex ones with a shell: `round_cells` (what of
//! them is nearest) · `round_points` · `rounded`. Others by quadrature: `adaptive` (division until nothing is missed) · `quadrature`.
//! `facet_moments` (what a facet adds) · `integral` (all of it together)

mod adaptive;
mod convex_facets;
mod convex_solid;
mod convex_volume;
mod facet_moments;
mod facet_part;
mod integral;
mod least_of;
mod locally_convex;
mod quadrature;
mod round_cells;
mod round_points;
mod rounded;

pub(crate) use integral::of_obstacle;
