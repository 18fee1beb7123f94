//! Rims: edges at which a curved face ends at one that has another height there.
//!
//! The depth below the faces is continuous, so to facets that do not bend the other way it has no height on a rim, and in the row of facets
//! along it less than the faces have. What presses there has the sag of one side alone.

use crate::geometry::boundary::facet_sags::{FacetSag, edge_count};
use crate::geometry::boundary::facets_around::FacetsAround;
use crate::geometry::boundary::sags::SMOOTH;
use crate::geometry::mesh::components::Components;
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::{Surface, Vector};
use rustc_hash::FxHashMap;
use std::collections::BTreeMap;

/// Part of the height of an edge by which that of the other facet there is another.
const DIFFERS: f64 = 1e-3;

/// An edge is hollow where a facet rises above the plane of another by more than this part of its length.
const HOLLOW: f64 = 1e-6;

/// Facets without deformation.
pub(super) struct Facets<'a, const D: usize> {
    pub(super) surface: &'a Surface<D>,
    pub(super) points: &'a [Vector<D>],
    pub(super) sags: &'a [FacetSag<D>],
    pub(super) is_surface: &'a [bool],
    pub(super) around: &'a FacetsAround,
}

/// The rims of a surface; only solids have some.
pub(super) struct Rims {
    /// Whether a facet lies along one.
    pub(super) at: Vec<bool>,
    /// Of facets at a vertex on a rim, the number of the smooth face there that each is of; none at a vertex with a hollow edge, where a way
    /// out along one face leads into another.
    faces: FxHashMap<(u32, u32), u32>,
}

impl Rims {
    pub(super) fn new<const D: usize>(facets: &Facets<D>) -> Self {
        let all = if D == 3 { facets.surface.facets.len() } else { 0 };
        // A facet of each body that has the vertex on a rim.
        let mut on_rim: BTreeMap<(u32, u32), usize> = BTreeMap::new();
        for facet in (0..all).filter(|&facet| facets.is_surface[facet]) {
            for ends in (0..edge_count(D)).filter(|&k| facets.is_rim(facet, k)).map(|k| facets.edge(facet, k)) {
                on_rim.extend(ends.map(|vertex| ((facets.around.body(facet), vertex), facet)));
            }
        }
        let is_at = |(facet, sag): (usize, &FacetSag<D>)| {
            let of_body = |vertex: &u32| on_rim.contains_key(&(facets.around.body(facet), *vertex));
            !sag.is_flat() && facets.surface.facets[facet].iter().any(of_body)
        };
        let mut faces = FxHashMap::default();
        for (&(_, vertex), &facet) in &on_rim {
            faces.extend(facets.smooth_faces(facet, vertex));
        }
        Self { at: facets.sags.iter().enumerate().map(is_at).collect(), faces }
    }

    /// The number of the smooth face of a facet at a vertex; `None` where all are one.
    pub(super) fn face(&self, facet: usize, vertex: u32) -> Option<u32> {
        self.faces.get(&(facet as u32, vertex)).copied()
    }
}

impl<const D: usize> Facets<'_, D> {
    fn edge(&self, facet: usize, k: usize) -> [u32; 2] {
        let corners = &self.surface.facets[facet];
        [corners[k], corners[(k + 1) % D]]
    }

    /// The facets beside an edge of another, and the number of the edge in them.
    fn beside(&self, facet: usize, [a, b]: [u32; 2]) -> impl Iterator<Item = (usize, usize)> {
        let same = move |other: usize| {
            let is_same = |of: [u32; 2]| of == [a, b] || of == [b, a];
            (0..edge_count(D)).find(|&k| is_same(self.edge(other, k))).map(|k| (other, k))
        };
        let others = self.around.of_body(facet, a).filter(move |&other| other != facet && self.is_surface[other]);
        others.filter_map(same)
    }

    /// Whether the height of a facet on its edge is none of the one beside it.
    fn is_rim(&self, facet: usize, k: usize) -> bool {
        let height = self.sags[facet].at_edges[k];
        let differs =
            |(other, j): (usize, usize)| (self.sags[other].at_edges[j] - height).abs() > DIFFERS * height.abs();
        height != 0.0 && self.beside(facet, self.edge(facet, k)).any(differs)
    }

    /// The smooth faces at a vertex of the body of a facet: their facets, with a number for each face.
    fn smooth_faces(&self, facet: usize, vertex: u32) -> Vec<((u32, u32), u32)> {
        let here: Vec<usize> = self.around.of_body(facet, vertex).filter(|&other| self.is_surface[other]).collect();
        let mut faces = Components::new(here.len());
        for (p, &one) in here.iter().enumerate() {
            let corners = self.surface.facets[one].map(|v| self.points[v as usize]);
            let Some(normal) = area_vector(&corners).try_normalize(0.0) else { continue };
            for ends in (0..edge_count(D)).map(|k| self.edge(one, k)).filter(|ends| ends.contains(&vertex)) {
                for (other, _) in self.beside(one, ends) {
                    let Some(q) = here.iter().position(|&number| number == other) else { continue };
                    let of_other = self.surface.facets[other].map(|v| self.points[v as usize]);
                    if normal.dot(&area_vector(&of_other)) > SMOOTH * area_vector(&of_other).norm() {
                        faces.join(p as u32, q as u32, false);
                    } else if of_other.iter().any(|x| normal.dot(&(x - corners[0])) > HOLLOW * (x - corners[0]).norm())
                    {
                        return Vec::new();
                    }
                }
            }
        }
        (0..here.len()).map(|p| ((here[p] as u32, vertex), faces.find(p as u32).0)).collect()
    }
}
