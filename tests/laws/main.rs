//! What must always hold, whatever the meshes.

#[path = "../scene/scene.rs"]
mod scene;

mod pairs;

mod adjustment;
mod arrangements;
mod bad_meshes;
mod bad_values;
mod balance;
mod boundary_facets;
mod coinciding;
mod corners;
mod energy_gradient;
mod fiber_law;
mod fields;
mod folded;
mod gap_constraints;
mod gaps;
mod glued;
mod hinged;
mod interrupted;
mod law;
mod measures;
mod motion;
mod numbering;
mod pair_options;
mod patches;
mod removed_obstacles;
mod resolution;
mod resting;
mod same_bits;
mod shared_grids;
mod shared_walls;
mod smooth_plane;
mod stable_step;
mod swallowed;
mod tangent;
mod tangled;
mod through_nodes;
mod together;
mod torn;
mod touching;
mod turned_obstacles;
mod units;
mod warnings;
mod wrapped;
