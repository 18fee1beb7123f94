//! What sliding wears off, at the points of the facets.
//!
//! By the account of the work of friction, as it is when facets come into contact and leave it within a step: what a facet takes out of the
//! energy, divided by its limit now and times its pressure now. Of Coulomb friction that is the work divided by μ.

use super::slip_facets::SlipFacets;
use super::step::Sliding;
use crate::contact::laws::{PointOnSide, PressurePoint};
use crate::geometry::Surface;
use crate::overlap::{Pair, Partner, SurfacePoint};

/// What the sides of a pair lose by each volume of ∫ p |ds| dA on a facet, of one coefficient for each side: facets of two bodies share the
/// area of a contact, and each body wears on all of it.
fn by_facets(pair: &[Partner; 2], coefficients: [f64; 2]) -> [f64; 2] {
    let sides = if matches!(pair[1], Partner::Body(_)) { 2.0 } else { 1.0 };
    coefficients.map(|coefficient| coefficient * sides)
}

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
        let coefficients = by_facets(&pair.partners, coefficients);
        let mut pressed = 0.0;
        self.for_each_share(pair, points, |number, share| {
            let point = &points[number];
            let on_side = point.sides[usize::from(share.of_b)];
            let PointOnSide::Surface(SurfacePoint::Facet { facet, weights, .. }) = on_side else { return };
            let force = point.pressure * point.area * share.part;
            pressed += force;
            let volume = coefficients[usize::from(share.of_b)] * force * share.way;
            if volume > 0.0 {
                for (&vertex, weight) in pair.side(share.of_b).facets[facet as usize].iter().zip(weights) {
                    for (node, part) in pair.surface.nodes_of_vertex(vertex) {
                        add(share.facet, node, volume * weight * part);
                    }
                }
            }
        });
        let by_work = if self.facets.is_empty() { sliding.pressure_by_limit() } else { pressed / self.limit_of_slip() };
        for gone in self.gone.iter().filter(|_| by_work.is_finite()) {
            let volume = coefficients[usize::from(gone.of_b)] * by_work * gone.energy;
            spread(pair.surface, gone.facet, volume, &mut add);
        }
    }

    /// Force at which the facets slide, as a mean by how far they slid in all directions.
    fn limit_of_slip(&self) -> f64 {
        let (mut limit, mut slid, mut along) = (0.0, 0.0, 0.0);
        for (facet, _, traction) in self.tractions() {
            limit += facet.area * facet.slider.limit;
            let way = facet.area * (facet.trial - traction.elastic).norm();
            (slid, along) = (slid + way, along + way * facet.part_of_limit(&traction));
        }
        if slid > 0.0 { limit * (along / slid) } else { limit }
    }
}

impl<const D: usize> Sliding<'_, D> {
    /// The same of a pair that is not in contact any more.
    pub(crate) fn worn_off_before(
        &self,
        (pair, surface): ([Partner; 2], &Surface<D>),
        coefficients: [f64; 2],
        mut add: impl FnMut(usize, u32, f64),
    ) {
        let (coefficients, by_work) = (by_facets(&pair, coefficients), self.pressure_by_limit());
        for (&(_, of_b, facet), _, energy) in self.bore(pair) {
            spread(surface, facet, coefficients[usize::from(of_b)] * by_work * energy, &mut add);
        }
    }

    /// Pressure by the limit where nothing presses any more: by the coefficient alone.
    fn pressure_by_limit(&self) -> f64 {
        let coefficient = self.friction.coefficient;
        if coefficient > 0.0 { 1.0 / coefficient } else { 0.0 }
    }
}

/// A volume, evenly on a facet.
fn spread<const D: usize>(surface: &Surface<D>, facet: usize, volume: f64, add: &mut impl FnMut(usize, u32, f64)) {
    if volume > 0.0 {
        for (node, part) in surface.facets[facet].iter().flat_map(|&vertex| surface.nodes_of_vertex(vertex)) {
            add(facet, node, volume * part / D as f64);
        }
    }
}
