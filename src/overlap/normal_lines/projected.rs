//! Contact points by projecting the facets of both sides along the normal of a patch (segment-based mortar integration).

pub(crate) mod contact_points;
pub(crate) mod edge_bounds;
pub(crate) mod edges;
pub(crate) mod inside;
pub(crate) mod kinks;
pub(crate) mod projected_facets;
pub(crate) mod projected_pair;
pub(crate) mod reached;
pub(crate) mod samples;
pub(crate) mod silhouettes;
pub(crate) mod work;
