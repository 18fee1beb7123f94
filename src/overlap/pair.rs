//! Two sides, where they can overlap, and what is known of their overlap.

pub(crate) mod assembly;
pub(crate) mod body_facet;
pub(crate) mod bounds;
pub(crate) mod distance_slopes;
pub(crate) mod fiber_trace;
pub(crate) mod half_space;
pub(crate) mod imbalance;
pub(crate) mod layer;
pub(crate) mod main_normal;
pub(crate) mod obstacle_distance;
pub(crate) mod obstacle_region;
#[cfg(test)]
pub(crate) mod of_meshes;
pub(crate) mod options;
pub(crate) mod overlap;
pub(crate) mod partner;
pub(crate) mod region;
pub(crate) mod region_search;
pub(crate) mod second_derivative;
pub(crate) mod sides;
pub(crate) mod surface_point;
pub(crate) mod warning;
