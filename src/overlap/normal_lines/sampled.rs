//! Contact points, and samples for the search for patches, on sampled lines.

pub(crate) mod contact_points;
pub(crate) mod samples;
pub(crate) mod volume_hessian;
