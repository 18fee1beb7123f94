//! Contact points from those of the laws.

use super::point_of_contact::{PointOfContact, SideOfPoint};
use crate::geometry::Vector;
use crate::overlap::{ContactPoints, DepthPoint, Pair, Partner, PlaceInCell, SurfacePoint, nodes_of};

/// The contact points of a pair; `pressure` is a function of the penetration.
pub(crate) fn points_of_contact<const D: usize>(
    points: &ContactPoints<D>,
    pair: &Pair<D>,
    pressure: impl Fn(f64) -> f64,
) -> Vec<PointOfContact<D>> {
    let is_second = |end: &SurfacePoint<D>| !matches!(end, SurfacePoint::Facet { of_b: false, .. });
    (points.points.iter())
        .map(|point| {
            let mut ends = point.ends;
            if is_second(&ends[0]) && !is_second(&ends[1]) {
                ends.swap(0, 1);
            }
            let sides = ends.each_ref().map(|end| side_of_point(pair, end));
            let along = points.patches.directions[point.direction as usize];
            let normal = if along.dot(&pair.normal_at(&ends[0])) < 0.0 { -along } else { along };
            PointOfContact {
                partners: pair.partners,
                position: std::array::from_fn(|i| 0.5 * (sides[0].position[i] + sides[1].position[i])),
                normal: normal.into(),
                gap: -point.length,
                pressure: pressure(point.length),
                area: point.weight,
                patch: point.direction as usize,
                sides,
            }
        })
        .collect()
}

fn side_of_point<const D: usize>(pair: &Pair<D>, end: &SurfacePoint<D>) -> SideOfPoint<D> {
    let mut side = SideOfPoint::at(&pair.position(end));
    let SurfacePoint::Facet { of_b, facet, weights } = *end else { return side };
    let Partner::Body(body) = pair.partners[usize::from(of_b)] else { return side };
    let in_surface = pair.surface.ranges[body].start + facet as usize;
    side.cell = pair.surface.facet_cell.get(in_surface).map(|&cell| cell as usize);
    for (&vertex, weight) in pair.side(of_b).facets[facet as usize].iter().zip(weights) {
        nodes_of(pair.surface, vertex, |node, part| {
            let known = side.nodes[..side.node_count].iter().position(|&n| n == node);
            let place = known.unwrap_or_else(|| {
                side.nodes[side.node_count] = node;
                side.node_count += 1;
                side.node_count - 1
            });
            side.weights[place] += weight * part;
        });
    }
    side
}

/// The same of the law `depth`.
pub(crate) fn points_of_depth<const D: usize>(
    points: &[DepthPoint<D>],
    pair: &Pair<D>,
    pressure: impl Fn(f64) -> f64,
) -> Vec<PointOfContact<D>> {
    (points.iter())
        .map(|point| {
            let &DepthPoint { of_b, facet, weights, .. } = point;
            let own = side_of_point(pair, &SurfacePoint::Facet { of_b, facet, weights });
            let position = own.position;
            let mut sides = [own, SideOfPoint::at(&position.into())];
            if let (Some(place), Some(cells)) = (&point.other, &pair.surface.cells) {
                sides[1].take_place(place, cells.nodes(place.cell as usize));
            }
            if of_b {
                sides.swap(0, 1);
            }
            PointOfContact {
                partners: pair.partners,
                position,
                normal: point.normal.map(|n| if of_b { -n } else { n }),
                gap: -point.depth,
                pressure: pressure(point.depth),
                area: point.area,
                patch: 0,
                sides,
            }
        })
        .collect()
}

impl<const D: usize> SideOfPoint<D> {
    /// A place that belongs to no cell.
    fn at(position: &Vector<D>) -> Self {
        Self { position: (*position).into(), cell: None, node_count: 0, nodes: [0; 8], weights: [0.0; 8] }
    }

    fn take_place(&mut self, place: &PlaceInCell, nodes: &[u32]) {
        self.cell = Some(place.cell as usize);
        self.node_count = nodes.len();
        self.nodes[..nodes.len()].copy_from_slice(nodes);
        self.weights = place.weights;
    }
}
