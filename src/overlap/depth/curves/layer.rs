//! A layer around a body: over every facet, and over rims between the faces that meet there.
//!
//! The piece below tells the depth in the layer, negative, and the height is that at the foot on the facet. Over a rim the feet on both faces are
//! others, so each face has its layer as far as its own normals, and between them lie wedges in which the foot is that on the edge: the
//! height is one from the one face to the other, and so is the depth halfway, as far from both.

use crate::configuration::FacetSide;
use crate::depth_field::{Curves, DepthPiece};
use crate::geometry::boundary::facet_sags::edge_count;
use crate::geometry::boundary::symmetry::AcrossPlanes;
use crate::geometry::mesh::cells::Cells;
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::primitives::facet_slopes::foot;
use crate::geometry::{Surface, Vector};
use nalgebra::SMatrix;

/// A layer is no thicker than this part of the facets around a vertex, so that it does not fold in a corner.
const LARGEST_PART: f64 = 0.5;

/// A corner of the layer is no farther from its vertex than this many times the thickness: the edge of a knife has no normal.
const FARTHEST: f64 = 3.0;

/// Part by which normals of a flat vertex are kept from having none.
const NO_NORMAL: f64 = 1e-3;

/// The layer over the surface of a body.
pub(super) struct Layer<'a, const D: usize> {
    pub(super) surface: &'a Surface<D>,
    pub(super) cells: &'a Cells,
    pub(super) curves: &'a Curves<D>,
    pub(super) side: &'a FacetSide<'a, D>,
    /// Number of the first facet of the side in the surface.
    pub(super) first: usize,
    pub(super) thickness: f64,
}

/// Simplices in which the corners of the piece below have the heights of their feet, given in its own coordinates.
pub(super) struct LayerPart<const D: usize> {
    pub(super) feet: [[f64; 4]; 4],
    pub(super) simplices: Vec<[Vector<D>; 4]>,
}

impl<const D: usize> Layer<'_, D> {
    /// The parts over a facet, and over the rims along it, of a facet that a piece has for its face.
    pub(super) fn parts(&self, facet: u32, piece: &DepthPiece<D>) -> Vec<LayerPart<D>> {
        let number = facet as usize;
        let (vertices, corners) = (self.side.facets[number], self.side.corners(number));
        let in_surface = self.first + number;
        let before = self.without_deformation(piece);
        let of_face: [Vector<D>; D] = std::array::from_fn(|k| before[k]);
        let Some(foot) = foot(&of_face, &before[D]) else { return Vec::new() };
        let mut feet = [[0.0; 4]; 4];
        (0..D).for_each(|k| feet[k][k] = 1.0);
        feet[D][..D].copy_from_slice(&foot);
        let own: [Vector<D>; D] = std::array::from_fn(|k| {
            self.way_out(in_surface, vertices[k], self.curves.face_at_rim(in_surface, vertices[k]))
        });
        let mut parts = vec![LayerPart { feet, simplices: over_facet(&vertices, &corners, &own) }];
        if D == 2 || !self.curves.has_bends() {
            return parts;
        }
        let nearest = |x: &Vector<D>| {
            let distance = |k: &usize| (piece.corners[*k] - x).norm_squared();
            (0..D).min_by(|p, q| distance(p).total_cmp(&distance(q))).unwrap_or_default()
        };
        for k in 0..edge_count(D) {
            let mut ends = [k, (k + 1) % D];
            ends.sort_unstable_by_key(|&end| vertices[end]);
            let Some(beside) = self.facet_beside(in_surface, ends.map(|end| vertices[end])) else { continue };
            let is_parted = ends.map(|end| {
                let [here, there] = [in_surface, beside].map(|facet| self.curves.face_at_rim(facet, vertices[end]));
                here != there
            });
            if is_parted.contains(&true) {
                let triangles = [0, 1].map(|j| {
                    let (end, x) = (ends[j], corners[ends[j]]);
                    let halfway = if is_parted[j] { self.way_out(in_surface, vertices[end], None) } else { own[end] };
                    [x, x + own[end], x + halfway]
                });
                let edge = ends.map(|end| nearest(&corners[end]));
                parts.push(LayerPart { feet: feet_on_edge(&before, edge), simplices: wedge(&triangles) });
            }
        }
        parts
    }

    /// Corners of a piece without deformation.
    fn without_deformation(&self, piece: &DepthPiece<D>) -> [Vector<D>; 4] {
        let (nodes, reference) = (self.cells.nodes(piece.cell as usize), self.surface.reference());
        piece.weights.map(|weights| {
            let terms =
                nodes.iter().zip(weights).map(|(&node, weight)| Vector::from(reference[node as usize]) * weight);
            terms.fold(Vector::zeros(), |sum, term| sum + term)
        })
    }

    /// The facet on the other side of an edge.
    fn facet_beside(&self, facet: usize, [v, w]: [u32; 2]) -> Option<usize> {
        let has_edge = |other: &usize| self.side.facets[other - self.first].contains(&w);
        let is_other = |other: &usize| *other != facet && self.curves.is_surface(*other) && has_edge(other);
        self.curves.around.of_body(facet, v).find(is_other)
    }

    /// The way from a vertex to the other side of the layer: as high above all facets of a face around it, or of all faces, as the layer is
    /// thick, or nearly so, and along the planes in which the surface ends there.
    fn way_out(&self, of: usize, vertex: u32, face: Option<u32>) -> Vector<D> {
        let (mut squares, mut sum) = (SMatrix::<f64, D, D>::zeros(), Vector::<D>::zeros());
        let (mut count, mut least, mut ends) = (0.0, f64::INFINITY, AcrossPlanes::default());
        for facet in self.curves.around.of_body(of, vertex) {
            let area = area_vector(&self.side.corners(facet - self.first));
            let Some(normal) = area.try_normalize(0.0) else { continue };
            if !self.curves.is_surface(facet) {
                ends.add(&normal);
                continue;
            }
            least = least.min(area.norm().powf(1.0 / (D - 1) as f64));
            if face.is_none() || self.curves.face_at_rim(facet, vertex) == face {
                squares += normal * normal.transpose();
                sum += normal;
                count += 1.0;
            }
        }
        let kept = squares + SMatrix::identity() * (NO_NORMAL * count);
        let mut way = ends.taken_from(kept.try_inverse().map_or_else(Vector::zeros, |inverse| inverse * sum));
        let length = way.norm();
        if length > FARTHEST {
            way *= FARTHEST / length;
        }
        way * self.thickness.min(LARGEST_PART * least)
    }
}

