//! Second derivative of the exact volume.
//!
//! ∂V/∂x_a = Σ_f ∫_{f ∩ B} N_a n dA changes in two ways. At a fixed region of the facet its area vector changes,
//!
//! ```text
//! M_a ∂A/∂x_b,        M_a = ∫ N_a over the region, the whole facet having measure 1
//! ```
//!
//! and along the curve C in which f of one side meets g of the other at the angle θ the region's rim moves:
//!
//! ```text
//! δ(∂V/∂x_a)|_C = ∫_C N_a n_f [n_g·(δx_g − δx_f) / sin θ] dl
//! ```
//!
//! It grows without bound as the facets become parallel: in flat contact there is no usable tangent. Not for a body
//! against itself, nor for bodies that are folded.

use super::clipper::Clipped;
use super::volume::ExactPair;
use crate::Error;
use crate::geometry::aabb::Aabb;
use crate::geometry::convex_piece::{whole, zeros};
use crate::geometry::facet::area_vector;
use crate::geometry::tree::Tree;
use crate::geometry::{Shape, Vector};
use crate::overlap::pair::sides::{Counterpart, FacetSide, ImplicitSide};
use crate::overlap::points::hessian::{Block, merged, nodes_of};

/// What moves a point: nodes with weights.
type Weights = Vec<(u32, f64)>;

/// Below this sine of the angle between two facets they do not cross in a curve.
const PARALLEL: f64 = 1e-12;

impl<const D: usize> ExactPair<'_, D> {
    /// Hessian of the overlap volume, as blocks sorted by row and column; the translation of the pair's obstacle has the
    /// number `obstacle_node`.
    pub(crate) fn hessian(&self, obstacle_node: u32) -> Result<Vec<Block<D>>, Error> {
        let mut blocks = Vec::new();
        let Some(found) = self.clipped()? else { return Ok(blocks) };
        let Some((a, shares_a, _)) = found.sides.first() else { return Ok(blocks) };
        self.turn(a, shares_a, false, obstacle_node, &mut blocks);
        match &self.pair.counterpart {
            Counterpart::Facets(b) => {
                if let Some((_, shares_b, _)) = found.sides.get(1) {
                    self.turn(b, shares_b, true, obstacle_node, &mut blocks);
                }
                self.cross(a, b, &found.region, obstacle_node, &mut blocks);
            }
            Counterpart::Implicit(ImplicitSide { shape: Shape::HalfSpace, pose, .. }) => {
                let mut up = Vector::zeros();
                up[D - 1] = 1.0;
                let (normal, origin) = (pose.rotate(&up), Vector::from(pose.position));
                for facet in 0..a.facets.len() as u32 {
                    let corners = a.corners(facet as usize);
                    let Some(n) = area_vector(&corners).try_normalize(0.0) else { continue };
                    let ends = zeros(&whole::<D>(), &corners.map(|x| normal.dot(&(x - origin))));
                    self.silhouette(&ends, &corners, [n, normal], &mut blocks, |w| {
                        [self.weights(a, facet, false, w, obstacle_node), vec![(obstacle_node, 1.0)]]
                    });
                }
            }
            _ => return Err(Error::Unsupported { what: "the tangent of the exact volume of a body with itself" }),
        }
        Ok(merged(blocks))
    }

    /// Nodes of a facet with the weights of a point at barycentric coordinates `w`.
    fn weights(&self, side: &FacetSide<D>, facet: u32, of_b: bool, w: &[f64; D], obstacle_node: u32) -> Weights {
        if of_b && self.pair.pose.is_some() {
            return vec![(obstacle_node, 1.0)];
        }
        let mut weights = Vec::with_capacity(4);
        for (&vertex, &w) in side.facets[facet as usize].iter().zip(w) {
            nodes_of(self.pair.surface, vertex, |node, part| weights.push((node, part * w)));
        }
        weights
    }

    /// Derivative of the area vectors. On an obstacle they do not change with its place.
    fn turn(
        &self,
        side: &FacetSide<D>,
        shares: &[Clipped<D>],
        of_b: bool,
        obstacle_node: u32,
        blocks: &mut Vec<Block<D>>,
    ) {
        if of_b && self.pair.pose.is_some() {
            return;
        }
        for Clipped { share, .. } in shares {
            let corners = side.corners(share.facet as usize);
            let measure = area_vector(&corners).norm();
            if measure == 0.0 {
                continue;
            }
            let moments = share.shares.map(|s| s / measure);
            let unit = |a: usize| std::array::from_fn(|k| f64::from(u8::from(k == a)));
            let of_corner: Vec<Weights> =
                (0..D).map(|a| self.weights(side, share.facet, of_b, &unit(a), obstacle_node)).collect();
            for b in 0..D {
                let change = area_change(&corners, b);
                for (a, moment) in moments.iter().enumerate() {
                    for &(row, p) in &of_corner[a] {
                        for &(col, q) in &of_corner[b] {
                            let value = change.map(|r| r.map(|x| x * moment * p * q));
                            blocks.push(Block { row, col, value });
                        }
                    }
                }
            }
        }
    }

    /// Curves in which facets of both sides cross.
    fn cross(
        &self,
        a: &FacetSide<D>,
        b: &FacetSide<D>,
        region: &Aabb<D>,
        obstacle_node: u32,
        blocks: &mut Vec<Block<D>>,
    ) {
        let of_b = b.facets_in(region);
        let boxes: Vec<Aabb<D>> = of_b.iter().map(|&g| b.facet_box(g as usize)).collect();
        let tree = Tree::new(&boxes);
        for facet in a.facets_in(region) {
            let corners = a.corners(facet as usize);
            let Some(n) = area_vector(&corners).try_normalize(0.0) else { continue };
            let aabb = a.facet_box(facet as usize);
            let mut near = Vec::new();
            tree.visit(|b| b.meets(&aabb), |g| near.push(g));
            near.sort_unstable();
            for g in near {
                if !boxes[g as usize].meets(&aabb) {
                    continue;
                }
                let other = b.corners(of_b[g as usize] as usize);
                let Some(m) = area_vector(&other).try_normalize(0.0) else { continue };
                let ends = zeros(&whole::<D>(), &corners.map(|x| m.dot(&(x - other[0]))));
                let ends = within(&ends, &corners, &other, &m);
                self.silhouette(&ends, &corners, [n, m], blocks, |w| {
                    let point = (0..D).fold(Vector::zeros(), |sum, k| sum + corners[k] * w[k]);
                    let on_other = barycentric(&other, &m, &point);
                    [
                        self.weights(a, facet, false, w, obstacle_node),
                        self.weights(b, of_b[g as usize], true, &on_other, obstacle_node),
                    ]
                });
            }
        }
    }

    /// ∫ along the curve between `ends`, barycentric on the first of two facets with normals n: both facets' parts.
    fn silhouette(
        &self,
        ends: &[[f64; D]],
        corners: &[Vector<D>; D],
        [n, m]: [Vector<D>; 2],
        blocks: &mut Vec<Block<D>>,
        weights: impl Fn(&[f64; D]) -> [Weights; 2],
    ) {
        let (Some(first), Some(last)) = (ends.first(), ends.last()) else { return };
        let sine = (1.0 - n.dot(&m).powi(2)).max(0.0).sqrt();
        if sine < PARALLEL {
            return;
        }
        let place = |w: &[f64; D]| (0..D).fold(Vector::zeros(), |sum, k| sum + corners[k] * w[k]);
        let length = if D == 2 { 1.0 } else { (place(last) - place(first)).norm() };
        let offset = if D == 2 { 0.0 } else { 0.5 / 3f64.sqrt() };
        for s in [0.5 - offset, 0.5 + offset] {
            let w = std::array::from_fn(|k| first[k] + s * (last[k] - first[k]));
            let [of_f, of_g] = weights(&w);
            let factor = 0.5 * length / sine;
            // δ(∂V/∂x of f) = N n [m·(δg − δf)], and that of g with n and m exchanged.
            let mut add = |rows: &Weights, cols: &Weights, p: &Vector<D>, q: &Vector<D>, sign: f64| {
                for &(row, x) in rows {
                    for &(col, y) in cols {
                        let value =
                            std::array::from_fn(|i| std::array::from_fn(|j| sign * factor * x * y * p[i] * q[j]));
                        blocks.push(Block { row, col, value });
                    }
                }
            };
            add(&of_f, &of_g, &n, &m, 1.0);
            add(&of_f, &of_f, &n, &m, -1.0);
            add(&of_g, &of_f, &m, &n, 1.0);
            add(&of_g, &of_g, &m, &n, -1.0);
        }
    }
}

