//! A body as the facets of another meet it: the pieces of its cells, and a layer around it that is thicker than faces are curved.

use crate::configuration::FacetSide;
use crate::depth_field::{Curves, DepthPiece, MOST_NODES, Quadratic};
use crate::geometry::Vector;
use crate::geometry::boundary::symmetry::AcrossPlanes;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::primitives::tree::Tree;
use crate::overlap::depth::bodies::CellPieces;
use nalgebra::SMatrix;
use rustc_hash::FxHashMap;

/// A layer is no thicker than this part of the facets around a vertex, so that it does not fold in a corner.
const LARGEST_PART: f64 = 0.5;

/// A corner of the layer is no farther from its vertex than this many times the thickness: the edge of a knife has no normal.
const FARTHEST: f64 = 3.0;

/// Part by which normals of a flat vertex are kept from having none.
const NO_NORMAL: f64 = 1e-3;

/// The pieces of a body, then the simplices of the layer.
pub(super) struct Shell<const D: usize> {
    pub(super) pieces: CellPieces<D>,
    /// What curved faces add to the depth in every piece.
    pub(super) heights: Vec<Quadratic>,
    layer: Vec<DepthPiece<D>>,
    /// The piece below every simplex of the layer, which tells the depth there.
    below: Vec<u32>,
    boxes: Vec<Aabb<D>>,
    pub(super) tree: Tree<D>,
}

impl<const D: usize> Shell<D> {
    /// Of a body, whose surface begins with facet `first`, with a layer of this thickness over some of its facets.
    pub(super) fn new(
        (pieces, curves): (CellPieces<D>, &Curves<D>),
        (side, first, facets): (&FacetSide<D>, usize, &[u32]),
        facet_cell: &[u32],
        thickness: f64,
    ) -> Self {
        let heights =
            pieces.pieces.iter().map(|piece| curves.in_simplex(piece.cell, piece.simplex as usize, &piece.numbers));
        let heights = heights.collect();
        let mut at_surface: FxHashMap<u32, Vec<u32>> = FxHashMap::default();
        for (number, piece) in pieces.pieces.iter().enumerate().filter(|(_, piece)| piece.is_at_surface) {
            at_surface.entry(piece.cell).or_default().push(number as u32);
        }
        let (mut layer, mut below) = (Vec::new(), Vec::new());
        let over = Layer { side, curves, first, thickness };
        for &facet in facets.iter().filter(|&&facet| curves.is_surface(first + facet as usize)) {
            let corners = side.corners(facet as usize);
            let middle = mean(&corners);
            let of_cell = at_surface.get(&facet_cell[first + facet as usize]).map_or(&[][..], Vec::as_slice);
            // The piece that has the facet for a face.
            let distance = |number: &u32| (mean(&pieces.pieces[*number as usize].corners[..D]) - middle).norm_squared();
            let Some(piece) = of_cell.iter().copied().min_by(|p, q| distance(p).total_cmp(&distance(q))) else {
                continue;
            };
            over.for_each_simplex(facet, &corners, |corners| {
                let none = ([0.0; 4], [[0.0; MOST_NODES]; 4]);
                let simplex = DepthPiece::new(pieces.pieces[piece as usize].cell, corners, none.0, none.1, false);
                if let Some(simplex) = simplex {
                    layer.push(DepthPiece { sign: 1.0, ..simplex });
                    below.push(piece);
                }
            });
        }
        let boxes = pieces.pieces.iter().chain(&layer).map(|piece| Aabb::of(&piece.corners[..=D]));
        let boxes: Vec<Aabb<D>> = boxes.collect();
        let tree = Tree::new(&boxes);
        Self { pieces, heights, layer, below, boxes, tree }
    }

    /// A simplex that is clipped by, its box, and the piece that tells the depth there.
    pub(super) fn get(&self, number: u32) -> (&DepthPiece<D>, &Aabb<D>, usize) {
        let aabb = &self.boxes[number as usize];
        match (number as usize).checked_sub(self.pieces.pieces.len()) {
            None => (&self.pieces.pieces[number as usize], aabb, number as usize),
            Some(layer) => (&self.layer[layer], aabb, self.below[layer] as usize),
        }
    }
}

fn mean<const D: usize>(points: &[Vector<D>]) -> Vector<D> {
    points.iter().sum::<Vector<D>>() / points.len() as f64
}

/// The layer over a surface.
struct Layer<'a, const D: usize> {
    side: &'a FacetSide<'a, D>,
    curves: &'a Curves<D>,
    first: usize,
    thickness: f64,
}

impl<const D: usize> Layer<'_, D> {
    /// Calls `visit` for the simplices over a facet. Those of neighbours fit, since all are divided in the order of the vertices.
    fn for_each_simplex(&self, facet: u32, corners: &[Vector<D>; D], mut visit: impl FnMut([Vector<D>; 4])) {
        let vertices = &self.side.facets[facet as usize];
        let mut order: [usize; D] = std::array::from_fn(|k| k);
        order.sort_by_key(|&k| vertices[k]);
        let low = order.map(|k| corners[k]);
        let high: [Vector<D>; D] = order.map(|k| corners[k] + self.way_out(facet, vertices[k]));
        for step in 0..D {
            // From the lower facet to the upper one, corner by corner.
            let mut simplex = [Vector::zeros(); 4];
            simplex[..=step].copy_from_slice(&low[..=step]);
            simplex[step + 1..=D].copy_from_slice(&high[step..]);
            visit(simplex);
        }
    }

    /// The way from a vertex to the other side of the layer: as high above all facets around it as the layer is thick, or nearly so,
    /// and along the planes in which the surface ends there.
    fn way_out(&self, of: u32, vertex: u32) -> Vector<D> {
        let (mut squares, mut sum) = (SMatrix::<f64, D, D>::zeros(), Vector::<D>::zeros());
        let (mut count, mut least, mut ends) = (0.0, f64::INFINITY, AcrossPlanes::default());
        for facet in self.curves.around.of_body(self.first + of as usize, vertex) {
            let area = area_vector(&self.side.corners(facet - self.first));
            let Some(normal) = area.try_normalize(0.0) else { continue };
            if !self.curves.is_surface(facet) {
                ends.add(&normal);
                continue;
            }
            squares += normal * normal.transpose();
            sum += normal;
            count += 1.0;
            least = least.min(area.norm().powf(1.0 / (D - 1) as f64));
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
