//! Rims: edges at which a curved face ends at one that has another height there.
//!
//! The depth below the faces is continuous, so it has no height on a rim, and in the row of facets along it less than the faces have. What presses
//! there has the sag of one side alone.

use crate::geometry::Surface;
use crate::geometry::boundary::facet_sags::{FacetSag, edge_count};
use crate::geometry::boundary::facets_around::FacetsAround;
use std::collections::BTreeSet;

/// Part of the height of an edge by which that of the other facet there is another.
const DIFFERS: f64 = 1e-3;

/// Whether facets lie along a rim; only solids have rims.
pub(super) fn at_rims<const D: usize>(
    surface: &Surface<D>,
    sags: &[FacetSag<D>],
    is_surface: &[bool],
    around: &FacetsAround,
) -> Vec<bool> {
    let facets = &surface.facets;
    let mut on_rim = BTreeSet::new();
    let edge = |facet: usize, k: usize| [facets[facet][k], facets[facet][(k + 1) % D]];
    let is_edge = |[a, b]: [u32; 2], of: [u32; 2]| of == [a, b] || of == [b, a];
    for facet in (0..facets.len()).filter(|&facet| D == 3 && is_surface[facet]) {
        for k in 0..edge_count(D) {
            let (height, here) = (sags[facet].at_edges[k], edge(facet, k));
            let differs = |other: usize| {
                let same = (0..edge_count(D)).find(|&j| is_edge(here, edge(other, j)));
                same.is_some_and(|j| (sags[other].at_edges[j] - height).abs() > DIFFERS * height.abs())
            };
            let mut others = around.of_body(facet, here[0]).filter(|&other| other != facet);
            if height != 0.0 && others.any(|other| is_surface[other] && differs(other)) {
                on_rim.extend(here.map(|vertex| (around.body(facet), vertex)));
            }
        }
    }
    let is_at = |(facet, sag): (usize, &FacetSag<D>)| {
        !sag.is_flat() && facets[facet].iter().any(|&vertex| on_rim.contains(&(around.body(facet), vertex)))
    };
    sags.iter().enumerate().map(is_at).collect()
}
