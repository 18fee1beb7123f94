//! The exact estimator: facets of each side clipped by the simplices of the other.
//!
//! ```text
//! ∂V/∂x_a = Σ_{facets f of one side} Σ_{simplices s of the other} ∫_{f ∩ s} N_a n dA
//! ```
//!
//! V is homogeneous of degree D in all coordinates, so D V = Σ_a x_a · ∂V/∂x_a (the divergence theorem on the same
//! pieces). Exact for straight-sided cells and flat-sided obstacles; quadrilateral faces are split about their centroid.

use super::assembly::{Assembly, FacetShare};
use super::clip::clip_below;
use super::estimate::{Overlap, Partner};
use super::region::{Region, common_region};
use super::side::{FacetSide, ImplicitSide, Opponent, Pair};
use super::solid::Solid;
use super::warning::swallowed;
use crate::Error;
use crate::geometry::aabb::Aabb;
use crate::geometry::facet::area_vector;
use crate::geometry::{Pose, Shape, Vector};
use rayon::prelude::*;

/// What a facet has inside the other body, and the corners of its pieces there.
type Clipped<const D: usize> = (FacetShare<D>, Vec<Vector<D>>);

/// A pair that is to be clipped.
pub(crate) struct ExactPair<'a, const D: usize> {
    pub(crate) pair: &'a Pair<'a, D>,
    pub(crate) coords: &'a [[f64; D]],
}

