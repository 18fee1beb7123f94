//! The law `depth` of bodies on lines: the parts of a line inside both bodies, cell by cell, and the crossings that bound
//! them.
//!
//! On a line that passes through a piece of A and one of B at once both depths are linear, so that its sums are closed
//! forms; the faces between pieces are crossed by the same watertight rule as facets. With consistent weights the gradient is
//! that of the energy on the same lines. No direction has a part in the energy: it is noise alone.
//!
//! `chords` (a line in a piece) · `line_sums` (what one line adds) · `moments` (of what is
//! inside) · `curvature` (of a profile) · `facet_touches` (the crossings, facet by facet) ·
//! `two_bodies` (both sides together)

mod chords;
mod curvature;
mod facet_touches;
mod line_sums;
mod moments;
mod two_bodies;

pub(crate) use two_bodies::depth_integral;
