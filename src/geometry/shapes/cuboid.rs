//! A box about the origin.

use super::chord::{Chord, common, slab};
use super::convex_shape::ConvexShape;
use super::extent::Extent;
use super::faces::{Faceted, positive};
use crate::Error;
use crate::geometry::Vector;

pub(super) struct Cuboid<const D: usize> {
    half_extents: Vector<D>,
}

impl<const D: usize> Cuboid<D> {
    pub(super) fn new(half_extents: &[f64; D]) -> Result<Self, Error> {
        half_extents.iter().try_for_each(|&half| positive("half_extent", half).map(drop))?;
        Ok(Self { half_extents: (*half_extents).into() })
    }
}

impl<const D: usize> ConvexShape<D> for Cuboid<D> {
    fn extent(&self) -> Extent<D> {
        Extent::Bounded { half: self.half_extents, radius: self.half_extents.norm() }
    }

    fn chord(&self, o: &Vector<D>, d: &Vector<D>) -> Chord<D> {
        (0..D).map(|i| slab(o, d, i, -self.half_extents[i], self.half_extents[i])).reduce(common).flatten()
    }

    fn signed_distance(&self, x: &Vector<D>) -> (f64, Vector<D>) {
        distance_from_box(x, &self.half_extents)
    }

    fn distance_bound(&self, x: &Vector<D>) -> f64 {
        (0..D).map(|i| x[i].abs() - self.half_extents[i]).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Corner c has coordinate +half on axis i where bit i of c is set.
    fn faces(&self) -> Option<Faceted<D>> {
        let half = &self.half_extents;
        let points =
            (0..1u32 << D).map(|c| std::array::from_fn(|i| if c >> i & 1 == 1 { half[i] } else { -half[i] })).collect();
        const EDGES: [[u32; 2]; 4] = [[0, 1], [1, 3], [3, 2], [2, 0]];
        const SQUARES: [[u32; 4]; 6] =
            [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let facets = match D {
            2 => EDGES.iter().map(|e| std::array::from_fn(|k| e[k])).collect(),
            _ => SQUARES
                .iter()
                .flat_map(|s| [[s[0], s[1], s[2]], [s[0], s[2], s[3]]])
                .map(|t| std::array::from_fn(|k| t[k]))
                .collect(),
        };
        Some((points, facets))
    }
}

/// Signed distance of a point from a box about the origin, and its gradient.
pub(super) fn distance_from_box<const D: usize>(x: &Vector<D>, half: &Vector<D>) -> (f64, Vector<D>) {
    let beyond = x.abs() - half;
    let sign = x.map(f64::signum);
    let nearest = beyond.imax();
    if beyond[nearest] <= 0.0 {
        let mut gradient = Vector::zeros();
        gradient[nearest] = sign[nearest];
        return (beyond[nearest], gradient);
    }
    let outside = beyond.map(|b| b.max(0.0));
    let phi = outside.norm();
    (phi, outside.component_mul(&sign) / phi)
}
