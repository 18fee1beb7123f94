//! Second derivative of the exact volume.
//!
//! ∂V/∂x_a = Σ_f ∫_{f ∩ B} N_a n dA changes in two ways. At a fixed region of the facet its area vector changes,
//!
//! ```text
//! M_a ∂A/∂x_b,        M_a = ∫ N_a over the region, the whole facet having measure 1
//! ```
//!
//! and along the curve C in which f of one side meets g of the other at the angle θ the region's border moves:
//!
//! ```text
//! δ(∂V/∂x_a)|_C = ∫_C N_a n_f [n_g·(δx_g − δx_f) / sin θ] dl
//! ```
//!
//! It grows without bound as the facets become parallel: in flat contact there is no usable tangent. Where faces lie
//! flush the force has a jump, and no derivative: what is left of both terms has a symmetric part, which is returned.
//! Not for a body against itself, nor for bodies that are folded.

use super::clipper::Clipped;
use super::volume::{ClippedPair, Found};
use crate::Error;
use crate::configuration::FacetSide;
use crate::geometry::primitives::convex_piece::{whole, zeros};
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::primitives::plane::Plane;
use crate::geometry::{Vector, Weighting};
use crate::overlap::pair::overlap::Overlap;
use crate::overlap::pair::sides::Counterpart;
use crate::overlap::sums::block_sum::{Block, BlockSum, product, symmetric_part};

/// Below this sine of the angle between two facets they do not cross in a curve.
const PARALLEL: f64 = 1e-12;

/// Facets that a thread takes at once. Fixed, so that sums do not depend on the number of threads.
const CHUNK: usize = 256;

/// What moves a point: nodes, each with the corner it belongs to and its part of that corner.
type Movers = Vec<(u32, usize, f64)>;

