//! The state at the start of a step.

use super::carried::CarriedSlip;
use super::carriers::SliderName;
use super::law::OwnLimit;
use super::moved_out::{Material, MovedOut};
use super::options::Friction;
use super::orthotropic::Orthotropy;
use super::past_points::PastPoints;
use super::touch::{Bearing, FacetBearings};
use super::traction::Stick;
use crate::geometry::{Pose, Surface, Vector};
use crate::overlap::Partner;
use std::borrow::Cow;

/// Where all stood when the step began, and the elastic slip that was carried into it.
#[derive(Clone)]
pub(crate) struct Step<const D: usize> {
    /// Points of the mesh.
    pub(crate) coords: PastPoints<D>,
    /// Places of the surface's vertices.
    pub(crate) points: Vec<Vector<D>>,
    /// How far surfaces were moved out, where any was.
    pub(crate) moved_out: Option<MovedOut<D>>,
    /// Which coordinates these are, of a mesh that is given in parts.
    pub(crate) epoch: u64,
    /// Poses of the obstacles; `None` for one that was removed.
    pub(crate) poses: Vec<Option<Pose<D>>>,
    /// Elastic slip of every facet against each of those that it faces.
    pub(crate) slip: CarriedSlip<D>,
}

impl<const D: usize> Step<D> {
    pub(crate) fn new(
        surface: &Surface<D>,
        coords: PastPoints<D>,
        poses: Vec<Option<Pose<D>>>,
        slip: CarriedSlip<D>,
        epoch: u64,
    ) -> Self {
        Self { points: surface.points(coords.placed()), moved_out: None, coords, epoch, poses, slip }
    }

    /// The same step, which began with surfaces that were moved out.
    pub(crate) fn with_moved_out(self, moved_out: Option<MovedOut<D>>) -> Self {
        Self { moved_out, ..self }
    }

    /// Has the surface have lain elsewhere when it began.
    pub(crate) fn place(&mut self, surface: &Surface<D>, place: impl FnOnce(&[[f64; D]]) -> Cow<'_, [[f64; D]]>) {
        self.coords.place(place);
        self.points = surface.points(self.coords.placed());
    }

    /// The same step of other cells of the mesh, whose points were here when it began; `facet` is the new number of a facet, if it is
    /// still there.
    pub(crate) fn of_cells(
        self,
        surface: &Surface<D>,
        points: &[[f64; D]],
        facet: impl Fn(usize) -> Option<usize>,
    ) -> Self {
        let of = |((partners, of_b, old), slip)| facet(old).map(|new| ((partners, of_b, new), slip));
        let slip = self.slip.into_iter().filter_map(of).collect();
        let coords = PastPoints::new(points, points.into(), |points| points.into());
        Self::new(surface, coords, self.poses, slip, self.epoch)
    }

    /// Where an obstacle stood; one that came later has not moved.
    pub(crate) fn pose<'a>(&'a self, obstacle: usize, now: &'a Pose<D>) -> &'a Pose<D> {
        self.poses.get(obstacle).and_then(Option::as_ref).unwrap_or(now)
    }
}

/// How a pair slides.
pub(crate) struct Sliding<'a, const D: usize> {
    pub(crate) friction: Friction,
    /// Where that is not the same in all directions; `friction` is then the largest.
    pub(crate) orthotropy: Option<Orthotropy>,
    pub(crate) stick: Stick,
    pub(crate) step: &'a Step<D>,
    /// Where the material lies now; `None` where the surfaces of the pair do.
    pub(crate) material: Option<Material<'a, D>>,
    /// How facets bore when it began; `None` where that is not known of the pair.
    pub(crate) bearings: Option<&'a FacetBearings>,
    /// Whether the pressure grows with the depth.
    pub(crate) is_by_depth: bool,
    /// How many times as stiff the pair is as then.
    pub(crate) stiffer: f64,
    /// What elastic slip that is carried pulled with then, by what it does with the stiffness of now.
    pub(crate) pulled: f64,
    /// Part of its stiffness with which it sticks.
    pub(crate) sticking: f64,
    /// The law of the host that says at which traction facets slide; the coefficient of `friction` is then 1.
    pub(crate) own: Option<OwnLimit<'a>>,
}

impl<const D: usize> Sliding<'_, D> {
    /// Factor by which elastic slip that is carried pulls as it did.
    pub(crate) fn stretched(&self) -> f64 {
        if self.sticking > 0.0 { 1.0 / self.sticking } else { 0.0 }
    }

    /// How a facet bore when the step began, with the pressure of then by the stiffness of now, and by how much less deep that is; `None`
    /// where it is not known.
    pub(crate) fn bearing(&self, facet: &SliderName) -> Option<(Bearing, f64)> {
        self.bearings.map(|bearings| bearings.get(facet).copied().unwrap_or_default().by_stiffer(self.stiffer))
    }

    /// The same of all facets of a pair that bore.
    pub(crate) fn bearings_of(&self, pair: [Partner; 2]) -> impl Iterator<Item = (&SliderName, Bearing)> {
        let of_pair = self.bearings.map(|bearings| bearings.range((pair, false, 0)..=(pair, true, usize::MAX)));
        of_pair.into_iter().flatten().map(|(name, bearing)| (name, bearing.by_stiffer(self.stiffer).0))
    }

    /// Coefficient of a facet, which falls as it slides.
    pub(crate) fn coefficient(&self, facet: &SliderName) -> f64 {
        let slid = || self.step.slip.get(facet).map_or(0.0, |carried| carried.slid);
        if self.friction.at_rest.is_some() {
            self.friction.coefficient_after(slid())
        } else {
            self.friction.coefficient
        }
    }

    /// The facets of a pair that bore when the step began, with the energy that was stored in their sliders; none without memory.
    pub(crate) fn bore(&self, pair: [Partner; 2]) -> impl Iterator<Item = (&SliderName, Bearing, f64)> {
        let stiffness = match self.stick {
            Stick::Spring(stiffness) => Some(stiffness),
            Stick::Memoryless(_) => None,
        };
        let all = stiffness.map(|stiffness| self.bearings_of(pair).map(move |one| (one, stiffness)));
        all.into_iter().flatten().map(|((name, bearing), stiffness)| {
            let slip = self.step.slip.get(name).map_or(0.0, |carried| carried.slip.norm_squared());
            (name, bearing, 0.5 * stiffness * bearing.area * bearing.whole * slip)
        })
    }
}
