//! Which part of facets common pieces cover, and what they leave out.

use super::common_pieces::{CommonPiece, Facing};
use crate::Error;
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::{Vector, Weighting};
use crate::overlap::{Partner, Warning};
use std::collections::BTreeMap;

/// Part of a facet that pieces may cover twice by rounding.
const TWICE: f64 = 1e-6;

/// Part of what is covered above which facets that are covered in part are told.
const TOLD: f64 = 0.01;

/// What lies beyond the reach of facets that are covered in part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct LeftOut {
    pub(crate) area: f64,
    /// How far apart both surfaces are there at most, and the reach.
    pub(crate) farthest: f64,
    pub(crate) reach: f64,
}

impl LeftOut {
    /// What is to be said of two bodies that are held together over an area.
    pub(crate) fn warning(&self, bodies: [usize; 2], tied: f64) -> Warning {
        let [a, b] = bodies.map(Partner::Body);
        Warning::TiedInPart { a, b, tied, left_out: self.area, distances: [self.reach, self.farthest] }
    }
}

#[derive(Default)]
struct OfFacet {
    covered: f64,
    beyond: f64,
    farthest: f64,
}

/// Which part of every facet pieces cover.
#[derive(Default)]
pub(super) struct Covered(BTreeMap<usize, OfFacet>);

impl Covered {
    pub(super) fn add<const D: usize>(&mut self, piece: &CommonPiece<D>) {
        let found = self.0.entry(piece.facets[0]).or_default();
        found.covered += piece.within;
        if piece.beyond > 0.0 {
            (found.beyond, found.farthest) = (found.beyond + piece.beyond, found.farthest.max(piece.distances[1]));
        }
    }

    /// Refuses facets that are covered twice.
    pub(super) fn check(&self) -> Result<(), Error> {
        match self.0.values().any(|part| part.covered > 1.0 + TWICE) {
            true => Err(Error::Unsupported {
                what: "bodies that are held together where several faces of one lie within reach",
            }),
            false => Ok(()),
        }
    }

    /// What is covered by another pair of facets is not left out.
    pub(super) fn left_out<const D: usize>(
        &self,
        facing: &Facing<D>,
        weighting: Weighting,
        whole: f64,
    ) -> Option<LeftOut> {
        let (mut area, mut farthest) = (0.0, 0.0_f64);
        for (facet, of_facet) in self.0.iter().filter(|(_, part)| part.covered > 0.0) {
            let corners = facing.corners(*facet);
            let centre = corners.iter().sum::<Vector<D>>() / D as f64;
            let part = of_facet.beyond.min(1.0 - of_facet.covered).max(0.0);
            area += part * area_vector(&corners).norm() * weighting.at(&centre);
            farthest = farthest.max(of_facet.farthest);
        }
        (area > TOLD * whole).then_some(LeftOut { area, farthest, reach: facing.given })
    }
}
