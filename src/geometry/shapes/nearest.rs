//! Nearest points of boundaries, by parry's point queries.

use super::faces::Faces;
use crate::geometry::primitives::aabb::Aabb;

/// From a point to whether it is inside and the nearest point of the boundary, in the frame of the shape.
pub(super) type Query<const D: usize> = Box<dyn Fn(&[f64; D]) -> (bool, [f64; D]) + Send + Sync>;

/// The query of a shape, and its least extent.
pub(crate) struct Nearest<const D: usize> {
    pub(super) point: Query<D>,
    pub(super) least: f64,
}

// parry's axis of revolution is y; exchanging y and z is its own inverse.
pub(super) const PLANE: [usize; 2] = [0, 1];
const SPACE: [usize; 3] = [0, 1, 2];
pub(super) const UPRIGHT: [usize; 3] = [0, 2, 1];

/// The query of a shape of parry, which has a crate for each dimension, with the same names in both.
macro_rules! by_parry {
    ($parry:ident, $dim:literal, $axes:expr, $shape:expr) => {{
        use $parry::query::PointQuery;
        let (shape, axes): (_, [usize; $dim]) = ($shape, $axes);
        let query: $crate::geometry::shapes::nearest::Query<D> = Box::new(move |x: &[f64; D]| {
            let found = shape.project_local_point(axes.map(|axis| x[axis]).into(), false);
            let point = found.point.to_array();
            (found.is_inside, std::array::from_fn(|axis| point[axes[axis]]))
        });
        query
    }};
}
pub(super) use by_parry;

/// The query of a closed surface; `None` where parry takes none of it.
pub(super) fn of_faces<const D: usize>(faces: &Faces<D>) -> Option<Nearest<D>> {
    let (points, facets) = (&faces.points, &faces.surface.facets);
    let least = Aabb::of(points).extent().min();
    let point = if D == 2 {
        let points = points.iter().map(|x| [x[0], x[1]].into()).collect();
        let facets = facets.iter().map(|f| [f[0], f[1]]).collect();
        by_parry!(parry2d_f64, 2, PLANE, polyline(points, facets))
    } else {
        let points = points.iter().map(|x| [x[0], x[1], x[2]].into()).collect();
        let facets = facets.iter().map(|f| [f[0], f[1], f[2]]).collect();
        by_parry!(parry3d_f64, 3, SPACE, mesh(points, facets)?)
    };
    Some(Nearest { point, least })
}

/// A closed polygon, with the normals at its corners that decide between inside and outside.
pub(super) fn polyline(points: Vec<parry2d_f64::math::Vector>, edges: Vec<[u32; 2]>) -> parry2d_f64::shape::Polyline {
    use parry2d_f64::shape::{Polyline, PolylineFlags};
    Polyline::with_flags(points, Some(edges), PolylineFlags::ORIENTED)
}

/// A closed triangle mesh, with the normals at its edges and nodes that decide between inside and outside.
fn mesh(points: Vec<parry3d_f64::math::Vector>, triangles: Vec<[u32; 3]>) -> Option<parry3d_f64::shape::TriMesh> {
    use parry3d_f64::shape::{TriMesh, TriMeshFlags};
    TriMesh::with_flags(points, triangles, TriMeshFlags::ORIENTED).ok()
}
