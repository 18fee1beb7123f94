//! The heights of faces of second order.

use super::{FacetSag, edge_count};
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::second_order::OnCurve;
use crate::geometry::{Surface, Vector};

/// A height that is smaller than this part of its facet, or than so many roundings of the coordinates, is none.
const ROUNDING: f64 = 1e-9;
const ROUNDINGS: f64 = 256.0;

impl<const D: usize> Surface<D> {
    pub(super) fn add_second_order(
        &self,
        points: &[Vector<D>],
        normals: &[Vector<D>],
        is_surface: impl Fn(usize) -> bool,
        sags: &mut [FacetSag<D>],
    ) {
        let (Some(cells), Some(division)) = (&self.cells, self.division()) else { return };
        let reference = self.reference();
        let extent = points.iter().fold(0.0f64, |most, x| most.max(x.amax()));
        for (number, facet) in self.facets.iter().enumerate().filter(|(number, _)| is_surface(*number)) {
            let straight = self.facet_cell[number] as usize;
            let corners = facet.map(|vertex| points[vertex as usize]);
            let Some(on_curve) = division.on_curve(straight, reference) else { continue };
            let nodes = cells.nodes(straight);
            let face = cells.cell_type(straight).faces()[self.facet_source[number] as usize];
            // Nodes of the cell whose mean a corner is.
            let of_corner = |corner: usize| -> Vec<usize> {
                match (facet[corner] as usize).checked_sub(self.nodes.len()) {
                    Some(_) => face.to_vec(),
                    None => {
                        let node = self.nodes[facet[corner] as usize];
                        nodes.iter().position(|n| *n == node).into_iter().collect()
                    }
                }
            };
            let places: [[f64; 3]; D] = std::array::from_fn(|corner| on_curve.mean(&of_corner(corner)));
            let face = CurvedFace { on_curve, places, normal: normals[number] };
            let size = area_vector(&corners).norm().powf(1.0 / (D - 1) as f64);
            let rounding = (ROUNDING * size).max(ROUNDINGS * f64::EPSILON * extent);
            let seen = |height: f64| if height.abs() > rounding { height } else { 0.0 };
            let at_corners: [f64; D] = std::array::from_fn(|k| face.height(places[k], &corners[k]));
            let sag = &mut sags[number];
            sag.at_corners = at_corners.map(seen);
            for k in 0..edge_count(D) {
                let next = (k + 1) % D;
                let place = std::array::from_fn(|axis| 0.5 * (places[k][axis] + places[next][axis]));
                let height = face.height(place, &((corners[k] + corners[next]) * 0.5));
                sag.at_edges[k] = seen(height - 0.5 * (at_corners[k] + at_corners[next]));
            }
        }
    }
}

/// A curved face over a straight facet.
struct CurvedFace<'a, const D: usize> {
    on_curve: OnCurve<'a, D>,
    /// The corners of the facet in the coordinates of the curved cell.
    places: [[f64; 3]; D],
    /// Of the facet.
    normal: Vector<D>,
}

impl<const D: usize> CurvedFace<'_, D> {
    /// How high above a point of the facet the face lies, which has a place near it: along the normal of the facet, to the plane that
    /// touches the face in that place.
    fn height(&self, place: [f64; 3], point: &Vector<D>) -> f64 {
        let along = |k: usize| self.on_curve.slope(place, self.places[0], self.places[k]);
        // As a facet with these edges.
        let edges: [Vector<D>; D] = std::array::from_fn(|k| if k == 0 { Vector::zeros() } else { along(k) });
        let across = area_vector(&edges);
        let cosine = across.dot(&self.normal);
        if cosine <= 0.0 {
            return 0.0;
        }
        (self.on_curve.position(place) - point).dot(&across) / cosine
    }
}
