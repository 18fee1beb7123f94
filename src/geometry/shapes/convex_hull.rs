//! Facets of the convex hull of points.

use super::faces::Faceted;
use super::solid::Solid;
use crate::Error;
use crate::geometry::Vector;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::facet::area_vector;

/// What counts as flat, and as beside a facet, in parts of the points' extent: parry's hull takes what is nearer to a
/// facet than 1e-14 for a part of it, and a hull so thin would be noise.
const FLAT: f64 = 1e-12;

/// The hull as a closed surface.
pub(super) fn solid<const D: usize>(points: &[[f64; D]]) -> Result<Solid<D>, Error> {
    let (corners, facets) = convex_hull(points)?;
    Solid::faceted(&corners, &facets)
}

/// Corners and facets of the hull, checked: no point lies outside by more than rounding.
fn convex_hull<const D: usize>(points: &[[f64; D]]) -> Result<Faceted<D>, Error> {
    for (node, point) in points.iter().enumerate() {
        if let Some(axis) = point.iter().position(|x| !x.is_finite()) {
            return Err(Error::NonFiniteCoordinate { node, axis });
        }
    }
    let degenerate = Error::DegenerateHull { point_count: points.len() };
    let given: Vec<Vector<D>> = points.iter().map(|&x| x.into()).collect();
    let aabb = Aabb::of(&given);
    let tolerance = aabb.rounding().max(FLAT * aabb.extent().amax());
    if given.is_empty() || is_flat(&given, tolerance) {
        return Err(degenerate);
    }
    // parry's tolerances in 2D are absolute: it is given points of size one, and numbers those that it takes.
    let scaled = |x: &Vector<D>| (x - aabb.center()) / aabb.extent().amax();
    let (corners, facets): Faceted<D> = if D == 2 {
        let plane: Vec<_> = given.iter().map(|x| parry2d_f64::math::Vector::new(scaled(x)[0], scaled(x)[1])).collect();
        let corners = parry2d_f64::transformation::convex_hull_idx(&plane);
        let count = corners.len() as u32;
        let edges = (0..count).map(|k| std::array::from_fn(|end| (k + end as u32) % count)).collect();
        (corners.into_iter().map(|corner| points[corner]).collect(), edges)
    } else {
        let space: Vec<_> = given.iter().map(|x| parry3d_f64::math::Vector::new(x[0], x[1], x[2])).collect();
        let (corners, facets) = parry3d_f64::transformation::try_convex_hull(&space).map_err(|_| degenerate.clone())?;
        let corner = |x: &parry3d_f64::math::Vector| std::array::from_fn(|axis| x.to_array()[axis]);
        (corners.iter().map(corner).collect(), facets.iter().map(|f| std::array::from_fn(|k| f[k])).collect())
    };
    let outside = facets.iter().any(|facet| {
        let x: [Vector<D>; D] = facet.map(|corner| corners[corner as usize].into());
        let Some(normal) = area_vector(&x).try_normalize(0.0) else { return true };
        let level = normal.dot(&x[0]);
        // The normal of a sliver is known to fewer digits than its corners.
        given.iter().any(|y| normal.dot(y) - level > 1e3 * tolerance)
    });
    if outside { Err(degenerate) } else { Ok((corners, facets)) }
}

/// Whether points lie in a plane (2D: on a line), to a tolerance: no D of their differences from the first, each the
/// farthest from the space of those before it, are independent.
fn is_flat<const D: usize>(points: &[Vector<D>], tolerance: f64) -> bool {
    let mut rests: Vec<Vector<D>> = points.iter().map(|x| x - points[0]).collect();
    (0..D).any(|_| {
        let farthest = rests.iter().fold(Vector::zeros(), |a: Vector<D>, b| if b.norm() > a.norm() { *b } else { a });
        if farthest.norm() <= tolerance {
            return true;
        }
        let direction = farthest.normalize();
        rests.iter_mut().for_each(|x| *x -= direction * direction.dot(x));
        false
    })
}
