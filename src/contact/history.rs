//! What a contact carries from one evaluation to the next, on which results depend.
//!
//! `past` (all of it) · `bearings` (how facets bore when the step began) · `first_touches` (where pairs came to touch in it) · `kept_patches` (patches of the fiber law that are held) · `last` (the equilibrium that a search found last) · `multipliers` (surfaces that are moved out)

mod bearings;
mod first_touches;
mod kept_patches;
mod last;
mod multipliers;
mod past;

pub(super) use bearings::Bearings;
pub(super) use first_touches::FirstTouches;
pub(super) use kept_patches::KeptPatches;
pub(super) use last::LastEquilibrium;
pub use multipliers::Multiplier;
pub(super) use multipliers::{Multipliers, check_law, sorted};
pub(super) use past::{Begun, History};
