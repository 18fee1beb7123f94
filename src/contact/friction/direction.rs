//! The direction of a surface at a contact point.
//!
//! With the deformation F of what carries the direction d, and the unit normal n of the tangent plane now, N = Fᵀn is normal to the same
//! plane without deformation. So
//!
//! ```text
//! F (d − N (N·d)/|N|²)
//! ```
//!
//! is d in that plane, carried along: it lies in the tangent plane now, and turns with it, whatever carries it.

use super::orthotropic::Orthotropy;
use super::side_motion::FacetFrame;
use crate::contact::laws::{PointOnSide, PressurePoint};
use crate::geometry::Vector;
use crate::overlap::{Pair, Partner, PlaceInCell, SurfacePoint};
use nalgebra::SMatrix;

/// Sine of the angle up to which a direction counts as perpendicular to a facet: of what is left in its plane, coordinates that are
/// written to six digits would say where it points.
pub(super) const PERPENDICULAR: f64 = 1e-3;

/// Unit vector in the tangent plane with this normal; `None` where the direction is perpendicular to it.
pub(super) fn direction_at<const D: usize>(
    pair: &Pair<D>,
    orthotropy: &Orthotropy,
    point: &PressurePoint<D>,
    normal: &Vector<D>,
) -> Option<Vector<D>> {
    let side = usize::from(orthotropy.of_second);
    let deformation = match &point.middles[side] {
        _ if matches!(pair.partners[side], Partner::Obstacle(_)) => {
            let pose = pair.pose?;
            SMatrix::<f64, D, D>::from_fn(|i, j| pose.rotation[i][j])
        }
        PointOnSide::Surface(SurfacePoint::Facet { of_b, facet, .. }) => of_facet(pair, *of_b, *facet)?,
        PointOnSide::Cell(place) => of_cell(pair, place, &point.gradients)?,
        PointOnSide::Surface(SurfacePoint::Point { .. }) | PointOnSide::Rigid(_) => return None,
    };
    let reference = (deformation.transpose() * normal).try_normalize(0.0)?;
    let direction = Vector::<D>::from_fn(|i, _| orthotropy.direction[i]);
    let within = direction - reference * reference.dot(&direction);
    if within.norm() < PERPENDICULAR {
        return None;
    }
    (deformation * within).try_normalize(0.0)
}

/// Deformation of a facet since it had none.
fn of_facet<const D: usize>(pair: &Pair<D>, of_b: bool, facet: u32) -> Option<SMatrix<f64, D, D>> {
    let reference = pair.surface.reference();
    let place = |vertex: u32| {
        let nodes = pair.surface.nodes_of_vertex(vertex);
        nodes.fold(Vector::zeros(), |sum, (node, part)| sum + Vector::<D>::from(reference[node as usize]) * part)
    };
    let vertices = pair.side(of_b).facets[facet as usize];
    if reference.is_empty() {
        return None;
    }
    Some(FacetFrame::new(&pair.side(of_b).corners(facet as usize), &vertices.map(place))?.deformation)
}

/// The same of a place in a cell.
fn of_cell<const D: usize>(
    pair: &Pair<D>,
    place: &PlaceInCell,
    gradients: &[Vector<D>; 8],
) -> Option<SMatrix<f64, D, D>> {
    let nodes = pair.surface.cells.as_ref()?.nodes(place.cell as usize);
    let reference = pair.surface.reference();
    let back = (nodes.iter().zip(gradients)).fold(SMatrix::<f64, D, D>::zeros(), |sum, (&node, gradient)| {
        sum + Vector::from(reference[node as usize]) * gradient.transpose()
    });
    back.try_inverse()
}
