//! ∫ over the facets of one body inside another of the other's depth, with its derivatives.

use super::boundary_moments::share;
use super::cell_pieces::CellPieces;
use super::facet_blocks::{FacetBlocks, FacetProducts};
use super::facet_clip::{Found, clip};
use super::facet_part::FacetPart;
use super::piece_moments::Moments;
use super::point_sums::PointSums;
use crate::configuration::FacetSide;
use crate::depth_field::DepthPiece;
use crate::geometry::mesh::cells::Cells;
use crate::geometry::primitives::convex_piece::Piece;
use crate::geometry::{Surface, Weighting};
use crate::overlap::depth::facet_sums::FacetSums;
use crate::overlap::depth::integral::DepthRequest;
use crate::overlap::pair::body_facet::BodyFacet;
use crate::overlap::pair::bounds::Bounds;
use crate::overlap::pair::second_derivative::SecondDerivative;
use crate::ranks::Packed;

/// Cosine of an angle between normals that is rounding.
const SAME_WAY: f64 = 1.0 - 1e-9;

/// A facet that is no deeper than this part of its size lies in the other's face.
pub(crate) const FLAT: f64 = 1e-9;

/// A facet that comes nearer to the last corner of a piece than this part of its size may have it on either side by rounding. That is
/// several thousand times as much as rounding is, and rare.
const NEAR: f64 = 1e-9;

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

/// What facets have inside the pieces of the other body: sums over the facets, and what they tell of the pieces.
pub(crate) struct FacetsFound<M, const D: usize> {
    pub(crate) sums: FacetSums<D>,
    /// What every part of a facet adds to the moments of a piece: see `boundary_moments`.
    pub(crate) shares: Vec<(u32, M)>,
    /// Pieces of which rounding might decide where a facet passes.
    pub(crate) doubtful: Vec<u32>,
}

impl<M: Moments, const D: usize> Packed for FacetsFound<M, D> {
    fn pack(&self, bytes: &mut Vec<u8>) {
        self.sums.pack(bytes);
        self.shares.pack(bytes);
        self.doubtful.pack(bytes);
    }

    fn unpack(bytes: &mut &[u8]) -> Option<Self> {
        let (sums, shares) = (FacetSums::unpack(bytes)?, Vec::unpack(bytes)?);
        Some(Self { sums, shares, doubtful: Vec::unpack(bytes)? })
    }

    fn blank() -> Self {
        Self { sums: FacetSums::default(), shares: Vec::new(), doubtful: Vec::new() }
    }
}

