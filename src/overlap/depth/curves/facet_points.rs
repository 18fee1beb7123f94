//! Facets of one body in the shell of another, divided until points can sum up what is in a part.

use super::height_errors::HeightErrors;
use super::of_facet::{Below, OfFacet, on};
use super::parabola::{Marks, crossings, quadratic};
use super::rules::Rules;
use super::shell::Shell;
use super::tent::Tent;
use crate::configuration::FacetSide;
use crate::depth_field::Curves;
use crate::geometry::boundary::facet_sags::FacetSag;
use crate::geometry::mesh::cells::Cells;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::convex_piece::{Piece, place};
use crate::geometry::primitives::quadrature::for_each_simplex;
use crate::geometry::{Surface, Vector, Weighting};
use crate::overlap::depth::bodies::{FLAT, FacetPart, Found, clip};
use crate::overlap::depth::facet_sums::FacetSums;
use crate::overlap::depth::integral::DepthRequest;
use crate::overlap::depth::simplex_parts::{Corners, below, between};
use crate::overlap::pair::body_facet::BodyFacet;
use crate::overlap::pair::second_derivative::SecondDerivative;
use crate::ranks::packed;

/// The facets of one side, and the shell of the other.
pub(super) struct FacetPoints<'a, const D: usize> {
    pub(super) surface: &'a Surface<D>,
    pub(super) cells: &'a Cells,
    pub(super) curves: &'a Curves<D>,
    pub(super) side: &'a FacetSide<'a, D>,
    /// Number of its first facet in the surface.
    pub(super) first: usize,
    /// The body of the shell.
    pub(super) beside: usize,
    /// Whether the side is the second of the pair.
    pub(super) of_b: bool,
    pub(super) shell: &'a Shell<D>,
    pub(super) tent: Tent,
    pub(super) weighting: Weighting,
    /// How deep below the surfaces the contact begins.
    pub(super) clearance: f64,
    pub(super) request: &'a DepthRequest,
    pub(super) rules: Rules,
}

/// Sums over facets.
#[derive(Default)]
pub(super) struct PointsFound<const D: usize> {
    pub(super) sums: FacetSums<D>,
    /// ½ ∫ Ψ dA.
    pub(super) energy: f64,
    /// ½ ∫ min(g, c) dA.
    pub(super) volume: f64,
    /// The largest depth below the straight faces.
    pub(super) deepest: f64,
    /// How far heights may be wrong.
    pub(super) errors: HeightErrors,
}

packed!(PointsFound<D> { sums, energy, volume, deepest, errors });

