//! Bodies that slide on one another and do not separate: what holds them, found anew as they move.

mod held;

pub(super) use held::Glides;
