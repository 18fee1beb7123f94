//! A convex part of a facet, ray by ray from one of its corners.
//!
//! The depth is a quadratic function of the place, and what is summed up is a polynomial between its levels. Along a ray the levels are at roots,
//! so the integral along it is exact. From ray to ray it is smooth, but where a level leaves the part through an edge or touches a ray: there the
//! rays are parted.
//!
//! Edges of two bodies that coincide but for rounding, as in planes of symmetry, give corners that come and go, and each would part the rays
//! elsewhere. So these are left out, and the rays begin in a corner that does not depend on where the part does.

use super::facet_points::{FacetPoints, PointsFound};
use super::of_facet::{Below, OfFacet, on};
use super::parabola::{crossings, quadratic, value};
use super::rays::{GAUSS, Levels, Rays};
use crate::geometry::primitives::quadrature::{ON_CURVE, for_each_simplex};
use crate::overlap::depth::simplex_parts::Corners;
use smallvec::SmallVec;

/// A corner that stands out by no more than this part of the facet is rounding.
const ROUNDING: f64 = 1e-12;

/// Rays begin in the corner that lies farthest this way: no edge of a mesh is across it.
const WAY: [f64; 2] = [0.838_671, 0.544_639];

impl<const D: usize> FacetPoints<'_, D> {
    /// Adds a part of a facet that is curved, or lies over curved faces.
    pub(super) fn add_by_rays(
        &self,
        of_facet: &mut OfFacet<D>,
        below_it: &Below<D>,
        part: &[[f64; D]],
        counts: f64,
        found: &mut PointsFound<D>,
    ) {
        let corners = without_rounding(part);
        if corners.len() < D {
            return;
        }
        for_each_simplex(&corners, |corners, share| {
            let depth = |w: &[f64; D]| self.depth(of_facet.sag, below_it, w).0;
            let ends = corners.map(depth);
            let between =
                |p: usize, q: usize| 2.0 * depth(&on(corners[p], corners[q], 0.5)) - 0.5 * (ends[p] + ends[q]);
            // The coefficients of Bernstein's polynomials have all values between them.
            let all = [ends[0], ends[1], ends[D - 1], between(0, 1), between(1, D - 1), between(D - 1, 0)];
            let (least, most) = all.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(*x), b.max(*x)));
            if most <= 0.0 {
                return;
            }
            let levels = self.tent.levels().into_iter().filter(|level| least < *level && *level < most);
            let levels: Levels = levels.collect();
            if !levels.is_empty() {
                self.add_rays(of_facet, below_it, corners, (share * counts, &levels), found);
            } else {
                let mut whole: Corners = [[0.0; 4]; 4];
                whole.iter_mut().zip(corners).for_each(|(corner, w)| corner[..D].copy_from_slice(w));
                self.add_points(of_facet, below_it, &whole, share * counts, found);
            }
        });
    }

    /// Adds a triangle by rays from its first corner.
    fn add_rays(
        &self,
        of_facet: &mut OfFacet<D>,
        below_it: &Below<D>,
        corners: [&[f64; D]; D],
        (share, levels): (f64, &[f64]),
        found: &mut PointsFound<D>,
    ) {
        let (apex, far) = (corners[0], [corners[1], corners[D - 1]]);
        let depth = |w: &[f64; D]| self.depth(of_facet.sag, below_it, w).0;
        let rays = Rays::new([0.0, 0.5, 1.0].map(|t| quadratic(|r| depth(&on(apex, &on(far[0], far[1], t), r)))));
        let parted = rays.parted(levels);
        for pair in parted.windows(2) {
            let width = pair[1] - pair[0];
            for (aside, of_ray) in GAUSS {
                let t = 0.5 * (pair[0] + pair[1]) + aside * width;
                let (end, ray) = (on(far[0], far[1], t), rays.at(t));
                for piece in crossings(&ray, levels).windows(2) {
                    let (middle, length) = (0.5 * (piece[0] + piece[1]), piece[1] - piece[0]);
                    if value(&ray, middle) <= 0.0 {
                        continue;
                    }
                    for (aside, of_point) in ON_CURVE {
                        let r = middle + aside * length;
                        // The area grows with the distance from the corner.
                        let part = share * 2.0 * r * width * of_ray * length * of_point;
                        self.add_point(of_facet, below_it, &on(apex, &end, r), part, found);
                    }
                }
            }
        }
    }
}

/// The corners of a part that stand out by more than rounding, from the one that lies farthest one way.
fn without_rounding<const D: usize>(part: &[[f64; D]]) -> SmallVec<[[f64; D]; 8]> {
    let mut corners: SmallVec<[[f64; D]; 8]> = SmallVec::from_slice(part);
    let stands_out = |corners: &[[f64; D]], k: usize| {
        let count = corners.len();
        let [p, q, r] = [count - 1, 0, 1].map(|step| corners[(k + step) % count]);
        let [[a, b], [c, d]] = [q, r].map(|x| [x[1] - p[1], x[D - 1] - p[D - 1]]);
        (a * d - b * c).abs() > ROUNDING
    };
    while let Some(k) = (0..corners.len()).find(|&k| !stands_out(&corners, k)) {
        corners.remove(k);
    }
    let along = |w: &[f64; D]| WAY[0] * w[1] + WAY[1] * w[D - 1];
    let first = (0..corners.len()).max_by(|&p, &q| along(&corners[p]).total_cmp(&along(&corners[q])));
    corners.rotate_left(first.unwrap_or_default());
    corners
}
