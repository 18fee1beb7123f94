//! How the material at one side of a contact point moved since the step began, and what moves it.
//!
//! A traction acts at the middle of the two points, as if that were fixed rigidly to either side: with r the way there, h
//! the gradients of a facet's shape functions and n its normal, the middle moves by
//!
//! ```text
//! Σ_a [ (N_a + h_a·r) I − (r·n) h_a nᵀ ] δx_a
//! ```
//!
//! so that forces and moments of both sides cancel.

use super::step::{Sliding, Step};
use crate::contact::laws::{PointOnSide, PressurePoint};
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::primitives::facet_slopes::slopes;
use crate::geometry::{Pose, Vector, cross_matrix};
use crate::interfaces::LawFields;
use crate::overlap::{Pair, Partner, PlaceInCell, SurfacePoint};
use nalgebra::SMatrix;

/// One side of a contact point.
pub(crate) struct SideMotion<const D: usize> {
    /// The material point now, and when the step began.
    pub(crate) now: Vector<D>,
    pub(crate) start: Vector<D>,
    /// From it to where the surface is measured, now and then.
    pub(crate) out: Vector<D>,
    pub(crate) was_out: Vector<D>,
    /// Deformation since then.
    pub(crate) deformation: SMatrix<f64, D, D>,
    pub(crate) movers: Movers<D>,
}

/// What moves a side.
pub(crate) enum Movers<const D: usize> {
    /// A facet of a body: its vertices, their shape functions and the gradients of these.
    Facet { vertices: [u32; D], weights: [f64; D], gradients: [Vector<D>; D], normal: Vector<D> },
    /// A cell.
    Cell { cell: u32, weights: [f64; 8] },
    /// An obstacle.
    Rigid,
}

/// The facet of a side that was looked at last: points come facet by facet.
pub(crate) type LastFacet<const D: usize> = Option<((bool, u32), FacetFrame<D>)>;

impl<const D: usize> SideMotion<D> {
    /// Of one side, 0 or 1, of a point; `None` where a facet has no measure, or a cell is flat.
    pub(crate) fn new(
        pair: &Pair<D>,
        sliding: &Sliding<D>,
        (point, side): (&PressurePoint<D>, usize),
        last: &mut LastFacet<D>,
    ) -> Option<Self> {
        let step = sliding.step;
        match &point.middles[side] {
            PointOnSide::Surface(SurfacePoint::Facet { of_b, facet, weights }) if !of_b || pair.pose.is_none() => {
                Self::of_facet(pair, sliding, (*of_b, *facet, weights), last)
            }
            PointOnSide::Surface(end) => Self::of_obstacle(pair, step, pair.position(end)),
            PointOnSide::Rigid(position) => Self::of_obstacle(pair, step, *position),
            PointOnSide::Cell(place) => Self::in_cell(pair, sliding, place, &point.gradients),
        }
    }

    fn of_facet(
        pair: &Pair<D>,
        sliding: &Sliding<D>,
        (of_b, facet, weights): (bool, u32, &[f64; D]),
        last: &mut LastFacet<D>,
    ) -> Option<Self> {
        let (step, material) = (sliding.step, sliding.material);
        let vertices = pair.side(of_b).facets[facet as usize];
        let measured = pair.side(of_b).corners(facet as usize);
        let corners = material.map_or(measured, |material| vertices.map(|v| material.vertices[v as usize]));
        let starts = vertices.map(|v| step.points[v as usize]);
        let frame = match *last {
            Some((known, frame)) if known == (of_b, facet) => frame,
            _ => FacetFrame::new(&corners, &starts)?,
        };
        *last = Some(((of_b, facet), frame));
        let FacetFrame { gradients, normal, deformation } = frame;
        let sum = |x: &[Vector<D>; D]| x.iter().zip(weights).fold(Vector::zeros(), |sum, (x, w)| sum + x * *w);
        let now = sum(&corners);
        let out = if material.is_some() { sum(&measured) - now } else { Vector::zeros() };
        let was_out = step.moved_out.as_ref().map_or(Vector::zeros(), |out| sum(&vertices.map(|v| out.at_vertex(v))));
        Some(Self {
            now,
            start: sum(&starts),
            out,
            was_out,
            deformation,
            movers: Movers::Facet { vertices, weights: *weights, gradients, normal },
        })
    }

    fn in_cell(pair: &Pair<D>, sliding: &Sliding<D>, place: &PlaceInCell, gradients: &[Vector<D>; 8]) -> Option<Self> {
        let Sliding { step, material, .. } = sliding;
        let nodes = pair.surface.cells.as_ref()?.nodes(place.cell as usize);
        let sum = |of_node: &dyn Fn(u32) -> Vector<D>| {
            nodes.iter().zip(&place.weights).fold(Vector::zeros(), |sum, (&node, &weight)| sum + of_node(node) * weight)
        };
        // By the place now, as surfaces are measured.
        let slope = |of_points: &dyn Fn(u32) -> Vector<D>| {
            let all = nodes.iter().zip(gradients);
            all.fold(SMatrix::zeros(), |sum, (&node, gradient)| sum + of_points(node) * gradient.transpose())
        };
        let old = |node: u32| Vector::from(step.coords[node as usize]);
        let measured = |node: u32| Vector::from(pair.coords[node as usize]);
        let back: SMatrix<f64, D, D> = slope(&old);
        let back = back.try_inverse()?;
        let (now, out, deformation) = match material {
            None => (sum(&measured), Vector::zeros(), back),
            Some(material) => {
                let here = |node: u32| Vector::from(material.points[node as usize]);
                let now = sum(&here);
                (now, sum(&measured) - now, slope(&here) * back)
            }
        };
        let was_out = step.moved_out.as_ref().map_or(Vector::zeros(), |out| sum(&|node| out.at_point(node)));
        let movers = Movers::Cell { cell: place.cell, weights: place.weights };
        Some(Self { now, start: sum(&old), out, was_out, deformation, movers })
    }

