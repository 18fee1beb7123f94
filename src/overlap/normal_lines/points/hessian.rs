//! Second derivatives of sums over contact points, in closed form.
//!
//! With the line o + t d fixed, a facet with corners x_a is crossed at barycentric N. Let m solve m·(x_b − x_c) = 0,
//! m·d = 1, and h_a solve h_a·(x_b − x_c) = δ_ab − δ_ac, h_a·d = 0. Then
//!
//! ```text
//! ∂t/∂x_a       =  N_a m
//! ∂²t/∂x_a∂x_b  = −(N_b m h_aᵀ + N_a h_b mᵀ)
//! ```
//!
//! so that a point of penetration L = t_leaving − t_entering adds ω [ψ'' ∇L ∇Lᵀ + ψ' ∇²L] on the nodes of two facets.
//! The first part alone is positive semidefinite. For sampled lines this is the derivative of the force; where the
//! integral over the lines is exact, the kinks of L along the edges of facets, which move with their nodes, add
//! [`GapKink`](super::edge_terms::GapKink)s.
//!
//! Where patches blend, the point counts with a part p, linear in N with slope η across the lines:
//!
//! ```text
//! ∂p/∂x_a       = −N_a η
//! ∂²p/∂x_a∂x_b  =  N_b η h_aᵀ + N_a h_b ηᵀ
//! ```
//!
//! and adds ω [p (ψ'' ∇L ∇Lᵀ + ψ' ∇²L) + ψ' (∇L ∇pᵀ + ∇p ∇Lᵀ) + ψ ∇²p].
//!
//! m, h and η are those of the facets, so that all points between two facets need their sums over N_a N_b and N_a only.

use super::contact_point::ContactPoint;
use super::contact_points::ContactPoints;
use super::end_motion::EndMotion;
use crate::overlap::pair::sides::Pair;
use crate::overlap::pair::surface_point::SurfacePoint;
use crate::overlap::sums::block_sum::{Block, BlockSum};

/// A function of the penetration.
pub(crate) type OfLength<'a> = &'a (dyn Fn(f64) -> f64 + Sync);

/// Pairs of facets that a thread takes at once. Fixed, so that sums do not depend on the number of threads.
const CHUNK: usize = 512;

impl<const D: usize> ContactPoints<D> {
    /// Hessian of Σ ω ψ(L), given ψ, ψ' and ψ'', as blocks sorted by row and column. The obstacle of the pair, if there
    /// is one, has the row and column number `obstacle_node`: its translation. `semidefinite` leaves out what can be
    /// negative.
    pub(crate) fn hessian(
        &self,
        pair: &Pair<D>,
        functions: [OfLength; 3],
        semidefinite: bool,
        obstacle_node: u32,
    ) -> Vec<Block<D>> {
        let mut order: Vec<(Key, u32)> = self.points.iter().zip(0..).map(|(p, index)| (key(p, index), index)).collect();
        pair.sharing.sort(&mut order);
        let groups: Vec<&[(Key, u32)]> = order.chunk_by(|p, q| p.0 == q.0).collect();
        let of_chunk = |groups: &[&[(Key, u32)]]| {
            let mut sum = BlockSum::default();
            for group in groups {
                self.add_group(pair, group, functions, semidefinite, obstacle_node, &mut sum);
            }
            sum
        };
        let mut sum = BlockSum::default();
        pair.in_chunks(&groups, CHUNK, of_chunk).into_iter().for_each(|chunk| sum.add_sum(chunk));
        if !semidefinite {
            let [value, slope, _] = functions;
            for kink in &self.kinks {
                let factor = slope(kink.length) * kink.factor + value(kink.length) * kink.blend;
                kink.add_to(pair, factor, obstacle_node, &mut sum);
            }
            for silhouette in &self.silhouettes {
                self.add_silhouette(pair, silhouette, [value, slope], obstacle_node, &mut sum);
            }
        }
        sum.into_blocks()
    }

