//! Options by their names, those of pairs, and a stiffness for a law.

pub(super) mod added_ties;
pub(super) mod context_options;
pub(super) mod friction_law_pair;
pub(super) mod interrupt;
pub(super) mod option_keys;
pub(super) mod orthotropic_pair;
pub(super) mod own_law_pair;
mod pair_conversion;
pub(super) mod pair_interface;
pub(super) mod pair_options;
pub(super) mod ppr_pair;
pub(super) mod stiffness;
