//! What of a body's depth does not count, below facets that are tied.
//!
//! A piece that stands on such a facet is divided about the middle of the facet, and the depth there falls far below zero. So it does at nodes
//! on the surface all of whose facets are tied, and at nodes below that belong to no other facet. What is left of the depth in such pieces
//! is a film along their other faces, as much thinner than the overlap is deep as the fall is steep: where it meets pieces that count it has
//! their depth. The field stays continuous and stays zero on the surface, so that forces are the derivative of the energy as before.

use super::field::DepthField;
use super::pieces::DepthPiece;
use crate::geometry::mesh::cells::Cells;
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::{Surface, Vector};
use rustc_hash::FxHashSet;

/// How far the depth falls, in sizes of the largest facet that is tied: what is left presses by twice the penetration by this at most, and
/// rounding grows as it does.
const FALL: f64 = 1e4;

/// Part of the size of a facet within which the face of a piece is that facet.
const SAME: f64 = 1e-6;

/// The layer below the tied facets of one body.
pub(crate) struct TiedLayer {
    /// Nodes at which the depth falls.
    nodes: FxHashSet<u32>,
    /// Pieces that stand on a tied facet, by cell and number.
    pieces: FxHashSet<(u32, u32)>,
    fall: f64,
}

impl TiedLayer {
    /// Below some facets of a body, by number in the surface, ascending.
    pub(crate) fn new<const D: usize>(
        surface: &Surface<D>,
        (field, cells): (&DepthField<D>, &Cells),
        body: usize,
        facets: &[usize],
    ) -> Self {
        let (coords, is_tied) = (surface.reference(), |facet: usize| facets.binary_search(&facet).is_ok());
        let corners = |facet: usize| {
            let place = |(node, weight): (u32, f64)| Vector::<D>::from(coords[node as usize]) * weight;
            surface.facets[facet].map(|vertex| surface.nodes_of_vertex(vertex).map(place).sum::<Vector<D>>())
        };
        let size = |facet: usize| area_vector(&corners(facet)).norm().powf(1.0 / (D as f64 - 1.0));
        let fall = FALL * facets.iter().map(|&facet| size(facet)).fold(0.0, f64::max);
        let (mut tied, mut free) = (FxHashSet::default(), FxHashSet::default());
        let mut facets_of = rustc_hash::FxHashMap::<u32, Vec<usize>>::default();
        for facet in surface.ranges[body].clone() {
            let nodes = surface.facets[facet].iter().flat_map(|&vertex| surface.nodes_of_vertex(vertex));
            let into = if is_tied(facet) { &mut tied } else { &mut free };
            into.extend(nodes.map(|(node, _)| node));
            facets_of.entry(surface.facet_cell[facet]).or_default().push(facet);
        }
        let mut pieces = FxHashSet::default();
        for (&cell, of_cell) in &facets_of {
            field.for_each_piece(cells, cell as usize, coords, |piece| {
                if !piece.is_at_surface {
                    return;
                }
                let middle = mean(&piece.corners[..D]);
                let is_same = |facet: &&usize| (mean(&corners(**facet)) - middle).norm() <= SAME * size(**facet);
                if of_cell.iter().find(is_same).is_some_and(|&facet| is_tied(facet)) {
                    pieces.insert((piece.cell, piece.simplex));
                } else {
                    free.extend(own_nodes(&piece, cells));
                }
            });
        }
        for cell in (0..cells.len()).filter(|&cell| cells.body[cell] as usize == body) {
            let below = cells.nodes(cell).iter().copied();
            tied.extend(below.filter(|&node| field.nearest_facet(node).is_some_and(is_tied)));
        }
        let nodes = tied.difference(&free).copied().collect();
        Self { nodes, pieces, fall }
    }

    /// Calls `visit` for a piece as it counts, or for the pieces that stand for it.
    pub(crate) fn for_each_part<const D: usize>(
        &self,
        piece: DepthPiece<D>,
        cells: &Cells,
        mut visit: impl FnMut(DepthPiece<D>),
    ) {
        let is_below_facet = self.pieces.contains(&(piece.cell, piece.simplex));
        let nodes = cells.nodes(piece.cell as usize);
        let falls = |number: u8| nodes.get(number as usize).is_some_and(|node| self.nodes.contains(node));
        if !is_below_facet && !piece.numbers[..=D].iter().any(|&number| falls(number)) {
            return visit(piece);
        }
        let mut corners: [Corner<D>; 4] = std::array::from_fn(|k| Corner {
            number: piece.numbers[k],
            place: piece.corners[k],
            depth: if k <= D && falls(piece.numbers[k]) { -self.fall } else { piece.depths[k] },
            weights: piece.weights[k],
        });
        if !is_below_facet {
            return visit_sorted(&piece, &mut corners, visit);
        }
        let weights = std::array::from_fn(|n| piece.weights[..D].iter().map(|w| w[n]).sum::<f64>() / D as f64);
        let middle = Corner { number: u8::MAX, place: mean(&piece.corners[..D]), depth: -self.fall, weights };
        for k in 0..D {
            let mut of_part = corners;
            of_part[k] = middle;
            visit_sorted(&piece, &mut of_part, &mut visit);
        }
    }
}

#[derive(Clone, Copy)]
struct Corner<const D: usize> {
    number: u8,
    place: Vector<D>,
    depth: f64,
    weights: [f64; super::MOST_NODES],
}

/// A part of a piece with these corners, the least deep first; none where it is flat.
fn visit_sorted<const D: usize>(
    piece: &DepthPiece<D>,
    corners: &mut [Corner<D>; 4],
    mut visit: impl FnMut(DepthPiece<D>),
) {
    corners[..=D].sort_by(|a, b| a.depth.total_cmp(&b.depth));
    let (places, depths, weights) = (corners.map(|c| c.place), corners.map(|c| c.depth), corners.map(|c| c.weights));
    if let Some(part) = DepthPiece::new(piece.cell, places, depths, weights, false) {
        let (simplex, sign, numbers) = (piece.simplex, piece.sign, corners.map(|c| c.number));
        visit(DepthPiece { simplex, sign, numbers, is_below_tie: true, ..part });
    }
}

/// Nodes of the cell among the corners of a piece.
fn own_nodes<const D: usize>(piece: &DepthPiece<D>, cells: &Cells) -> Vec<u32> {
    let nodes = cells.nodes(piece.cell as usize);
    piece.numbers[..=D].iter().filter_map(|&number| nodes.get(number as usize).copied()).collect()
}

fn mean<const D: usize>(points: &[Vector<D>]) -> Vector<D> {
    points.iter().sum::<Vector<D>>() / points.len() as f64
}
