//! Crossings of a bundle's fibers with an obstacle that has no facets, and where such an obstacle can be.

use super::bundle::Bundle;
use super::gather::Gathered;
use super::side::ImplicitSide;
use crate::Error;
use crate::geometry::aabb::Aabb;
use crate::geometry::{Passage, Pose, Shape, SignedDistance, Stretch, Vector, chord, march};

/// Rounds in which the box around a signed distance function is cut in two along every axis.
const OCTREE_DEPTH: usize = 5;

/// Passages of every gathered fiber through the obstacle, between its first and its last event; ordered by fiber.
pub(crate) fn passages<const D: usize>(
    side: &ImplicitSide<D>,
    bundle: &Bundle<D>,
    gathered: &Gathered,
    resolution: f64,
) -> Result<Vec<Passage<D>>, Error> {
    if let Shape::SignedDistance(function) = side.shape {
        let stretches: Vec<Stretch<D>> = gathered
            .fibers
            .iter()
            .map(|gathering| {
                let (origin, direction) = bundle.ray(gathering.fiber);
                let [start, end] = bundle.stretch(gathering, &gathered.events);
                Stretch { origin, direction, start, end }
            })
            .collect();
        return march(function.as_ref(), side.pose, &stretches, resolution)
            .map_err(|point| Error::SignedDistance { obstacle: side.obstacle, point });
    }
    let mut passages = Vec::with_capacity(2 * gathered.fibers.len());
    for (stretch, gathering) in gathered.fibers.iter().enumerate() {
        let (origin, direction) = bundle.ray(gathering.fiber);
        let found = chord(side.shape, &side.pose.unplace(&origin), &side.pose.unrotate(&direction));
        for (mut hit, leaves) in found.into_iter().flatten().zip([false, true]) {
            hit.t *= side.pose.scale;
            hit.normal = side.pose.rotate(&hit.normal);
            passages.push(Passage { stretch, hit, leaves });
        }
    }
    Ok(passages)
}

/// A box, within `within`, around the obstacle; `None` if it does not reach there.
pub(crate) fn region<const D: usize>(side: &ImplicitSide<D>, within: &Aabb<D>) -> Result<Option<Aabb<D>>, Error> {
    let mut half = Vector::<D>::zeros();
    match *side.shape {
        Shape::HalfSpace => return Ok(below_plane(side.pose, within)),
        Shape::SignedDistance(ref function) => return near_zero(function.as_ref(), side, within),
        Shape::Ball { radius } => half.fill(radius),
        Shape::Cuboid { half_extents } => half = half_extents.into(),
        Shape::Cylinder { radius, half_height } | Shape::Cone { radius, half_height } => {
            half.fill(radius);
            half[D - 1] = half_height;
        }
        Shape::Capsule { radius, half_height } => {
            half.fill(radius);
            half[D - 1] = half_height + radius;
        }
        // Obstacles with facets come as such.
        Shape::Polytope { .. } => return Ok(None),
    }
    let mut reach = Vector::<D>::zeros();
    for axis in 0..D {
        let mut unit = Vector::<D>::zeros();
        unit[axis] = half[axis] * side.pose.scale;
        reach += side.pose.rotate(&unit).abs();
    }
    let center = Vector::from(side.pose.position);
    let found = within.intersection(&Aabb { min: center - reach, max: center + reach });
    Ok((!found.is_empty()).then_some(found))
}

/// Part of a box below the plane of a half-space: for every axis, as far as the plane cuts the box's edges.
fn below_plane<const D: usize>(pose: &Pose<D>, within: &Aabb<D>) -> Option<Aabb<D>> {
    let mut up = Vector::<D>::zeros();
    up[D - 1] = 1.0;
    let normal = pose.rotate(&up);
    let level = normal.dot(&Vector::from(pose.position));
    // Lowest value of n·x over the box, and what each axis adds to it.
    let least: f64 = (0..D).map(|i| (normal[i] * within.min[i]).min(normal[i] * within.max[i])).sum();
    if least > level {
        return None;
    }
    let mut found = *within;
    for i in 0..D {
        let room = (level - least) / normal[i].abs();
        if room < within.extent()[i] {
            if normal[i] > 0.0 {
                found.max[i] = within.min[i] + room;
            } else {
                found.min[i] = within.max[i] - room;
            }
        }
    }
    Some(found)
}

/// Box around the cells of a subdivided box that the zero set or the inside of a signed distance function can reach.
fn near_zero<const D: usize>(
    function: &dyn SignedDistance<D>,
    side: &ImplicitSide<D>,
    within: &Aabb<D>,
) -> Result<Option<Aabb<D>>, Error> {
    let mut boxes = vec![*within];
    let mut inside = Aabb::empty();
    for depth in 0..=OCTREE_DEPTH {
        let x: Vec<[f64; D]> = boxes.iter().map(|b| side.pose.unplace(&b.center()).into()).collect();
        let (mut phi, mut gradient) = (vec![f64::NAN; x.len()], vec![[0.0; D]; x.len()]);
        function
            .evaluate(&x, &mut phi, &mut gradient)
            .map_err(|point| Error::SignedDistance { obstacle: side.obstacle, point })?;
        if let Some(point) = phi.iter().position(|p| !p.is_finite()) {
            return Err(Error::SignedDistance { obstacle: side.obstacle, point });
        }
        let mut kept = Vec::new();
        for (cell, phi) in boxes.iter().zip(&phi) {
            let reach = 0.5 * cell.extent().norm();
            let phi = phi * side.pose.scale;
            if phi > reach || inside.contains(cell) {
                continue;
            }
            if phi < -reach || depth == OCTREE_DEPTH {
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
