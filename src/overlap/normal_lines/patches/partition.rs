//! Patches of contact: along which directions the lines of a pair run, and which facets count for which.
//!
//! Every facet of either side belongs to one patch, so that whatever comes into contact is counted, and counted once: a
//! span counts half for the patch of either end. Where two patches meet on a smooth surface, the facets along the
//! border pass from the one to the other, linearly in the barycentric coordinates: the parts of all patches are a
//! partition of unity, the energy is as smooth as with one patch, and the parts move with the nodes as the lengths do.
//! Where they meet at a sharp edge, the energy has a step.

use crate::Error;
use crate::geometry::{Vector, Weighting};
use crate::overlap::pair::surface_point::SurfacePoint;

/// Directions of the lines of one pair, and who counts for which.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Patches<const D: usize> {
    pub(crate) directions: Vec<Vector<D>>,
    /// Spacing of the lines, once it is known and kept.
    pub(crate) spacing: Option<f64>,
    /// Directions of the facets of either side; empty where there is only one.
    pub(crate) labels: [Labels; 2],
    /// For facets at a border: the part of every direction at every corner.
    pub(crate) blends: Vec<Vec<[f64; D]>>,
    /// Patches of the contact that are not among them.
    pub(crate) left_out: Vec<LeftOut<D>>,
}

/// A patch that is left out beside others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct LeftOut<const D: usize> {
    /// Unit normal, outwards of the first side.
    pub(crate) normal: Vector<D>,
    /// Measure.
    pub(crate) area: f64,
    /// Mean penetration.
    pub(crate) depth: f64,
}

/// The direction of every facet of one side that may come into contact.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Labels {
    /// Numbers of the facets, ascending.
    pub(crate) facets: Vec<u32>,
    /// Number of each one's direction; a number from the count of directions on is that of a blend.
    pub(crate) labels: Vec<u32>,
}

impl Labels {
    fn of(&self, facet: u32) -> Option<u32> {
        // All facets of a side stand at their own numbers.
        let place = match self.facets.get(facet as usize) {
            Some(&found) if found == facet => facet as usize,
            _ => self.facets.binary_search(&facet).ok()?,
        };
        self.labels.get(place).copied()
    }
}

/// The part of a span that counts for one direction.
pub(crate) struct Part<const D: usize> {
    pub(crate) value: f64,
    /// The same at the corners of the facet at either end, times the share of that end, where it is not the same at
    /// all.
    pub(crate) at_corners: [Option<[f64; D]>; 2],
}

impl<const D: usize> Patches<D> {
    /// A single patch.
    pub(crate) fn single(direction: Vector<D>) -> Self {
        Self { directions: vec![direction], ..Self::default() }
    }

    /// Whether parts vary along facets.
    pub(crate) fn are_blended(&self) -> bool {
        !self.blends.is_empty()
    }

    /// Refuses what lines with a weight cannot have: patches that pass into one another.
    ///
    /// # Errors
    /// [`Error::Unsupported`].
    pub(crate) fn check(&self, weighting: Weighting) -> Result<(), Error> {
        if self.are_blended() && !weighting.is_plain() {
            let what = "the law fiber with axisymmetry where patches pass into one another: use the law depth";
            return Err(Error::Unsupported { what });
        }
        Ok(())
    }

    /// The part of a span that counts for one direction; all of them together are 1.
    pub(crate) fn part(&self, direction: usize, ends: &[SurfacePoint<D>; 2]) -> Part<D> {
        let mut part = Part { value: 1.0, at_corners: [None; 2] };
        if self.directions.len() == 1 {
            return part;
        }
        let labels = ends.each_ref().map(|end| match *end {
            SurfacePoint::Facet { of_b, facet, weights } => {
                self.labels[usize::from(of_b)].of(facet).map(|label| (label as usize, weights))
            }
            SurfacePoint::Point { .. } => None,
        });
        let count = labels.iter().flatten().count();
        if count == 0 {
            part.value = f64::from(direction == 0);
            return part;
        }
        let share = 1.0 / count as f64;
        part.value = 0.0;
        for (label, at_corners) in labels.into_iter().zip(&mut part.at_corners) {
            let Some((label, weights)) = label else { continue };
            match label.checked_sub(self.directions.len()) {
                None => part.value += if label == direction { share } else { 0.0 },
                Some(blend) => {
                    let corners = self.blends[blend][direction].map(|p| share * p);
                    part.value += (0..D).map(|a| weights[a] * corners[a]).sum::<f64>();
                    *at_corners = Some(corners);
                }
            }
        }
        part
    }
}
