//! The depth of a body below the surface that lies outside of a convex solid by a radius.
//!
//! In the solid it is the depth there and the radius, in closed form. Beside it the space is divided into cells, in each of which it is
//! the radius less the distance from a plane, a line or a point. Over facets it is summed cell by cell. Over the overlap it
//! is summed along lines that go up in a cell, from the facets that bound the body in it or below:
//!
//! ```text
//! U(x) = ∫ g along the line above x, in the cell:   ∫_{A∩cell} g dx = −∮_∂A U up·n dA
//! ```
//!
//! All of what lies below a floor has the U of its foot on the floor. A cell that no facet enters lies in the body or not: then
//! nothing is summed that would cancel to a rounding error.

use super::convex_facets::facet_moments;
use super::convex_solid::ConvexSolid;
use super::convex_volume::DepthSum;
use super::facet_moments::FacetMoments;
use super::round_cells::{Cell, Nearest, cells};
use super::round_points::{Round, gauss};
use crate::configuration::FacetSide;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::convex_piece::{Piece, place};
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::primitives::quadrature::for_each_gauss_point;
use crate::geometry::primitives::tree::Tree;
use crate::geometry::{Vector, Weighting};
use crate::overlap::depth::facet_sums::FacetSums;
use crate::overlap::depth::integral::DepthRequest;
use crate::overlap::pair::body_facet::BodyFacet;
use crate::overlap::pair::second_derivative::SecondDerivative;
use crate::overlap::pair::sides::Pair;

/// Facets, and cells, that a thread takes at once.
const FACETS: usize = 16;
const CELLS: usize = 16;

/// A convex solid with all that is no farther from it than a radius.
pub(super) struct Rounded<'a, const D: usize> {
    solid: ConvexSolid<'a, D>,
    cells: Vec<Cell<D>>,
    /// Over their boxes.
    tree: Tree<D>,
    /// Around the solid.
    aabb: Aabb<D>,
    radius: f64,
}

impl<'a, const D: usize> Rounded<'a, D> {
    /// `None` for a side that is not convex.
    pub(super) fn new(side: &FacetSide<'a, D>, scale: f64, radius: f64) -> Option<Self> {
        let solid = ConvexSolid::within(side, scale)?;
        let cells = cells(&solid, side.rigid?.flat().convex.as_ref()?, side, radius)?;
        let boxes: Vec<Aabb<D>> = cells.iter().map(|cell| cell.aabb).collect();
        Some(Self { solid, cells, tree: Tree::new(&boxes), aabb: side.aabb, radius })
    }

    /// Sums over facets of the body of a pair.
    pub(super) fn over_facets(&self, pair: &Pair<D>, facets: &[u32], request: &DepthRequest) -> FacetSums<D> {
        let rounding = pair.a.aabb.rounding();
        let parts = pair.in_chunks(facets, FACETS, |facets| {
            let (mut sums, mut work) = (FacetSums::default(), Piece::default());
            for &facet in facets {
                if let Some(facet) = BodyFacet::new(pair.surface, &pair.a, facet) {
                    let on_facet = (&facet, pair.weighting);
                    let within = (self.radius, rounding);
                    let mut moments = facet_moments(&self.solid, on_facet, within, request.second, &mut work);
                    let aabb = Aabb::of(&facet.corners);
                    let mut near = Vec::new();
                    self.tree.visit(|of_cells| of_cells.meets(&aabb), |cell| near.push(cell));
                    near.sort_unstable();
                    for cell in near {
                        self.add(&self.cells[cell as usize], on_facet, request.second, &mut moments, &mut work);
                    }
                    sums.add(&facet, &moments, request, pair.weighting);
                }
            }
            sums
        });
        FacetSums::of_parts(parts)
    }

    /// Adds what of a facet lies in a cell.
    fn add(
        &self,
        cell: &Cell<D>,
        (facet, weighting): (&BodyFacet<D>, Weighting),
        second: SecondDerivative,
        moments: &mut FacetMoments<D>,
        work: &mut Piece<D>,
    ) {
        if !cell.cut(&facet.corners, work) || !self.cut_at_top(cell, &facet.corners, work) {
            return;
        }
        let mut is_met = false;
        let mut add = |w: &[f64; D], part: f64| {
            let away = cell.away(&place(&facet.corners, w));
            let distance = away.norm();
            let gradient = away * if distance > 0.0 { -1.0 / distance } else { 0.0 };
            let slopes = (second != SecondDerivative::No).then_some(&gradient);
            moments.add_point((facet, weighting), w, part, self.radius - distance, slopes);
            is_met = true;
        };
        match cell.nearest {
            Nearest::Face => for_each_gauss_point(work.corners(), false, add),
            _ => self.round(cell).for_each_point(&facet.corners, work.corners(), &mut add),
        }
        if is_met {
            let away: Vec<Vector<D>> = work.corners().iter().map(|w| cell.away(&place(&facet.corners, w))).collect();
            moments.reach(self.radius - self.round(cell).least_at_border(&away));
            moments.piece_count += 1;
        }
    }

    /// Keeps of a piece above a face what is near enough; beside edges and corners that is left to the quadrature.
    fn cut_at_top(&self, cell: &Cell<D>, corners: &[Vector<D>; D], work: &mut Piece<D>) -> bool {
        let Nearest::Face = cell.nearest else { return true };
        let above = corners.each_ref().map(|x| cell.up.dot(&(x - cell.apex)) - self.radius);
        above.iter().all(|h| *h <= 0.0) || above.iter().any(|h| *h < 0.0) && work.cut(&above)
    }

