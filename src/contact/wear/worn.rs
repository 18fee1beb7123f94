//! What was worn off so far.

use super::worn_facet::{WornFacet, check};
use crate::Error;
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::{Surface, Vector};
use std::collections::BTreeMap;
use std::sync::Arc;

/// What is worn off the bodies in the steps that were accepted.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Wear {
    /// How far the surface lies farther in at every node, a length.
    pub depth: Vec<f64>,
    /// What every body has lost: a volume, in 2D by unit of thickness.
    pub volumes: Vec<f64>,
}

/// Depth and volume of a facet at a point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Part {
    pub(super) depth: f64,
    pub(super) volume: f64,
}

/// What was worn off, by facet and point: a point at an edge wears on two faces.
#[derive(Clone, Debug)]
pub(crate) struct Worn<const D: usize> {
    pub(super) parts: BTreeMap<(usize, u32), Part>,
    /// From every point of the mesh to the worn surface, by the normals of the facets where the step began; empty before one has.
    inwards: Arc<Vec<[f64; D]>>,
}

impl<const D: usize> Worn<D> {
    pub(crate) fn none() -> Self {
        Self { parts: BTreeMap::new(), inwards: Arc::default() }
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.parts.is_empty()
    }

    /// What a list says.
    ///
    /// # Errors
    /// [`Error::NoSuchRow`], [`Error::BadEntry`].
    pub(crate) fn of_list(list: &[WornFacet], surface: &Surface<D>) -> Result<Self, Error> {
        let points_of = |facet: usize| {
            let corners = surface.facets.get(facet)?;
            Some(corners.iter().flat_map(|&vertex| surface.nodes_of_vertex(vertex)).map(|(point, _)| point))
        };
        check(list, points_of)?;
        let part = |one: &WornFacet| ((one.facet, one.point), Part { depth: one.depth, volume: one.volume });
        Ok(Self { parts: list.iter().map(part).collect(), ..Self::none() })
    }

    /// The same as a list, ascending by facet and point.
    pub(crate) fn list(&self) -> Vec<WornFacet> {
        let one = |(&(facet, point), &Part { depth, volume }): (&_, &_)| WornFacet { facet, point, depth, volume };
        self.parts.iter().map(one).collect()
    }

    /// The same of bodies whose step begins with their points here: the worn surface goes along as facets turn.
    pub(crate) fn at(self, surface: &Surface<D>, points: &[[f64; D]]) -> Self {
        if self.is_empty() {
            return self;
        }
        let vertices = surface.points(points);
        let mut inwards = vec![[0.0; D]; points.len()];
        for (&(facet, point), part) in &self.parts {
            let normal = unit_normal(surface, &vertices, facet);
            (0..D).for_each(|axis| inwards[point as usize][axis] -= part.depth * normal[axis]);
        }
        Self { inwards: Arc::new(inwards), ..self }
    }

    /// Moves points in.
    pub(crate) fn add_to(&self, points: &mut [[f64; D]]) {
        let sums = points.as_flattened_mut().iter_mut().zip(self.inwards.as_flattened());
        sums.for_each(|(x, inwards)| *x += inwards);
    }

    /// By point: how far the surface lies farther in; zero before a step has begun.
    pub(crate) fn depths(&self, point_count: usize) -> Vec<f64> {
        let mut depths: Vec<f64> = self.inwards.iter().map(|way| Vector::from(*way).norm()).collect();
        depths.resize(point_count, 0.0);
        depths
    }

    /// By body.
    pub(crate) fn volumes(&self, surface: &Surface<D>) -> Vec<f64> {
        let of_body = |range: &std::ops::Range<usize>| {
            let parts = self.parts.range((range.start, 0)..(range.end, 0));
            parts.fold(0.0, |sum, (_, part)| sum + part.volume)
        };
        surface.ranges.iter().map(of_body).collect()
    }
}

/// Outwards; zero for a facet without measure.
pub(super) fn unit_normal<const D: usize>(surface: &Surface<D>, vertices: &[Vector<D>], facet: usize) -> Vector<D> {
    let corners = surface.facets[facet].map(|vertex| vertices[vertex as usize]);
    area_vector(&corners).try_normalize(0.0).unwrap_or_else(Vector::zeros)
}
