//! Second derivatives of sums over spans, in closed form.
//!
//! With the line o + t d fixed, a facet with corners x_a is crossed at barycentric N. Let m solve m·(x_b − x_c) = 0,
//! m·d = 1, and h_a solve h_a·(x_b − x_c) = δ_ab − δ_ac, h_a·d = 0. Then
//!
//! ```text
//! ∂t/∂x_a       =  N_a m
//! ∂²t/∂x_a∂x_b  = −(N_b m h_aᵀ + N_a h_b mᵀ)
//! ```
//!
//! so that a span of length L = t_leaving − t_entering adds ω [ψ'' ∇L ∇Lᵀ + ψ' ∇²L] on the nodes of two facets. The first
//! part alone is positive semidefinite. For sampled lines this is the derivative of the force; where the integral over
//! the lines is exact, the kinks of L along the edges of facets, which move with their nodes, add [`GapKink`]s.
//!
//! Where patches blend, the span counts with a part p, linear in N with slope η across the lines:
//!
//! ```text
//! ∂p/∂x_a       = −N_a η
//! ∂²p/∂x_a∂x_b  =  N_b η h_aᵀ + N_a h_b ηᵀ
//! ```
//!
//! and adds ω [p (ψ'' ∇L ∇Lᵀ + ψ' ∇²L) + ψ' (∇L ∇pᵀ + ∇p ∇Lᵀ) + ψ ∇²p].

use crate::geometry::facet_slopes::slopes;
use crate::geometry::{Surface, Vector};
use crate::overlap::pair::sides::Pair;
use crate::overlap::pair::surface_point::SurfacePoint;
use crate::overlap::points::contact_point::ContactPoint;
use crate::overlap::points::contact_points::ContactPoints;
use crate::overlap::points::edge_terms::{Anchor, GapKink};

/// A block ∂²w/∂x_row ∂x_col.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Block<const D: usize> {
    /// Node of the rows.
    pub row: u32,
    /// Node of the columns.
    pub col: u32,
    /// Entries, row by row.
    pub value: [[f64; D]; D],
}

/// What a node has to do with one end of a span.
#[derive(Clone, Copy)]
pub(crate) struct Share<const D: usize> {
    pub(crate) node: u32,
    /// N, and h with the sign of the end.
    pub(crate) weight: f64,
    h: Vector<D>,
}

/// One end of a span: ∂t/∂x = ±N m on its nodes, and ∂p/∂x = −N η.
pub(crate) struct EndShares<const D: usize> {
    pub(crate) shares: Vec<Share<D>>,
    pub(crate) m: Vector<D>,
    pub(crate) eta: Vector<D>,
    /// +1 where the line leaves, −1 where it enters.
    pub(crate) sign: f64,
}

/// Nodes of a surface's vertex with their parts: itself, or the four of a face about whose centroid it is.
pub(crate) fn nodes_of<const D: usize>(surface: &Surface<D>, vertex: u32, mut visit: impl FnMut(u32, f64)) {
    match surface.nodes.get(vertex as usize) {
        Some(&node) => visit(node, 1.0),
        None => {
            let corners = surface.centroids[vertex as usize - surface.nodes.len()];
            corners.iter().for_each(|&v| visit(surface.nodes[v as usize], 0.25));
        }
    }
}