impl<const D: usize> ClippedPair<'_, D> {
    /// The overlap, and the Hessian of its volume, as blocks sorted by row and column; the translation of the pair's
    /// obstacle has the number `obstacle_node`. `None` where the sides are apart.
    pub(crate) fn overlap_and_hessian(&self, obstacle_node: u32) -> Result<Option<(Overlap<D>, Vec<Block<D>>)>, Error> {
        let Some(found) = self.clipped()? else { return Ok(None) };
        let overlap = self.assemble(&found);
        if !overlap.has_volume() {
            return Ok(Some((overlap, Vec::new())));
        }
        if self.pair.is_own() {
            return Err(Error::Unsupported { what: "the tangent of the exact volume of a body with itself" });
        }
        Ok(Some((overlap, self.hessian(found, obstacle_node))))
    }

    fn hessian(&self, Found { sides, plane, region }: Found<D>, obstacle_node: u32) -> Vec<Block<D>> {
        let mut sum = BlockSum::default();
        for (side, shares, _) in &sides {
            let parts = self.in_chunks(shares, |share, sum| self.normal_variation(side, share, obstacle_node, sum));
            parts.into_iter().for_each(|part| sum.add_sum(part));
        }
        let a = &self.pair.a;
        let parts = match (&self.pair.counterpart, plane) {
            (Counterpart::Facets(b), _) => self.in_chunks(&a.facets_in(&region), |&facet, sum| {
                self.add_crossings(b, facet, obstacle_node, sum);
            }),
            (_, Some(plane)) => {
                let met = a.facets_where(|aabb| plane.least(aabb) <= 0.0);
                for clipped in sides.iter().flat_map(|(_, shares, _)| shares) {
                    self.add_shift_of_plane(clipped, obstacle_node, &mut sum);
                }
                self.in_chunks(&met, |&facet, sum| self.add_crossing_with(&plane, facet, obstacle_node, sum))
            }
            _ => Vec::new(),
        };
        parts.into_iter().for_each(|part| sum.add_sum(part));
        symmetric_part(sum.into_blocks())
    }

    /// Sums over chunks of some items, in their order.
    fn in_chunks<T: Sync>(&self, items: &[T], add: impl Fn(&T, &mut BlockSum<D>) + Sync) -> Vec<BlockSum<D>> {
        let of_chunk = |items: &[T]| {
            let mut sum = BlockSum::default();
            items.iter().for_each(|item| add(item, &mut sum));
            sum
        };
        self.pair.in_chunks(items, CHUNK, of_chunk)
    }

    /// Nodes that move a facet, by corner; an obstacle moves as a whole, as if it had one corner.
    fn movers(&self, side: &FacetSide<D>, facet: u32, of_b: bool, obstacle_node: u32) -> Movers {
        if of_b && self.pair.pose.is_some() {
            return vec![(obstacle_node, D, 1.0)];
        }
        let mut movers = Vec::with_capacity(4 * D);
        for (corner, &vertex) in side.facets[facet as usize].iter().enumerate() {
            movers.extend(self.pair.surface.nodes_of_vertex(vertex).map(|(node, part)| (node, corner, part)));
        }
        movers
    }

    /// Derivative of a facet's area vector, which does not change on an obstacle, and of its weight.
    fn normal_variation(
        &self,
        side: &FacetSide<D>,
        Clipped { share, spread, .. }: &Clipped<D>,
        obstacle_node: u32,
        sum: &mut BlockSum<D>,
    ) {
        let corners = side.corners(share.facet as usize);
        let measure = area_vector(&corners).norm();
        if measure > 0.0 && !self.pair.weighting.is_plain() {
            let outwards = self.pair.weighting.gradient::<D>();
            let moved = product(1.0 / outwards.norm(), &(area_vector(&corners) / measure), &outwards);
            let movers = self.movers(side, share.facet, share.of_b, obstacle_node);
            // What moves with corner D moves as a whole.
            let all = |row: &[f64; D]| row.iter().sum::<f64>();
            for &(row, a, p) in &movers {
                for &(col, b, q) in &movers {
                    let spread = if a == D { spread.iter().map(all).sum() } else { spread[a][b] };
                    sum.add(row, col, &moved.map(|r| r.map(|x| x * (spread * p * q))));
                }
            }
        }
        if measure == 0.0 || share.of_b && self.pair.pose.is_some() {
            return;
        }
        let moments = share.shares.map(|s| s / measure);
        let changes: [[[f64; D]; D]; D] = std::array::from_fn(|b| area_change(&corners, b));
        let movers = self.movers(side, share.facet, share.of_b, 0);
        for &(row, a, p) in &movers {
            for &(col, b, q) in &movers {
                sum.add(row, col, &changes[b].map(|r| r.map(|x| x * (moments[a] * p * q))));
            }
        }
    }

    /// What the change of the weight adds to the force on a plane: its part inside the body closes the boundary of the
    /// overlap.
    fn add_shift_of_plane(
        &self,
        Clipped { share, spread, .. }: &Clipped<D>,
        obstacle_node: u32,
        sum: &mut BlockSum<D>,
    ) {
        let outwards = self.pair.weighting.gradient::<D>();
        let normal = area_vector(&self.pair.a.corners(share.facet as usize)).try_normalize(0.0);
        if let (Some(normal), false) = (normal, self.pair.weighting.is_plain()) {
            let part = spread.as_flattened().iter().sum::<f64>() / outwards.norm();
            sum.add(obstacle_node, obstacle_node, &product(-part, &normal, &outwards));
        }
    }

    /// Curves in which a facet of the first side crosses facets of the second.
    fn add_crossings(&self, b: &FacetSide<D>, facet: u32, obstacle_node: u32, sum: &mut BlockSum<D>) {
        let a = &self.pair.a;
        let corners = a.corners(facet as usize);
        let Some(n) = area_vector(&corners).try_normalize(0.0) else { return };
        let of_f = self.movers(a, facet, false, obstacle_node);
        for g in b.facets_in(&a.facet_box(facet as usize)) {
            let other = b.corners(g as usize);
            let Some(m) = area_vector(&other).try_normalize(0.0) else { continue };
            let ends = zeros(&whole::<D>(), &corners.map(|x| m.dot(&(x - other[0]))));
            let ends = within(&ends, &corners, &other, &m);
            let on_other = |w: &[f64; D]| {
                let point = (0..D).fold(Vector::zeros(), |sum, k| sum + corners[k] * w[k]);
                barycentric(&other, &m, &point)
            };
            let of_g = self.movers(b, g, true, obstacle_node);
            add_curve(&ends, (&corners, self.pair.weighting), [n, m], [&of_f, &of_g], on_other, sum);
        }
    }

    /// The curve in which a facet crosses the plane of a half-space.
    fn add_crossing_with(&self, plane: &Plane<D>, facet: u32, obstacle_node: u32, sum: &mut BlockSum<D>) {
        let corners = self.pair.a.corners(facet as usize);
        let Some(n) = area_vector(&corners).try_normalize(0.0) else { return };
        let ends = zeros(&whole::<D>(), &corners.map(|x| plane.height(&x)));
        let of_f = self.movers(&self.pair.a, facet, false, obstacle_node);
        let (facet, of_plane) = ((&corners, self.pair.weighting), vec![(obstacle_node, D, 1.0)]);
        add_curve(&ends, facet, [n, plane.normal], [&of_f, &of_plane], |_| [0.0; D], sum);
    }
}

