//! Facets that meet where the surface is smooth have one height there.

use super::{FacetSag, edge_count};
use crate::geometry::boundary::sags::SMOOTH;
use crate::geometry::{Surface, Vector};
use rustc_hash::FxHashMap;
use std::ops::Range;

impl<const D: usize> Surface<D> {
    /// Gives facets that meet at a smooth corner or edge the mean of their heights there.
    pub(super) fn agree(&self, sags: &mut [FacetSag<D>], normals: &[Vector<D>], is_surface: impl Fn(usize) -> bool) {
        // By body: others may share its nodes.
        let mut shared: FxHashMap<(usize, [u32; 2]), Shared<D>> = FxHashMap::default();
        let of_body = |(body, range): (usize, &Range<usize>)| {
            range.clone().map(move |number| (body, number, &self.facets[number]))
        };
        let all = || self.ranges.iter().enumerate().flat_map(of_body).filter(|(_, number, _)| is_surface(*number));
        let places = |facet: &[u32; D]| {
            let facet = *facet;
            let corners = (0..D).map(move |k| ([facet[k]; 2], k, false));
            corners.chain((0..edge_count(D)).map(move |k| (ends(&facet, k), k, true)))
        };
        let height = |sag: &FacetSag<D>, k: usize, is_edge: bool| {
            if is_edge { sag.at_edges[k] } else { sag.at_corners[k] }
        };
        for (body, number, facet) in all() {
            for (place, k, is_edge) in places(facet) {
                shared.entry((body, place)).or_default().add(&normals[number], height(&sags[number], k, is_edge));
            }
        }
        for (body, number, facet) in all() {
            for (place, k, is_edge) in places(facet) {
                let Some(mean) = shared.get(&(body, place)).and_then(Shared::mean) else { continue };
                let sag = &mut sags[number];
                if is_edge {
                    sag.at_edges[k] = mean;
                } else {
                    sag.at_corners[k] = mean;
                }
            }
        }
    }
}

/// What the facets have at a corner or an edge.
#[derive(Clone, Copy)]
struct Shared<const D: usize> {
    first: Vector<D>,
    is_smooth: bool,
    sum: f64,
    count: f64,
}

impl<const D: usize> Default for Shared<D> {
    fn default() -> Self {
        Self { first: Vector::zeros(), is_smooth: true, sum: 0.0, count: 0.0 }
    }
}

impl<const D: usize> Shared<D> {
    fn add(&mut self, normal: &Vector<D>, height: f64) {
        if self.count == 0.0 {
            self.first = *normal;
        }
        self.is_smooth &= self.first.dot(normal) > SMOOTH;
        self.sum += height;
        self.count += 1.0;
    }

    /// `None` at an edge of the body.
    fn mean(&self) -> Option<f64> {
        self.is_smooth.then(|| self.sum / self.count)
    }
}

/// Ends of an edge of a facet, the lower first.
fn ends<const D: usize>(facet: &[u32; D], edge: usize) -> [u32; 2] {
    let (p, q) = (facet[edge], facet[(edge + 1) % D]);
    [p.min(q), p.max(q)]
}
