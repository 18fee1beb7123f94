//! A rigid surface that is convex as far as a body reaches, and a convex solid that is the same there.
//!
//! Let K be the obstacle, and C a box around all that the body can have inside it, with room for the largest depth on all
//! sides. If every face of K that meets C lies below the planes of all others of them, K ∩ C is what lies below these
//! planes in C: a way in C from a point of K to another point below all planes can leave K nowhere, and a way to a point
//! above one of them cannot come back. The ball around a point of the body in K that reaches to the surface lies in C as well, so that
//! the depth there is that below the nearest of these planes.
//!
//! What lies below these planes, and in the box around K with that room, is a convex solid. The body has the same in it as in K, and as
//! deep: the sides of the box are too far away to be nearest.

use super::convex_solid::{ConvexSolid, Linear, PlacedFaces, below_face, bounds, height_of};
use crate::configuration::FacetSide;
use crate::geometry::Vector;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::convex_piece::{Piece, clip_to_box};
use crate::geometry::shapes::{FLAT, PlaneTree};
use std::borrow::Cow;

/// Room beside what the body can reach, in parts of the largest depth there, and of the obstacle's extent.
const ROOM: f64 = 1.01;
const LEAST_ROOM: f64 = 1e-6;

impl<'a, const D: usize> ConvexSolid<'a, D> {
    /// A solid that has the same in common with a body in this box as an obstacle has, and as deep; `None` if the obstacle is
    /// not convex there.
    pub(crate) fn near(side: &FacetSide<'a, D>, body: &Aabb<D>) -> Option<Self> {
        if !side.is_upright {
            return None;
        }
        let flat = side.rigid?.flat();
        let common = side.aabb.intersection(body);
        // Nothing in this box is farther from the side of the box around the obstacle that is nearest to it.
        let deep = (0..D).map(|i| (common.max[i] - side.aabb.min[i]).min(side.aabb.max[i] - common.min[i]));
        let room = ROOM * deep.fold(f64::INFINITY, f64::min).max(0.0) + LEAST_ROOM * side.aabb.extent().amax();
        let outer = side.aabb.inflated(room);
        let reached = outer.intersection(body).inflated(room);
        // Faces that are there, with what of them is.
        let mut work = Piece::default();
        let mut found: Vec<(u32, u32, Aabb<D>)> = Vec::new();
        for facet in side.facets_in(&reached) {
            let part = clip_to_box(&side.corners(facet as usize), &reached, &mut work);
            if !part.is_empty() {
                found.push((flat.face_of[facet as usize], facet, part));
            }
        }
        found.sort_unstable_by_key(|(face, facet, _)| (*face, *facet));
        let (mut heights, mut boxes, mut faces): (Vec<Linear<D>>, Vec<Aabb<D>>, Vec<u32>) = Default::default();
        for of_face in found.chunk_by(|p, q| p.0 == q.0) {
            let height = height_of(side, flat.facets[of_face[0].0 as usize])?;
            let part = of_face.iter().fold(Aabb::empty(), |all, (_, _, part)| all.union(part));
            boxes.push(below_face(&part, &height, room));
            heights.push(height);
            faces.push(of_face[0].0);
        }
        let number = |face: &u32| faces.binary_search(face).ok().map(|number| number as u32);
        let mut neighbours: Vec<Vec<u32>> =
            faces.iter().map(|&face| flat.neighbours[face as usize].iter().filter_map(number).collect()).collect();
        let tolerance = FLAT * side.aabb.extent().amax() + side.aabb.rounding();
        let tree = PlaneTree::new(&slopes(&heights));
        let planes = bounds(&tree, &heights);
        let is_above = |x: &Vector<D>| {
            let of_plane = |face: u32| -heights[face as usize].at(x);
            tree.least(&planes, -tolerance, |node| node.least_depth(x), of_plane) < -tolerance
        };
        let mut corners: Vec<u32> = found.iter().flat_map(|(_, facet, _)| side.facets[*facet as usize]).collect();
        corners.sort_unstable();
        corners.dedup();
        if corners.iter().any(|&corner| is_above(&side.points[corner as usize])) {
            return None;
        }
        if !heights.is_empty() {
            for axis in 0..D {
                for direction in [-1.0, 1.0] {
                    let mut slope = Vector::<D>::zeros();
                    slope[axis] = direction;
                    let place = if direction < 0.0 { outer.min[axis] } else { outer.max[axis] };
                    heights.push(Linear { slope, constant: -direction * place });
                    // For no point that the body can reach it is the nearest.
                    boxes.push(Aabb::empty());
                    neighbours.push(Vec::new());
                }
            }
        }
        let tree = PlaneTree::new(&slopes(&heights));
        let (planes, rounding) = (bounds(&tree, &heights), side.aabb.rounding());
        let deepest = vec![outer.extent().norm(); heights.len()];
        let (tree, neighbours) = (Cow::Owned(tree), Cow::Owned(neighbours));
        Some(Self { heights, faces: Some(PlacedFaces { tree, planes, boxes, deepest, neighbours, rounding }) })
    }
}

fn slopes<const D: usize>(heights: &[Linear<D>]) -> Vec<Vector<D>> {
    heights.iter().map(|height| height.slope).collect()
}