impl<const D: usize> FacetsInCells<'_, D> {
    /// The integrals over some facets.
    pub(crate) fn integrals<M: Moments>(&self, facets: &[u32], rounding: f64) -> FacetsFound<M, D> {
        let mut found = FacetsFound::blank();
        let mut scratch = Scratch {
            work: Piece::default(),
            part: FacetPart::default(),
            blocks: FacetProducts::default(),
            values: Vec::new(),
        };
        for &number in facets {
            let Some(facet) = BodyFacet::new(self.surface, self.side, number) else { continue };
            let is_axis = self.weighting.is_axis(&facet.corners, rounding);
            let aabb = self.bounds.box_of_part(&facet.corners);
            if aabb.is_empty() {
                continue;
            }
            let near = aabb.inflated(NEAR * facet.size() + rounding);
            let mut moments = FacetMoments { count: 0, area: [0.0; D], depth: [0.0; D], points: PointSums::default() };
            self.other.tree.visit(
                |node| node.meets(&near),
                |j| {
                    let piece = &self.other.pieces[j as usize];
                    if !self.other.boxes[j as usize].meets(&near) {
                        return;
                    }
                    let (may_meet, may_hold_last) = facet.stands_to(piece, rounding);
                    if may_hold_last {
                        found.doubtful.push(j);
                    }
                    let is_own = self.own_cell.is_some_and(|cells| cells[number as usize] == piece.cell);
                    if may_meet && !is_own && !is_axis {
                        self.add(&facet, (j, piece), &mut scratch, &mut moments, &mut found);
                    }
                },
            );
            if moments.count > 0 {
                let side = (self.of_b, self.weight);
                if self.request.second != SecondDerivative::No {
                    let Scratch { blocks, values, .. } = &mut scratch;
                    self.blocks().add(&facet, blocks, values, &mut found.sums.hessian);
                }
                found.sums.add_to_nodes(&facet, &moments.area, &moments.depth, side);
                found.sums.points.extend(moments.points.into_points(&facet, side));
            }
        }
        found
    }

    /// Adds what a facet has inside a piece.
    fn add<M: Moments>(
        &self,
        facet: &BodyFacet<D>,
        (number, piece): (u32, &DepthPiece<D>),
        scratch: &mut Scratch<D>,
        moments: &mut FacetMoments<D>,
        found: &mut FacetsFound<M, D>,
    ) {
        let barycentric = facet.corners.each_ref().map(|x| piece.barycentric(x));
        let Scratch { work, part, blocks, .. } = scratch;
        let FacetsFound { sums, shares, doubtful } = found;
        let is_same_way = facet.looks_the_same_way(piece);
        let depth = |at: &[f64; 4]| -> f64 { (0..=D).map(|k| at[k] * piece.depths[k]).sum() };
        let at_corners: [f64; D] = std::array::from_fn(|c| depth(&barycentric[c]));
        clip(&facet.corners, &barycentric, &facet.area, piece, (part, work), |part| {
            let (inside, counts) = match part {
                Found::Part(inside, counts) => (inside, counts),
                Found::Border(inside) => return shares.push((number, share::<M, D>(inside))),
                Found::Doubt => return doubtful.push(number),
            };
            let part = counts * piece.sign;
            if is_same_way {
                sums.flush += part * self.flush(facet, &at_corners, inside);
            }
            if piece.is_cut() && !inside.cut_where(&piece.depths) {
                return;
            }
            moments.count += 1;
            if !piece.is_below_tie {
                sums.piece_count += 1;
                sums.deepest = inside.in_piece().iter().fold(sums.deepest, |most, at| most.max(depth(at)));
            }
            let Products { products, moved } = self.products(facet, inside.on_facet(), &at_corners);
            let products = products.map(|row| row.map(|m| m * part));
            let areas = products.map(|row| row.iter().sum::<f64>());
            let local = products.map(|row| row.iter().zip(&at_corners).map(|(m, g)| m * g).sum::<f64>());
            for a in 0..D {
                moments.depth[a] += local[a];
            }
            // What a tie leaves presses nowhere that hosts would see.
            if !piece.is_below_tie {
                sums.area += facet.measure * areas.iter().sum::<f64>();
                sums.depth += facet.measure * local.iter().sum::<f64>();
                (0..D).for_each(|a| moments.area[a] += areas[a]);
            }
            if self.request.points && !piece.is_below_tie {
                moments.points.add(piece, (&areas, &local), &barycentric, inside.on_facet());
            }
            if self.request.second != SecondDerivative::No {
                let moved = moved.map(|row| row.map(|m| m * part));
                self.blocks().gather(facet, piece, &barycentric, (&products, &local, &moved), blocks);
            }
        });
    }

    fn blocks(&self) -> FacetBlocks<'_> {
        let (cells, weight, weighting, second) = (self.cells, self.weight, self.weighting, self.request.second);
        FacetBlocks { cells, weight, weighting, second }
    }

    /// ∫ of the products of the facet's coordinates over a part of it, and ∫ g of them without the weight, given the depth g at its
    /// corners.
    fn products(&self, facet: &BodyFacet<D>, part: &[[f64; D]], depths: &[f64; D]) -> Products<D> {
        let (mut products, mut moved) = ([[0.0; D]; D], [[0.0; D]; D]);
        let is_plain = self.weighting.is_plain();
        self.weighting.for_each_simplex(&facet.corners, part, |corners, share, bare| {
            let norm = share / (D * (D + 1)) as f64;
            let sums: [f64; D] = std::array::from_fn(|a| corners.iter().map(|w| w[a]).sum());
            for a in 0..D {
                for b in a..D {
                    let same: f64 = corners.iter().map(|w| w[a] * w[b]).sum();
                    products[a][b] += norm * (same + sums[a] * sums[b]);
                }
            }
            if !is_plain {
                let w = corners[0];
                let by = bare * w.iter().zip(depths).map(|(w, g)| w * g).sum::<f64>();
                moved.iter_mut().zip(w).for_each(|(row, a)| row.iter_mut().zip(w).for_each(|(m, c)| *m += by * a * c));
            }
        });
        for a in 0..D {
            for b in 0..a {
                products[a][b] = products[b][a];
            }
        }
        Products { products, moved }
    }

    /// Measure of the part of a facet that is in the other's face, given the depth at its corners.
    fn flush(&self, facet: &BodyFacet<D>, depths: &[f64; D], inside: &FacetPart<D>) -> f64 {
        let flat = FLAT * facet.size();
        let depths = depths.map(|depth| depth + self.clearance);
        let mut flush = 0.0;
        self.weighting.for_each_simplex(&facet.corners, inside.on_facet(), |corners, share, _| {
            let is_flat = |w: &[f64; D]| w.iter().zip(&depths).map(|(w, g)| w * g).sum::<f64>().abs() <= flat;
            if corners.iter().all(|w| is_flat(w)) {
                flush += share * facet.measure;
            }
        });
        flush
    }
}

/// ∫ of products of two of a facet's coordinates.
struct Products<const D: usize> {
    products: [[f64; D]; D],
    moved: [[f64; D]; D],
}

/// ∫ N_a and ∫ g N_a over what a facet has inside, in parts of its measure, and its points.
struct FacetMoments<const D: usize> {
    /// Number of parts.
    count: usize,
    area: [f64; D],
    depth: [f64; D],
    points: PointSums<D>,
}

/// Memory that is used again.
struct Scratch<const D: usize> {
    work: Piece<D>,
    part: FacetPart<D>,
    blocks: FacetProducts<D>,
    values: Vec<[[f64; D]; D]>,
}

impl<const D: usize> BodyFacet<D> {
    /// Whether a piece has a face on its body's surface that looks the same way.
    pub(crate) fn looks_the_same_way(&self, piece: &DepthPiece<D>) -> bool {
        piece.is_at_surface && self.normal.dot(&piece.gradient) < -SAME_WAY * piece.gradient.norm()
    }

    pub(crate) fn size(&self) -> f64 {
        self.measure.powf(1.0 / (D - 1) as f64)
    }

    /// How it stands to a piece: whether it may meet it, which is false only if the piece keeps clear of its plane; and whether it may
    /// hold the piece's last corner.
    fn stands_to(&self, piece: &DepthPiece<D>, rounding: f64) -> (bool, bool) {
        let (mut least, mut largest, mut last) = (f64::INFINITY, f64::NEG_INFINITY, 0.0);
        for x in &piece.corners[..=D] {
            last = self.normal.dot(&(x - self.corners[0]));
            (least, largest) = (least.min(last), largest.max(last));
        }
        (least <= rounding && largest >= -rounding, last.abs() <= NEAR * (largest - least) + rounding)
    }
}
