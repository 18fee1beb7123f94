//! A rigid convex solid, as the planes of its faces.

use crate::configuration::FacetSide;
use crate::geometry::Vector;
use crate::geometry::aabb::Aabb;
use crate::geometry::facet::area_vector;
use crate::geometry::plane::Plane;

/// Faces of a solid that is still taken as such: the work grows as their square.
const MOST_FACES: usize = 256;

/// Corners that lie above a face by this part of the solid's extent lie in it: rounding of coordinates that were turned
/// and scaled is far below, and what the exact integrals shall know is not far above.
const FLAT: f64 = 1e-11;

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
pub(crate) struct ConvexSolid<const D: usize> {
    /// Height above every face; its slope is the face's unit normal.
    pub(crate) heights: Vec<Linear<D>>,
    /// Greatest distance of two faces along each face's normal; infinite for a half-space.
    pub(crate) widths: Vec<f64>,
}

impl<const D: usize> ConvexSolid<D> {
    /// A half-space.
    pub(crate) fn below(plane: &Plane<D>) -> Self {
        let height = Linear { slope: plane.normal, constant: -plane.normal.dot(&plane.point) };
        Self { heights: vec![height], widths: vec![f64::INFINITY] }
    }

    /// The solid that facets bound; `None` if it is not convex, or has too many faces.
    pub(crate) fn within(side: &FacetSide<D>) -> Option<Self> {
        let tolerance = FLAT * side.aabb.extent().amax() + side.aabb.rounding();
        let mut heights: Vec<Linear<D>> = Vec::new();
        for facet in 0..side.facets.len() {
            let corners = side.corners(facet);
            let Some(normal) = area_vector(&corners).try_normalize(0.0) else { continue };
            let lies_in = |height: &Linear<D>| {
                height.slope.dot(&normal) > 0.0 && corners.iter().all(|x| height.at(x).abs() <= tolerance)
            };
            if heights.iter().any(lies_in) {
                continue;
            }
            if heights.len() == MOST_FACES {
                return None;
            }
            heights.push(Linear { slope: normal, constant: -normal.dot(&corners[0]) });
        }
        let mut widths = vec![0.0f64; heights.len()];
        for &corner in side.facets.as_flattened() {
            let x = &side.points[corner as usize];
            for (height, width) in heights.iter().zip(&mut widths) {
                let above = height.at(x);
                if above > tolerance {
                    return None;
                }
                *width = width.max(-above);
            }
        }
        // All faces bound the hull of the corners: inside it is covered as often everywhere.
        let corners = side.facets.as_flattened();
        let middle =
            corners.iter().fold(Vector::zeros(), |sum, &c| sum + side.points[c as usize]) / corners.len() as f64;
        (side.winding_number(&middle) == 1).then_some(Self { heights, widths })
    }
}
