//! The facets that carry the friction of a point.

use crate::contact::laws::{PointOnSide, PressurePoint};
use crate::geometry::Vector;
use crate::overlap::{Pair, Partner, SurfacePoint};

/// A facet and what it faces: its pair, whether it is of the second side, and its number in the surface.
pub(crate) type SliderName = ([Partner; 2], bool, usize);

/// The facets on which a point lies: both by halves where both sides are facets of bodies.
pub(super) struct Carriers<const D: usize> {
    /// Unit normal of the tangent plane, outwards of the first side.
    pub(super) normal: Vector<D>,
    /// Part of the point's area that each facet carries, within the tangent plane.
    pub(super) part: f64,
    /// Number of the facet within its side.
    facets: [Option<u32>; 2],
}

impl<const D: usize> Carriers<D> {
    /// `None` where no facet faces the other side.
    pub(super) fn of(pair: &Pair<D>, point: &PressurePoint<D>) -> Option<Self> {
        if is_swallowed(pair, point) {
            return None;
        }
        let normal_of = |side: &PointOnSide<D>| match side {
            PointOnSide::Surface(end) => Some(pair.normal_at(end)),
            PointOnSide::Cell(_) | PointOnSide::Rigid(_) => None,
        };
        // The tangent plane is that of the surfaces, not that across the line on which the penetration is measured.
        let normal = match point.middles.each_ref().map(normal_of) {
            [Some(n), Some(m)] => (n - m).try_normalize(0.0)?,
            [Some(n), None] => n,
            [None, Some(m)] => -m,
            [None, None] => return None,
        };
        let facets = point.middles.each_ref().map(|side| facet_of(pair, side));
        let along = point.normal.dot(&normal);
        let count = facets.iter().flatten().count();
        (along > 0.0 && count > 0).then(|| Self { normal, part: 1.0 / (count as f64 * along), facets })
    }

    /// Each facet, and whether it is of the second side: a body against itself has facets in both roles.
    pub(super) fn facets(&self) -> impl Iterator<Item = (bool, u32)> {
        [(false, self.facets[0]), (true, self.facets[1])].into_iter().filter_map(|(of_b, facet)| Some((of_b, facet?)))
    }
}

/// The facet of a body on which a point lies.
fn facet_of<const D: usize>(pair: &Pair<D>, side: &PointOnSide<D>) -> Option<u32> {
    match *side {
        PointOnSide::Surface(SurfacePoint::Facet { of_b, facet, .. }) if !of_b || pair.pose.is_none() => Some(facet),
        _ => None,
    }
}

/// Number of a facet within the surface.
pub(super) fn in_surface<const D: usize>(pair: &Pair<D>, of_b: bool, facet: u32) -> Option<usize> {
    match pair.partners[usize::from(of_b && !pair.is_own())] {
        Partner::Body(body) => Some(pair.surface.ranges[body].start + facet as usize),
        Partner::Obstacle(_) => None,
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
