//! A context: a contact of either dimension, what was found with it, and the lock that lets one call in at a time.

pub(super) mod found;
pub(super) mod resident;
pub(super) mod search;
pub(super) mod session;
pub(super) mod state;
