//! Sums over the contact points of a pair, for energies that are taken point by point.
//!
//! A span is a part of a line inside both sides; where the line runs along the normal of the contact, its length is
//! the penetration depth. Both estimators return the same: sampled lines, or the points of a quadrature.
//!
//! With the line fixed, moving node a of the facet at an end moves the end by N_a n/(d·n), so that a function ψ of the
//! length has the gradient ±ψ'(L) N_a n/(d·n): along the outward normal of the facet at both ends. Where patches blend,
//! the part p(N) that counts moves too: ∂p/∂x_a = −N_a η, with η the slope of p across the lines. Where lines have a weight,
//! that of their middle, p is the part times the weight: an end that moves by δt along the line d changes it by ½ d·∇ρ δt.

use super::contact_point::ContactPoint;
use super::edge_terms::{Anchor, GapKink, SilhouettePoint};
use super::facet_sums::{FacetSum, facet_sums};
use crate::geometry::Vector;
use crate::geometry::primitives::facet_slopes::across;
use crate::overlap::normal_lines::patches::partition::Patches;
use crate::overlap::pair::assembly::{Assembly, FacetShare, PointShare};
use crate::overlap::pair::overlap::{Overlap, PoseGradient};
use crate::overlap::pair::sides::Pair;
use crate::overlap::pair::surface_point::SurfacePoint;
use crate::overlap::pair::warning::{Warning, swallowed};

/// All spans of a pair.
#[derive(Clone, Debug, Default)]
pub(crate) struct ContactPoints<const D: usize> {
    /// Directions of the lines, and which part of a span counts for which.
    pub(crate) patches: Patches<D>,
    pub(crate) points: Vec<ContactPoint<D>>,
    pub(crate) kinks: Vec<GapKink<D>>,
    /// Only where the integral over the lines is exact.
    pub(crate) silhouettes: Vec<SilhouettePoint<D>>,
    /// Standard error of the volume.
    pub(crate) standard_error: f64,
    pub(crate) fiber_count: usize,
    pub(crate) spacing: f64,
    pub(crate) warnings: Vec<Warning>,
}

/// Gradient of a sum over spans, laid out as in [`Overlap`].
pub(crate) struct PointGradient<const D: usize> {
    pub(crate) nodes: Vec<u32>,
    pub(crate) values: Vec<Vector<D>>,
    pub(crate) of_b: Vec<bool>,
    pub(crate) pose: Option<PoseGradient<D>>,
}

impl<const D: usize> ContactPoints<D> {
    /// Whether the lines lie in what a body has swallowed: none of them ends on the body.
    pub(crate) fn are_of_obstacle_alone(&self) -> bool {
        let is_of_body = |end: &SurfacePoint<D>| matches!(end, SurfacePoint::Facet { of_b: false, .. });
        !self.points.iter().flat_map(|point| &point.ends).any(is_of_body)
    }

    /// Longest span.
    pub(crate) fn longest(&self) -> f64 {
        self.points.iter().map(|s| s.length).fold(0.0, f64::max)
    }

    /// Σ ω f(L).
    pub(crate) fn sum(&self, f: impl Fn(f64) -> f64) -> f64 {
        self.points.iter().map(|s| s.weight * f(s.length)).sum()
    }

    /// Gradient of Σ ω ψ(L), given ψ and ψ'; and the volume Σ ω L, its gradient, and what is known of the contact.
    pub(crate) fn gradient_and_overlap(
        &self,
        pair: &Pair<D>,
        value: &(dyn Fn(f64) -> f64 + Sync),
        slope: &(dyn Fn(f64) -> f64 + Sync),
    ) -> (PointGradient<D>, Overlap<D>) {
        let sums = facet_sums(pair, &self.patches.directions, &self.points, slope);
        let (energy, volume) = pair.both(
            || self.assembly(pair, &sums, |sum| sum.energy, value, slope),
            || self.assembly(pair, &sums, |sum| sum.volume, &|length| length, &|_| 1.0),
        );
        let pose = pair.pose.map(|_| energy.pose_gradient().in_weighting(pair.weighting));
        let (nodes, values, of_b) = energy.into_nodes(pair.surface);
        (PointGradient { nodes, values, of_b, pose }, self.overlap_of(pair, &sums, volume))
    }

    /// Volume Σ ω L, its gradient, and what is known of the contact.
    pub(crate) fn overlap(&self, pair: &Pair<D>) -> Overlap<D> {
        let sums = facet_sums(pair, &self.patches.directions, &self.points, &|_| 1.0);
        let volume = self.assembly(pair, &sums, |sum| sum.volume, &|length| length, &|_| 1.0);
        self.overlap_of(pair, &sums, volume)
    }

