//! Where the facets of a straight face lie on it, and what an arc over each of its edges raises there.

use super::facet_sags::{FacetSag, edge_count};
use crate::geometry::Surface;
use crate::geometry::second_order::OnCurve;
use smallvec::SmallVec;

/// A facet, and the face of which it is a part: one of a straight cell, or of one of second order.
#[derive(Clone, Debug)]
pub(super) struct OnFace<const D: usize> {
    /// The cell, and which of its faces it is.
    pub(super) face: [u32; 2],
    /// Vertices at the corners of the face, around it.
    pub(super) corners: SmallVec<[u32; 4]>,
    /// The corners of the facet, in parts of the first and of the last edge of the face.
    places: [[f64; 2]; D],
}

/// The corners of a quadrilateral face, in parts of its edges; the first three are those of a triangle with the last one second.
const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];

impl<const D: usize> Surface<D> {
    /// A facet on its face; of cells of second order `as_given` on the whole face of the cell, else on that of the straight cell.
    pub(super) fn on_face(&self, facet: usize, as_given: bool) -> OnFace<D> {
        let found = if as_given { self.on_face_as_given(facet) } else { None };
        found.unwrap_or_else(|| self.on_straight_face(facet))
    }

    fn on_straight_face(&self, facet: usize) -> OnFace<D> {
        let face = [self.facet_cell[facet], self.facet_source[facet]];
        let vertices = &self.facets[facet];
        let Some(middle) = (vertices[D - 1] as usize).checked_sub(self.nodes.len()) else {
            let places = std::array::from_fn(|k| if k == 2 { SQUARE[3] } else { SQUARE[k] });
            return OnFace { face, corners: SmallVec::from_slice(vertices), places };
        };
        let corners = self.centroids[middle];
        let place = |vertex: &u32| corners.iter().position(|corner| corner == vertex).map_or([0.5; 2], |k| SQUARE[k]);
        OnFace { face, corners: SmallVec::from(corners), places: std::array::from_fn(|k| place(&vertices[k])) }
    }

    /// `None` for a facet of a straight cell.
    fn on_face_as_given(&self, facet: usize) -> Option<OnFace<D>> {
        let (straight, division) = (self.facet_cell[facet] as usize, self.division()?);
        let on_curve = division.on_curve(straight, self.reference())?;
        let face = division.face(straight, self.facet_source[facet] as usize)?;
        let vertex = |node: u32| self.nodes.binary_search(&node).ok().map(|vertex| vertex as u32);
        let corners: SmallVec<[u32; 4]> =
            division.corners_of_face(straight, face).map(vertex).collect::<Option<_>>()?;
        let local = division.cell_type(straight)?.faces()[face];
        let at = |k: usize| on_curve.corner(local[k]);
        let edge = |k: usize| -> [f64; 3] { std::array::from_fn(|axis| at(k)[axis] - at(0)[axis]) };
        let (first, last) = (edge(1), edge(local.len() - 1));
        let dot = |a: &[f64; 3], b: &[f64; 3]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let [uu, uv, vv] = [dot(&first, &first), dot(&first, &last), dot(&last, &last)];
        let place = |x: [f64; 3]| {
            let from: [f64; 3] = std::array::from_fn(|axis| x[axis] - at(0)[axis]);
            let (u, v) = (dot(&from, &first), dot(&from, &last));
            match local.len() {
                2 => [u / uu, 0.0],
                _ => [(u * vv - v * uv) / (uu * vv - uv * uv), (v * uu - u * uv) / (uu * vv - uv * uv)],
            }
        };
        let face = [division.cell(straight) as u32, face as u32];
        Some(OnFace { face, corners, places: self.places_on(&on_curve, facet).map(place) })
    }

    /// The corners of a facet in the coordinates of the curved cell of which its own is a part.
    pub(super) fn places_on(&self, on_curve: &OnCurve<D>, facet: usize) -> [[f64; 3]; D] {
        let Some(cells) = &self.cells else { return [[0.0; 3]; D] };
        let straight = self.facet_cell[facet] as usize;
        let nodes = cells.nodes(straight);
        let face = cells.cell_type(straight).faces()[self.facet_source[facet] as usize];
        // A corner is a node of the straight cell, or the middle of the face.
        self.facets[facet].map(|vertex| match self.nodes.get(vertex as usize) {
            None => on_curve.mean(face),
            Some(node) => on_curve.mean(&nodes.iter().position(|n| n == node).into_iter().collect::<Vec<_>>()),
        })
    }
}

impl<const D: usize> OnFace<D> {
    /// Ends of an edge of the face, vertices; an edge in the plane is itself the only one.
    pub(super) fn edges(&self) -> impl Iterator<Item = [u32; 2]> {
        let count = if D == 2 { 1 } else { self.corners.len() };
        (0..count).map(|k| [self.corners[k], self.corners[(k + 1) % self.corners.len()]])
    }

    /// The height above the facet where each edge of the face has an arc of this rise, a parabola: in a quadrilateral each direction rises as
    /// its two edges do, each by its nearness.
    pub(super) fn sag(&self, rises: &[f64]) -> FacetSag<D> {
        let at = |[s, t]: [f64; 2]| match rises {
            [a] => 4.0 * a * s * (1.0 - s),
            [a, b, c] => 4.0 * (a * (1.0 - s - t) * s + b * s * t + c * t * (1.0 - s - t)),
            [a, b, c, d] => {
                4.0 * s * (1.0 - s) * ((1.0 - t) * a + t * c) + 4.0 * t * (1.0 - t) * ((1.0 - s) * d + s * b)
            }
            _ => 0.0,
        };
        let at_corners = self.places.map(at);
        let mut sag = FacetSag { at_corners, at_edges: [0.0; D] };
        for k in 0..edge_count(D) {
            let next = (k + 1) % D;
            let middle = std::array::from_fn(|axis| 0.5 * (self.places[k][axis] + self.places[next][axis]));
            sag.at_edges[k] = at(middle) - 0.5 * (at_corners[k] + at_corners[next]);
        }
        sag
    }
}
