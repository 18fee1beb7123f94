//! Wear by Archard (1953): what slides under pressure loses K p |ds| of its depth.
//!
//! `worn` (what was worn off so far, and how far surfaces lie farther in by that) · `growth` (from worn volumes to depths) · `worn_facet` (for a
//! restart)

mod growth;
mod worn;
mod worn_facet;

pub(super) use growth::WornOff;
pub use worn::Wear;
pub(super) use worn::Worn;
pub use worn_facet::WornFacet;
