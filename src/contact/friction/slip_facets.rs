//! The facets of a pair on which friction acts, with their slip.
//!
//! Every facet is one spring with one slider: its slip is the mean of that of its points, and its limit is the sum of
//! theirs. So the elastic slip is one vector for every facet, and nothing is carried from one to another: what does not
//! slide does not creep.

use super::bore::Bore;
use super::carried::Carried;
use super::carriers::{SliderName, in_surface};
use super::direction::PERPENDICULAR;
use super::ellipse::Ellipse;
use super::facet_sums::{Row, Sums, add_point};
use super::return_mapping::Slider;
use super::step::Sliding;
use super::touch::{Bearing, FacetBearings, Touch};
use super::traction::{Stick, Traction};
use crate::Error;
use crate::contact::laws::{Measured, PressurePoint};
use crate::geometry::Vector;
use crate::overlap::{Pair, Partner};
use nalgebra::SMatrix;
use std::collections::BTreeMap;
use std::ops::Range;

/// All facets of a pair.
#[derive(Clone)]
pub(crate) struct SlipFacets<const D: usize> {
    pub(crate) partners: [Partner; 2],
    pub(crate) facets: Vec<SlipFacet<D>>,
    /// What moves the facets against the other side, one after the other.
    pub(crate) rows: Vec<Row<D>>,
    /// Facets that bore when the step began and do not now.
    pub(crate) gone: Vec<Gone>,
}

/// A facet that is not in contact any more.
#[derive(Clone, Copy)]
pub(crate) struct Gone {
    /// Index within the surface.
    pub(crate) facet: usize,
    pub(crate) of_b: bool,
    /// That was stored in it, and that it took as it slid out.
    pub(crate) energy: f64,
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
    pub(crate) slider: Slider<D>,
    /// Whether its friction has a direction that is perpendicular to it.
    pub(crate) is_undirected: bool,
    /// Elastic slip of side 0 against side 1 if nothing slides: what was carried into the step, and the slip of the step
    /// since it bears.
    pub(crate) trial: Vector<D>,
    /// What that changes by with the slip of the step.
    pub(crate) counted: f64,
    /// And with the approach, for which more of the step counts.
    pub(crate) by_approach: Vector<D>,
    /// Whether limits and parts of the step are those of an earlier iteration.
    pub(crate) is_frozen: bool,
    /// Traction that the last step of the iteration asked for, by the limit; zero where there was none.
    pub(crate) dual: Vector<D>,
    /// Slip over which its coefficient falls from that at rest; zero where it does not.
    pub(crate) weakening_slip: f64,
    pub(crate) bearing: Bearing,
    pub(crate) before: Before<D>,
    /// How far it has slipped since the step began, elastic or not, whatever part of that counts.
    pub(super) slip: Vector<D>,
    /// What a law of the host keeps of it at the end of the step.
    pub(super) history: Vec<f64>,
}

/// A facet when the step began, all by the area in contact now.
#[derive(Clone, Copy)]
pub(crate) struct Before<const D: usize> {
    /// Elastic slip that was carried, turned along.
    pub(crate) slip: Vector<D>,
    /// Deformation since then, by which it was turned.
    pub(crate) deformation: SMatrix<f64, D, D>,
    /// Part of it that stays, as a mean over the area in contact now.
    pub(crate) part: f64,
    /// Area in contact.
    pub(crate) area: f64,
    /// Traction at which it slid, where a facet tells it.
    pub(crate) limit: Option<f64>,
    /// How far it had slid since it rested.
    pub(crate) slid: f64,
    /// What the elastic slip pulled with, by what it does with the stiffness of now.
    pub(crate) pulled: f64,
}

