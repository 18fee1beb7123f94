//! Sums over the points of a facet on which friction acts.

use super::bore::Bore;
use super::carriers::{Carriers, in_surface};
use super::direction::direction_at;
use super::side_motion::{LastFacet, Mover, SideMotion};
use super::step::Sliding;
use super::touch::Bearing;
use super::turn::turned;
use crate::contact::laws::PressurePoint;
use crate::geometry::Vector;
use crate::geometry::primitives::facet::area_vector;
use crate::overlap::Pair;
use nalgebra::SMatrix;
use std::collections::BTreeMap;

/// What moves a facet, or what it faces.
#[derive(Clone, Copy)]
pub(crate) struct Row<const D: usize> {
    pub(crate) mover: Mover,
    pub(crate) of_b: bool,
    /// What the slip changes by as the node moves: that of side 0 against side 1.
    pub(crate) slip: SMatrix<f64, D, D>,
    /// What the limit, times the area, changes by as the node moves.
    pub(crate) limit: Vector<D>,
}

/// Sums over the points of a facet.
pub(super) struct Sums<const D: usize> {
    /// The weight of all means.
    pub(super) area: f64,
    /// Traction at which the facet slides, times the area.
    pub(super) limit: f64,
    /// The part of it that is pressure.
    pub(super) pressed: f64,
    pub(super) slip: Vector<D>,
    /// By which the sides came nearer in the step.
    pub(super) approach: f64,
    pub(super) depth: f64,
    pub(super) position: Vector<D>,
    pub(super) normal: Vector<D>,
    /// Unit vectors along which friction is another, times the area; zero without such a direction.
    pub(super) direction: Vector<D>,
    /// Of friction, as far as it has fallen.
    coefficient: f64,
    /// Of the facet, since the step began.
    pub(super) deformation: SMatrix<f64, D, D>,
    pub(super) rows: Vec<Row<D>>,
    /// Fields on both sides for a law of the host, times the area.
    pub(super) fields: Vec<f64>,
}

/// Adds a point to the facets on which it lies: to both by halves where both sides are facets of bodies.
pub(super) fn add_point<const D: usize>(
    of_facets: &mut BTreeMap<(bool, u32), Sums<D>>,
    pair: &Pair<D>,
    sliding: &Sliding<D>,
    point: &PressurePoint<D>,
    obstacle_node: u32,
    last: &mut [LastFacet<D>; 2],
) -> Option<()> {
    let friction = &sliding.friction;
    if friction.limit(point.pressure, friction.largest_coefficient()).0 <= 0.0 {
        return None;
    }
    let carriers = Carriers::of(pair, point)?;
    let (normal, part) = (carriers.normal, carriers.part);
    let [last_of_a, last_of_b] = last;
    let sides = [
        SideMotion::new(pair, sliding, (point, 0), last_of_a)?,
        SideMotion::new(pair, sliding, (point, 1), last_of_b)?,
    ];
    let turned = turned(&sides[0].deformation, &sides[1].deformation);
    let slip = (sides[0].now - sides[1].now) - turned * (sides[0].start - sides[1].start);
    // Surfaces come nearer also as they are moved out; the material does not slip by that.
    let out = (sides[0].out - sides[1].out) - turned * (sides[0].was_out - sides[1].was_out);
    let approach = normal.dot(&(slip + out));
    let slip = slip - normal * normal.dot(&slip);
    // Cells bear where their material is.
    let inside = sides.iter().find(|side| sliding.material.is_some() && side.is_inside());
    let position = inside.map_or((sides[0].now + sides[1].now) * 0.5, |side| side.now);
    let direction = sliding.orthotropy.as_ref().and_then(|one| direction_at(pair, one, point, &normal));
    for (of_b, facet) in carriers.facets() {
        let name = (pair.partners, of_b, in_surface(pair, of_b, facet)?);
        let new = || Sums::new(sides[usize::from(of_b)].deformation, sliding.coefficient(&name));
        let sums = of_facets.entry((of_b, facet)).or_insert_with(new);
        let (traction, slope) = friction.limit(point.pressure, sums.coefficient);
        let area = part * point.area;
        sums.area += area;
        sums.limit += area * traction;
        sums.pressed += area * slope * point.pressure;
        sums.slip += slip * area;
        sums.approach += approach * area;
        sums.depth += area * point.penetration * point.normal.dot(&normal);
        sums.position += position * area;
        sums.normal += normal * area;
        if let Some(asked) = sliding.own.filter(|asked| asked.fields.count > 0) {
            let of_sides = sides.iter().flat_map(|side| side.fields(pair, asked.fields));
            sums.fields.resize(2 * asked.fields.count, 0.0);
            sums.fields.iter_mut().zip(of_sides).for_each(|(sum, value)| *sum += value * area);
        }
        if let Some(direction) = direction {
            sums.direction += direction * area;
        }
        for (of_b, side) in [(false, &sides[0]), (true, &sides[1])] {
            let signed = if of_b { -area } else { area };
            let slope = point.slopes[usize::from(of_b)] * (slope * part);
            side.for_each_node(pair, &(position - side.now), obstacle_node, |mover, point, middle| {
                let limit = point.transpose() * slope;
                sums.add_row(Row { mover, of_b, slip: middle * signed, limit });
            });
        }
    }
    Some(())
}

impl<const D: usize> Sums<D> {
    fn new(deformation: SMatrix<f64, D, D>, coefficient: f64) -> Self {
        let zero = Vector::zeros();
        let (area, limit, pressed, approach, depth) = (0.0, 0.0, 0.0, 0.0, 0.0);
        Self {
            area,
            limit,
            pressed,
            slip: zero,
            approach,
            depth,
            position: zero,
            normal: zero,
            direction: zero,
            coefficient,
            deformation,
            rows: Vec::new(),
            fields: Vec::new(),
        }
    }

    /// How the facet bears.
    pub(super) fn bearing(&self, pair: &Pair<D>, (of_b, facet): (bool, u32)) -> Bearing {
        let corners = pair.side(of_b).corners(facet as usize);
        let centre = corners.iter().fold(Vector::zeros(), |sum, x| sum + x / D as f64);
        let whole = area_vector(&corners).norm() * pair.weighting.at(&centre);
        Bearing { area: self.area / whole, depth: self.depth / whole, whole }
    }

    /// How it bears, and the force at which it slides: of pressure, and of what does not grow with it.
    pub(super) fn bore(&self) -> Bore {
        Bore { area: self.area, depth: self.depth, pressed: self.pressed, cohesion: self.limit - self.pressed }
    }

    fn add_row(&mut self, row: Row<D>) {
        match self.rows.iter_mut().find(|known| (known.mover, known.of_b) == (row.mover, row.of_b)) {
            Some(known) => {
                known.slip += row.slip;
                known.limit += row.limit;
            }
            None => self.rows.push(row),
        }
    }
}
