//! Contact points from those of the laws.

use super::point_of_contact::{PointOfContact, SideOfPoint};
use crate::contact::friction::PointFriction;
use crate::contact::laws::{PointOnSide, PressurePoint};
use crate::geometry::Vector;
use crate::overlap::{Pair, Partner, PlaceInCell, SurfacePoint, without_rounding};

/// The contact points of a pair, with what friction does at each; `None` without friction.
pub(crate) fn points_of_contact<const D: usize>(
    points: &[PressurePoint<D>],
    friction: Option<&[PointFriction<D>]>,
    pair: &Pair<D>,
) -> Vec<PointOfContact<D>> {
    let of_point = |(number, point): (usize, &PressurePoint<D>)| {
        let none = PointFriction { traction: Vector::zeros(), slip: Vector::zeros(), sliding: 0.0 };
        let friction = friction.map_or(none, |friction| friction[number]);
        let sides = point.sides.each_ref().map(|side| match side {
            PointOnSide::Surface(end) => of_surface(pair, end),
            PointOnSide::Cell(place) => in_cell(pair, place),
            PointOnSide::Rigid(position) => SideOfPoint::at(position),
        });
        PointOfContact {
            partners: pair.partners,
            position: std::array::from_fn(|i| 0.5 * (sides[0].position[i] + sides[1].position[i])),
            normal: point.normal.into(),
            gap: -point.penetration,
            pressure: point.pressure,
            area: point.area,
            friction: friction.traction.into(),
            slip: friction.slip.into(),
            sliding: friction.sliding,
            patch: point.patch,
            sides,
        }
    };
    points.iter().enumerate().map(of_point).collect()
}

fn of_surface<const D: usize>(pair: &Pair<D>, end: &SurfacePoint<D>) -> SideOfPoint<D> {
    let mut side = SideOfPoint::at(&pair.position(end));
    let SurfacePoint::Facet { of_b, facet, weights } = *end else { return side };
    let Partner::Body(body) = pair.partners[usize::from(of_b)] else { return side };
    let in_surface = pair.surface.ranges[body].start + facet as usize;
    side.cell = pair.surface.facet_cell.get(in_surface).map(|&cell| cell as usize);
    for (&vertex, weight) in pair.side(of_b).facets[facet as usize].iter().zip(weights) {
        pair.surface.nodes_of_vertex(vertex).for_each(|(node, part)| {
            let known = side.nodes[..side.node_count].iter().position(|&n| n == node);
            let place = known.unwrap_or_else(|| {
                side.nodes[side.node_count] = node;
                side.node_count += 1;
                side.node_count - 1
            });
            side.weights[place] += weight * part;
        });
    }
    without_rounding(&mut side.weights);
    side
}

fn in_cell<const D: usize>(pair: &Pair<D>, place: &PlaceInCell) -> SideOfPoint<D> {
    let nodes = pair.surface.cells.as_ref().map_or(&[][..], |cells| cells.nodes(place.cell as usize));
    let terms = nodes.iter().zip(&place.weights).map(|(&n, &weight)| Vector::from(pair.coords[n as usize]) * weight);
    let mut side = SideOfPoint::at(&terms.fold(Vector::zeros(), |x, term| x + term));
    side.cell = Some(place.cell as usize);
    side.node_count = nodes.len();
    side.nodes[..nodes.len()].copy_from_slice(nodes);
    side.weights = place.weights;
    without_rounding(&mut side.weights);
    side
}

impl<const D: usize> SideOfPoint<D> {
    /// A place that belongs to no cell.
    fn at(position: &Vector<D>) -> Self {
        Self { position: (*position).into(), cell: None, node_count: 0, nodes: [0; 8], weights: [0.0; 8] }
    }
}
