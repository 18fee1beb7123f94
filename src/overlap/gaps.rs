//! Gaps between surfaces that are near one another or overlap, whatever the law: what methods of others ask for.
//!
//! `near_surface` (the other side, up to a reach) · `facet_gaps` (of one facet over the other side) · `gap_points` (quadrature on facets over an obstacle) · `nodal_gaps` (of the nodes of both sides)

mod facet_gaps;
mod gap_points;
mod height_slopes;
mod near_surface;
mod nodal_gaps;

pub(crate) use gap_points::gap_points;
pub(crate) use nodal_gaps::{NodalGap, nodal_gaps};
