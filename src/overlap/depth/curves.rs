//! The law `depth` of bodies with faces that are known to be curved, for which straight facets stand.
//!
//! Where curved faces conform, the waves of their straight facets are larger than the penetration. So what is shallow is measured on the
//! surfaces: the depth of a point of a facet below the other body is that below the straight faces, and the heights of both curved
//! surfaces above their facets. These are fixed in the material, so that they move no point: forces of both sides act at one place. What
//! is deep is measured by the overlap, which has an energy without a step wherever bodies go. Together they are
//!
//! ```text
//! J = ½ Σ_sides ∫ Ψ(g) dA + m/(m−1) J(c) − 1/(m−1) J(m c)
//! ```
//!
//! with J(c) the integral of the depths beyond c over the overlap, and Ψ' = g up to c, from there down to zero at m c: a flat contact has
//! the pressure k g at every depth g.
//!
//! `tent` (Ψ) · `shell`, `layer` (a body and a layer around it) · `facet_points`, `of_facet`, `by_rays`, `rays`, `parabola` (facets, and how
//! they are divided) · `facet_point`, `point_blocks`, `borders`, `rules` (points on them) · `height_errors` (of coarse faces) ·
//! `joined` (all together)

mod borders;
mod by_rays;
mod facet_point;
mod facet_points;
mod height_errors;
mod joined;
mod layer;
mod of_facet;
mod parabola;
mod point_blocks;
mod rays;
mod rules;
mod shell;
mod tent;

pub(super) use joined::of_curved_bodies;
