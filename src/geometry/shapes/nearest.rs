//! Nearest points of boundaries, by parry's point queries.

use super::Part;
use crate::geometry::Shape;

/// From a point to whether it is inside and the nearest point of the boundary, in the frame of the shape.
pub(super) type Nearest<const D: usize> = Box<dyn Fn(&[f64; D]) -> (bool, [f64; D]) + Send + Sync>;

/// parry has a crate for each dimension, with the same names in both.
macro_rules! nearest {
    ($parry:ident, $dim:literal, $axes:expr, $shape:expr) => {{
        use $parry::query::PointQuery;
        let (shape, axes): (_, [usize; $dim]) = ($shape, $axes);
        Box::new(move |x: &[f64; D]| {
            let found = shape.project_local_point(axes.map(|axis| x[axis]).into(), false);
            let point = found.point.to_array();
            (found.is_inside, std::array::from_fn(|axis| point[axes[axis]]))
        })
    }};
}

/// The query of a part, and its least extent; `None` for what has no need of it.
pub(super) fn nearest<const D: usize>(part: &Part<D>) -> Option<(Nearest<D>, f64)> {
    // parry's axis of revolution is y; exchanging y and z is its own inverse.
    const PLANE: [usize; 2] = [0, 1];
    const SPACE: [usize; 3] = [0, 1, 2];
    const UPRIGHT: [usize; 3] = [0, 2, 1];
    Some(match (part.facets, part.shape) {
        (_, Shape::HalfSpace | Shape::Ball { .. } | Shape::SignedDistance(_)) => return None,
        (_, &Shape::Capsule { radius, half_height }) if D == 2 => {
            (nearest!(parry2d_f64, 2, PLANE, parry2d_f64::shape::Capsule::new_y(half_height, radius)), radius)
        }
        (_, &Shape::Capsule { radius, half_height }) => {
            (nearest!(parry3d_f64, 3, UPRIGHT, parry3d_f64::shape::Capsule::new_y(half_height, radius)), radius)
        }
        (_, &Shape::Cylinder { radius, half_height }) if D == 2 => (
            nearest!(parry2d_f64, 2, PLANE, parry2d_f64::shape::Cuboid::new([radius, half_height].into())),
            radius.min(half_height),
        ),
        (_, &Shape::Cylinder { radius, half_height }) => (
            nearest!(parry3d_f64, 3, UPRIGHT, parry3d_f64::shape::Cylinder::new(half_height, radius)),
            radius.min(half_height),
        ),
        (_, &Shape::Cone { radius, half_height }) if D == 3 => (
            nearest!(parry3d_f64, 3, UPRIGHT, parry3d_f64::shape::Cone::new(half_height, radius)),
            radius.min(half_height),
        ),
        (_, &Shape::Cone { radius, half_height }) => {
            let corners = [[-radius, -half_height], [radius, -half_height], [0.0, half_height]];
            let (line, edges) = (corners.map(Into::into).to_vec(), vec![[0, 1], [1, 2], [2, 0]]);
            (nearest!(parry2d_f64, 2, PLANE, polyline(line, edges)), radius.min(half_height))
        }
        (Some((points, facets)), _) => {
            let least = crate::geometry::aabb::Aabb::of(points).extent().min();
            if D == 2 {
                let points = points.iter().map(|x| [x[0], x[1]].into()).collect();
                let facets = facets.iter().map(|f| [f[0], f[1]]).collect();
                (nearest!(parry2d_f64, 2, PLANE, polyline(points, facets)), least)
            } else {
                let points = points.iter().map(|x| [x[0], x[1], x[2]].into()).collect();
                let facets = facets.iter().map(|f| [f[0], f[1], f[2]]).collect();
                (nearest!(parry3d_f64, 3, SPACE, mesh(points, facets)?), least)
            }
        }
        _ => return None,
    })
}

/// A closed polygon, with the normals at its corners that decide between inside and outside.
fn polyline(points: Vec<parry2d_f64::math::Vector>, edges: Vec<[u32; 2]>) -> parry2d_f64::shape::Polyline {
    use parry2d_f64::shape::{Polyline, PolylineFlags};
    Polyline::with_flags(points, Some(edges), PolylineFlags::ORIENTED)
}

/// A closed triangle mesh, with the normals at its edges and nodes that decide between inside and outside.
fn mesh(points: Vec<parry3d_f64::math::Vector>, triangles: Vec<[u32; 3]>) -> Option<parry3d_f64::shape::TriMesh> {
    use parry3d_f64::shape::{TriMesh, TriMeshFlags};
    TriMesh::with_flags(points, triangles, TriMeshFlags::ORIENTED).ok()
}