impl<const D: usize> ExactPair<'_, D> {
    /// The overlap, or `None` where the sides are apart.
    pub(crate) fn overlap(&self) -> Result<Option<Overlap<D>>, Error> {
        let mut assembly = Assembly::new(self.pair.a.views.points.len());
        let volume = match &self.pair.opponent {
            Opponent::Itself => {
                let aabb = self.pair.a.aabb;
                let facets: Vec<u32> = (0..self.pair.a.facets.len() as u32).collect();
                let shares = self.clip(&self.pair.a, &facets, &self.solid(0, &self.pair.a, &aabb), true, false);
                self.add(&mut assembly, &self.pair.a, &shares, None, &aabb.center())
            }
            Opponent::Facets(b) => {
                let Some(region) = common_region(&self.pair.a, b) else { return Ok(None) };
                // One side after the other, so that a swap of the bodies swaps two numbers and no more.
                let Region { aabb, facets } = &region;
                let of_a = self.clip(&self.pair.a, &facets[0], &self.solid(1, b, aabb), false, false);
                let of_b = self.clip(b, &facets[1], &self.solid(0, &self.pair.a, aabb), false, true);
                let origin = aabb.center();
                self.add(&mut assembly, &self.pair.a, &of_a, None, &origin)
                    + self.add(&mut assembly, b, &of_b, self.pair.pose, &origin)
            }
            Opponent::Implicit(ImplicitSide { shape: Shape::HalfSpace, pose, .. }) => {
                let mut up = Vector::zeros();
                up[D - 1] = 1.0;
                let normal = pose.rotate(&up);
                let origin = Vector::from(pose.position);
                let shares: Vec<Clipped<D>> = (0..self.pair.a.facets.len())
                    .filter_map(|facet| {
                        let corners = self.pair.a.corners(facet);
                        let piece =
                            clip_below(&corners.map(|x| normal.dot(&(x - origin))), self.pair.a.aabb.rounding())?;
                        let area = area_vector(&corners).norm();
                        let shares = piece.moments.map(|w| w * area);
                        let share = FacetShare { facet: facet as u32, of_b: false, shares };
                        Some((share, piece.places(&corners).collect()))
                    })
                    .collect();
                // With the origin on the plane, the plane itself adds nothing to the volume.
                let nearest = self.pair.a.aabb.center();
                let origin = nearest - normal * normal.dot(&(nearest - origin));
                let volume = self.add(&mut assembly, &self.pair.a, &shares, None, &origin);
                assembly.add_reaction(&normal, &self.pair.a.views.points);
                volume
            }
            Opponent::Implicit(_) => {
                let what = "the exact overlap with a curved or signed-distance obstacle; use fibers, or give it as a polygon or triangle mesh";
                return Err(Error::Unsupported { what });
            }
        };
        Ok(Some(self.finish(assembly, volume / D as f64)))
    }

    /// Simplices of one of the two sides.
    fn solid(&self, which: usize, side: &FacetSide<D>, region: &Aabb<D>) -> Solid<D> {
        match (&self.pair.surface.cells, self.pair.partners[which]) {
            (Some(cells), Partner::Body(body)) => Solid::from_cells(cells, body, self.coords, region),
            _ => Solid::from_facets(side, region),
        }
    }

    /// What each of some facets of `side` has inside `solid`. With `own`, a facet's own cell does not count.
    fn clip(&self, side: &FacetSide<D>, facets: &[u32], solid: &Solid<D>, own: bool, of_b: bool) -> Vec<Clipped<D>> {
        let clip_facet = |facet: &u32| {
            let facet = *facet;
            let corners = side.corners(facet as usize);
            let area = area_vector(&corners);
            let (mut sums, mut ends, mut cancelled) = ([0.0; D], Vec::new(), false);
            let own_cell = if own { Some(self.cell_of(facet)) } else { None };
            solid.for_each_near(&Aabb::of(&corners), |simplex, origin| {
                if Some(origin) == own_cell {
                    return;
                }
                if let Some(piece) = simplex.clip(&corners, &area, solid.tie) {
                    for (sum, moment) in sums.iter_mut().zip(piece.moments) {
                        *sum += simplex.sign * moment;
                    }
                    ends.extend(piece.places(&corners));
                    // Where pieces are subtracted from one another, their corners are not those of the overlap.
                    cancelled |= simplex.sign < 0.0;
                }
            });
            let measure = area.norm();
            if cancelled {
                ends.clear();
            }
            let share = FacetShare { facet, of_b, shares: sums.map(|w| w * measure) };
            (sums.iter().sum::<f64>() > 0.0).then_some((share, ends))
        };
        if self.pair.parallel {
            facets.par_iter().filter_map(clip_facet).collect()
        } else {
            facets.iter().filter_map(clip_facet).collect()
        }
    }

    /// The cell that a facet of the first side belongs to, or the facet itself where there are no cells.
    fn cell_of(&self, facet: u32) -> u32 {
        match self.pair.partners[0] {
            Partner::Body(body) => {
                let index = self.pair.surface.ranges[body].start + facet as usize;
                self.pair.surface.facet_cell.get(index).copied().unwrap_or(facet)
            }
            Partner::Obstacle(_) => facet,
        }
    }

    /// Adds shares to the assembly and returns their part of D V.
    fn add(
        &self,
        assembly: &mut Assembly<D>,
        side: &FacetSide<D>,
        clipped: &[Clipped<D>],
        pose: Option<&Pose<D>>,
        origin: &Vector<D>,
    ) -> f64 {
        let mut moments = 0.0;
        for (share, ends) in clipped {
            assembly.add_facet(side, share, pose);
            assembly.extend_to(ends);
            let corners = side.corners(share.facet as usize);
            if let Some(normal) = area_vector(&corners).try_normalize(0.0) {
                moments += (0..D).map(|a| share.shares[a] * normal.dot(&(corners[a] - origin))).sum::<f64>();
            }
        }
        moments
    }

    fn finish(&self, mut assembly: Assembly<D>, volume: f64) -> Overlap<D> {
        let [a, b] = self.pair.partners;
        let mut overlap = Overlap {
            a,
            b,
            volume: volume.max(0.0),
            standard_error: 0.0,
            nodes: Vec::new(),
            gradient: Vec::new(),
            of_b: Vec::new(),
            pose_gradient: self.pair.pose.map(|_| assembly.pose_gradient()),
            contact_area: assembly.contact_area(),
            penetration: assembly.penetration(),
            fiber_count: 0,
            crossing_count: assembly.share_count(),
            facet_count: assembly.facet_count(),
            spacing: 0.0,
            warnings: swallowed(a, b, assembly.side_areas()).into_iter().collect(),
        };
        (overlap.nodes, overlap.gradient, overlap.of_b) = assembly.into_nodes(self.pair.surface);
        overlap
    }
}
