//! The overlap of a body with a convex solid, and the depth summed over it, from the body's facets alone.
//!
//! The points for which face i is the nearest make a convex region R, bounded by i and by planes that halve the angles
//! between i and other faces. A line along the normal m of i meets R, if at all, from the face down to a depth D, so
//! that
//!
//! ```text
//! U(x) = measure of R on the line above x,    m·∇U = −1 in R, 0 else:   |A ∩ R| = −∮_∂A U m·n dA
//!                                                                ∫_{A∩R} g dx = −∮_∂A ½ U² m·n dA
//! ```
//!
//! U is the depth below i in R and D below R, a minimum of linear functions. Where the body has most of its facets below R,
//! the same is done with the measure below x, which is D above the face and 0 below R. What is summed is then of the size
//! of the overlap, however thin it is.

use super::convex_solid::{ConvexSolid, Linear};
use super::facet_part::FacetPart;
use super::least_of::{candidates, cut_to_least};
use crate::configuration::FacetSide;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::convex_piece::{Piece, place};
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::primitives::quadrature::for_each_gauss_point;
use crate::geometry::{Vector, Weighting};
use crate::overlap::pair::sides::Pair;
use std::ops::AddAssign;

/// Volume of the overlap, and the depth summed over it, both weighted.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct DepthSum {
    pub(crate) volume: f64,
    pub(crate) depth: f64,
    /// The latter not weighted, where there is a weight.
    pub(crate) bare_depth: f64,
    /// Nor the volume.
    pub(crate) bare_volume: f64,
}

/// Faces that a thread takes at once.
const CHUNK: usize = 16;

/// The lines through one face.
struct Column<'a, const D: usize> {
    solid: &'a ConvexSolid<'a, D>,
    face: u32,
    height: Linear<D>,
    /// Depth down to the planes that halve the angles with the faces at its edges, of the foot of a point on this face.
    ends: Vec<Linear<D>>,
    /// No point of the region is deeper.
    deepest: f64,
}

impl<const D: usize> ConvexSolid<'_, D> {
    /// Sums over the overlap with the body of a pair.
    pub(crate) fn sums(&self, pair: &Pair<D>) -> DepthSum {
        let body = &pair.a;
        let rounding = body.aabb.rounding();
        let of_faces = |faces: &[u32]| {
            let (mut sums, mut work) = (DepthSum::default(), Piece::default());
            for &face in faces {
                let column = self.column(face);
                // On whichever side of the region less of the body lies; from above no line is longer than a facet is deep, so
                // that few other faces are of any account.
                let lists = [true, false].map(|from_above| column.facets(body, from_above));
                let from_above = lists[0].len() <= lists[1].len();
                let facets = &lists[usize::from(!from_above)];
                for &facet in facets {
                    let corners = body.corners(facet as usize);
                    let mut parts = vec![FacetPart::whole()];
                    while let Some(part) = parts.pop() {
                        let at = part.corners(&corners);
                        let Some(functions) = column.functions(&at, from_above) else { continue };
                        match part.halves(&corners, functions.len()) {
                            Some(halves) => parts.extend(halves),
                            None => {
                                sums +=
                                    column.flux(&at, (from_above, pair.weighting), &functions, (rounding, &mut work))
                            }
                        }
                    }
                }
            }
            sums
        };
        let mut all = DepthSum::default();
        pair.on_threads(&self.faces_near(&body.aabb), CHUNK, of_faces).into_iter().for_each(|sums| all += sums);
        all
    }

    fn column(&self, face: u32) -> Column<'_, D> {
        let ends = self.neighbours(face).iter().filter_map(|&other| self.end(face, other)).collect();
        Column { solid: self, face, height: self.heights[face as usize], ends, deepest: self.deepest(face) }
    }
}

