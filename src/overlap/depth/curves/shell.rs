//! A body as the facets of another meet it: the pieces of its cells, and a layer around it that is thicker than faces are curved.

use super::layer::Layer;
use crate::depth_field::{DepthPiece, MOST_NODES, Quadratic};
use crate::geometry::Vector;
use crate::geometry::boundary::facet_sags::Bend;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::tree::Tree;
use crate::overlap::depth::bodies::CellPieces;
use rustc_hash::FxHashMap;

/// The pieces of a body, then the simplices of the layer.
pub(super) struct Shell<const D: usize> {
    pub(super) pieces: CellPieces<D>,
    /// What curved faces add to the depth in every piece, then in every part of the layer; of each as facets see it that bend in any way, or as
    /// facets of every bend do.
    heights: Vec<Quadratic>,
    bends: usize,
    layer: Vec<LayerSimplex<D>>,
    boxes: Vec<Aabb<D>>,
    pub(super) tree: Tree<D>,
}

/// A simplex of the layer, the piece that tells the depth there, and the number of its heights.
struct LayerSimplex<const D: usize> {
    simplex: DepthPiece<D>,
    piece: usize,
    heights: usize,
}

/// A simplex that is clipped by, its box, and what tells the depth there.
pub(super) struct InShell<'a, const D: usize> {
    pub(super) simplex: &'a DepthPiece<D>,
    pub(super) aabb: &'a Aabb<D>,
    pub(super) piece: &'a DepthPiece<D>,
    heights: usize,
}

impl<const D: usize> Shell<D> {
    /// Of a body with a layer over some of its facets.
    pub(super) fn new(pieces: CellPieces<D>, over: &Layer<D>, facets: &[u32]) -> Self {
        let curves = over.curves;
        let bends = if curves.has_bends() { Bend::ALL.len() } else { 1 };
        let seen = |piece: &DepthPiece<D>| {
            let of_bend = |bend| curves.in_simplex(piece.cell, piece.simplex as usize, &piece.numbers, bend);
            Bend::ALL.map(of_bend).into_iter().take(bends)
        };
        let mut heights: Vec<Quadratic> = pieces.pieces.iter().flat_map(seen).collect();
        let mut at_surface: FxHashMap<u32, Vec<usize>> = FxHashMap::default();
        for (number, piece) in pieces.pieces.iter().enumerate().filter(|(_, piece)| piece.is_at_surface) {
            at_surface.entry(piece.cell).or_default().push(number);
        }
        let mut layer = Vec::new();
        for &facet in facets.iter().filter(|&&facet| curves.is_surface(over.first + facet as usize)) {
            let middle = mean(&over.side.corners(facet as usize));
            let of_cell = at_surface.get(&over.surface.facet_cell[over.first + facet as usize]);
            // The piece that has the facet for a face.
            let distance = |number: &usize| (mean(&pieces.pieces[*number].corners[..D]) - middle).norm_squared();
            let nearest =
                of_cell.and_then(|all| all.iter().copied().min_by(|p, q| distance(p).total_cmp(&distance(q))));
            let Some(piece) = nearest else { continue };
            for part in over.parts(facet, &pieces.pieces[piece]) {
                let number = heights.len() / bends;
                for bend in 0..bends {
                    heights.push(heights[piece * bends + bend].mapped(&part.feet));
                }
                for corners in part.simplices {
                    let none = ([0.0; 4], [[0.0; MOST_NODES]; 4]);
                    let simplex = DepthPiece::new(pieces.pieces[piece].cell, corners, none.0, none.1, false);
                    if let Some(simplex) = simplex {
                        layer.push(LayerSimplex {
                            simplex: DepthPiece { sign: 1.0, ..simplex },
                            piece,
                            heights: number,
                        });
                    }
                }
            }
        }
        let simplices = pieces.pieces.iter().chain(layer.iter().map(|of_layer| &of_layer.simplex));
        let boxes: Vec<Aabb<D>> = simplices.map(|simplex| Aabb::of(&simplex.corners[..=D])).collect();
        let tree = Tree::new(&boxes);
        Self { pieces, heights, bends, layer, boxes, tree }
    }

    pub(super) fn get(&self, number: u32) -> InShell<'_, D> {
        let number = number as usize;
        let (aabb, pieces) = (&self.boxes[number], &self.pieces.pieces);
        match number.checked_sub(pieces.len()) {
            None => InShell { simplex: &pieces[number], aabb, piece: &pieces[number], heights: number },
            Some(number) => {
                let LayerSimplex { simplex, piece, heights } = &self.layer[number];
                InShell { simplex, aabb, piece: &pieces[*piece], heights: *heights }
            }
        }
    }

    /// What curved faces add to the depth in a simplex, as facets see it that bend so.
    pub(super) fn heights(&self, of: &InShell<D>, seen_by: Bend) -> &Quadratic {
        &self.heights[of.heights * self.bends + (seen_by as usize).min(self.bends - 1)]
    }
}

fn mean<const D: usize>(points: &[Vector<D>]) -> Vector<D> {
    points.iter().sum::<Vector<D>>() / points.len() as f64
}
