//! The heights of faces of second order.

use super::{FacetSag, edge_count};
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::second_order::OnCurve;
use crate::geometry::{Surface, Vector};
use rustc_hash::FxHashSet;

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
        let Some(division) = self.division() else { return };
        let reference = self.reference();
        let extent = points.iter().fold(0.0f64, |most, x| most.max(x.amax()));
        for (number, facet) in self.facets.iter().enumerate().filter(|(number, _)| is_surface(*number)) {
            let straight = self.facet_cell[number] as usize;
            let corners = facet.map(|vertex| points[vertex as usize]);
            let Some(on_curve) = division.on_curve(straight, reference) else { continue };
            let places = self.places_on(&on_curve, number);
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

impl<const D: usize> Surface<D> {
    /// How far faces of second order rise above the chords of their edges, and in their middle, by the lengths of these, at most: by body.
    pub(super) fn rises(&self, is_surface: impl Fn(usize) -> bool) -> Vec<f64> {
        let mut rises = vec![0.0; self.ranges.len()];
        let Some(division) = self.division().filter(|_| !self.curved().is_empty()) else { return rises };
        let mut seen = FxHashSet::default();
        for (body, range) in self.ranges.iter().enumerate() {
            for facet in range.clone().filter(|&facet| is_surface(facet)) {
                let straight = self.facet_cell[facet] as usize;
                let found = (
                    division.on_curve(straight, self.reference()),
                    division.cell_type(straight),
                    division.face(straight, self.facet_source[facet] as usize),
                );
                let (Some(on_curve), Some(cell_type), Some(face)) = found else { continue };
                if seen.insert((division.cell(straight), face)) {
                    rises[body] = f64::max(rises[body], rise(&on_curve, cell_type.faces()[face]));
                }
            }
        }
        rises
    }
}

/// How far a face with these corners rises above the chords of its edges, or in its middle, by its own length.
fn rise<const D: usize>(on_curve: &OnCurve<D>, corners: &[usize]) -> f64 {
    let mean = |of: &[usize]| -> [f64; 3] {
        let sum = |axis: usize| of.iter().map(|&corner| on_curve.corner(corner)[axis]).sum::<f64>();
        std::array::from_fn(|axis| sum(axis) / of.len() as f64)
    };
    let at = |corner: usize| on_curve.position(on_curve.corner(corner));
    let edge = |k: usize| {
        let ends = [corners[k], corners[(k + 1) % corners.len()]];
        let (chord, middle) = (at(ends[1]) - at(ends[0]), (at(ends[0]) + at(ends[1])) * 0.5);
        let beside = on_curve.position(mean(&ends)) - middle;
        (beside - chord * (beside.dot(&chord) / chord.norm_squared())).norm() / chord.norm()
    };
    let count = if D == 2 { 1 } else { corners.len() };
    let of_edges = (0..count).map(edge).fold(0.0, f64::max);
    if corners.len() < 4 {
        return of_edges;
    }
    let middle = corners.iter().fold(Vector::zeros(), |sum, &corner| sum + at(corner)) * 0.25;
    let diagonals = [at(corners[2]) - at(corners[0]), at(corners[3]) - at(corners[1])];
    let across = area_vector(&std::array::from_fn(|k| if k == 0 { Vector::zeros() } else { diagonals[k - 1] }));
    let above = (on_curve.position(mean(corners)) - middle).dot(&across) / across.norm();
    f64::max(of_edges, above.abs() / across.norm().sqrt())
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