impl<const D: usize> FacetPoints<'_, D> {
    /// The sums over some facets.
    pub(super) fn sums(&self, facets: &[u32], rounding: f64) -> PointsFound<D> {
        let mut found = PointsFound::default();
        let (mut part, mut work) = (FacetPart::default(), Piece::default());
        for &number in facets {
            let in_surface = self.first + number as usize;
            if !self.curves.is_surface(in_surface) {
                continue;
            }
            let Some(facet) = BodyFacet::new(self.surface, self.side, number) else { continue };
            let near = Aabb::of(&facet.corners).inflated(rounding);
            let before = self.curves.corners(&self.side.facets[number as usize]);
            let bend = self.curves.bend(in_surface, self.beside);
            let mut of_facet = OfFacet::new(facet, self.curves.facet(in_surface), before);
            self.shell.tree.visit(
                |node| node.meets(&near),
                |j| {
                    let in_shell = self.shell.get(j);
                    if !in_shell.aabb.meets(&near) {
                        return;
                    }
                    let simplex = in_shell.simplex;
                    let at = of_facet.facet.corners.each_ref().map(|x| simplex.barycentric(x));
                    let heights = self.shell.heights(&in_shell, bend);
                    let below = Below::new((in_shell.piece, heights), &of_facet.facet);
                    let (corners, area) = (of_facet.facet.corners, of_facet.facet.area);
                    clip(&corners, &at, &area, simplex, (&mut part, &mut work), |inside| {
                        if let Found::Part(inside, counts) = inside {
                            let part = counts * simplex.sign;
                            self.add(&mut of_facet, &below, inside.on_facet(), part, &mut found);
                            if self.request.second == SecondDerivative::Full {
                                self.add_borders(&mut of_facet, &below, simplex, (inside, part));
                            }
                        }
                    });
                },
            );
            self.finish(of_facet, &mut found.sums);
        }
        found
    }

    /// Adds a convex part of a facet over a piece: by rays, or simplex by simplex between the levels of the tent.
    fn add(
        &self,
        of_facet: &mut OfFacet<D>,
        below_it: &Below<D>,
        part: &[[f64; D]],
        counts: f64,
        found: &mut PointsFound<D>,
    ) {
        let straight = |w: &[f64; D]| -> f64 {
            let at = below_it.at(w);
            (0..=D).map(|k| at[k] * below_it.piece.depths[k]).sum()
        };
        found.deepest = part.iter().map(straight).fold(found.deepest, f64::max);
        if !self.is_flat(of_facet.sag, below_it) {
            for w in part {
                let heights = [of_facet.sag.at(w), below_it.heights.at(&below_it.at(w)).0];
                if straight(w) + heights[0] + heights[1] > 0.0 {
                    found.errors.see(heights, below_it.turn);
                }
            }
        }
        let facet = &of_facet.facet;
        let flat = FLAT * facet.size();
        if facet.looks_the_same_way(below_it.piece) && part.iter().all(|w| (straight(w) + self.clearance).abs() <= flat)
        {
            let measure = |share: f64, corners: [&[f64; D]; D]| {
                let middle = corners.iter().map(|w| place(&facet.corners, w)).sum::<Vector<D>>() / D as f64;
                // The same area has facets on both sides.
                0.5 * counts * share * facet.measure * self.weighting.at(&middle)
            };
            for_each_simplex(part, |corners, share| found.sums.flush += measure(share, corners));
        }
        if D == 3 && !self.is_flat(of_facet.sag, below_it) {
            return self.add_by_rays(of_facet, below_it, part, counts, found);
        }
        let levels = self.tent.levels();
        for_each_simplex(part, |corners, share| {
            let mut whole: Corners = [[0.0; 4]; 4];
            for (corner, w) in whole.iter_mut().zip(corners) {
                corner[..D].copy_from_slice(w);
            }
            match D {
                2 => self.between_roots(of_facet, below_it, &whole, share * counts, found),
                _ => self.between_levels(of_facet, below_it, &whole, (share * counts, &levels), found),
            }
        });
    }

    /// Divides an interval of the facet where the depth is that of a level: what is summed up is a polynomial in between, of which the
    /// points have the integral.
    fn between_roots(
        &self,
        of_facet: &mut OfFacet<D>,
        below_it: &Below<D>,
        ends: &Corners,
        share: f64,
        found: &mut PointsFound<D>,
    ) {
        let end = |k: usize| -> [f64; D] { std::array::from_fn(|c| ends[k][c]) };
        let at = |t: f64| -> [f64; 4] { std::array::from_fn(|c| ends[0][c] + t * (ends[1][c] - ends[0][c])) };
        for pair in self.cuts(of_facet.sag, below_it, [&end(0), &end(1)]).windows(2) {
            let part = [at(pair[0]), at(pair[1]), [0.0; 4], [0.0; 4]];
            self.add_points(of_facet, below_it, &part, share * (pair[1] - pair[0]), found);
        }
    }

    /// Parts of the way between two places of the facet at which the depth, a quadratic function, is that of a level, with both ends.
    pub(super) fn cuts(&self, sag: &FacetSag<D>, below_it: &Below<D>, [from, to]: [&[f64; D]; 2]) -> Marks {
        let depth = |t: f64| self.depth(sag, below_it, &on(from, to, t)).0;
        crossings(&quadratic(depth), &self.tent.levels())
    }

    /// Divides a simplex of the facet where the depth is that of a level, and adds the points of what it is divided into.
    fn between_levels(
        &self,
        of_facet: &mut OfFacet<D>,
        below_it: &Below<D>,
        corners: &Corners,
        (share, levels): (f64, &[f64]),
        found: &mut PointsFound<D>,
    ) {
        let Some((level, higher)) = levels.split_first() else {
            return self.add_points(of_facet, below_it, corners, share, found);
        };
        let mut values = [0.0; 4];
        for (value, corner) in values.iter_mut().zip(corners).take(D) {
            let at = std::array::from_fn(|c| corner[c]);
            *value = self.depth(of_facet.sag, below_it, &at).0 - level;
        }
        if values[..D].iter().all(|value| *value <= 0.0) {
            return self.add_points(of_facet, below_it, corners, share, found);
        }
        let in_facet = |simplex: &Corners| -> Corners { std::array::from_fn(|c| between(corners, &simplex[c])) };
        below(D - 1, &values, |simplex, part| {
            self.add_points(of_facet, below_it, &in_facet(simplex), share * part, found);
        });
        below(D - 1, &values.map(|value| -value), |simplex, part| {
            self.between_levels(of_facet, below_it, &in_facet(simplex), (share * part, higher), found);
        });
    }
}