/// ∂A/∂x_b of the area vector.
fn area_change<const D: usize>(x: &[Vector<D>; D], b: usize) -> [[f64; D]; D] {
    let mut change = [[0.0; D]; D];
    if D == 2 {
        // A = (e_y, −e_x), e = x_1 − x_0.
        let sign = if b == 1 { 1.0 } else { -1.0 };
        (change[0][1], change[1][0]) = (sign, -sign);
        return change;
    }
    // A = ½ (x_0 × x_1 + x_1 × x_2 + x_2 × x_0), so that δA = ½ δx_b × (x_{b+1} − x_{b+2}).
    let w = (x[(b + 1) % D] - x[(b + 2) % D]) * 0.5;
    for i in 0..D {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        (change[i][j], change[i][k]) = (w[k], -w[j]);
    }
    change
}

/// Barycentric coordinates, in a facet with unit normal `n`, of a point in its plane.
fn barycentric<const D: usize>(x: &[Vector<D>; D], n: &Vector<D>, point: &Vector<D>) -> [f64; D] {
    let total = area_vector(x).dot(n);
    std::array::from_fn(|a| {
        let mut part = *x;
        part[a] = *point;
        area_vector(&part).dot(n) / total
    })
}

/// The part of a segment of facet `f` (2D: the point), given by its ends, that lies in the facet with corners `other`.
fn within<const D: usize>(
    ends: &[[f64; D]],
    f: &[Vector<D>; D],
    other: &[Vector<D>; D],
    n: &Vector<D>,
) -> Vec<[f64; D]> {
    let (Some(first), Some(last)) = (ends.first(), ends.last()) else { return Vec::new() };
    let on_other = |w: &[f64; D]| {
        let point = (0..D).fold(Vector::zeros(), |sum, k| sum + f[k] * w[k]);
        barycentric(other, n, &point)
    };
    let (p, q) = (on_other(first), on_other(last));
    let (mut from, mut to) = (0.0f64, 1.0f64);
    for a in 0..D {
        match (p[a] >= 0.0, q[a] >= 0.0) {
            (true, true) => {}
            (false, false) => return Vec::new(),
            (true, false) => to = to.min(p[a] / (p[a] - q[a])),
            (false, true) => from = from.max(p[a] / (p[a] - q[a])),
        }
    }
    if from >= to {
        return Vec::new();
    }
    [from, to].map(|s| std::array::from_fn(|k| first[k] + s * (last[k] - first[k]))).to_vec()
}
