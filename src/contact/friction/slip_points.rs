//! The points of a pair at which friction acts, with their slip.

use super::options::Friction;
use super::return_mapping::{Slider, Traction};
use super::side_motion::SideMotion;
use super::step::Step;
use crate::contact::laws::{PointOnSide, PressurePoint};
use crate::geometry::Vector;
use crate::overlap::{Pair, Partner, SurfacePoint};
use nalgebra::SMatrix;
use std::ops::Range;

/// All points of a pair.
#[derive(Clone)]
pub(crate) struct SlipPoints<const D: usize> {
    pub(crate) partners: [Partner; 2],
    pub(crate) points: Vec<SlipPoint<D>>,
    /// What moves the points, one after the other.
    pub(crate) rows: Vec<Row<D>>,
}

/// A point at which friction acts.
#[derive(Clone)]
pub(crate) struct SlipPoint<const D: usize> {
    /// Its part of `rows`.
    pub(crate) rows: Range<usize>,
    /// Middle of the two material points, where the traction acts.
    pub(crate) position: Vector<D>,
    /// Unit normal of the tangent plane.
    pub(crate) normal: Vector<D>,
    /// Area for which it stands.
    pub(crate) area: f64,
    pub(crate) slider: Slider,
    /// Elastic slip that was carried into the step, and that with the slip of the step.
    pub(crate) carried: Vector<D>,
    pub(crate) trial: Vector<D>,
    /// Which sides carry elastic slip.
    pub(crate) carries: [bool; 2],
}

/// A node that moves a point on one side.
#[derive(Clone, Copy)]
pub(crate) struct Row<const D: usize> {
    /// From the number of nodes on: an obstacle.
    pub(crate) node: u32,
    pub(crate) of_b: bool,
    /// Shape function of the node at the point.
    pub(crate) shape: f64,
    /// What the slip changes by as the node moves: that of side 0 against side 1.
    pub(crate) slip: SMatrix<f64, D, D>,
    /// What the limit, times the area, changes by as the node moves.
    pub(crate) limit: Vector<D>,
}

impl<const D: usize> SlipPoints<D> {
    /// The points at which a law presses. `stiffness` is k_T; the translation of the pair's obstacle has the number
    /// `obstacle_node`.
    pub(crate) fn new(
        pair: &Pair<D>,
        step: &Step<D>,
        pressed: &[PressurePoint<D>],
        (friction, stiffness): (&Friction, f64),
        obstacle_node: u32,
    ) -> Self {
        let mut all = Self { partners: pair.partners, points: Vec::with_capacity(pressed.len()), rows: Vec::new() };
        for point in pressed.iter().filter(|point| !is_swallowed(pair, point)) {
            let slider = Slider::new(friction, stiffness, point.pressure);
            if slider.limit > 0.0 {
                all.add(pair, step, point, slider, obstacle_node);
            }
        }
        all
    }

    fn add(
        &mut self,
        pair: &Pair<D>,
        step: &Step<D>,
        point: &PressurePoint<D>,
        slider: Slider,
        obstacle_node: u32,
    ) -> Option<()> {
        let first = SideMotion::new(pair, step, &point.sides[0])?;
        let second = SideMotion::new(pair, step, &point.sides[1])?;
        // The tangent plane is that of the surfaces, not that across the line on which the penetration is measured.
        let normal = match (first.normal, second.normal) {
            (Some(n), Some(m)) => (n - m).try_normalize(0.0)?,
            (Some(n), None) => n,
            (None, Some(m)) => -m,
            (None, None) => return None,
        };
        let along = point.normal.dot(&normal);
        if along <= 0.0 {
            return None;
        }
        let tangential = |v: Vector<D>| v - normal * normal.dot(&v);
        let turned = (first.deformation + second.deformation) * 0.5;
        let slip = tangential((first.now - second.now) - turned * (first.start - second.start));
        let of_sides = [first.carried(&step.carried), second.carried(&step.carried)];
        let carried = match of_sides {
            [Some(e), Some(f)] => (first.deformation * e - second.deformation * f) * 0.5,
            [Some(e), None] => first.deformation * e,
            [None, Some(f)] => -(second.deformation * f),
            [None, None] => Vector::zeros(),
        };
        let carried = tangential(carried);
        let position = (first.now + second.now) * 0.5;
        let begin = self.rows.len();
        for (of_b, side) in [(false, &first), (true, &second)] {
            let sign = if of_b { -1.0 } else { 1.0 };
            let slope = point.slopes[usize::from(of_b)] * (slider.limit_slope / along);
            side.for_each_node(pair, &(position - side.now), obstacle_node, |node, shape, moved| {
                self.rows.push(Row { node, of_b, shape, slip: moved * sign, limit: slope * shape });
            });
        }
        self.points.push(SlipPoint {
            rows: begin..self.rows.len(),
            position,
            normal,
            area: point.area / along,
            slider,
            carried,
            trial: carried + slip,
            carries: of_sides.map(|carried| carried.is_some()),
        });
        Some(())
    }

    /// Every point with its rows and its traction.
    pub(crate) fn tractions(&self) -> impl Iterator<Item = (&SlipPoint<D>, &[Row<D>], Traction<D>)> {
        self.points.iter().map(|point| (point, &self.rows[point.rows.clone()], point.slider.traction(&point.trial)))
    }
}

/// Whether a line has both its ends on one side: that lies within the other, and its surfaces do not face.
fn is_swallowed<const D: usize>(pair: &Pair<D>, point: &PressurePoint<D>) -> bool {
    let side = |point: &PointOnSide<D>| match point {
        PointOnSide::Surface(SurfacePoint::Facet { of_b, .. }) => Some(*of_b),
        PointOnSide::Surface(SurfacePoint::Point { .. }) => Some(true),
        _ => None,
    };
    let sides = point.sides.each_ref().map(side);
    !pair.is_own() && sides[0].is_some() && sides[0] == sides[1]
}
