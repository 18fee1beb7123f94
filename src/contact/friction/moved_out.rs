//! Surfaces that multipliers move out, and the material below them.
//!
//! Slip is that of the material: multipliers that change, and bodies that turn below surfaces that are moved out, slip by nothing. How near
//! sides come is that of the surfaces, since they bear: a facet that touches in the middle of a step does so where it is moved out to.

use crate::geometry::{Surface, Vector};
use std::sync::Arc;

/// Where the material lies of surfaces that are moved out.
#[derive(Clone, Copy)]
pub(crate) struct Material<'a, const D: usize> {
    /// Points of the mesh.
    pub(crate) points: &'a [[f64; D]],
    /// Vertices of the surface.
    pub(crate) vertices: &'a [Vector<D>],
}

/// How far surfaces were moved out when a step began.
#[derive(Clone)]
pub(crate) struct MovedOut<const D: usize> {
    of_points: Arc<Vec<[f64; D]>>,
    of_vertices: Arc<Vec<Vector<D>>>,
}

impl<const D: usize> MovedOut<D> {
    /// From the points of the mesh to where they were moved.
    pub(crate) fn new(surface: &Surface<D>, points: &[[f64; D]], moved: &[[f64; D]]) -> Self {
        let way = |(from, to): (&[f64; D], &[f64; D])| std::array::from_fn(|axis| to[axis] - from[axis]);
        let of_points: Vec<[f64; D]> = points.iter().zip(moved).map(way).collect();
        Self { of_vertices: Arc::new(surface.points(&of_points)), of_points: Arc::new(of_points) }
    }

    /// At a vertex of the surface.
    pub(crate) fn at_vertex(&self, vertex: u32) -> Vector<D> {
        self.of_vertices[vertex as usize]
    }

    /// At a point of the mesh.
    pub(crate) fn at_point(&self, point: u32) -> Vector<D> {
        Vector::from(self.of_points[point as usize])
    }
}