impl<const D: usize> SlipFacets<D> {
    /// The facets on which a law presses.
    ///
    /// # Errors
    /// [`Error::FrictionLaw`] of a law of the host.
    pub(crate) fn new(
        measured: &Measured<D>,
        sliding: &Sliding<D>,
        pressed: &[PressurePoint<D>],
    ) -> Result<Self, Error> {
        let (pair, obstacle_node) = (measured.pair, measured.obstacle_node());
        let mut of_facets: BTreeMap<(bool, u32), Sums<D>> = BTreeMap::new();
        let mut last = [None, None];
        for point in pressed {
            add_point(&mut of_facets, pair, sliding, point, obstacle_node, &mut last);
        }
        let facets = Vec::with_capacity(of_facets.len());
        let mut bore: Bore = of_facets.values().map(Sums::bore).sum();
        let mut all = Self { partners: pair.partners, facets, rows: Vec::new(), gone: Vec::new() };
        let mut fields = Vec::new();
        for ((of_b, facet), mut sums) in of_facets {
            let (area, of_facet) = (sums.area, std::mem::take(&mut sums.fields));
            if all.add(pair, sliding, (of_b, facet), sums).is_some() {
                fields.extend(of_facet.into_iter().map(|sum| sum / area));
            }
        }
        if let Some(own) = sliding.own {
            bore = all.take_limits((sliding, own), &fields, bore)?;
        }
        all.gone = all.left(sliding, &bore);
        Ok(all)
    }

    /// Facets that bore when the step began and do not now: they slid as the others, while their limit fell to nothing.
    fn left(&self, sliding: &Sliding<D>, bore: &Bore) -> Vec<Gone> {
        let slides = self.tractions().filter(|(_, _, traction)| traction.slides);
        let slid: f64 =
            slides.map(|(facet, _, t)| facet.area * (facet.trial - t.elastic).norm() * facet.part_of_limit(&t)).sum();
        let is_found =
            |of_b, facet| self.facets.binary_search_by_key(&(of_b, facet), |one| (one.of_b, one.facet)).is_ok();
        let gone = sliding.bore(self.partners).filter(|((_, of_b, facet), ..)| !is_found(*of_b, *facet));
        gone.map(|(&(_, of_b, facet), before, stored)| {
            let is_known = sliding.is_by_depth && slid > 0.0;
            let slid_out = if is_known { 0.5 * bore.limit_before(&before) * (slid / bore.area) } else { 0.0 };
            Gone { facet, of_b, energy: stored + slid_out }
        })
        .collect()
    }

    /// What those took that left.
    pub(crate) fn released(&self) -> f64 {
        self.gone.iter().map(|gone| gone.energy).sum()
    }

