//! Friction as hosts see it: at the contact points, and at the nodes of the facets on which they lie.

use super::carriers::{Carriers, in_surface};
use super::slip_facets::SlipFacets;
use crate::contact::laws::{PointOnSide, PressurePoint};
use crate::geometry::Vector;
use crate::overlap::{Pair, SurfacePoint};

/// Friction at a contact point: that of the facets on which it lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct PointFriction<const D: usize> {
    /// Traction on the first side, by the area of the point.
    pub(crate) traction: Vector<D>,
    /// Slip of the first side against the second since the step began that was not elastic.
    pub(crate) slip: Vector<D>,
    /// Part of the point's area that slides.
    pub(crate) sliding: f64,
}

/// What a point adds to a node of the facet on which it lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct NodalFriction<const D: usize> {
    pub(crate) node: u32,
    /// ∫ N dA.
    pub(crate) area: f64,
    /// ∫ N q dA, q the traction on the node's own side.
    pub(crate) force: Vector<D>,
    /// ∫ N dA over what slides.
    pub(crate) sliding: f64,
}

impl<const D: usize> SlipFacets<D> {
    /// Friction at every point from which these facets were made, in their order; zero where there is none.
    pub(crate) fn at_points(&self, pair: &Pair<D>, points: &[PressurePoint<D>]) -> Vec<PointFriction<D>> {
        let zero = Vector::zeros();
        let mut found = vec![PointFriction { traction: zero, slip: zero, sliding: 0.0 }; points.len()];
        self.for_each_share(pair, points, |point, share| {
            let (at, part) = (&mut found[point], share.part);
            at.traction -= share.traction * part;
            // Means over the facets; parts are those of areas, which lie in another plane.
            at.slip += share.slip * share.mean;
            at.sliding += share.mean * share.sliding;
        });
        found
    }

    /// What every point adds to the nodes of the facets on which it lies.
    pub(crate) fn at_nodes(&self, pair: &Pair<D>, points: &[PressurePoint<D>]) -> Vec<NodalFriction<D>> {
        let mut found = Vec::new();
        self.for_each_share(pair, points, |point, share| {
            let middle = points[point].middles[usize::from(share.of_b)];
            let PointOnSide::Surface(SurfacePoint::Facet { facet, weights, .. }) = middle else { return };
            let area = points[point].area * share.part;
            let force = share.traction * if share.of_b { area } else { -area };
            for (&vertex, weight) in pair.side(share.of_b).facets[facet as usize].iter().zip(weights) {
                for (node, part) in pair.surface.nodes_of_vertex(vertex) {
                    let shape = weight * part;
                    let sliding = shape * area * share.sliding;
                    found.push(NodalFriction { node, area: shape * area, force: force * shape, sliding });
                }
            }
        });
        found
    }

    /// Calls `visit(number of the point, its share in a facet)`.
    pub(super) fn for_each_share(
        &self,
        pair: &Pair<D>,
        points: &[PressurePoint<D>],
        mut visit: impl FnMut(usize, Share<D>),
    ) {
        for (number, point) in points.iter().enumerate() {
            let Some(carriers) = Carriers::of(pair, point) else { continue };
            let mean = 1.0 / carriers.facets().count() as f64;
            for (of_b, facet) in carriers.facets() {
                let Some(key) = in_surface(pair, of_b, facet).map(|facet| (of_b, facet)) else { continue };
                // Facets are in this order.
                let Ok(at) = self.facets.binary_search_by_key(&key, |facet| (facet.of_b, facet.facet)) else {
                    continue;
                };
                let facet = &self.facets[at];
                let traction = facet.slider.traction(&facet.trial);
                visit(
                    number,
                    Share {
                        of_b,
                        facet: facet.facet,
                        part: carriers.part,
                        mean,
                        traction: traction.value,
                        slip: facet.trial - traction.elastic,
                        way: facet.way(&traction),
                        sliding: f64::from(u8::from(traction.slides)),
                    },
                );
            }
        }
    }
}

/// What a facet does at a point.
pub(super) struct Share<const D: usize> {
    pub(super) of_b: bool,
    /// Its number in the surface.
    pub(super) facet: usize,
    /// Part of the point's area.
    pub(super) part: f64,
    /// One by the number of facets on which the point lies.
    mean: f64,
    /// By which the first side is held back.
    traction: Vector<D>,
    slip: Vector<D>,
    /// The way by which its pressure now wears what the step did.
    pub(super) way: f64,
    /// 1 where the facet slides, else 0.
    sliding: f64,
}
