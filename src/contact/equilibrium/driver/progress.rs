//! A search under way: where it is, how near it came, and what it has changed.
//!
//! `search` (what its parts share) · `state`, `balance` (bodies and contact, and when they balance) · `before` (what is taken back) · `updates` (multipliers, until what is left of the penetration does
//! not matter), `within_facets` (where there are none) · `patches` (of the law `fiber`) · `falling` (a load that falls) · `stood` (what was before) · `breaking` (interfaces that break)

pub(crate) mod balance;
pub(crate) mod before;
pub(crate) mod breaking;
pub(crate) mod falling;
pub(crate) mod patches;
pub(crate) mod search;
pub(crate) mod state;
pub(crate) mod stood;
pub(crate) mod updates;
pub(crate) mod within_facets;