    fn of_obstacle(pair: &Pair<D>, step: &Step<D>, now: Vector<D>) -> Option<Self> {
        let (Partner::Obstacle(obstacle), Some(pose)) = (pair.partners[1], pair.pose) else { return None };
        let old: &Pose<D> = step.pose(obstacle, pose);
        let turn = |pose: &Pose<D>| SMatrix::<f64, D, D>::from_fn(|i, j| pose.rotation[i][j] * pose.scale);
        let deformation = turn(pose) * turn(old).transpose() / (old.scale * old.scale);
        let zero = Vector::zeros();
        let start = old.place(&pose.unplace(&now));
        Some(Self { now, start, out: zero, was_out: zero, deformation, movers: Movers::Rigid })
    }

    /// Whether it lies within a cell.
    pub(crate) fn is_inside(&self) -> bool {
        matches!(self.movers, Movers::Cell { .. })
    }

    /// Fields of the host at the point; NaN of an obstacle, which has none.
    pub(crate) fn fields(&self, pair: &Pair<D>, of: &LawFields) -> Vec<f64> {
        let mut found = vec![if matches!(self.movers, Movers::Rigid) { f64::NAN } else { 0.0 }; of.count];
        if !matches!(self.movers, Movers::Rigid) {
            self.for_each_node(pair, &Vector::zeros(), u32::MAX, |mover, point, _| {
                let values = &of.values[mover.node as usize * of.count..][..of.count];
                // The shape function of the node, times the identity.
                found.iter_mut().zip(values).for_each(|(sum, value)| *sum += point[(0, 0)] * value);
            });
        }
        found
    }

    /// Calls `visit(what moves the side, by what the point moves with it, by what the middle does)`; the middle lies at `arm` from the
    /// point.
    pub(crate) fn for_each_node(
        &self,
        pair: &Pair<D>,
        arm: &Vector<D>,
        obstacle_node: u32,
        mut visit: impl FnMut(Mover, SMatrix<f64, D, D>, SMatrix<f64, D, D>),
    ) {
        let identity = SMatrix::<f64, D, D>::identity();
        match &self.movers {
            Movers::Facet { vertices, weights, gradients, normal } => {
                for ((&vertex, &weight), h) in vertices.iter().zip(weights).zip(gradients) {
                    let row = identity * (weight + h.dot(arm)) - h * normal.transpose() * arm.dot(normal);
                    for (node, part) in pair.surface.nodes_of_vertex(vertex) {
                        visit(Mover { node, turns: false }, identity * (weight * part), row * part);
                    }
                }
            }
            Movers::Cell { cell, weights } => {
                let nodes = pair.surface.cells.as_ref().map_or(&[][..], |cells| cells.nodes(*cell as usize));
                nodes.iter().zip(weights).for_each(|(&node, &weight)| {
                    visit(Mover { node, turns: false }, identity * weight, identity * weight);
                });
            }
            Movers::Rigid => {
                visit(Mover { node: obstacle_node, turns: false }, identity, identity);
                if let Some(pose) = pair.pose {
                    let from = self.now - Vector::from(pose.position);
                    visit(Mover { node: obstacle_node, turns: true }, by_turn(&from), by_turn(&(from + arm)));
                }
            }
        }
    }
}

/// A node, or an obstacle, by a number from the count of nodes on: its translation, or its rotation about its position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Mover {
    pub(crate) node: u32,
    pub(crate) turns: bool,
}

/// What a point at `arm` from the axis moves by with a rotation vector; in 2D with its first entry.
fn by_turn<const D: usize>(arm: &Vector<D>) -> SMatrix<f64, D, D> {
    // ω × arm = −arm × ω.
    let across = cross_matrix(&(*arm).into());
    SMatrix::from_fn(|i, j| across[j][i])
}

/// A facet, and its deformation since another state.
#[derive(Clone, Copy)]
pub(crate) struct FacetFrame<const D: usize> {
    /// Of the shape functions now, within the facet.
    gradients: [Vector<D>; D],
    normal: Vector<D>,
    /// Of vectors within the facet, and of its normal into the normal now.
    pub(super) deformation: SMatrix<f64, D, D>,
}

impl<const D: usize> FacetFrame<D> {
    /// `None` where it has no measure.
    pub(super) fn new(corners: &[Vector<D>; D], starts: &[Vector<D>; D]) -> Option<Self> {
        let (normal, gradients) = frame(corners)?;
        let (old_normal, old_gradients) = frame(starts)?;
        let deformation = (corners.iter().zip(&old_gradients))
            .fold(normal * old_normal.transpose(), |sum, (x, h)| sum + (x - corners[0]) * h.transpose());
        Some(Self { gradients, normal, deformation })
    }
}

/// Unit normal, and the gradients of the shape functions.
fn frame<const D: usize>(corners: &[Vector<D>; D]) -> Option<(Vector<D>, [Vector<D>; D])> {
    let normal = area_vector(corners).try_normalize(0.0)?;
    Some((normal, slopes(corners, &normal)?.1))
}
