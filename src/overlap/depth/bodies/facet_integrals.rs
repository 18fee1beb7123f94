//! ∫ over the facets of one body inside another of the other's depth, with its derivatives.

use super::cell_pieces::CellPieces;
use super::facet_blocks::{FacetBlocks, MOST};
use super::facet_clip::clip;
use super::point_sums::PointSums;
use crate::configuration::FacetSide;
use crate::depth_field::DepthPiece;
use crate::geometry::cells::Cells;
use crate::geometry::convex_piece::Piece;
use crate::geometry::{Surface, Weighting};
use crate::overlap::depth::facet_sums::FacetSums;
use crate::overlap::depth::integral::DepthRequest;
use crate::overlap::pair::body_facet::BodyFacet;
use crate::overlap::pair::bounds::Bounds;
use crate::overlap::pair::second_derivative::SecondDerivative;

/// Cosine of an angle between normals that is rounding.
const SAME_WAY: f64 = 1.0 - 1e-9;

/// A facet that is no deeper than this part of its size lies in the other's face.
const FLAT: f64 = 1e-9;

/// The facets of one side, and the other body.
pub(crate) struct FacetsInCells<'a, const D: usize> {
    pub(crate) surface: &'a Surface<D>,
    pub(crate) cells: &'a Cells,
    pub(crate) side: &'a FacetSide<'a, D>,
    /// Whether the side is the second of the pair.
    pub(crate) of_b: bool,
    pub(crate) other: &'a CellPieces<D>,
    /// Part with which it counts.
    pub(crate) weight: f64,
    /// How deep below the other's surface the contact begins.
    pub(crate) clearance: f64,
    pub(crate) weighting: Weighting,
    pub(crate) request: &'a DepthRequest,
    /// Cell of every facet of the side, which does not count, where the other body is the same.
    pub(crate) own_cell: Option<&'a [u32]>,
    /// What holds all of the overlap.
    pub(crate) bounds: &'a Bounds<D>,
}

