//! The exact estimator: facets of each side clipped by the simplices of the other.
//!
//! ```text
//! ∂V/∂x_a = Σ_{facets f of one side} Σ_{simplices s of the other} ∫_{f ∩ s} N_a n dA
//! ```
//!
//! A facet that keeps clear of the other body's boundary is all inside or all outside. Only the others, those near the
//! curve in which the boundaries cross, are clipped.
//!
//! V is homogeneous of degree D in all coordinates, so D V = Σ_a x_a · ∂V/∂x_a (the divergence theorem on the same
//! pieces). Exact for straight-sided cells and flat-sided obstacles; quadrilateral faces are split about their
//! centroid.

use super::clipper::{Clipped, Clipper, Inside};
use super::near_facets::{Facets, NearFacets};
use super::solid::Solid;
use super::winding::{winding_about, windings};
use crate::Error;
use crate::configuration::FacetSide;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::primitives::plane::Plane;
use crate::geometry::{Pose, Vector};
use crate::overlap::pair::assembly::Assembly;
use crate::overlap::pair::overlap::Overlap;
use crate::overlap::pair::partner::Partner;
use crate::overlap::pair::sides::{Counterpart, Pair};
use crate::overlap::pair::warning::swallowed;
use crate::ranks::Sharing;

/// Facets that a thread, or a rank, takes at once.
const CHUNK: usize = 16;

/// A pair that is to be clipped.
pub(crate) struct ClippedPair<'a, const D: usize> {
    pub(crate) pair: &'a Pair<'a, D>,
}

/// What was clipped.
pub(crate) struct Found<'a, const D: usize> {
    /// Sides that have facets, what of these lies inside the other side, and their pose if they are an obstacle.
    pub(crate) sides: Vec<(&'a FacetSide<'a, D>, Vec<Clipped<D>>, Option<&'a Pose<D>>)>,
    pub(crate) region: Aabb<D>,
    /// Boundary of a half-space.
    pub(crate) plane: Option<Plane<D>>,
}

