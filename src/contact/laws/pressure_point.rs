//! Where a law presses, point by point: what hosts see of a contact, and what friction acts on.

use crate::geometry::Vector;
use crate::overlap::{
    ContactPoint, ContactPoints, DepthPlace, DepthPoint, Pair, PlaceInCell, PointLists, SurfacePoint,
};

/// A point at which two sides are pressed together.
pub(crate) struct PressurePoint<const D: usize> {
    /// The centre of its pressure on either side, in the order of the partners.
    pub(crate) sides: [PointOnSide<D>; 2],
    /// The centre of its area, which stays where it is as the pressure changes.
    pub(crate) middles: [PointOnSide<D>; 2],
    /// Gradients of the weights where the latter lies in a cell.
    pub(crate) gradients: [Vector<D>; 8],
    /// Unit vector, outwards of the first side, along which the penetration is measured.
    pub(crate) normal: Vector<D>,
    pub(crate) penetration: f64,
    pub(crate) pressure: f64,
    /// Area (2D: length) across the normal.
    pub(crate) area: f64,
    /// Number of the patch within the pair.
    pub(crate) patch: usize,
    /// What pressure · area changes by as the point on either side is displaced.
    pub(crate) slopes: [Vector<D>; 2],
}

/// A material point of one side.
#[derive(Clone, Copy, Debug)]
pub(crate) enum PointOnSide<const D: usize> {
    /// On the boundary.
    Surface(SurfacePoint<D>),
    /// Inside a cell.
    Cell(PlaceInCell),
    /// Inside a rigid obstacle.
    Rigid(Vector<D>),
}

/// The points of a local law: `pressure` and its derivative are functions of the penetration.
pub(crate) fn of_contact_points<const D: usize>(
    points: &ContactPoints<D>,
    pair: &Pair<D>,
    pressure: impl Fn(f64) -> f64,
    derivative: impl Fn(f64) -> f64,
) -> Vec<PressurePoint<D>> {
    let of_point = |point: &ContactPoint<D>| {
        let along = points.patches.directions[point.direction as usize];
        // The line enters at the first end, so that its length grows as that goes back and the other goes on.
        let stiffness = point.weight * derivative(point.length);
        let slope = |end: &SurfacePoint<D>, sign: f64| {
            let normal = pair.normal_at(end);
            let across = along.dot(&normal);
            if across == 0.0 { Vector::zeros() } else { normal * (sign * stiffness / across) }
        };
        let (mut ends, mut slopes) = (point.ends, [slope(&point.ends[0], -1.0), slope(&point.ends[1], 1.0)]);
        let is_second = |end: &SurfacePoint<D>| !matches!(end, SurfacePoint::Facet { of_b: false, .. });
        if is_second(&ends[0]) && !is_second(&ends[1]) {
            ends.swap(0, 1);
            slopes.swap(0, 1);
        }
        PressurePoint {
            sides: ends.map(PointOnSide::Surface),
            middles: ends.map(PointOnSide::Surface),
            gradients: [Vector::zeros(); 8],
            normal: if along.dot(&pair.normal_at(&ends[0])) < 0.0 { -along } else { along },
            penetration: point.length,
            pressure: pressure(point.length),
            area: point.weight,
            patch: point.direction as usize,
            slopes,
        }
    };
    points.points.iter().map(of_point).collect()
}

/// Points of facets inside the other side: `pressure` is a function of the depth, and `derivative` its own.
pub(crate) fn of_depth_points<const D: usize>(
    points: PointLists<D>,
    pair: &Pair<D>,
    pressure: impl Fn(f64) -> f64,
    derivative: impl Fn(f64) -> f64,
) -> Vec<PressurePoint<D>> {
    let of_point = |point: &DepthPoint<D>| {
        let &DepthPoint { of_b, facet, .. } = point;
        let both = |place: &DepthPlace<D>| {
            let own = SurfacePoint::Facet { of_b, facet, weights: place.weights };
            let other = place.other.map_or_else(|| PointOnSide::Rigid(pair.position(&own)), PointOnSide::Cell);
            if of_b { [other, PointOnSide::Surface(own)] } else { [PointOnSide::Surface(own), other] }
        };
        let normal = pair.normal_at(&SurfacePoint::Facet { of_b, facet, weights: point.middle.weights });
        let stiffness = derivative(point.depth);
        let slope = point.slope * if of_b { -stiffness } else { stiffness };
        PressurePoint {
            sides: both(&point.pressed),
            middles: both(&point.middle),
            gradients: point.gradients,
            normal: if of_b { -normal } else { normal },
            penetration: point.depth,
            pressure: pressure(point.depth),
            area: point.area,
            patch: 0,
            slopes: [slope, -slope],
        }
    };
    points.map(of_point)
}
