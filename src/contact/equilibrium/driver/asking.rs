//! What a search asks, and whom.
//!
//! `request`, `unknowns` (what of) · `conversation` (a procedure that asks) · `host` (whom) · `assembly` (the bodies as the search sees them) · `options`,
//! `outcome`, `trouble` (how it may go, and how it ends)

pub(crate) mod assembly;
pub(crate) mod conversation;
pub(crate) mod host;
pub(crate) mod options;
pub(crate) mod outcome;
pub(crate) mod request;
pub(crate) mod trouble;
pub(crate) mod unknowns;