    /// Adds what all points between two facets contribute.
    fn add_group(
        &self,
        pair: &Pair<D>,
        group: &[(Key, u32)],
        [value, slope, curvature]: [OfLength; 3],
        semidefinite: bool,
        obstacle_node: u32,
        sum: &mut BlockSum<D>,
    ) {
        let point = |index: u32| &self.points[index as usize];
        let Some(ends) = self.end_motions(pair, point(group[0].1), obstacle_node) else { return };
        let has_blend = !semidefinite && ends.iter().any(|end| end.eta.amax() > 0.0);
        let mut sums = Sums::<D>::default();
        for &(_, index) in group {
            let point = point(index);
            let weights = ends.each_ref().map(|end| end.weights_of(&point.ends));
            let stiffness = point.weight * curvature(point.length);
            let slope = if semidefinite { 0.0 } else { slope(point.length) };
            let mixed = if has_blend { point.across * slope } else { 0.0 };
            let blend = if has_blend { point.across * value(point.length) } else { 0.0 };
            for p in 0..2 {
                for a in 0..D {
                    sums.geometric[p][a] += point.weight * slope * weights[p][a];
                    sums.blend[p][a] += blend * weights[p][a];
                    for q in 0..2 {
                        for b in 0..D {
                            let product = weights[p][a] * weights[q][b];
                            sums.stiffness[p][a][q][b] += stiffness * product;
                            sums.mixed[p][a][q][b] += mixed * product;
                        }
                    }
                }
            }
        }
        sums.add_to(&ends, sum);
    }
}

/// Which facets a point lies between, and along which direction. A rigid shape is curved: its points stand alone.
type Key = ([(bool, u32); 2], u32);

fn key<const D: usize>(point: &ContactPoint<D>, index: u32) -> Key {
    let of = |end: &SurfacePoint<D>| match *end {
        SurfacePoint::Facet { of_b, facet, .. } => (of_b, facet),
        SurfacePoint::Point { .. } => (true, u32::MAX - index),
    };
    ([of(&point.ends[0]), of(&point.ends[1])], point.direction)
}

/// Sums over the points between two facets, by end and corner.
struct Sums<const D: usize> {
    /// ω p ψ'' N N, of ∇L ∇Lᵀ.
    stiffness: [[[[f64; D]; 2]; D]; 2],
    /// ω ψ' N N, of ∇L ∇pᵀ + ∇p ∇Lᵀ.
    mixed: [[[[f64; D]; 2]; D]; 2],
    /// ω p ψ' N, of ∇²L.
    geometric: [[f64; D]; 2],
    /// ω ψ N, of ∇²p.
    blend: [[f64; D]; 2],
}

impl<const D: usize> Default for Sums<D> {
    fn default() -> Self {
        let square = [[[[0.0; D]; 2]; D]; 2];
        Self { stiffness: square, mixed: square, geometric: [[0.0; D]; 2], blend: [[0.0; D]; 2] }
    }
}

impl<const D: usize> Sums<D> {
    /// Adds the blocks of all nodes that move the two ends.
    fn add_to(&self, ends: &[EndMotion<D>; 2], sum: &mut BlockSum<D>) {
        let corners: Vec<(usize, usize)> =
            (0..2).flat_map(|p| (0..ends[p].corner_count()).map(move |a| (p, a))).collect();
        let nodes: Vec<u32> = corners.iter().flat_map(|&(p, a)| ends[p].nodes(a).map(|(node, _)| node)).collect();
        let mut values = Vec::with_capacity(nodes.len() * nodes.len());
        for &(p, a) in &corners {
            for (_, of_row) in ends[p].nodes(a) {
                for &(q, b) in &corners {
                    let block = self.block(ends, (p, a), (q, b));
                    for (_, of_col) in ends[q].nodes(b) {
                        values.push(block.map(|row| row.map(|x| x * (of_row * of_col))));
                    }
                }
            }
        }
        sum.add_square(&nodes, &values);
    }

    /// The block of corner a of end p, and corner b of end q.
    fn block(&self, ends: &[EndMotion<D>; 2], (p, a): (usize, usize), (q, b): (usize, usize)) -> [[f64; D]; D] {
        let (of_p, of_q) = (&ends[p], &ends[q]);
        let stiffness = self.stiffness[p][a][q][b] * of_p.sign * of_q.sign;
        let mixed = self.mixed[p][a][q][b];
        let mut block = [[0.0; D]; D];
        for i in 0..D {
            let along = stiffness * of_p.m[i] - mixed * of_q.sign * of_p.eta[i];
            let aside = mixed * of_p.sign * of_p.m[i];
            for j in 0..D {
                block[i][j] = along * of_q.m[j] - aside * of_q.eta[j];
            }
        }
        if p == q {
            let turning = |c: usize| of_p.eta * self.blend[p][c] - of_p.m * (self.geometric[p][c] * of_p.sign);
            let (of_a, of_b) = (turning(a), turning(b));
            for i in 0..D {
                for j in 0..D {
                    block[i][j] += of_b[i] * of_p.h[a][j] + of_p.h[b][i] * of_a[j];
                }
            }
        }
        block
    }
}
