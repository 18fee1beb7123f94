//! Where an obstacle that has no facets can be.

use super::distance_slopes::check_slopes;
use super::sides::ImplicitSide;
use crate::Error;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::plane::Plane;
use crate::geometry::shapes::{Extent, ImplicitShape};
use crate::geometry::{Pose, SignedDistance, Vector};

/// Rounds in which the box around a signed distance function is cut in two along every axis.
const ROUNDS_OF_FUNCTION: usize = 5;

/// The same around a shape, whose own box is known. A body may meet the tip of a cone alone: lines beside it cost more
/// than looking.
const ROUNDS_OF_SHAPE: usize = 4;

/// A box, within `within`, around the obstacle; `None` if it does not reach there.
pub(crate) fn region<const D: usize>(side: &ImplicitSide<D>, within: &Aabb<D>) -> Result<Option<Aabb<D>>, Error> {
    let shape = match side.shape {
        ImplicitShape::Convex(shape) => shape,
        ImplicitShape::Function(function) => {
            // Before anything is left out by its value.
            check_slopes(function.as_ref(), side, within)?;
            return reached(within, side, ROUNDS_OF_FUNCTION, |x| evaluated(function.as_ref(), side, x));
        }
    };
    let half = match shape.extent() {
        Extent::HalfSpace => return Ok(below_plane(side.pose, within)),
        Extent::Bounded { half, .. } => half,
    };
    let mut reach = Vector::<D>::zeros();
    for axis in 0..D {
        let mut unit = Vector::<D>::zeros();
        unit[axis] = half[axis] * side.pose.scale;
        reach += side.pose.rotate(&unit).abs();
    }
    let center = Vector::from(side.pose.position);
    let found = within.intersection(&Aabb { min: center - reach, max: center + reach });
    if found.is_empty() {
        return Ok(None);
    }
    reached(&found, side, ROUNDS_OF_SHAPE, |x| Ok(x.iter().map(|x| shape.distance_bound(&(*x).into())).collect()))
}

/// Part of a box below the plane of a half-space: for every axis, as far as the plane cuts the box's edges.
fn below_plane<const D: usize>(pose: &Pose<D>, within: &Aabb<D>) -> Option<Aabb<D>> {
    let Plane { normal, point } = Plane::of(pose);
    let level = normal.dot(&point);
    // Lowest value of n·x over the box, and what each axis adds to it.
    let least: f64 = (0..D).map(|i| (normal[i] * within.min[i]).min(normal[i] * within.max[i])).sum();
    if least > level {
        return None;
    }
    let mut found = *within;
    for i in 0..D {
        // Not the quotient first: the plane may be parallel to the axis.
        if level - least < normal[i].abs() * within.extent()[i] {
            let room = (level - least) / normal[i].abs();
            if normal[i] > 0.0 {
                found.max[i] = within.min[i] + room;
            } else {
                found.min[i] = within.max[i] - room;
            }
        }
    }
    Some(found)
}

/// Box around the cells of a subdivided box that the inside of an obstacle can reach, by its distance: negative inside,
/// in units of length, never more than the true one.
fn reached<const D: usize>(
    within: &Aabb<D>,
    side: &ImplicitSide<D>,
    rounds: usize,
    mut distance: impl FnMut(&[[f64; D]]) -> Result<Vec<f64>, Error>,
) -> Result<Option<Aabb<D>>, Error> {
    let mut boxes = vec![*within];
    let mut inside = Aabb::empty();
    for depth in 0..=rounds {
        let x: Vec<[f64; D]> = boxes.iter().map(|b| side.pose.unplace(&b.center()).into()).collect();
        let mut kept = Vec::new();
        for (cell, distance) in boxes.iter().zip(distance(&x)?) {
            let reach = 0.5 * cell.extent().norm();
            let distance = distance * side.pose.scale;
            if distance > reach || inside.contains(cell) {
                continue;
            }
            if distance < -reach || depth == rounds {
                inside = inside.union(cell);
            } else {
                kept.push(*cell);
            }
        }
        boxes = kept.iter().flat_map(halves).collect();
        if boxes.is_empty() {
            break;
        }
    }
    Ok((!inside.is_empty()).then_some(inside))
}

/// A signed distance function at some points.
fn evaluated<const D: usize>(
    function: &dyn SignedDistance<D>,
    side: &ImplicitSide<D>,
    x: &[[f64; D]],
) -> Result<Vec<f64>, Error> {
    let (mut phi, mut gradient) = (vec![f64::NAN; x.len()], vec![[0.0; D]; x.len()]);
    function
        .evaluate(x, &mut phi, &mut gradient)
        .map_err(|point| Error::SignedDistance { obstacle: side.obstacle, point })?;
    match phi.iter().position(|p| !p.is_finite()) {
        Some(point) => Err(Error::SignedDistance { obstacle: side.obstacle, point }),
        None => Ok(phi),
    }
}

/// The 2ᴰ equal parts of a box.
fn halves<const D: usize>(cell: &Aabb<D>) -> Vec<Aabb<D>> {
    let center = cell.center();
    (0..1usize << D)
        .map(|part| {
            let mut half = *cell;
            for axis in 0..D {
                if part >> axis & 1 == 0 {
                    half.max[axis] = center[axis];
                } else {
                    half.min[axis] = center[axis];
                }
            }
            half
        })
        .collect()
}
