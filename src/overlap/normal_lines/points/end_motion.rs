//! How one end of a contact point moves with the nodes of its facet.

use super::contact_point::ContactPoint;
use super::contact_points::ContactPoints;
use super::edge_terms::{Anchor, GapKink};
use crate::geometry::primitives::facet_slopes::slopes;
use crate::geometry::{Surface, Vector};
use crate::overlap::pair::sides::Pair;
use crate::overlap::pair::surface_point::SurfacePoint;
use crate::overlap::sums::block_sum::BlockSum;

/// One end of a contact point: ∂t/∂x_a = N_a m on its corners, and ∂p/∂x_a = −N_a η.
pub(crate) struct EndMotion<const D: usize> {
    corners: Corners<D>,
    pub(crate) m: Vector<D>,
    pub(crate) h: [Vector<D>; D],
    pub(crate) eta: Vector<D>,
    /// +1 where the line leaves, −1 where it enters.
    pub(crate) sign: f64,
}

/// What moves an end.
enum Corners<const D: usize> {
    /// The nodes of every corner, up to four, with their parts of it.
    Nodes([([u32; 4], u8); D]),
    /// A rigid shape as a whole.
    Obstacle(u32),
}

impl<const D: usize> EndMotion<D> {
    /// Number of corners: those of the facet, or one for a rigid shape.
    pub(crate) fn corner_count(&self) -> usize {
        if let Corners::Nodes(_) = self.corners { D } else { 1 }
    }

    /// Nodes of a corner with their parts of it.
    pub(crate) fn nodes(&self, corner: usize) -> impl Iterator<Item = (u32, f64)> + '_ {
        let (nodes, count) = match &self.corners {
            Corners::Nodes(corners) => corners[corner],
            Corners::Obstacle(node) => ([*node; 4], 1),
        };
        (0..count as usize).map(move |k| (nodes[k], 1.0 / f64::from(count)))
    }

    /// N by corner of the end of this kind among the two of a point; a rigid shape has N = 1 in its one corner.
    pub(crate) fn weights_of(&self, ends: &[SurfacePoint<D>; 2]) -> [f64; D] {
        match (&self.corners, &ends[usize::from(self.sign > 0.0)]) {
            (Corners::Nodes(_), SurfacePoint::Facet { weights, .. }) => *weights,
            _ => std::array::from_fn(|a| f64::from(u8::from(a == 0))),
        }
    }
}

/// Nodes of a surface's vertex: itself, or the four of a face about whose centroid it is.
fn nodes_at<const D: usize>(surface: &Surface<D>, vertex: u32) -> ([u32; 4], u8) {
    match surface.nodes.get(vertex as usize) {
        Some(&node) => ([node; 4], 1),
        None => {
            let corners = surface.centroids[vertex as usize - surface.nodes.len()];
            (corners.map(|v| surface.nodes[v as usize]), 4)
        }
    }
}

impl<const D: usize> ContactPoints<D> {
    /// The motions of a point's two ends; `None` where a facet is seen edge-on.
    pub(crate) fn end_motions(
        &self,
        pair: &Pair<D>,
        point: &ContactPoint<D>,
        obstacle_node: u32,
    ) -> Option<[EndMotion<D>; 2]> {
        let d = &self.patches.directions[point.direction as usize];
        let [before, behind] = self.blends(pair, point).map(|eta| eta.unwrap_or_else(Vector::zeros));
        let of = |end: &SurfacePoint<D>, sign: f64, eta: Vector<D>| match *end {
            SurfacePoint::Facet { of_b, facet, .. } => {
                let side = pair.side(of_b);
                let (m, h) = slopes(&side.corners(facet as usize), d)?;
                if of_b && pair.pose.is_some() {
                    // All corners move alike: Σ N = 1, Σ h = 0.
                    let corners = Corners::Obstacle(obstacle_node);
                    return Some(EndMotion { corners, m, h: [Vector::zeros(); D], eta, sign });
                }
                let corners = Corners::Nodes(side.facets[facet as usize].map(|v| nodes_at(pair.surface, v)));
                Some(EndMotion { corners, m, h, eta, sign })
            }
            SurfacePoint::Point { normal, .. } => {
                let slope = d.dot(&normal);
                let corners = Corners::Obstacle(obstacle_node);
                (slope != 0.0).then(|| EndMotion { corners, m: normal / slope, h: [Vector::zeros(); D], eta, sign })
            }
        };
        Some([of(&point.ends[0], -1.0, before)?, of(&point.ends[1], 1.0, behind)?])
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
        Anchor::Vertex { vertex, .. } => {
            pair.surface.nodes_of_vertex(vertex).for_each(|(node, part)| visit(node, part));
        }
        Anchor::Obstacle => visit(obstacle_node, 1.0),
    }
}

impl<const D: usize> GapKink<D> {
    /// Adds factor g gᵀ.
    pub(crate) fn add_to(&self, pair: &Pair<D>, factor: f64, obstacle_node: u32, sum: &mut BlockSum<D>) {
        let mut gradient: Vec<(u32, Vector<D>)> = Vec::with_capacity(2 * D);
        for (anchor, g) in &self.gradient {
            for_each_node(pair, *anchor, obstacle_node, |node, part| gradient.push((node, g * part)));
        }
        let factor = self.weight * factor;
        for (row, p) in &gradient {
            for (col, q) in &gradient {
                sum.add_product(*row, *col, factor, p, q);
            }
        }
    }
}