impl<const D: usize> FacetsInCells<'_, D> {
    /// The integrals over some facets.
    pub(crate) fn integrals(&self, facets: &[u32], rounding: f64) -> FacetSums<D> {
        let mut sums = FacetSums::default();
        let mut scratch = Scratch { work: Piece::default(), values: Vec::new() };
        for &number in facets {
            let Some(facet) = BodyFacet::new(self.surface, self.side, number) else { continue };
            if self.weighting.is_axis(&facet.corners, rounding) {
                continue;
            }
            let aabb = self.bounds.box_of_part(&facet.corners);
            if aabb.is_empty() {
                continue;
            }
            let before = sums.piece_count;
            let mut moments = Moments { area: [0.0; D], depth: [0.0; D], points: PointSums::default() };
            self.other.tree.visit(
                |node| node.meets(&aabb),
                |j| {
                    let piece = &self.other.pieces[j as usize];
                    let is_own = self.own_cell.is_some_and(|cells| cells[number as usize] == piece.cell);
                    if !is_own && self.other.boxes[j as usize].meets(&aabb) && facet.may_meet(piece, rounding) {
                        self.add(&facet, piece, &mut scratch, &mut moments, &mut sums);
                    }
                },
            );
            if sums.piece_count > before {
                let side = (self.of_b, self.weight);
                sums.add_to_nodes(&facet, &moments.area, &moments.depth, side);
                sums.points.extend(moments.points.into_points(&facet, side));
            }
        }
        sums
    }

    /// Adds what a facet has inside a piece.
    fn add(
        &self,
        facet: &BodyFacet<D>,
        piece: &DepthPiece<D>,
        scratch: &mut Scratch<D>,
        moments: &mut Moments<D>,
        sums: &mut FacetSums<D>,
    ) {
        let blocks = FacetBlocks {
            cells: self.cells,
            weight: self.weight,
            weighting: self.weighting,
            second: self.request.second,
        };
        let barycentric = facet.corners.each_ref().map(|x| piece.barycentric(x));
        let Scratch { work, values } = scratch;
        let is_same_way = piece.is_at_surface && facet.normal.dot(&piece.gradient) < -SAME_WAY * piece.gradient.norm();
        let flat = FLAT * facet.measure.powf(1.0 / (D - 1) as f64);
        let coordinates =
            |w: &[f64; D]| -> [f64; 4] { std::array::from_fn(|k| (0..D).map(|c| w[c] * barycentric[c][k]).sum()) };
        let depth = |at: &[f64; 4]| -> f64 { (0..=D).map(|k| at[k] * piece.depths[k]).sum() };
        let at_corners: [f64; D] = std::array::from_fn(|c| depth(&barycentric[c]));
        clip(&facet.corners, &barycentric, &facet.area, piece, work, |inside, part| {
            let part = part * piece.sign;
            if is_same_way {
                self.weighting.for_each_simplex(&facet.corners, inside.corners(), |corners, share, _| {
                    let is_flat = |w: &[f64; D]| (depth(&coordinates(w)) + self.clearance).abs() <= flat;
                    if corners.iter().all(|w| is_flat(w)) {
                        sums.flush += share * part * facet.measure;
                    }
                });
            }
            let mut below = Piece::default();
            let inside = if piece.is_cut() {
                below.clone_from(inside);
                if !below.cut(&at_corners.map(|depth| -depth)) {
                    return;
                }
                &below
            } else {
                inside
            };
            sums.piece_count += 1;
            let (mut areas, mut local) = ([0.0; D], [0.0; D]);
            // Products of the functions that move with nodes.
            let mut products = [[0.0; MOST]; MOST];
            let mut moved = [[0.0; D]; D];
            let count = facet.nodes.len() + self.cells.nodes(piece.cell as usize).len();
            sums.deepest = inside.corners().iter().fold(sums.deepest, |most, w| most.max(depth(&coordinates(w))));
            self.weighting.for_each_simplex(&facet.corners, inside.corners(), |corners, share, bare| {
                let share = share * part;
                let at = corners.map(&coordinates);
                let g: [f64; D] = std::array::from_fn(|c| depth(&at[c]));
                let total: f64 = g.iter().sum();
                sums.area += share * facet.measure;
                sums.depth += share * facet.measure * total / D as f64;
                let norm = share / (D * (D + 1)) as f64;
                for (a, moment) in local.iter_mut().enumerate() {
                    let same: f64 = (0..D).map(|c| g[c] * corners[c][a]).sum();
                    let sum: f64 = (0..D).map(|c| corners[c][a]).sum();
                    *moment += norm * (same + total * sum);
                    moments.area[a] += share * sum / D as f64;
                    areas[a] += share * sum / D as f64;
                }
                if self.request.second != SecondDerivative::No {
                    let of_corners: [[f64; MOST]; D] =
                        std::array::from_fn(|c| blocks.shapes(facet, piece, corners[c], &at[c]));
                    add_products(&mut products, &of_corners, count, norm);
                    if !self.weighting.is_plain() {
                        let by = bare * part * g[0];
                        for (row, a) in moved.iter_mut().zip(corners[0]) {
                            row.iter_mut().zip(corners[0]).for_each(|(sum, c)| *sum += by * a * c);
                        }
                    }
                }
            });
            for (sum, moment) in moments.depth.iter_mut().zip(&local) {
                *sum += moment;
            }
            if self.request.points {
                moments.points.add(piece, (&areas, &local), &barycentric, inside.corners());
            }
            if self.request.second != SecondDerivative::No {
                blocks.add(facet, piece, &products, (&local, &moved), values, &mut sums.hessian);
            }
        });
    }
}

/// ∫ N_a and ∫ g N_a over what a facet has inside, in parts of its measure, and its points.
struct Moments<const D: usize> {
    area: [f64; D],
    depth: [f64; D],
    points: PointSums<D>,
}

/// Memory that is used again.
struct Scratch<const D: usize> {
    work: Piece<D>,
    values: Vec<[[f64; D]; D]>,
}

impl<const D: usize> BodyFacet<D> {
    /// False only if the piece keeps clear of the facet's plane.
    fn may_meet(&self, piece: &DepthPiece<D>, rounding: f64) -> bool {
        let (mut least, mut largest) = (f64::INFINITY, f64::NEG_INFINITY);
        for x in &piece.corners[..=D] {
            let height = self.normal.dot(&(x - self.corners[0]));
            (least, largest) = (least.min(height), largest.max(height));
        }
        least <= rounding && largest >= -rounding
    }
}

/// Adds ∫ of all products of two of the first `count` functions that are linear on a simplex, given at its corners.
fn add_products<const D: usize>(
    products: &mut [[f64; MOST]; MOST],
    at_corners: &[[f64; MOST]; D],
    count: usize,
    norm: f64,
) {
    let sums: [f64; MOST] = std::array::from_fn(|i| at_corners.iter().map(|f| f[i]).sum());
    for i in 0..count {
        for j in 0..count {
            let same: f64 = at_corners.iter().map(|f| f[i] * f[j]).sum();
            products[i][j] += norm * (same + sums[i] * sums[j]);
        }
    }
}
