//! The depth of two bodies below each other's surfaces, summed over their overlap.

use super::cell_integrals::cell_integrals;
use super::cell_pieces::CellPieces;
use super::facet_integrals::FacetsInCells;
use super::piece_moments::common_moments;
use crate::configuration::FacetSide;
use crate::depth::DepthField;
use crate::geometry::Vector;
use crate::geometry::cells::Cells;
use crate::overlap::depth_integral::{DepthIntegral, DepthRequest};
use crate::overlap::exact::depth::facet_sums::FacetSums;
use crate::overlap::pair::partner::Partner;
use crate::overlap::pair::region::Region;
use crate::overlap::pair::sides::Pair;
use crate::overlap::pair::warning::Warning;

/// Facets, or pieces, that a thread takes at once.
const CHUNK: usize = 64;

/// Bodies of cells.
pub(crate) struct DeepBodies<'a, const D: usize> {
    pub(crate) pair: &'a Pair<'a, D>,
    pub(crate) cells: &'a Cells,
    pub(crate) field: &'a DepthField<D>,
    pub(crate) request: &'a DepthRequest,
}

/// Part with which the depth of either body counts.
const WEIGHT: f64 = 0.5;

impl<const D: usize> DeepBodies<'_, D> {
    /// Of two bodies.
    pub(crate) fn two(&self, b: &FacetSide<D>, region: &Region<D>) -> Option<DepthIntegral<D>> {
        let pair = self.pair;
        let (of_a, of_b) = pair.both(|| self.pieces(0, region), || self.pieces(1, region));
        let rounding = region.aabb.rounding();
        let (facets_a, facets_b) = pair.both(
            || self.facets(&pair.a, &region.facets[0], (false, false), &of_b, rounding),
            || self.facets(b, &region.facets[1], (true, false), &of_a, rounding),
        );
        let (moments_a, moments_b) = self.moments(&of_a, &of_b);
        self.assemble(vec![facets_a, facets_b], &[(&of_a, &moments_a), (&of_b, &moments_b)])
    }

    /// ∫ over the overlap of the barycentric coordinates of every piece of either body.
    fn moments(&self, of_a: &CellPieces<D>, of_b: &CellPieces<D>) -> (Vec<[f64; 4]>, Vec<[f64; 4]>) {
        let numbered: Vec<usize> = (0..of_a.pieces.len()).collect();
        let found = self.pair.in_chunks(&numbered, CHUNK, |numbers| {
            let mut found = Vec::new();
            for &i in numbers {
                let (piece, aabb) = (&of_a.pieces[i], &of_a.boxes[i]);
                of_b.tree.visit(
                    |node| node.meets(aabb),
                    |j| {
                        let j = j as usize;
                        if of_b.boxes[j].meets(aabb) {
                            found.extend(common_moments(piece, &of_b.pieces[j]).map(|moments| (i, j, moments)));
                        }
                    },
                );
            }
            found
        });
        let (mut in_a, mut in_b) = (vec![[0.0; 4]; of_a.pieces.len()], vec![[0.0; 4]; of_b.pieces.len()]);
        for (i, j, [of_i, of_j]) in found.into_iter().flatten() {
            add_to(&mut in_a[i], of_i);
            add_to(&mut in_b[j], of_j);
        }
        (in_a, in_b)
    }

    /// Of a body with itself: every two of its cells that overlap.
    pub(crate) fn one(&self) -> Option<DepthIntegral<D>> {
        let a = &self.pair.a;
        let region = Region { aabb: a.aabb, facets: [(0..a.facets.len() as u32).collect(), Vec::new()] };
        let all = self.pieces(0, &region);
        let facets = self.facets(a, &region.facets[0], (false, true), &all, a.aabb.rounding());
        let mut moments = vec![[0.0; 4]; all.pieces.len()];
        all.tree.visit_own_pairs(&Vector::zeros(), |i, j| {
            let (p, q) = (&all.pieces[i as usize], &all.pieces[j as usize]);
            if p.cell != q.cell
                && all.boxes[i as usize].meets(&all.boxes[j as usize])
                && let Some([in_p, in_q]) = common_moments(p, q)
            {
                add_to(&mut moments[i as usize], in_p);
                add_to(&mut moments[j as usize], in_q);
            }
            true
        });
        self.assemble(vec![facets], &[(&all, &moments)])
    }

    /// From what the facets of either side have inside the other, and the moments of its pieces.
    fn assemble(&self, facets: Vec<FacetSums<D>>, cells: &[(&CellPieces<D>, &[[f64; 4]])]) -> Option<DepthIntegral<D>> {
        let inside = || facets.iter().filter(|part| part.area > 0.0);
        let area: f64 = inside().map(|part| part.area).sum();
        let depth: f64 = inside().map(|part| part.depth / part.area).sum();
        let sides = inside().count() as f64;
        let mut sums = FacetSums::of_parts(facets);
        let (mut volume, mut value) = (0.0, 0.0);
        for (which, (pieces, moments)) in cells.iter().enumerate() {
            let FacetSums { gradient, hessian, .. } = &mut sums;
            let side = (which == 1, WEIGHT);
            let found = cell_integrals(self.cells, pieces, moments, side, self.request.second, gradient, hessian);
            value += WEIGHT * found.depth;
            volume += 0.5 * found.volume;
        }
        let mut overlap = sums.overlap(self.pair, volume, 0.5 * area)?;
        if sums.flush > 0.0 && !self.field.is_surface_told() {
            let (a, b) = (overlap.a, overlap.b);
            overlap.warnings.push(Warning::FlushFaces { a, b, area: sums.flush });
        }
        let (nodes, of_b, gradient) = sums.gradient.into_nodes();
        Some(DepthIntegral {
            value,
            nodes,
            of_b,
            gradient,
            pose_gradient: None,
            hessian: sums.hessian.into_blocks(),
            facets: sums.facets,
            points: sums.points,
            mean_depth: if sides > 0.0 { depth / sides } else { 0.0 },
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
        (of_b, own): (bool, bool),
        other: &CellPieces<D>,
        rounding: f64,
    ) -> FacetSums<D> {
        let (surface, cells, request) = (self.pair.surface, self.cells, self.request);
        let body = if let Partner::Body(body) = self.pair.partners[0] { body } else { 0 };
        let own_cell = own.then(|| &surface.facet_cell[surface.ranges[body].clone()]);
        let of_side = FacetsInCells { surface, cells, side, of_b, other, weight: WEIGHT, request, own_cell };
        let parts = self.pair.in_chunks(facets, CHUNK, |facets| of_side.integrals(facets, rounding));
        FacetSums::of_parts(parts)
    }
}

fn add_to(sums: &mut [f64; 4], found: [f64; 4]) {
    sums.iter_mut().zip(found).for_each(|(sum, m)| *sum += m);
}
