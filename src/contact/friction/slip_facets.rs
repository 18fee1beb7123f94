//! The facets of a pair on which friction acts, with their slip.
//!
//! Every facet is one spring with one slider: its slip is the mean of that of its points, and its limit is the sum of
//! theirs. So the elastic slip is one vector for every facet, and nothing is carried from one to another: what does not
//! slide does not creep.

use super::carriers::in_surface;
use super::facet_sums::{Row, Sums, add_point};
use super::return_mapping::{Slider, Stick, Traction};
use super::step::Sliding;
use super::touch::{Bearing, FacetBearings, Touch};
use crate::contact::laws::{Measured, PressurePoint};
use crate::geometry::Vector;
use crate::overlap::{Pair, Partner};
use std::collections::BTreeMap;
use std::ops::Range;

/// All facets of a pair.
#[derive(Clone)]
pub(crate) struct SlipFacets<const D: usize> {
    pub(crate) partners: [Partner; 2],
    pub(crate) facets: Vec<SlipFacet<D>>,
    /// What moves the facets against the other side, one after the other.
    pub(crate) rows: Vec<Row<D>>,
}

/// A facet on which friction acts.
#[derive(Clone)]
pub(crate) struct SlipFacet<const D: usize> {
    /// Index within the surface.
    pub(crate) facet: usize,
    pub(crate) of_b: bool,
    /// Its part of `rows`.
    pub(crate) rows: Range<usize>,
    /// Where the traction acts.
    pub(crate) position: Vector<D>,
    /// Unit normal of the tangent plane.
    pub(crate) normal: Vector<D>,
    /// Area for which it stands.
    pub(crate) area: f64,
    pub(crate) slider: Slider,
    /// Elastic slip of side 0 against side 1 if nothing slides: what was carried into the step, and the slip of the step
    /// since it bears.
    pub(crate) trial: Vector<D>,
    /// What that changes by with the slip of the step.
    pub(crate) counted: f64,
    /// And with the approach, for which more of the step counts.
    pub(crate) by_approach: Vector<D>,
    /// Whether limits and parts of the step are those of an earlier iteration.
    pub(crate) is_frozen: bool,
    pub(crate) bearing: Bearing,
}

impl<const D: usize> SlipFacets<D> {
    /// The facets on which a law presses.
    pub(crate) fn new(measured: &Measured<D>, sliding: &Sliding<D>, pressed: &[PressurePoint<D>]) -> Self {
        let (pair, obstacle_node) = (measured.pair, measured.obstacle_node());
        let mut of_facets: BTreeMap<(bool, u32), Sums<D>> = BTreeMap::new();
        let mut last = [None, None];
        for point in pressed {
            add_point(&mut of_facets, pair, sliding, point, obstacle_node, &mut last);
        }
        let mut all = Self { partners: pair.partners, facets: Vec::with_capacity(of_facets.len()), rows: Vec::new() };
        for ((of_b, facet), sums) in of_facets {
            all.add(pair, sliding, (of_b, facet), sums);
        }
        all
    }

    fn add(&mut self, pair: &Pair<D>, sliding: &Sliding<D>, (of_b, facet): (bool, u32), sums: Sums<D>) -> Option<()> {
        let in_surface = in_surface(pair, of_b, facet)?;
        let normal = sums.normal.try_normalize(0.0)?;
        let sign = if of_b { -1.0 } else { 1.0 };
        let position = sums.position / sums.area;
        let bearing = sums.bearing(pair, (of_b, facet));
        let (carried, touch) = match sliding.stick {
            Stick::Spring(_) => {
                let before = sliding.bearing(&(pair.partners, of_b, in_surface));
                let touch =
                    before.map_or(Touch::WHOLE, |before| Touch::new(before, bearing, sums.approach / sums.area));
                (sums.deformation * Vector::from(sliding.step.slip[in_surface]) * (sign * touch.carried), touch)
            }
            // Of which only the slip of the step counts, as a speed.
            Stick::Memoryless(_) => (Vector::zeros(), Touch::WHOLE),
        };
        let tangential = |x: Vector<D>| x - normal * normal.dot(&x);
        let slip = sums.slip / sums.area;
        let begin = self.rows.len();
        self.rows.extend(sums.rows.iter().map(|row| Row { slip: row.slip / sums.area, ..*row }));
        self.facets.push(SlipFacet {
            facet: in_surface,
            of_b,
            rows: begin..self.rows.len(),
            position,
            normal,
            area: sums.area,
            slider: Slider { stick: sliding.stick, limit: sums.limit / sums.area },
            trial: tangential(carried + slip * touch.counted),
            counted: touch.counted,
            by_approach: tangential(slip * touch.by_approach),
            is_frozen: false,
            bearing,
        });
        Some(())
    }

    /// Every facet with its rows and its traction.
    pub(crate) fn tractions(&self) -> impl Iterator<Item = (&SlipFacet<D>, &[Row<D>], Traction<D>)> {
        self.facets.iter().map(|facet| (facet, &self.rows[facet.rows.clone()], facet.slider.traction(&facet.trial)))
    }

    /// Adds how the facets bear.
    pub(crate) fn add_bearings(&self, bearings: &mut FacetBearings) {
        bearings.extend(self.facets.iter().map(|facet| ((self.partners, facet.of_b, facet.facet), facet.bearing)));
    }

    /// Calls `visit(facet of the surface, area, elastic slip of that facet against what it faces)`.
    pub(crate) fn for_each_elastic_slip(&self, mut visit: impl FnMut(usize, f64, Vector<D>)) {
        for (facet, _, traction) in self.tractions() {
            visit(facet.facet, facet.area, traction.elastic * if facet.of_b { -1.0 } else { 1.0 });
        }
    }
}

impl<const D: usize> SlipFacet<D> {
    /// Energy taken out, by area. The traction acts for the whole step, though of it only the part φ counts: what slides does
    /// so at the limit for all of it. As areas shrink no less than they grow, that is the loss of the mean area.
    ///
    /// Frozen, the traction is the gradient of a potential, (stored + dissipated)/φ; what of it is not stored.
    pub(crate) fn dissipated(&self, traction: &Traction<D>) -> f64 {
        let Traction { stored, dissipated, .. } = *traction;
        match self.counted {
            0.0 => dissipated,
            part if self.is_frozen => (stored + dissipated) / part - stored,
            part => dissipated / part,
        }
    }
}