impl<const D: usize> Column<'_, D> {
    /// Facets of a body that count.
    fn facets(&self, body: &FacetSide<D>, from_above: bool) -> Vec<u32> {
        let is_in = |aabb: &Aabb<D>| self.ends.iter().all(|end| end.largest(aabb) > 0.0);
        body.facets_where(|aabb| {
            let counts =
                if from_above { self.height.least(aabb) < 0.0 } else { self.height.largest(aabb) > -self.deepest };
            counts && is_in(aabb)
        })
    }

    /// Measure of the region on the lines through a facet, at its corners: the least of these functions where that is positive;
    /// `None` if it is so nowhere.
    fn functions(&self, corners: &[Vector<D>; D], from_above: bool) -> Option<Vec<[f64; D]>> {
        let depth: [f64; D] = corners.each_ref().map(|x| -self.height.at(x));
        let limit = if from_above { depth.iter().copied().fold(f64::NEG_INFINITY, f64::max) } else { f64::INFINITY };
        let mut functions = self.solid.ends(self.face, corners, limit)?;
        if from_above {
            functions.push(depth);
        }
        let near = candidates(&functions)?;
        Some(near.iter().map(|&k| functions[k]).collect())
    }

    /// What a facet adds, or a part of one, on which the measure is the least of some functions.
    fn flux(
        &self,
        corners: &[Vector<D>; D],
        (from_above, weighting): (bool, Weighting),
        functions: &[[f64; D]],
        (rounding, work): (f64, &mut Piece<D>),
    ) -> DepthSum {
        let across = self.height.slope.dot(&area_vector(corners));
        if across == 0.0 {
            return DepthSum::default();
        }
        let depth: [f64; D] = corners.each_ref().map(|x| -self.height.at(x));
        // Of the foot of a line on the face, and how it changes down the line.
        let weight = |w: &[f64; D]| {
            let x = place(corners, w);
            [weighting.at(&(x - self.height.slope * self.height.at(&x))), -self.height.slope.dot(&weighting.gradient())]
        };
        let mut sums = DepthSum::default();
        for k in 0..functions.len() {
            let end = &functions[k];
            if from_above {
                if cut_to_least(functions, k, rounding, work) {
                    sums.add(work, -across, |w| [value(w, end), 0.0], weight);
                }
                continue;
            }
            // Above the face all of the region lies below x; in it, what is left from x down.
            for above in [true, false] {
                if !cut_to_least(functions, k, rounding, work) {
                    continue;
                }
                let is_left = if above {
                    depth.iter().all(|d| *d <= 0.0) || depth.iter().any(|d| *d < 0.0) && work.cut(&depth)
                } else {
                    let beyond: [f64; D] = std::array::from_fn(|c| depth[c] - end[c]);
                    depth.iter().any(|d| *d > 0.0) && work.cut(&depth.map(|d| -d)) && work.cut(&beyond)
                };
                if is_left {
                    sums.add(work, across, |w| [value(w, end), if above { 0.0 } else { value(w, &depth) }], weight);
                }
            }
        }
        sums
    }
}

fn value<const D: usize>(w: &[f64; D], at_corners: &[f64; D]) -> f64 {
    (0..D).map(|c| w[c] * at_corners[c]).sum()
}

impl DepthSum {
    /// Adds ∫ of the measure of a line between two depths over a piece of a facet, and of the depth along it; `weight` is
    /// linear along it.
    fn add<const D: usize>(
        &mut self,
        piece: &Piece<D>,
        across: f64,
        between: impl Fn(&[f64; D]) -> [f64; 2],
        weight: impl Fn(&[f64; D]) -> [f64; 2],
    ) {
        for_each_gauss_point(piece.corners(), false, |w, part| {
            let [low, high] = between(w);
            let [at_foot, slope] = weight(w);
            let (length, moment) = (low - high, 0.5 * (low * low - high * high));
            self.volume += across * part * (at_foot * length + slope * moment);
            let second = slope * (low * low * low - high * high * high) / 3.0;
            self.depth += across * part * (at_foot * moment + second);
            self.bare_depth += across * part * moment;
            self.bare_volume += across * part * length;
        });
    }
}

impl DepthSum {
    /// All of it, multiplied.
    pub(super) fn times(&self, factor: f64) -> Self {
        Self {
            volume: self.volume * factor,
            depth: self.depth * factor,
            bare_depth: self.bare_depth * factor,
            bare_volume: self.bare_volume * factor,
        }
    }
}

impl AddAssign for DepthSum {
    fn add_assign(&mut self, other: Self) {
        self.volume += other.volume;
        self.depth += other.depth;
        self.bare_depth += other.bare_depth;
        self.bare_volume += other.bare_volume;
    }
}
