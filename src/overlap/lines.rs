//! Lines, or isotropic segments, through the region of contact: `layout`, `resolution` and `bundle` (where they lie),
//! `crossings` and `obstacle_crossings`, `sweep` (what is inside both sides), `volume`, `trace` (to look at).

pub(crate) mod bundle;
pub(crate) mod crossings;
pub(crate) mod layout;
pub(crate) mod obstacle_crossings;
pub(crate) mod resolution;
pub(crate) mod sweep;
pub(crate) mod trace;
pub(crate) mod volume;
