//! The parallel surface of an obstacle, at the gap offset of a pair, where the contact of the pair begins.

use super::rigid::Rigid;
use crate::configuration::{FacetSide, FacetTree};
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::tree::Tree;
use crate::geometry::shapes::{ImplicitShape, Solid};
use crate::geometry::{Pose, SignedDistance, Surface, Vector};
use crate::overlap::distance_from_facets;
use std::sync::Arc;

/// An obstacle whose surface lies further out, or in.
pub(crate) struct Parallel<const D: usize> {
    pub(crate) shape: ImplicitShape<D>,
    offset: f64,
}

impl<const D: usize> Parallel<D> {
    /// That of an obstacle with its current scale, `offset` from its surface in space.
    pub(crate) fn new(rigid: &Rigid<D>, offset: f64) -> Self {
        let own = offset / rigid.obstacle.pose.scale;
        let in_closed_form = match rigid.solid().implicit() {
            Some(ImplicitShape::Convex(shape)) => shape.parallel(own).map(ImplicitShape::Convex),
            _ => None,
        };
        let shape = in_closed_form.unwrap_or_else(|| {
            let distance: Box<dyn SignedDistance<D>> = match rigid.solid() {
                Solid::Implicit { shape, .. } => Box::new(shape.clone()),
                Solid::Faceted(faces) => Box::new(ShapeFacets::new(&faces.surface, &faces.points)),
            };
            ImplicitShape::Function(Arc::new(Offset { distance, offset: own }))
        });
        Self { shape, offset }
    }

    /// Where its shape stands if the obstacle stands there. A half-space is the same at any offset, and moved instead.
    pub(crate) fn pose(&self, of_obstacle: &Pose<D>) -> Pose<D> {
        let mut pose = *of_obstacle;
        if self.shape.is_half_space() {
            let mut up = Vector::zeros();
            up[D - 1] = self.offset;
            pose.position = (Vector::from(pose.position) + pose.rotate(&up)).into();
        }
        pose
    }
}

/// A signed distance that is less by an offset.
struct Offset<const D: usize> {
    distance: Box<dyn SignedDistance<D>>,
    offset: f64,
}

impl<const D: usize> SignedDistance<D> for Offset<D> {
    fn evaluate(&self, x: &[[f64; D]], phi: &mut [f64], gradient: &mut [[f64; D]]) -> Result<(), usize> {
        self.distance.evaluate(x, phi, gradient)?;
        phi.iter_mut().for_each(|phi| *phi -= self.offset);
        Ok(())
    }
}

/// The facets of a shape, in its own frame.
struct ShapeFacets<const D: usize> {
    facets: Vec<[u32; D]>,
    points: Vec<Vector<D>>,
    /// For what lies around a point.
    tree: FacetTree<D>,
    /// For the nearest.
    boxes: Tree<D>,
}

impl<const D: usize> ShapeFacets<D> {
    fn new(surface: &Surface<D>, points: &[Vector<D>]) -> Self {
        let facets = &surface.facets;
        let box_of = |facet: &[u32; D]| Aabb::of(facet.iter().map(|&vertex| &points[vertex as usize]));
        let boxes: Vec<Aabb<D>> = facets.iter().map(box_of).collect();
        Self {
            facets: facets.clone(),
            points: points.to_vec(),
            tree: FacetTree::new(facets, &surface.vertices[0], points),
            boxes: Tree::new(&boxes),
        }
    }
}

impl<const D: usize> SignedDistance<D> for ShapeFacets<D> {
    fn evaluate(&self, x: &[[f64; D]], phi: &mut [f64], gradient: &mut [[f64; D]]) -> Result<(), usize> {
        let side = FacetSide {
            facets: &self.facets,
            points: &self.points,
            tree: &self.tree,
            aabb: self.tree.aabb(),
            is_upright: false,
            rigid: None,
        };
        for ((x, phi), gradient) in x.iter().zip(phi).zip(gradient) {
            let found = distance_from_facets(&side, &self.boxes, &(*x).into());
            (*phi, *gradient) = (found.phi, found.gradient.into());
        }
        Ok(())
    }
}