impl<const D: usize> ContactPoints<D> {
    /// Hessian of Σ ω ψ(L), given ψ, ψ' and ψ'', as blocks sorted by row and column. The obstacle of the pair, if there
    /// is one, has the row and column number `obstacle_node`: its translation. `semidefinite` leaves out what can be
    /// negative.
    pub(crate) fn hessian(
        &self,
        pair: &Pair<D>,
        [value, slope, curvature]: [&dyn Fn(f64) -> f64; 3],
        semidefinite: bool,
        obstacle_node: u32,
    ) -> Vec<Block<D>> {
        let mut order: Vec<(Key, u32)> = self.spans.iter().zip(0..).map(|(span, index)| (key(span), index)).collect();
        order.sort_unstable();
        let mut blocks = Vec::new();
        for group in order.chunk_by(|p, q| p.0 == q.0) {
            let mut local = Local::default();
            for &(_, index) in group {
                let span = &self.spans[index as usize];
                let Some(ends) = self.end_shares(pair, span, obstacle_node) else { continue };
                let mut factors = Factors { stiffness: span.weight * curvature(span.length), ..Factors::default() };
                if !semidefinite {
                    factors.geometric = span.weight * slope(span.length);
                    if ends.iter().any(|end| end.eta != Vector::<D>::zeros()) {
                        factors.mixed = span.across * slope(span.length);
                        factors.blend = span.across * value(span.length);
                    }
                }
                local.add(&ends, &factors);
            }
            local.write(&mut blocks);
        }
        if !semidefinite {
            for kink in &self.kinks {
                let factor = slope(kink.length) * kink.factor + value(kink.length) * kink.blend;
                add_kink(pair, kink, factor, obstacle_node, &mut blocks);
            }
            for silhouette in &self.silhouettes {
                self.add_silhouette(pair, silhouette, [value, slope], obstacle_node, &mut blocks);
            }
        }
        merged(blocks)
    }

    pub(crate) fn end_shares(
        &self,
        pair: &Pair<D>,
        span: &ContactPoint<D>,
        obstacle_node: u32,
    ) -> Option<[EndShares<D>; 2]> {
        let d = &self.patches.directions[span.direction as usize];
        let [before, behind] = self.blends(pair, span).map(|eta| eta.unwrap_or_else(Vector::zeros));
        let of = |end: &SurfacePoint<D>, sign: f64, eta: Vector<D>| match *end {
            SurfacePoint::Facet { of_b, facet, weights } => {
                let side = pair.side(of_b);
                let (m, h) = slopes(&side.corners(facet as usize), d)?;
                let mut shares: Vec<Share<D>> = Vec::with_capacity(4);
                if of_b && pair.pose.is_some() {
                    // All corners move alike: Σ N = 1, Σ h = 0.
                    shares.push(Share { node: obstacle_node, weight: 1.0, h: Vector::zeros() });
                    return Some(EndShares { shares, m, eta, sign });
                }
                for a in 0..D {
                    nodes_of(pair.surface, side.facets[facet as usize][a], |node, part| {
                        let place = shares.iter().position(|s| s.node == node).unwrap_or_else(|| {
                            shares.push(Share { node, weight: 0.0, h: Vector::zeros() });
                            shares.len() - 1
                        });
                        shares[place].weight += part * weights[a];
                        shares[place].h += h[a] * part;
                    });
                }
                Some(EndShares { shares, m, eta, sign })
            }
            SurfacePoint::Point { normal, .. } => {
                let slope = d.dot(&normal);
                let share = Share { node: obstacle_node, weight: 1.0, h: Vector::zeros() };
                (slope != 0.0).then(|| EndShares { shares: vec![share], m: normal / slope, eta, sign })
            }
        };
        Some([of(&span.ends[0], -1.0, before)?, of(&span.ends[1], 1.0, behind)?])
    }
}

/// Which facets a span lies between.
type Key = ([(bool, u32); 2], u32);

fn key<const D: usize>(span: &ContactPoint<D>) -> Key {
    let of = |end: &SurfacePoint<D>| match *end {
        SurfacePoint::Facet { of_b, facet, .. } => (of_b, facet),
        SurfacePoint::Point { .. } => (true, u32::MAX),
    };
    ([of(&span.ends[0]), of(&span.ends[1])], span.direction)
}

/// What the parts of a span's second derivative are multiplied by.
#[derive(Default)]
struct Factors {
    /// ω p ψ'', of ∇L ∇Lᵀ.
    stiffness: f64,
    /// ω p ψ', of ∇²L.
    geometric: f64,
    /// ω ψ', of ∇L ∇pᵀ + ∇p ∇Lᵀ.
    mixed: f64,
    /// ω ψ, of ∇²p.
    blend: f64,
}

