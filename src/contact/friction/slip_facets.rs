//! The facets of a pair on which friction acts, with their slip.
//!
//! Every facet is one spring with one slider: its slip is the mean of that of its points, and its limit is the sum of
//! theirs. So the elastic slip is one vector for every facet, and nothing is carried from one to another: what does not
//! slide does not creep.

use super::carriers::{Carriers, in_surface};
use super::options::Friction;
use super::return_mapping::{Slider, Stick, Traction};
use super::side_motion::SideMotion;
use super::step::Step;
use super::touch::{Bearing, Bearings, Touch};
use crate::contact::laws::{Measured, PressurePoint};
use crate::geometry::Vector;
use crate::geometry::facet::area_vector;
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
    pub(crate) bearing: Bearing,
}

/// A node that moves a facet, or what it faces.
#[derive(Clone, Copy)]
pub(crate) struct Row<const D: usize> {
    /// From the number of nodes on: an obstacle.
    pub(crate) node: u32,
    pub(crate) of_b: bool,
    /// What the slip changes by as the node moves: that of side 0 against side 1.
    pub(crate) slip: SMatrix<f64, D, D>,
    /// What the limit, times the area, changes by as the node moves.
    pub(crate) limit: Vector<D>,
}

/// Sums over the points of a facet.
struct Sums<const D: usize> {
    /// The weight of all means.
    area: f64,
    /// Traction at which the facet slides, times the area.
    limit: f64,
    slip: Vector<D>,
    /// By which the sides came nearer in the step.
    approach: f64,
    depth: f64,
    position: Vector<D>,
    normal: Vector<D>,
    /// Of the facet, since the step began.
    deformation: SMatrix<f64, D, D>,
    rows: Vec<Row<D>>,
}

/// How a pair slides.
pub(crate) struct Sliding<'a, const D: usize> {
    pub(crate) friction: Friction,
    pub(crate) stick: Stick,
    pub(crate) step: &'a Step<D>,
}

impl<const D: usize> SlipFacets<D> {
    /// The facets on which a law presses.
    pub(crate) fn new(measured: &Measured<D>, sliding: &Sliding<D>, pressed: &[PressurePoint<D>]) -> Self {
        let (pair, obstacle_node) = (measured.pair, measured.obstacle_node());
        let mut of_facets: BTreeMap<(bool, u32), Sums<D>> = BTreeMap::new();
        for point in pressed {
            add_point(&mut of_facets, pair, sliding, point, obstacle_node);
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
                let before = sliding.step.bearing(&(pair.partners, of_b, in_surface));
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
            bearing,
        });
        Some(())
    }

    /// Every facet with its rows and its traction.
    pub(crate) fn tractions(&self) -> impl Iterator<Item = (&SlipFacet<D>, &[Row<D>], Traction<D>)> {
        self.facets.iter().map(|facet| (facet, &self.rows[facet.rows.clone()], facet.slider.traction(&facet.trial)))
    }

    /// Adds how the facets bear.
    pub(crate) fn add_bearings(&self, bearings: &mut Bearings) {
        bearings.extend(self.facets.iter().map(|facet| ((self.partners, facet.of_b, facet.facet), facet.bearing)));
    }

    /// Calls `visit(facet of the surface, area, elastic slip of that facet against what it faces)`.
    pub(crate) fn for_each_elastic_slip(&self, mut visit: impl FnMut(usize, f64, Vector<D>)) {
        for (facet, _, traction) in self.tractions() {
            visit(facet.facet, facet.area, traction.elastic * if facet.of_b { -1.0 } else { 1.0 });
        }
    }
}

/// Adds a point to the facets on which it lies: to both by halves where both sides are facets of bodies.
fn add_point<const D: usize>(
    of_facets: &mut BTreeMap<(bool, u32), Sums<D>>,
    pair: &Pair<D>,
    sliding: &Sliding<D>,
    point: &PressurePoint<D>,
    obstacle_node: u32,
) -> Option<()> {
    let (traction, slope) = sliding.friction.limit(point.pressure);
    if traction <= 0.0 {
        return None;
    }
    let carriers = Carriers::of(pair, point)?;
    let (normal, part) = (carriers.normal, carriers.part);
    let sides = [
        SideMotion::new(pair, sliding.step, &point.middles[0])?,
        SideMotion::new(pair, sliding.step, &point.middles[1])?,
    ];
    let turned = (sides[0].deformation + sides[1].deformation) * 0.5;
    let slip = (sides[0].now - sides[1].now) - turned * (sides[0].start - sides[1].start);
    let approach = normal.dot(&slip);
    let slip = slip - normal * approach;
    let position = (sides[0].now + sides[1].now) * 0.5;
    for (of_b, facet) in carriers.facets() {
        let new = || Sums::new(sides[usize::from(of_b)].deformation);
        let sums = of_facets.entry((of_b, facet)).or_insert_with(new);
        let area = part * point.area;
        sums.area += area;
        sums.limit += area * traction;
        sums.slip += slip * area;
        sums.approach += approach * area;
        sums.depth += area * point.penetration * point.normal.dot(&normal);
        sums.position += position * area;
        sums.normal += normal * area;
        for (of_b, side) in [(false, &sides[0]), (true, &sides[1])] {
            let signed = if of_b { -area } else { area };
            let slope = point.slopes[usize::from(of_b)] * (slope * part);
            side.for_each_node(pair, &(position - side.now), obstacle_node, |node, shape, moved| {
                sums.add_row(Row { node, of_b, slip: moved * signed, limit: slope * shape });
            });
        }
    }
    Some(())
}

impl<const D: usize> Sums<D> {
    fn new(deformation: SMatrix<f64, D, D>) -> Self {
        let zero = Vector::zeros();
        let (area, limit, approach, depth) = (0.0, 0.0, 0.0, 0.0);
        Self { area, limit, slip: zero, approach, depth, position: zero, normal: zero, deformation, rows: Vec::new() }
    }

    /// How the facet bears.
    fn bearing(&self, pair: &Pair<D>, (of_b, facet): (bool, u32)) -> Bearing {
        let corners = pair.side(of_b).corners(facet as usize);
        let centre = corners.iter().fold(Vector::zeros(), |sum, x| sum + x / D as f64);
        let whole = area_vector(&corners).norm() * pair.weighting.at(&centre);
        Bearing { area: self.area / whole, depth: self.depth / whole }
    }

    fn add_row(&mut self, row: Row<D>) {
        match self.rows.iter_mut().find(|known| (known.node, known.of_b) == (row.node, row.of_b)) {
            Some(known) => {
                known.slip += row.slip;
                known.limit += row.limit;
            }
            None => self.rows.push(row),
        }
    }
}
