//! What edges add to the derivatives of an exactly integrated local law: kinks of the gap, and silhouette edges.

use super::contact_point::ContactPoint;
use crate::geometry::Vector;
use crate::ranks::{Packed, packed};

/// A point at which L has a kink that moves with the nodes. Only where the integral over the lines is exact; there the
/// derivative of the force gains weight [ψ'(L) factor + ψ(L) blend] g gᵀ.
#[derive(Clone, Debug)]
pub(crate) struct GapKink<const D: usize> {
    /// Measure along the kink for which the point stands; 1 in 2D.
    pub(crate) weight: f64,
    /// Length of the span there.
    pub(crate) length: f64,
    pub(crate) factor: f64,
    /// Jump of the slope of the part that counts for the direction.
    pub(crate) blend: f64,
    /// g by anchor.
    pub(crate) gradient: Vec<(Anchor, Vector<D>)>,
}

/// What moves a point.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Anchor {
    /// A vertex of a side.
    Vertex { of_b: bool, vertex: u32 },
    /// The pose of the obstacle.
    Obstacle,
}

impl Packed for Anchor {
    fn pack(&self, bytes: &mut Vec<u8>) {
        match *self {
            Anchor::Vertex { of_b, vertex } => Some((of_b, vertex)),
            Anchor::Obstacle => None,
        }
        .pack(bytes);
    }

    fn unpack(bytes: &mut &[u8]) -> Option<Self> {
        let vertex = Option::<(bool, u32)>::unpack(bytes)?;
        Some(vertex.map_or(Anchor::Obstacle, |(of_b, vertex)| Anchor::Vertex { of_b, vertex }))
    }

    fn blank() -> Self {
        Anchor::Obstacle
    }
}

/// A point of such an edge.
#[derive(Clone, Debug)]
pub(crate) struct SilhouettePoint<const D: usize> {
    /// N by anchor.
    pub(crate) weights: Vec<(Anchor, f64)>,
    /// ν times the measure for which the point stands.
    pub(crate) across: Vector<D>,
    /// Unit vectors u and v across the lines; (u vᵀ − v uᵀ) `turn` is the second derivative, by the first node and the
    /// second, of what the edge sweeps. Zero in 2D.
    pub(crate) axes: [Vector<D>; 2],
    pub(crate) turn: f64,
    /// The two spans on this side, and the one past the edge, which counts with a minus.
    pub(crate) spans: [ContactPoint<D>; 3],
}

packed!(GapKink<D> { weight, length, factor, blend, gradient });
packed!(SilhouettePoint<D> { weights, across, axes, turn, spans });
