//! What is known of the bodies, from the host's own matrix and from where they are.
//!
//! `layers` (stiffness of pairs), `masses` (the same for explicit hosts), `joined` (nodes that a host joins) · `motions`, `compatible` (rigid motions that
//! nothing holds) · `elastic`, `projected` (displacements of their own), `paths` (from one state to another) · `rows`, `limit` (gaps, and how far they may go)

pub(crate) mod compatible;
pub(crate) mod elastic;
pub(crate) mod joined;
pub(crate) mod layers;
pub(crate) mod limit;
pub(crate) mod masses;
pub(crate) mod motions;
pub(crate) mod paths;
pub(crate) mod projected;
pub(crate) mod rows;