/// The simplices over a facet with these ways out. Those of neighbours fit, since all are divided in the order of the vertices.
fn over_facet<const D: usize>(
    vertices: &[u32; D],
    corners: &[Vector<D>; D],
    ways: &[Vector<D>; D],
) -> Vec<[Vector<D>; 4]> {
    let mut order: [usize; D] = std::array::from_fn(|k| k);
    order.sort_by_key(|&k| vertices[k]);
    let (low, high) = (order.map(|k| corners[k]), order.map(|k| corners[k] + ways[k]));
    let simplex = |step: usize| {
        // From the lower facet to the upper one, corner by corner.
        let mut simplex = [Vector::zeros(); 4];
        simplex[..=step].copy_from_slice(&low[..=step]);
        simplex[step + 1..=D].copy_from_slice(&high[step..]);
        simplex
    };
    (0..D).map(simplex).collect()
}

/// The simplices between the triangles at both ends of an edge, that of the lower vertex first: divided as those beside it.
fn wedge<const D: usize>([p, q]: &[[Vector<D>; 3]; 2]) -> Vec<[Vector<D>; 4]> {
    vec![[p[0], p[1], p[2], q[2]], [p[0], p[1], q[1], q[2]], [p[0], q[0], q[1], q[2]]]
}

/// Where the corners of a piece have their feet on the line through two of them.
fn feet_on_edge<const D: usize>(corners: &[Vector<D>; 4], [a, b]: [usize; 2]) -> [[f64; 4]; 4] {
    let along = corners[b] - corners[a];
    let mut feet = [[0.0; 4]; 4];
    for (k, foot) in feet.iter_mut().enumerate().take(D + 1) {
        let part = match k {
            _ if k == a => 0.0,
            _ if k == b => 1.0,
            _ => along.dot(&(corners[k] - corners[a])) / along.norm_squared(),
        };
        (foot[a], foot[b]) = (1.0 - part, part);
    }
    feet
}