    fn add(&mut self, pair: &Pair<D>, sliding: &Sliding<D>, (of_b, facet): (bool, u32), sums: Sums<D>) -> Option<()> {
        let in_surface = in_surface(pair, of_b, facet)?;
        let normal = sums.normal.try_normalize(0.0)?;
        let sign = if of_b { -1.0 } else { 1.0 };
        let position = sums.position / sums.area;
        let bearing = sums.bearing(pair, (of_b, facet));
        let tangential = |x: Vector<D>| x - normal * normal.dot(&x);
        let limit = sums.limit / sums.area;
        let (ellipse, is_undirected) = ellipse_of(sliding, &normal, &(sums.direction / sums.area));
        let deformation = sums.deformation;
        let (touch, before) = match sliding.stick {
            Stick::Spring(_) => {
                let name = (pair.partners, of_b, in_surface);
                let bore = sliding.bearing(&name);
                let approach = sums.approach / sums.area;
                let touch = bore.map_or(Touch::WHOLE, |(bore, less)| Touch::new(bore, bearing, approach + less));
                let carried = sliding.step.slip.get(&name);
                let (slip, slid) = carried.map_or((Vector::zeros(), 0.0), |carried| (carried.slip, carried.slid));
                let slip = tangential(deformation * slip) * sign;
                let area = bore.map_or(1.0, |(bore, _)| bore.area / bearing.area);
                // Of a pressure that is one for a whole pair no facet tells what it was.
                let known = bore.filter(|_| sliding.is_by_depth);
                let limit = known.map(|(bore, _)| sums.bore().limit_before(&bore) / sums.area);
                let pulled = sliding.pulled;
                (touch, Before { slip, deformation, part: touch.carried, area, limit, slid, pulled })
            }
            // Of which only the slip of the step counts, as a speed.
            Stick::Memoryless(_) => {
                let slip = Vector::zeros();
                (Touch::WHOLE, Before { slip, deformation, part: 1.0, area: 1.0, limit: None, slid: 0.0, pulled: 1.0 })
            }
        };
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
            slider: Slider { stick: sliding.stick, limit, ellipse },
            is_undirected,
            trial: before.slip * (before.part * sliding.stretched()) + tangential(slip * touch.counted),
            counted: touch.counted,
            by_approach: tangential(slip * touch.by_approach),
            is_frozen: false,
            dual: Vector::zeros(),
            weakening_slip: sliding.friction.at_rest.map_or(0.0, |at_rest| at_rest.weakening_slip),
            bearing,
            before,
            slip: tangential(slip),
            history: Vec::new(),
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

    /// What every facet carries into the next step, where there is anything.
    pub(crate) fn carried(&self) -> impl Iterator<Item = (SliderName, Carried<D>)> {
        let all = self.tractions().map(|(facet, _, traction)| {
            let name = (self.partners, facet.of_b, facet.facet);
            let slip = if facet.of_b { -traction.elastic } else { traction.elastic };
            (name, Carried { slip, slid: facet.slid(&traction), history: facet.history.clone() })
        });
        all.filter(|(_, carried)| !carried.is_nothing())
    }
}

/// Limits by direction on a facet with this normal, and whether its friction has a direction that is perpendicular to it: all is across it
/// then. `direction` is the mean of unit vectors at its points.
fn ellipse_of<const D: usize>(
    sliding: &Sliding<D>,
    normal: &Vector<D>,
    direction: &Vector<D>,
) -> (Option<Ellipse<D>>, bool) {
    // It is refused in 2D, where there is one direction only.
    let Some(orthotropy) = sliding.orthotropy.as_ref().filter(|_| D == 3) else { return (None, false) };
    let within = direction - normal * normal.dot(direction);
    if let Some(along) = within.try_normalize(PERPENDICULAR) {
        return (Some(Ellipse::new(along, normal, orthotropy.factors)), false);
    }
    let [_, across] = orthotropy.factors;
    let axis = (0..D).min_by(|&i, &j| normal[i].abs().total_cmp(&normal[j].abs())).unwrap_or(0);
    let axis = Vector::from_fn(|i, _| f64::from(u8::from(i == axis)));
    let any = (axis - normal * normal.dot(&axis)).normalize();
    (Some(Ellipse::new(any, normal, [across; 2])), true)
}

impl<const D: usize> SlipFacet<D> {
    /// The derivative by the elastic slip that was carried into the step of what has this one by the trial slip.
    pub(crate) fn by_carried(&self, by_trial: &Vector<D>) -> Vector<D> {
        if let Stick::Memoryless(_) = self.slider.stick {
            return Vector::zeros();
        }
        let sign = if self.of_b { -1.0 } else { 1.0 };
        let within = by_trial - self.normal * self.normal.dot(by_trial);
        self.before.deformation.transpose() * within * (sign * self.before.part)
    }

    /// What the trial slip has of the elastic slip carried into the step.
    pub(crate) fn of_carried(&self, slip: &Vector<D>) -> Vector<D> {
        if let Stick::Memoryless(_) = self.slider.stick {
            return Vector::zeros();
        }
        let sign = if self.of_b { -1.0 } else { 1.0 };
        let turned = self.before.deformation * slip;
        (turned - self.normal * self.normal.dot(&turned)) * (sign * self.before.part)
    }

    /// Traction against the slip of what slides, by the largest limit there is in any direction.
    pub(super) fn part_of_limit(&self, traction: &Traction<D>) -> f64 {
        if self.slider.ellipse.is_none() {
            return 1.0;
        }
        let along = self.trial - traction.elastic;
        let work = self.slider.limit * along.norm();
        if work > 0.0 { (traction.value.dot(&along) / work).max(0.0) } else { 0.0 }
    }

    /// How far it has slid at the end of the step since it rested, as far as that matters.
    fn slid(&self, traction: &Traction<D>) -> f64 {
        if traction.slides && self.weakening_slip > 0.0 {
            (self.before.slid + (self.trial - traction.elastic).norm()).min(self.weakening_slip)
        } else {
            0.0
        }
    }
}
