//! Boxes, planes, facets and simplices, with what is measured on each.
//!
//! `aabb`, `tree` (boxes, and those that meet one) · `plane`, `pose`, `motion` (from one pose to another) · `facet`, `facet_slopes`, `nearest_on_facet`, `inside`, `crossing`
//! (facets and lines) · `simplex`, `convex_piece`, `orientation` (parts of simplices) · `quadrature`, `simplex_rule`, `weighting`
//! (integrals)

pub(crate) mod aabb;
pub(crate) mod convex_piece;
pub(crate) mod crossing;
pub(crate) mod facet;
pub(crate) mod facet_slopes;
pub(crate) mod inside;
pub(in crate::geometry) mod motion;
pub(crate) mod nearest_on_facet;
pub(crate) mod orientation;
pub(crate) mod plane;
pub(in crate::geometry) mod pose;
pub(crate) mod quadrature;
pub(crate) mod simplex;
pub(crate) mod simplex_rule;
pub(crate) mod tree;
pub(crate) mod weighting;