    fn round<'b>(&self, cell: &'b Cell<D>) -> Round<'b, D> {
        Round { nearest: &cell.nearest, apex: &cell.apex, radius: self.radius }
    }

    /// Sums over the overlap with the body of a pair.
    pub(super) fn sums(&self, pair: &Pair<D>) -> DepthSum {
        let mut all = if self.is_entered(&pair.a) { self.solid.sums(pair) } else { DepthSum::default() };
        // Inside the solid it is deeper by the radius.
        all.depth += self.radius * all.volume;
        all.bare_depth += self.radius * all.bare_volume;
        let near: Vec<u32> =
            (0..self.cells.len() as u32).filter(|cell| self.cells[*cell as usize].aabb.meets(&pair.a.aabb)).collect();
        let of_cells = |cells: &[u32]| {
            let (mut sums, mut work) = (DepthSum::default(), Piece::default());
            cells.iter().for_each(|cell| sums += self.in_cell(&self.cells[*cell as usize], pair, &mut work));
            sums
        };
        pair.on_threads(&near, CELLS, of_cells).into_iter().for_each(|sums| all += sums);
        all
    }

    /// Whether facets enter the solid, or all of it lies in the body.
    fn is_entered(&self, body: &FacetSide<D>) -> bool {
        let enters = |facet: &u32| !self.solid.nearest(&body.corners(*facet as usize)).is_empty();
        body.facets_in(&self.aabb).iter().any(enters) || body.winding_number(&self.aabb.center()) != 0
    }

    fn in_cell(&self, cell: &Cell<D>, pair: &Pair<D>, work: &mut Piece<D>) -> DepthSum {
        let (body, mut sums, mut is_met) = (&pair.a, DepthSum::default(), false);
        for facet in body.facets_in(&cell.aabb) {
            let corners = body.corners(facet as usize);
            if cell.cut(&corners, work) && self.cut_at_top(cell, &corners, work) {
                is_met |= self.flux(cell, pair.weighting, (&corners, work), &mut sums);
            }
        }
        if !is_met && body.winding_number(&cell.middle) == 0 {
            return DepthSum::default();
        }
        for floor in &cell.floors {
            let across = floor.wall.height.slope.dot(&cell.up);
            for facet in body.facets_where(|aabb| cell.is_below(floor, aabb, self.radius)) {
                let corners = body.corners(facet as usize);
                if floor.cut(&corners, work) {
                    let feet = corners.each_ref().map(|x| x - cell.up * (floor.wall.height.at(x) / across));
                    self.flux(cell, pair.weighting, (&feet, work), &mut sums);
                }
            }
        }
        sums
    }

    /// Adds what a piece of a facet that lies in a cell does; false if all of it is too far away.
    fn flux(
        &self,
        cell: &Cell<D>,
        weighting: Weighting,
        (corners, piece): (&[Vector<D>; D], &Piece<D>),
        sums: &mut DepthSum,
    ) -> bool {
        let mut is_met = false;
        let across = -cell.up.dot(&area_vector(corners));
        let outwards: Vector<D> = weighting.gradient();
        let slope = outwards.dot(&cell.up);
        let mut add = |w: &[f64; D], part: f64| {
            let x = place(corners, w);
            let [length, tilted, depth, tilted_depth] = self.above(cell, &x);
            let at = weighting.at(&x);
            sums.volume += across * part * (at * length + slope * tilted);
            sums.depth += across * part * (at * depth + slope * tilted_depth);
            sums.bare_depth += across * part * depth;
            sums.bare_volume += across * part * length;
            is_met = true;
        };
        match cell.nearest {
            Nearest::Face => for_each_gauss_point(piece.corners(), false, add),
            _ => self.round(cell).for_each_point(corners, piece.corners(), &mut add),
        }
        is_met
    }

    /// On the line above a point, in the cell: its length, ∫ of the way from the point, of the depth, and of both.
    fn above(&self, cell: &Cell<D>, x: &Vector<D>) -> [f64; 4] {
        let away = cell.away(x);
        let height = cell.up.dot(&away);
        if let Nearest::Face = cell.nearest {
            let length = self.radius - height;
            let squared = length * length;
            return [length, 0.5 * squared, 0.5 * squared, squared * length / 6.0];
        }
        let beside = (away - cell.up * height).norm_squared();
        let top = (self.radius * self.radius - beside).max(0.0).sqrt();
        let left = self.radius * self.radius - beside - height * height;
        let length = if height > 0.0 { left.max(0.0) / (top + height) } else { top - height };
        let (mut depth, mut tilted_depth) = (0.0, 0.0);
        if length <= (beside + height * height).sqrt() {
            // Without differences of what is much larger.
            gauss([0.0, length], |way, part| {
                let here = self.radius - (beside + (height + way) * (height + way)).sqrt();
                depth += part * here;
                tilted_depth += part * here * way;
            });
        } else {
            let [low, high] = [height, height + length].map(|t| {
                let distance = (beside + t * t).sqrt();
                let curved = if beside > 0.0 { beside * (t / beside.sqrt()).asinh() } else { 0.0 };
                let moment = 0.5 * self.radius * t * t - distance * distance * distance / 3.0;
                [self.radius * t - 0.5 * (t * distance + curved), moment]
            });
            depth = high[0] - low[0];
            tilted_depth = high[1] - low[1] - height * depth;
        }
        [length, 0.5 * length * length, depth, tilted_depth]
    }
}
