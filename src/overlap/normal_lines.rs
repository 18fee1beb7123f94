//! The law `fiber`: lines along the normals of the patches where a pair touches.
//!
//! `estimate` (either way, as a pair needs) · `patches` (which facets touch together, along which direction) · `points` (contact
//! points and sums over them) · `projected` and `sampled` (where they come from: facets projected along a direction, or lines
//! along it)
//!
//! Known wrong answers, each held by a test that is ignored until it is mended (`tests/laws`: corners, gaps, patches, motion,
//! same_bits, numbering), and told on the page of options and among the limits:
//!
//! 1. Floor and wall of one body: patches three times as deep as the shallowest are left out, with a warning, and their force with
//!    them; lines of the one patch run through the other's whole depth.
//! 2. Where patches meet at a corner, places count for two patches or for none, and the energy has a step.
//! 3. Moments do not balance: by some 1e-4 of the forces on curved surfaces, by up to 3e-2 at corners. It is warned of from 1e-6.
//! 4. Normals of steep flanks nearly cancel: their mean leans, and the energy of a steep tip is a fifth too small.
//! 5. Sampled lines that run along a free side wall give tangential forces of almost any size, and miss the edges of notches.
//! 6. Exact integration of a profile that is no polynomial has a force that is not quite the slope of its energy.
//! 7. A facet as near to one patch as to another goes to the one with the lower number: renumbering changes forces between patches.

pub(crate) mod estimate;
pub(crate) mod patches;
pub(crate) mod points;
pub(crate) mod projected;
pub(crate) mod sampled;
