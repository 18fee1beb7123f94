//! What sliding wears off, at the points of the facets.

use super::slip_facets::SlipFacets;
use super::step::Sliding;
use super::traction::Stick;
use crate::contact::laws::{PointOnSide, PressurePoint};
use crate::overlap::{Pair, Partner, SurfacePoint};

impl<const D: usize> SlipFacets<D> {
    /// Calls `add(facet of the surface, point of the mesh, ∫ N K ∫ p |ds| dA)` for the points from which these facets were made, s being the slip of
    /// the facet since the step began that was not elastic, and K one coefficient for each side.
    pub(crate) fn worn_off(
        &self,
        (pair, sliding): (&Pair<D>, &Sliding<D>),
        points: &[PressurePoint<D>],
        coefficients: [f64; 2],
        mut add: impl FnMut(usize, u32, f64),
    ) {
        // Facets of two bodies share the area of a contact, and each body wears on all of it.
        let sides = if matches!(pair.partners[1], Partner::Body(_)) { 2.0 } else { 1.0 };
        let coefficients = coefficients.map(|coefficient| coefficient * sides);
        let mut pressed = 0.0;
        self.for_each_share(pair, points, |number, share| {
            let point = &points[number];
            let on_side = point.sides[usize::from(share.of_b)];
            let PointOnSide::Surface(SurfacePoint::Facet { facet, weights, .. }) = on_side else { return };
            let force = point.pressure * point.area * share.part;
            pressed += force;
            let volume = coefficients[usize::from(share.of_b)] * force * share.slid_by_pressure;
            if volume > 0.0 {
                for (&vertex, weight) in pair.side(share.of_b).facets[facet as usize].iter().zip(weights) {
                    for (node, part) in pair.surface.nodes_of_vertex(vertex) {
                        add(share.facet, node, volume * weight * part);
                    }
                }
            }
        });
        self.worn_off_before(pair, sliding, pressed, coefficients, add);
    }

    /// The same of facets that bore when the step began and do not now: they slid as the others, while their pressure fell to nothing.
    fn worn_off_before(
        &self,
        pair: &Pair<D>,
        sliding: &Sliding<D>,
        pressed: f64,
        coefficients: [f64; 2],
        mut add: impl FnMut(usize, u32, f64),
    ) {
        let (Stick::Spring(_), Some(bearings), true) = (sliding.stick, sliding.bearings, sliding.is_by_depth) else {
            return;
        };
        let (mut depth, mut area, mut slid) = (0.0, 0.0, 0.0);
        for (facet, _, traction) in self.tractions() {
            depth += facet.bearing.depth * facet.bearing.whole;
            area += facet.area;
            slid += facet.area * (facet.trial - traction.elastic).norm();
        }
        let by_depth = 0.5 * (pressed / depth) * (slid / area);
        if !(by_depth.is_finite() && by_depth > 0.0) {
            return;
        }
        for ((_, of_b, facet), before) in bearings.range((pair.partners, false, 0)..=(pair.partners, true, usize::MAX))
        {
            let is_there = self.facets.binary_search_by_key(&(*of_b, *facet), |one| (one.of_b, one.facet)).is_ok();
            let volume = coefficients[usize::from(*of_b)] * by_depth * before.depth * before.whole;
            if is_there || volume <= 0.0 {
                continue;
            }
            for (node, part) in pair.surface.facets[*facet].iter().flat_map(|&v| pair.surface.nodes_of_vertex(v)) {
                add(*facet, node, volume * part / D as f64);
            }
        }
    }
}
