//! Contact points: what a local law is handed, and sums over them.

pub(crate) mod contact_point;
pub(crate) mod contact_points;
pub(crate) mod edge_terms;
pub(crate) mod end_motion;
mod facet_sums;
pub(crate) mod hessian;
pub(crate) mod nodal_sums;
pub(crate) mod silhouette_hessian;
pub(crate) mod trace;