/// The sum of the blocks of all spans between two facets.
#[derive(Default)]
struct Local<const D: usize> {
    nodes: Vec<u32>,
    /// Square, `nodes.len()` a side.
    values: Vec<[[f64; D]; D]>,
}

impl<const D: usize> Local<D> {
    fn add(&mut self, ends: &[EndShares<D>; 2], factors: &Factors) {
        if self.nodes.is_empty() {
            self.nodes = ends.iter().flat_map(|end| end.shares.iter().map(|share| share.node)).collect();
            self.values = vec![[[0.0; D]; D]; self.nodes.len().pow(2)];
        }
        let count = self.nodes.len();
        let mut row = 0;
        for p in ends {
            // Of ∇²: the same form for L, along m, and for the part, along η.
            let turning = p.eta * factors.blend - p.m * (factors.geometric * p.sign);
            let turns = factors.geometric != 0.0 || factors.blend != 0.0;
            for a in &p.shares {
                let mut col = 0;
                for q in ends {
                    let stiffness = factors.stiffness * p.sign * q.sign;
                    for b in &q.shares {
                        let block = &mut self.values[row * count + col];
                        for i in 0..D {
                            let along = stiffness * p.m[i] - factors.mixed * q.sign * p.eta[i];
                            let aside = factors.mixed * p.sign * p.m[i];
                            for j in 0..D {
                                block[i][j] += a.weight * b.weight * (along * q.m[j] - aside * q.eta[j]);
                            }
                        }
                        if turns && std::ptr::eq(p, q) {
                            for i in 0..D {
                                for j in 0..D {
                                    block[i][j] += b.weight * turning[i] * a.h[j] + a.weight * b.h[i] * turning[j];
                                }
                            }
                        }
                        col += 1;
                    }
                }
                row += 1;
            }
        }
    }

    fn write(&self, blocks: &mut Vec<Block<D>>) {
        for (r, &row) in self.nodes.iter().enumerate() {
            for (c, &col) in self.nodes.iter().enumerate() {
                blocks.push(Block { row, col, value: self.values[r * self.nodes.len() + c] });
            }
        }
    }
}

/// Nodes that move an anchor, with their parts of it.
pub(crate) fn for_each_node<const D: usize>(
    pair: &Pair<D>,
    anchor: Anchor,
    obstacle_node: u32,
    mut visit: impl FnMut(u32, f64),
) {
    match anchor {
        Anchor::Vertex { of_b: true, .. } if pair.pose.is_some() => visit(obstacle_node, 1.0),
        Anchor::Vertex { vertex, .. } => nodes_of(pair.surface, vertex, visit),
        Anchor::Obstacle => visit(obstacle_node, 1.0),
    }
}

/// factor g gᵀ of one point of a crease.
fn add_kink<const D: usize>(
    pair: &Pair<D>,
    kink: &GapKink<D>,
    factor: f64,
    obstacle_node: u32,
    blocks: &mut Vec<Block<D>>,
) {
    let mut gradient: Vec<(u32, Vector<D>)> = Vec::new();
    for (anchor, g) in &kink.gradient {
        for_each_node(pair, *anchor, obstacle_node, |node, part| gradient.push((node, g * part)));
    }
    let factor = kink.weight * factor;
    for (row, p) in &gradient {
        for (col, q) in &gradient {
            let value = std::array::from_fn(|i| std::array::from_fn(|j| factor * p[i] * q[j]));
            blocks.push(Block { row: *row, col: *col, value });
        }
    }
}

/// Blocks sorted by row and column, those of one place summed in the order in which they came.
pub(crate) fn merged<const D: usize>(mut blocks: Vec<Block<D>>) -> Vec<Block<D>> {
    blocks.sort_by_key(|block| (block.row, block.col));
    blocks.dedup_by(|next, sum| {
        let same = (next.row, next.col) == (sum.row, sum.col);
        if same {
            for i in 0..D {
                for j in 0..D {
                    sum.value[i][j] += next.value[i][j];
                }
            }
        }
        same
    });
    blocks
}
