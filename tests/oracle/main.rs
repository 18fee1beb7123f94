//! Independent ways to the same numbers: closed forms, clipping by half-spaces, point sampling, finite differences.

#[path = "../scene/scene.rs"]
mod scene;

mod halfspaces;
mod membership;

mod boxes;
mod built_shapes;
mod cell_types;
mod differences;
mod flat_obstacles;
mod hollow_bodies;
mod islands;
mod polygons;
mod pose_gradient;
mod raster;
mod round_obstacles;
mod self_overlap;
mod several_bodies;
mod signed_distances;
mod slivers;
mod tetrahedra;
mod traces;
