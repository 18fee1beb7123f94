//! A rigid convex solid, as the planes of its faces.

use crate::configuration::FacetSide;
use crate::geometry::Vector;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::primitives::plane::Plane;
use crate::geometry::shapes::{PlaneBounds, PlaneTree};
use std::borrow::Cow;

/// Depth of the points for which a face is the nearest, in parts of the solid's width across it: a ball inside that touches the
/// face is no wider than the solid.
const DEEPEST: f64 = 0.5;

/// Faces of a solid that is taken as such however deep a body reaches into it, and the part of its extent up to which a body
/// reaches into others.
const MOST_FACES: usize = 256;
const SHALLOW: f64 = 0.25;

/// A function that is linear in space.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Linear<const D: usize> {
    pub(crate) slope: Vector<D>,
    pub(crate) constant: f64,
}

impl<const D: usize> Linear<D> {
    pub(crate) fn at(&self, x: &Vector<D>) -> f64 {
        self.slope.dot(x) + self.constant
    }

    /// The same with the other sign, to the last bit.
    pub(crate) fn negated(&self) -> Self {
        Self { slope: -self.slope, constant: -self.constant }
    }

    /// Its least value in a box.
    pub(crate) fn least(&self, aabb: &Aabb<D>) -> f64 {
        (0..D).fold(self.constant, |sum, i| sum + (self.slope[i] * aabb.min[i]).min(self.slope[i] * aabb.max[i]))
    }

    /// Its largest value in a box.
    pub(crate) fn largest(&self, aabb: &Aabb<D>) -> f64 {
        (0..D).fold(self.constant, |sum, i| sum + (self.slope[i] * aabb.min[i]).max(self.slope[i] * aabb.max[i]))
    }
}

/// The points below all planes. The depth below the surface is that below the nearest plane.
pub(crate) struct ConvexSolid<'a, const D: usize> {
    /// Height above every face; its slope is the face's unit normal.
    pub(super) heights: Vec<Linear<D>>,
    /// What is known of the faces; `None` of a half-space.
    pub(super) faces: Option<PlacedFaces<'a, D>>,
}

/// Faces of a solid, where it is.
pub(super) struct PlacedFaces<'a, const D: usize> {
    pub(super) tree: Cow<'a, PlaneTree>,
    pub(super) planes: Vec<PlaneBounds<D>>,
    /// Boxes around the points for which each face is the nearest, as far as a body can reach.
    pub(super) boxes: Vec<Aabb<D>>,
    /// No point for which a face is the nearest is deeper.
    pub(super) deepest: Vec<f64>,
    pub(super) neighbours: Cow<'a, [Vec<u32>]>,
    /// Of the coordinates of the solid.
    pub(super) rounding: f64,
}

impl<'a, const D: usize> ConvexSolid<'a, D> {
    /// A half-space.
    pub(crate) fn below(plane: &Plane<D>) -> Self {
        let height = Linear { slope: plane.normal, constant: -plane.normal.dot(&plane.point) };
        Self { heights: vec![height], faces: None }
    }

    /// The solid that an obstacle's facets bound, which stands there at this scale; `None` if it is not convex.
    pub(crate) fn within(side: &FacetSide<'a, D>, scale: f64) -> Option<Self> {
        let flat = side.rigid?.flat();
        let convex = flat.convex.as_ref()?;
        let heights = flat.facets.iter().map(|&facet| height_of(side, facet)).collect::<Option<Vec<Linear<D>>>>()?;
        let deepest: Vec<f64> = convex.widths.iter().map(|width| DEEPEST * width * scale).collect();
        let boxes = convex.corners.iter().zip(&heights).zip(&deepest).map(|((corners, height), deepest)| {
            let outer = Aabb::of(corners.iter().map(|&corner| &side.points[corner as usize]));
            below_face(&outer, height, *deepest)
        });
        let (tree, boxes) = (Cow::Borrowed(&convex.planes), boxes.collect());
        let neighbours = Cow::Borrowed(flat.neighbours.as_slice());
        let (planes, rounding) = (bounds(&tree, &heights), side.aabb.rounding());
        Some(Self { heights, faces: Some(PlacedFaces { tree, planes, boxes, deepest, neighbours, rounding }) })
    }

    /// The solid whose surface lies further in: the depth is less by so much everywhere.
    pub(crate) fn moved_in(mut self, by: f64) -> Self {
        self.heights.iter_mut().for_each(|height| height.constant += by);
        if let Some(faces) = &mut self.faces {
            faces.planes = bounds(&faces.tree, &self.heights);
        }
        self
    }

    /// Whether closed forms are worth their while for a body in this box: deep in an obstacle of many faces most of them are as
    /// far away, and each has to be compared with each.
    pub(crate) fn is_cheap(side: &FacetSide<D>, body: &Aabb<D>) -> bool {
        let (common, extent) = (side.aabb.intersection(body), side.aabb.extent());
        let reached = (0..D).map(|i| (common.max[i] - side.aabb.min[i]).min(side.aabb.max[i] - common.min[i]));
        side.rigid.is_some_and(|faces| faces.flat().facets.len() <= MOST_FACES)
            || reached.fold(f64::INFINITY, f64::min) <= SHALLOW * extent.min()
    }

