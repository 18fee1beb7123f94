//! Patches of contact: along which directions the lines of a pair run, and which facets count for which.
//!
//! Every facet of either side belongs to one patch, so that whatever comes into contact is counted, and counted once: a
//! span counts half for the patch of either end. Where contact reaches the border between two patches, the energy has a
//! step there.

use super::span::End;
use crate::geometry::Vector;

/// Directions of the lines of one pair, and who counts for which.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Patches<const D: usize> {
    pub(crate) directions: Vec<Vector<D>>,
    /// Spacing of the lines, once it is known and kept.
    pub(crate) spacing: Option<f64>,
    /// Direction of every facet of either side; empty where there is only one.
    pub(super) labels: [Vec<u32>; 2],
}

impl<const D: usize> Patches<D> {
    /// A single patch.
    pub(crate) fn single(direction: Vector<D>) -> Self {
        Self { directions: vec![direction], spacing: None, labels: Default::default() }
    }

    /// The part of a span that counts for one direction: 0, ½ or 1.
    pub(crate) fn part(&self, direction: usize, ends: &[End<D>; 2]) -> f64 {
        if self.directions.len() == 1 {
            return 1.0;
        }
        let label = |end: &End<D>| match *end {
            End::Facet { of_b, facet, .. } => {
                self.labels[usize::from(of_b)].get(facet as usize).map(|&label| label as usize)
            }
            End::Point { .. } => None,
        };
        match [label(&ends[0]), label(&ends[1])] {
            [Some(p), Some(q)] => 0.5 * (f64::from(p == direction) + f64::from(q == direction)),
            [Some(p), None] | [None, Some(p)] => f64::from(p == direction),
            [None, None] => f64::from(direction == 0),
        }
    }
}
