//! Contact points, as hosts and outputs see them.

use crate::geometry::Vector;
use crate::overlap::{ContactPoints, Pair, Partner, SurfacePoint, nodes_of};

/// A point of the contact: a piece of a line inside both sides, from the boundary of one to that of the other, and the
/// area for which it stands. Laws that act at contact points have them (`fiber`).
#[derive(Clone, Debug, PartialEq)]
pub struct PointOfContact<const D: usize> {
    /// The two sides.
    pub partners: [Partner; 2],
    /// Middle of the piece.
    pub position: [f64; D],
    /// Unit vector along the line, outwards of the first side.
    pub normal: [f64; D],
    /// Minus the penetration, the length of the piece.
    pub gap: f64,
    /// Contact pressure.
    pub pressure: f64,
    /// Area (2D: length) across the line; the resultant on the first side is −Σ pressure · area · normal where its
    /// facets lie across the lines.
    pub area: f64,
    /// Number of the patch within the pair: points of one patch have one normal, up to its sign.
    pub patch: usize,
    /// The end on the boundary of either side, in the order of `partners`.
    pub sides: [SideOfPoint<D>; 2],
}

/// One end of a contact point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SideOfPoint<const D: usize> {
    /// Where.
    pub position: [f64; D],
    /// Cell of the mesh, counted over all blocks; `None` for an obstacle, and for a surface without cells.
    pub cell: Option<usize>,
    /// How many of `nodes` and `weights` are used: those of the boundary face; 0 for an obstacle.
    pub node_count: usize,
    /// Nodes of the mesh.
    pub nodes: [u32; 4],
    /// Values of their shape functions here: Σ weights · coordinates is `position`, and a force here goes to the nodes
    /// by these parts.
    pub weights: [f64; 4],
}

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
    let position: Vector<D> = pair.position(end);
    let mut side =
        SideOfPoint { position: position.into(), cell: None, node_count: 0, nodes: [0; 4], weights: [0.0; 4] };
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
