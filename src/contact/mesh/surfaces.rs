//! Parts of the surface that hosts name, and what of pairs is tied.

use crate::Error;
use crate::depth_field::{DepthField, TiedLayer};
use crate::geometry::Surface;
use crate::interfaces::HeldFacets;
use crate::overlap::TiedFacets;
use std::collections::BTreeMap;
use std::sync::{Arc, OnceLock};

/// Named parts of the surface, numbered from 1: their facets, ascending.
#[derive(Default)]
pub(super) struct Surfaces(Vec<Arc<[usize]>>);

impl Surfaces {
    /// Adds one and returns its number.
    ///
    /// # Errors
    /// [`Error::NoSuchNumber`] for a facet that does not exist, [`Error::Unsupported`] without any.
    pub(super) fn add(&mut self, facets: &[usize], facet_count: usize) -> Result<usize, Error> {
        if facets.is_empty() {
            return Err(Error::Unsupported { what: "a surface without facets" });
        }
        if let Some(entry) = facets.iter().position(|&facet| facet >= facet_count) {
            return Err(Error::NoSuchNumber { array: "facets", entry, number: [facets[entry], facet_count] });
        }
        let mut facets = facets.to_vec();
        facets.sort_unstable();
        facets.dedup();
        self.0.push(facets.into());
        Ok(self.0.len())
    }

    /// The bodies of two of them.
    ///
    /// # Errors
    /// [`Error::NoSuchNumber`], [`Error::Unsupported`] for one that has facets of several.
    pub(super) fn bodies<const D: usize>(
        &self,
        surface: &Surface<D>,
        numbers: [usize; 2],
    ) -> Result<[usize; 2], Error> {
        let body = |entry: usize| {
            let facets = self.facets(numbers, entry)?;
            let of = |facet: usize| surface.ranges.iter().position(|range| range.contains(&facet));
            match [facets.first(), facets.last()].map(|facet| facet.and_then(|facet| of(*facet))) {
                [Some(first), Some(last)] if first == last => Ok(first),
                _ => Err(Error::Unsupported { what: "a tie of a surface with facets of several bodies" }),
            }
        };
        Ok([body(0)?, body(1)?])
    }

    fn facets(&self, numbers: [usize; 2], entry: usize) -> Result<&Arc<[usize]>, Error> {
        let number = numbers[entry];
        let found = number.checked_sub(1).and_then(|place| self.0.get(place));
        found.ok_or(Error::NoSuchNumber { array: "surfaces", entry, number: [number, self.0.len()] })
    }

    /// What two of them have of two bodies.
    ///
    /// # Errors
    /// [`Error::NoSuchNumber`] for one that does not exist, [`Error::Unsupported`] for one that has nothing of its body.
    pub(super) fn of_bodies<const D: usize>(
        &self,
        surface: &Surface<D>,
        bodies: [usize; 2],
        numbers: [usize; 2],
    ) -> Result<[Arc<[usize]>; 2], Error> {
        let of_body = |entry: usize| {
            let (facets, range) = (self.facets(numbers, entry)?, &surface.ranges[bodies[entry]]);
            let own = &facets[facets.partition_point(|f| *f < range.start)..facets.partition_point(|f| *f < range.end)];
            match own.is_empty() {
                true => Err(Error::Unsupported { what: "a surface of a pair that has no facet of its body" }),
                false => Ok(own.into()),
            }
        };
        Ok([of_body(0)?, of_body(1)?])
    }
}

/// Facets of pairs that are tied, so that they are in no contact.
#[derive(Default)]
pub(super) struct TiedPairs(BTreeMap<[usize; 2], TiedPair>);

struct TiedPair {
    facets: HeldFacets,
    /// Found when it is asked for first.
    layers: OnceLock<[TiedLayer; 2]>,
}

impl TiedPairs {
    pub(super) fn new(pairs: BTreeMap<[usize; 2], HeldFacets>) -> Self {
        Self(pairs.into_iter().map(|(bodies, facets)| (bodies, TiedPair { facets, layers: OnceLock::new() })).collect())
    }

    /// Has layers found again, on another field.
    pub(super) fn forget_layers(&mut self) {
        self.0.values_mut().for_each(|pair| pair.layers = OnceLock::new());
    }

    /// What is tied of a pair.
    pub(super) fn of<const D: usize>(
        &self,
        surface: &Surface<D>,
        field: &DepthField<D>,
        bodies: [usize; 2],
    ) -> Option<TiedFacets<'_>> {
        let (pair, cells) = (self.0.get(&bodies)?, surface.cells.as_ref()?);
        let layer = |side: usize| TiedLayer::new(surface, (field, cells), bodies[side], &pair.facets[side]);
        let layers = pair.layers.get_or_init(|| [layer(0), layer(1)]);
        Some(TiedFacets { facets: &pair.facets, layers })
    }
}