    /// The overlap with the gradient that was assembled.
    fn overlap_of(&self, pair: &Pair<D>, sums: &[FacetSum<D>], assembly: Assembly<D>) -> Overlap<D> {
        let [a, b] = pair.partners;
        let of_shapes = self.points.iter().flat_map(|point| &point.ends).filter(|end| end.is_of_shape()).count();
        let mut overlap = Overlap {
            a,
            b,
            volume: self.sum(|length| length),
            standard_error: self.standard_error,
            nodes: Vec::new(),
            gradient: Vec::new(),
            of_b: Vec::new(),
            pose_gradient: pair.pose.map(|_| assembly.pose_gradient().in_weighting(pair.weighting)),
            contact_area: assembly.contact_area(),
            penetration: self.longest(),
            fiber_count: self.fiber_count,
            crossing_count: of_shapes + sums.iter().map(|sum| sum.count).sum::<usize>(),
            facet_count: sums.iter().filter(|sum| sum.count > 0).count(),
            spacing: self.spacing,
            warnings: self.warnings.clone(),
        };
        overlap.warnings.extend(self.patches.left_out.iter().map(|patch| {
            let mut normal = [0.0; 3];
            normal[..D].copy_from_slice(patch.normal.as_slice());
            Warning::PatchLeftOut { a, b, normal, area: patch.area, depth: patch.depth }
        }));
        overlap.warnings.extend(swallowed(a, b, assembly.side_areas()));
        (overlap.nodes, overlap.gradient, overlap.of_b) = assembly.into_nodes(pair.surface);
        overlap
    }

    fn assembly(
        &self,
        pair: &Pair<D>,
        sums: &[FacetSum<D>],
        shares: impl Fn(&FacetSum<D>) -> [f64; D],
        value: &(dyn Fn(f64) -> f64 + Sync),
        slope: &(dyn Fn(f64) -> f64 + Sync),
    ) -> Assembly<D> {
        let mut assembly = Assembly::new();
        let pose_of = |of_b: bool| if of_b { pair.pose } else { None };
        for sum in sums {
            let &FacetSum { of_b, facet, .. } = sum;
            assembly.add_facet(pair.side(of_b), &FacetShare { facet, of_b, shares: shares(sum) }, pose_of(of_b));
        }
        if pair.counterpart.is_shape() {
            for span in &self.points {
                let d = &self.patches.directions[span.direction as usize];
                for end in &span.ends {
                    let (SurfacePoint::Point { point, normal }, Some(pose)) = (*end, pair.pose) else { continue };
                    let share = span.weight * slope(span.length) / d.dot(&normal).abs();
                    assembly.add_point(&PointShare { point, normal, share }, pose);
                }
            }
        }
        if self.patches.are_blended() || !pair.weighting.is_plain() {
            for span in &self.points {
                for (end, blend) in span.ends.iter().zip(self.blends(pair, span)) {
                    let Some(eta) = blend else { continue };
                    let force = -eta * (span.across * value(span.length));
                    match (*end, pair.pose) {
                        (SurfacePoint::Facet { of_b, facet, weights }, _) => {
                            assembly.add_force(pair.side(of_b), (of_b, facet), &weights, &force, pose_of(of_b));
                        }
                        (SurfacePoint::Point { point, .. }, Some(pose)) => assembly.pull(&point, &force, pose),
                        _ => {}
                    }
                }
            }
        }
        for silhouette in &self.silhouettes {
            let jump: f64 = silhouette.spans.iter().map(|span| span.weight * value(span.length)).sum();
            for (anchor, weight) in &silhouette.weights {
                let Anchor::Vertex { of_b, vertex } = *anchor else { continue };
                let point = pair.side(of_b).points[vertex as usize];
                assembly.add_to_vertex(of_b, vertex, &point, &(silhouette.across * (*weight * jump)), pose_of(of_b));
            }
        }
        assembly
    }

    /// Slope η, across the lines, of the part of a span that counts, at either end where it has one.
    pub(crate) fn blends(&self, pair: &Pair<D>, span: &ContactPoint<D>) -> [Option<Vector<D>>; 2] {
        if !pair.weighting.is_plain() {
            return self.slopes_of_weight(pair, span);
        }
        if !self.patches.are_blended() {
            return [None; 2];
        }
        let part = self.patches.part(span.direction as usize, &span.ends);
        let d = &self.patches.directions[span.direction as usize];
        let mut blends = [None; 2];
        for ((end, corners), blend) in span.ends.iter().zip(part.at_corners).zip(&mut blends) {
            let (SurfacePoint::Facet { of_b, facet, .. }, Some(corners)) = (*end, corners) else { continue };
            *blend = across(&pair.side(of_b).corners(facet as usize), d, &corners);
        }
        blends
    }

    /// The same of a span's weight, times the part that counts.
    fn slopes_of_weight(&self, pair: &Pair<D>, span: &ContactPoint<D>) -> [Option<Vector<D>>; 2] {
        let d = &self.patches.directions[span.direction as usize];
        let whole = span.across * pair.weight_between(&span.ends);
        let part = if whole != 0.0 { span.weight / whole } else { 0.0 };
        let along = 0.5 * part * d.dot(&pair.weighting.gradient());
        span.ends.each_ref().map(|end| {
            let normal = pair.normal_at(end);
            let slope = d.dot(&normal);
            (slope != 0.0).then(|| normal * (-along / slope))
        })
    }
}