    /// Faces for which some point of a box may be nearest.
    pub(super) fn faces_near(&self, aabb: &Aabb<D>) -> Vec<u32> {
        let is_near = |face: &u32| self.faces.as_ref().is_none_or(|faces| faces.boxes[*face as usize].meets(aabb));
        (0..self.heights.len() as u32).filter(is_near).collect()
    }

    /// No point for which this face is the nearest is deeper.
    pub(super) fn deepest(&self, face: u32) -> f64 {
        self.faces.as_ref().map_or(f64::INFINITY, |faces| faces.deepest[face as usize])
    }

    /// Faces at the edges of a face.
    pub(super) fn neighbours(&self, face: u32) -> &[u32] {
        self.faces.as_ref().map_or(&[], |faces| &faces.neighbours[face as usize])
    }

    /// The faces that are the nearest to some point of a facet, or may be, with the depth of the facet's corners below each;
    /// none if all of it is outside.
    pub(super) fn nearest(&self, corners: &[Vector<D>; D]) -> Vec<(u32, [f64; D])> {
        let depths = |face: u32| corners.each_ref().map(|x| -self.heights[face as usize].at(x));
        let Some(PlacedFaces { tree, planes, rounding, .. }) = &self.faces else { return vec![(0, depths(0))] };
        let slack = rounding.max(Aabb::of(corners).rounding());
        let bounds = |node: &PlaneBounds<D>| corners.each_ref().map(|x| node.least_depth(x) - slack);
        let bound = tree.least(planes, f64::INFINITY, |node| largest(&bounds(node)), |face| largest(&depths(face)));
        let mut found = Vec::new();
        if bound > 0.0 {
            tree.visit(
                planes,
                |node| least(&bounds(node)) <= bound,
                |face| {
                    let at = depths(face);
                    if least(&at) <= bound {
                        found.push((face, at));
                    }
                },
            );
            found.sort_unstable_by_key(|(face, _)| *face);
        }
        found
    }

    /// Depth below a face at which another one is as near, as a function of the foot on the face; `None` for one that looks
    /// the same way.
    pub(super) fn end(&self, face: u32, other: u32) -> Option<Linear<D>> {
        let (height, other) = (&self.heights[face as usize], &self.heights[other as usize]);
        let cosine = height.slope.dot(&other.slope);
        let factor = -1.0 / (1.0 - cosine);
        let slope = (other.slope - height.slope * cosine) * factor;
        let constant = (other.constant - height.constant * cosine) * factor;
        factor.is_finite().then_some(Linear { slope, constant })
    }

    /// The same at the corners of a facet, of all other faces of which it is the least somewhere on it, or may be, where it is
    /// not above `limit`; `None` if all of the facet lies beside the face.
    pub(super) fn ends(&self, face: u32, corners: &[Vector<D>; D], limit: f64) -> Option<Vec<[f64; D]>> {
        let Some(PlacedFaces { tree, planes, rounding, .. }) = &self.faces else { return Some(Vec::new()) };
        let height = &self.heights[face as usize];
        let feet = corners.each_ref().map(|x| x - height.slope * height.at(x));
        let slack = rounding.max(Aabb::of(corners.iter().chain(&feet)).rounding());
        let at = |other: u32| {
            self.end(face, other).filter(|_| other != face).map(|end| corners.each_ref().map(|x| end.at(x)))
        };
        let bounds = |node: &PlaneBounds<D>| {
            let widest = 1.0 - node.least_product(&height.slope);
            feet.each_ref().map(|x| {
                let depth = node.least_depth(x) - slack;
                if depth > 0.0 { depth / widest } else { f64::NEG_INFINITY }
            })
        };
        let of_face = |other: u32| at(other).map_or(f64::INFINITY, |at| largest(&at));
        let bound = tree.least(planes, limit, |node| largest(&bounds(node)), of_face);
        if bound <= 0.0 {
            return None;
        }
        let mut found = Vec::new();
        tree.visit(
            planes,
            |node| least(&bounds(node)) <= bound,
            |other| found.extend(at(other).filter(|at| least(at) <= bound).map(|at| (other, at))),
        );
        found.sort_unstable_by_key(|(other, _)| *other);
        Some(found.into_iter().map(|(_, at)| at).collect())
    }
}

/// Height above the plane of a facet; `None` where it has no measure.
pub(super) fn height_of<const D: usize>(side: &FacetSide<D>, facet: u32) -> Option<Linear<D>> {
    let corners = side.corners(facet as usize);
    let slope = area_vector(&corners).try_normalize(0.0)?;
    Some(Linear { slope, constant: -slope.dot(&corners[0]) })
}

/// Box around the points below a face that are no deeper, given the box around the face.
pub(super) fn below_face<const D: usize>(face: &Aabb<D>, height: &Linear<D>, deepest: f64) -> Aabb<D> {
    let down = height.slope * -deepest;
    face.union(&Aabb { min: face.min + down, max: face.max + down })
}

/// Bounds for the planes below the nodes of a tree.
pub(super) fn bounds<const D: usize>(tree: &PlaneTree, heights: &[Linear<D>]) -> Vec<PlaneBounds<D>> {
    tree.bounds(|face| (heights[face as usize].slope, -heights[face as usize].constant))
}

fn largest<const D: usize>(values: &[f64; D]) -> f64 {
    values.iter().copied().fold(f64::NEG_INFINITY, f64::max)
}

fn least<const D: usize>(values: &[f64; D]) -> f64 {
    values.iter().copied().fold(f64::INFINITY, f64::min)
}