impl<const D: usize> ClippedPair<'_, D> {
    /// The overlap, or `None` where the sides are apart.
    pub(crate) fn overlap(&self) -> Result<Option<Overlap<D>>, Error> {
        Ok(self.clipped()?.map(|found| self.assemble(&found)))
    }

    /// The facets of each side as far as they are inside the other, or `None` where the sides are apart.
    pub(crate) fn clipped(&self) -> Result<Option<Found<'_, D>>, Error> {
        let (a, pose) = (&self.pair.a, self.pair.pose);
        match &self.pair.counterpart {
            Counterpart::Itself => {
                let tolerance = a.aabb.rounding();
                let solid = match (&self.pair.surface.cells, self.pair.partners[0]) {
                    (Some(cells), Partner::Body(body)) => Solid::from_cells(cells, body, self.pair.coords),
                    _ => Solid::from_facets(a, &a.aabb.inflated(tolerance)),
                };
                let facets: Vec<u32> = (0..a.facets.len() as u32).collect();
                let shares = self.clip(a, &facets, &solid, tolerance, true, false, |_, _| None);
                Ok(Some(Found { sides: vec![(a, shares, None)], region: a.aabb, plane: None }))
            }
            Counterpart::Facets(b) => {
                let Some(region) = self.pair.region()? else { return Ok(None) };
                let aabb = region.aabb;
                let clearance = NearFacets::new(self.pair, b, region);
                let tolerance = clearance.tolerance;
                let [of_a, of_b] = &clearance.sides;
                // One side by itself, then the other, so that a swap of the bodies swaps two numbers and no more.
                let (shares_a, shares_b) = self.pair.both(
                    || self.shares(a, of_a, 1, b, of_b, &aabb, tolerance),
                    || self.shares(b, of_b, 0, a, of_a, &aabb, tolerance),
                );
                Ok(Some(Found { sides: vec![(a, shares_a, None), (b, shares_b, pose)], region: aabb, plane: None }))
            }
            Counterpart::Implicit(_) => {
                let Some(plane) = self.pair.plane()? else { return Ok(None) };
                let tolerance = a.aabb.rounding();
                let mut clipper = Clipper::new(self.pair.weighting);
                let below = a.facets_where(|aabb| plane.least(aabb) <= tolerance);
                let shares: Vec<Clipped<D>> = below
                    .into_iter()
                    .filter_map(|facet| clipper.below(facet, &a.corners(facet as usize), &plane, tolerance))
                    .collect();
                Ok(Some(Found { sides: vec![(a, shares, None)], region: a.aabb, plane: Some(plane) }))
            }
        }
    }

    /// What the facets of one side have inside the other, which is side number `which` of the pair.
    #[allow(clippy::too_many_arguments)]
    fn shares(
        &self,
        side: &FacetSide<D>,
        facets: &Facets<D>,
        which: usize,
        other: &FacetSide<D>,
        other_facets: &Facets<D>,
        region: &Aabb<D>,
        tolerance: f64,
    ) -> Vec<Clipped<D>> {
        let of_b = which == 0;
        let near: Vec<u32> = (facets.numbers.iter().zip(&facets.is_near)).filter(|f| *f.1).map(|f| *f.0).collect();
        let mut clipped = Vec::new();
        if !near.is_empty() {
            let solid = match (&self.pair.surface.cells, self.pair.partners[which]) {
                (Some(cells), Partner::Body(body)) => {
                    let facet_cell = &self.pair.surface.facet_cell[self.pair.surface.ranges[body].clone()];
                    Solid::Cells { cells, coords: self.pair.coords, facets: other_facets, facet_cell }
                }
                _ => {
                    let boxes = facets.boxes.iter().zip(&facets.is_near).filter(|f| *f.1);
                    let around = boxes.fold(Aabb::empty(), |sum, f| sum.union(f.0));
                    Solid::from_facets(other, &around)
                }
            };
            let whole = |facet: u32, corners: &[Vector<D>; D]| {
                let winding = winding_about(other, corners);
                (winding > 0).then(|| Clipped::whole((facet, of_b), corners, winding, self.pair.weighting))
            };
            clipped = self.clip(side, &near, &solid, tolerance, false, of_b, whole);
        }
        let windings = windings(side, facets, other, &region.inflated(tolerance));
        let mut clipped = clipped.into_iter().peekable();
        let mut shares = Vec::new();
        for (f, &facet) in facets.numbers.iter().enumerate() {
            if let Some(share) = clipped.next_if(|c| c.share.facet == facet) {
                shares.push(share);
            } else if windings[f] > 0 {
                let corners = &facets.corners[f];
                shares.push(Clipped::whole((facet, of_b), corners, windings[f], self.pair.weighting));
            }
        }
        shares
    }

    /// What each of some facets of `side` has inside `solid`. With `own`, a facet's own cell does not count. `whole`
    /// decides about facets in no cell: the boundary that they are near may not reach to where they are.
    #[allow(clippy::too_many_arguments)]
    fn clip(
        &self,
        side: &FacetSide<D>,
        facets: &[u32],
        solid: &Solid<D>,
        tolerance: f64,
        own: bool,
        of_b: bool,
        whole: impl Fn(u32, &[Vector<D>; D]) -> Option<Clipped<D>> + Sync,
    ) -> Vec<Clipped<D>> {
        let clip = |clipper: &mut Clipper<D>, &facet: &u32| {
            let own_cell = own.then(|| self.cell_of(facet));
            let corners = side.corners(facet as usize);
            match clipper.inside(facet, of_b, &corners, solid, tolerance, own_cell) {
                Inside::Part(clipped) => Some(clipped),
                Inside::Touching => None,
                Inside::Nothing => whole(facet, &corners),
            }
        };
        let of_chunk = |facets: &[u32]| -> Vec<Clipped<D>> {
            let mut clipper = Clipper::new(self.pair.weighting);
            let clipped = |facet| {
                self.pair.sharing.check();
                clip(&mut clipper, facet)
            };
            facets.iter().filter_map(clipped).collect()
        };
        match self.pair.sharing {
            // One clipper for all.
            Sharing::Alone(_) => of_chunk(facets),
            _ => self.pair.in_chunks(facets, CHUNK, of_chunk).into_iter().flatten().collect(),
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

    /// Sums up the shares of one or two sides, and what the plane of a half-space must carry.
    ///
    /// The volume is taken about the middle of the boundary of the overlap: about a point at a distance r from a thin
    /// overlap, the boundary on both of its sides would add two numbers of size r that cancel. A half-space has the
    /// origin on its plane, which then adds nothing itself.
    pub(super) fn assemble(&self, Found { sides, region, plane }: &Found<D>) -> Overlap<D> {
        let near = region.center();
        let (mut weight, mut origin) = (0.0, Vector::zeros());
        for (side, shares, _) in sides {
            let (mut of_side, mut moment) = (0.0, Vector::zeros());
            for Clipped { share, .. } in shares {
                let corners = side.corners(share.facet as usize);
                of_side += share.shares.iter().sum::<f64>();
                moment += (0..D).fold(Vector::zeros(), |m, a| m + (corners[a] - near) * share.shares[a]);
            }
            weight += of_side;
            origin += moment;
        }
        origin = if weight > 0.0 { near + origin / weight } else { near };
        if let Some(plane) = plane {
            origin -= plane.normal * plane.height(&origin);
        }
        let mut assembly = Assembly::new();
        let (mut volume, mut bare) = (0.0, 0.0);
        for (side, shares, pose) in sides {
            let [of_side, bare_of_side] = self.add(&mut assembly, side, shares, *pose, &origin);
            volume += of_side;
            bare += bare_of_side;
        }
        let weighting = self.pair.weighting;
        if let Some(plane) = plane {
            // The weight's gradient has the size by which the moments were multiplied.
            let size = weighting.gradient::<D>().norm();
            let as_one = if size > 0.0 { weighting.gradient() * (bare / (D as f64 * size)) } else { Vector::zeros() };
            assembly.add_reaction(&plane.normal, self.pair.a.points, &as_one);
        }
        // With a weight ρ that is linear, ∇·[(ρ + ρ(o)/D) (x − o)] = (D + 1) ρ.
        let degree = if weighting.is_plain() { D } else { D + 1 };
        self.finish(assembly, volume / degree as f64)
    }

    /// Adds shares to the assembly and returns their part of D V, and the same without the weight, times the size of its
    /// gradient. With a weight the first is that of (D + 1) V.
    fn add(
        &self,
        assembly: &mut Assembly<D>,
        side: &FacetSide<D>,
        clipped: &[Clipped<D>],
        pose: Option<&Pose<D>>,
        origin: &Vector<D>,
    ) -> [f64; 2] {
        let (mut moments, mut bare) = (0.0, 0.0);
        let weighting = self.pair.weighting;
        for Clipped { share, ends, spread } in clipped {
            let corners = side.corners(share.facet as usize);
            // What lies on an axis closes the section, and bounds no body.
            if !weighting.is_axis(&corners, self.pair.a.aabb.rounding()) {
                assembly.add_facet(side, share, pose);
                assembly.extend_to(ends.as_deref().unwrap_or(&corners));
            }
            if let Some(normal) = area_vector(&corners).try_normalize(0.0) {
                moments += (0..D).map(|a| share.shares[a] * normal.dot(&(corners[a] - origin))).sum::<f64>();
                if !weighting.is_plain() {
                    let flux = normal.dot(&(corners[0] - origin)) * spread.as_flattened().iter().sum::<f64>();
                    bare += flux;
                    moments += flux * origin.dot(&weighting.gradient()) / (D as f64 * weighting.gradient::<D>().norm());
                }
            }
        }
        [moments, bare]
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
            pose_gradient: self.pair.pose.map(|_| assembly.pose_gradient().in_weighting(self.pair.weighting)),
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
