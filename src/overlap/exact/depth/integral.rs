//! The depth of two bodies below each other's surfaces, summed over their overlap.

use super::cell_integrals::cell_integrals;
use super::cell_pieces::CellPieces;
use super::facet_integrals::{FacetIntegrals, FacetsInCells};
use super::obstacle::of_obstacle;
use super::piece_moments::common_moments;
use crate::Error;
use crate::configuration::FacetSide;
use crate::depth::DepthField;
use crate::geometry::cells::Cells;
use crate::overlap::depth_integral::{DepthIntegral, SecondDerivative};
use crate::overlap::pair::overlap::Overlap;
use crate::overlap::pair::partner::Partner;
use crate::overlap::pair::region::{Region, common_region};
use crate::overlap::pair::sides::{Counterpart, Pair};

/// Facets that a thread takes at once.
const CHUNK: usize = 64;

/// J of a pair, or `None` where the sides are apart; the translation of the pair's obstacle has the number
/// `obstacle_node`.
///
/// # Errors
/// [`Error::Unsupported`] for two bodies that are given by facets only.
pub(crate) fn depth_integral<const D: usize>(
    pair: &Pair<D>,
    second: SecondDerivative,
    obstacle_node: u32,
) -> Result<Option<DepthIntegral<D>>, Error> {
    if let (Partner::Obstacle(_), Some(pose)) = (pair.partners[1], pair.pose) {
        return of_obstacle(pair, pose, second, obstacle_node);
    }
    match (&pair.counterpart, pair.partners[1], pair.depth, &pair.surface.cells) {
        (Counterpart::Facets(b), Partner::Body(_), Some(field), Some(cells)) => {
            let Some(region) = common_region(&pair.a, b) else { return Ok(None) };
            Ok(TwoBodies { pair, cells, field, second }.integral(b, &region))
        }
        (_, Partner::Body(_), _, None) => {
            Err(Error::Unsupported { what: "the law depth between bodies given by facets: depth is that of cells" })
        }
        _ => Err(Error::Unsupported { what: "the law depth with this partner" }),
    }
}

/// Two bodies of cells.
struct TwoBodies<'a, const D: usize> {
    pair: &'a Pair<'a, D>,
    cells: &'a Cells,
    field: &'a DepthField<D>,
    second: SecondDerivative,
}

impl<const D: usize> TwoBodies<'_, D> {
    fn integral(&self, b: &FacetSide<D>, region: &Region<D>) -> Option<DepthIntegral<D>> {
        let pair = self.pair;
        let (of_a, of_b) = pair.both(|| self.pieces(0, region), || self.pieces(1, region));
        let weight = 0.5;
        let (facets_a, facets_b) = pair.both(
            || self.facets(&pair.a, &region.facets[0], false, &of_b, weight, region),
            || self.facets(b, &region.facets[1], true, &of_a, weight, region),
        );
        let mut moments = [vec![[0.0; 4]; of_a.pieces.len()], vec![[0.0; 4]; of_b.pieces.len()]];
        of_a.tree.visit_pairs(&of_b.tree, [&of_a.boxes, &of_b.boxes], |i, j| {
            if let Some([in_a, in_b]) = common_moments(&of_a.pieces[i as usize], &of_b.pieces[j as usize]) {
                for (which, piece, found) in [(0, i, in_a), (1, j, in_b)] {
                    let sums = &mut moments[which][piece as usize];
                    sums.iter_mut().zip(found).for_each(|(sum, m)| *sum += m);
                }
            }
        });
        let [of_a_in_b, of_b_in_a] = [&facets_a, &facets_b].map(|f| (f.area, f.depth));
        let mut sums = facets_a;
        sums.add_part(facets_b);
        let (mut volume, mut value) = (0.0, 0.0);
        for (which, pieces) in [&of_a, &of_b].into_iter().enumerate() {
            let FacetIntegrals { gradient, hessian, .. } = &mut sums;
            let side = (which == 1, weight);
            let found = cell_integrals(self.cells, pieces, &moments[which], side, self.second, gradient, hessian);
            value += weight * found.depth;
            volume = found.volume;
        }
        if sums.piece_count == 0 && volume <= 0.0 {
            return None;
        }
        let mean = |(area, depth): (f64, f64)| if area > 0.0 { depth / area } else { 0.0 };
        let [a, b] = pair.partners;
        let overlap = Overlap {
            a,
            b,
            volume: volume.max(0.0),
            standard_error: 0.0,
            nodes: Vec::new(),
            gradient: Vec::new(),
            of_b: Vec::new(),
            pose_gradient: None,
            contact_area: 0.5 * (of_a_in_b.0 + of_b_in_a.0),
            penetration: sums.deepest,
            fiber_count: 0,
            crossing_count: sums.piece_count,
            facet_count: sums.facet_count,
            spacing: 0.0,
            warnings: Vec::new(),
        };
        let (nodes, of_b, gradient) = sums.gradient.into_nodes();
        Some(DepthIntegral {
            value,
            nodes,
            of_b,
            gradient,
            pose_gradient: None,
            hessian: sums.hessian.into_blocks(),
            mean_depth: 0.5 * (mean(of_a_in_b) + mean(of_b_in_a)),
            overlap,
        })
    }

    fn pieces(&self, which: usize, region: &Region<D>) -> CellPieces<D> {
        let (surface, coords) = (self.pair.surface, self.pair.coords);
        let body = if let Partner::Body(body) = self.pair.partners[which] { body } else { 0 };
        CellPieces::new(surface, self.cells, self.field, coords, body, &region.facets[which], &region.aabb)
    }

    fn facets(
        &self,
        side: &FacetSide<D>,
        facets: &[u32],
        of_b: bool,
        other: &CellPieces<D>,
        weight: f64,
        region: &Region<D>,
    ) -> FacetIntegrals<D> {
        let (surface, cells, second) = (self.pair.surface, self.cells, self.second);
        let of_side = FacetsInCells { surface, cells, side, of_b, other, weight, second, own_cell: None };
        let rounding = region.aabb.rounding();
        let parts = self.pair.in_chunks(facets, CHUNK, |facets| of_side.integrals(facets, rounding));
        parts.into_iter().fold(FacetIntegrals::default(), |mut sum, part| {
            sum.add_part(part);
            sum
        })
    }
}