/// ∫ along the curve between `ends`, barycentric on the first of two facets with normals n: both facets' parts.
/// `on_other` gives the barycentric coordinates on the second.
fn add_curve<const D: usize>(
    ends: &[[f64; D]],
    (corners, weighting): (&[Vector<D>; D], Weighting),
    [n, m]: [Vector<D>; 2],
    [of_f, of_g]: [&Movers; 2],
    on_other: impl Fn(&[f64; D]) -> [f64; D],
    sum: &mut BlockSum<D>,
) {
    let (Some(first), Some(last)) = (ends.first(), ends.last()) else { return };
    let sine = (1.0 - n.dot(&m).powi(2)).max(0.0).sqrt();
    if sine < PARALLEL {
        return;
    }
    let place = |w: &[f64; D]| (0..D).fold(Vector::zeros(), |sum, k| sum + corners[k] * w[k]);
    let length = if D == 2 { 1.0 } else { (place(last) - place(first)).norm() };
    let offset = if D == 2 { 0.0 } else { 0.5 / 3f64.sqrt() };
    let factor = 0.5 * length / sine;
    // What moves with corner D moves as a whole.
    let weight = |w: &[f64; D], corner: usize, part: f64| if corner == D { part } else { w[corner] * part };
    let nodes: Vec<u32> = of_f.iter().chain(of_g).map(|mover| mover.0).collect();
    let (count, of_first) = (nodes.len(), of_f.len());
    let mut products = vec![0.0; count * count];
    let mut weights = vec![0.0; count];
    for s in [0.5 - offset, 0.5 + offset] {
        let w = std::array::from_fn(|k| first[k] + s * (last[k] - first[k]));
        let v = on_other(&w);
        let factor = factor * weighting.at(&place(&w));
        for (k, &(_, corner, part)) in of_f.iter().chain(of_g).enumerate() {
            weights[k] = weight(if k < of_first { &w } else { &v }, corner, part);
        }
        for (row, p) in weights.iter().enumerate() {
            for (product, q) in products[row * count..].iter_mut().zip(&weights) {
                *product += factor * p * q;
            }
        }
    }
    // δ(∂V/∂x of f) = N n [m·(δg − δf)], and that of g with n and m exchanged.
    let (of_n, of_m) = (product(1.0, &n, &m), product(1.0, &m, &n));
    let values: Vec<[[f64; D]; D]> = (0..count * count)
        .map(|k| {
            let (row, col) = (k / count, k % count);
            let base = if row < of_first { &of_n } else { &of_m };
            let sign = if (row < of_first) == (col < of_first) { -1.0 } else { 1.0 };
            base.map(|r| r.map(|x| sign * products[k] * x))
        })
        .collect();
    sum.add_square(&nodes, &values);
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
