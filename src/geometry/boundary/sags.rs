//! How far the round surface that straight facets stand for lies beside them.

use super::facets_around::FacetsAround;
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::{Surface, Vector};
use rustc_hash::FxHashMap;

/// Facets that meet at a larger angle meet at an edge of the body: cosine of 45°. An octagon is none of a round body.
pub(crate) const SMOOTH: f64 = std::f64::consts::FRAC_1_SQRT_2;

impl<const D: usize> Surface<D> {
    /// Largest distance of every facet, without deformation, from the surface whose normals at the vertices are those of the facets
    /// around them; all facets of a face have one distance. 0 for flat surfaces, for facets of which `is_surface` does
    /// not hold, and beside edges of the body.
    ///
    /// An edge of length h between normals that differ by the angle h/R stands for an arc that rises h²/8R above it: a quarter of
    /// h times the slope of the normal at an end. Of the two ends the smaller counts, so that a flat facet beside a round one has none.
    pub(crate) fn sags(&self, is_surface: impl Fn(usize) -> bool) -> Vec<f64> {
        let points = self.points(self.reference());
        let mut areas = vec![Vector::<D>::zeros(); self.facets.len()];
        for (number, facet) in self.facets.iter().enumerate().filter(|(number, _)| is_surface(*number)) {
            areas[number] = area_vector(&facet.map(|vertex| points[vertex as usize]));
        }
        let around = FacetsAround::new(self);
        let normal_at = |vertex: u32, of: usize| {
            let own = &areas[of];
            // Facets that are not surface have no area here.
            let smooth = around
                .of_body(of, vertex)
                .filter(|&facet| areas[facet].dot(own) > SMOOTH * areas[facet].norm() * own.norm());
            let sum = smooth.fold(Vector::<D>::zeros(), |sum, facet| sum + areas[facet]);
            sum.try_normalize(0.0).unwrap_or_else(Vector::zeros)
        };
        let is_curved = self.are_curved(&is_surface);
        let mut of_faces: FxHashMap<[u32; 2], f64> = FxHashMap::default();
        let mut sags = vec![0.0; self.facets.len()];
        for number in (0..self.facets.len()).filter(|&number| is_surface(number)) {
            let whole = self.on_face(number, !is_curved[around.body(number) as usize]);
            let rise = |[i, j]: [u32; 2]| {
                let along = (points[j as usize] - points[i as usize]) * 0.25;
                let [of_i, of_j] = [-along.dot(&normal_at(i, number)), along.dot(&normal_at(j, number))];
                if of_i * of_j > 0.0 { of_i.abs().min(of_j.abs()) } else { 0.0 }
            };
            sags[number] = *of_faces.entry(whole.face).or_insert_with(|| whole.edges().map(rise).fold(0.0, f64::max));
        }
        sags
    }
}
