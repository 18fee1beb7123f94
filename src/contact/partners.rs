//! What bodies may touch: the obstacles, and the options of single pairs.
//!
//! `list` (all together) · `obstacles` (added, moved, removed) · `rigid` (as estimators take them), `sides` (that a point passes) · `parallel` (at a gap offset) ·
//! `pair_options`, `pair_table` (pairs that are left out, or follow a law of their own) ·
//! `layers` (stiffness from that of the bodies) · `bearing_rules` (what decides how facets bear)

mod bearing_rules;
mod layers;
mod list;
mod obstacles;
mod pair_options;
mod pair_table;
mod parallel;
mod rigid;
mod sides;

pub(crate) use bearing_rules::{BearingRule, BearingRules, MeshHashes};
pub use layers::LayerStiffness;
pub(crate) use list::Partners;
pub(crate) use obstacles::Poses;
pub use pair_options::{Interface, PairOptions};
pub(super) use rigid::Placed;
pub(super) use sides::Sides;
