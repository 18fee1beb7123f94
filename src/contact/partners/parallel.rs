//! The parallel surface of an obstacle, at the gap offset of a pair, where the contact of the pair begins.

use super::rigid::Rigid;
use crate::configuration::{FacetSide, FacetTree};
use crate::geometry::aabb::Aabb;
use crate::geometry::tree::Tree;
use crate::geometry::{Pose, Shape, SignedDistance, Surface, Vector, signed_distance};
use crate::overlap::distance_from_facets;
use std::sync::Arc;

/// An obstacle whose surface lies further out, or in.
pub(crate) struct Parallel<const D: usize> {
    pub(crate) shape: Shape<D>,
    offset: f64,
}

impl<const D: usize> Parallel<D> {
    /// That of an obstacle with its current scale, `offset` from its surface in space.
    pub(crate) fn new(rigid: &Rigid<D>, offset: f64) -> Self {
        let own = offset / rigid.obstacle.pose.scale;
        let shape = in_closed_form(&rigid.obstacle.shape, own).unwrap_or_else(|| {
            let distance = match (rigid.implicit(), rigid.facets()) {
                (Shape::SignedDistance(function), _) => Distance::Function(function.clone()),
                (Shape::Cuboid { .. }, _) | (_, None) => Distance::Shape(rigid.implicit().clone()),
                (_, Some((surface, points))) => Distance::Facets(Facets::new(surface, points)),
            };
            Shape::SignedDistance(Arc::new(Offset { distance, offset: own }))
        });
        Self { shape, offset }
    }

    /// Where its shape stands if the obstacle stands there.
    pub(crate) fn pose(&self, of_obstacle: &Pose<D>) -> Pose<D> {
        let mut pose = *of_obstacle;
        if let Shape::HalfSpace = self.shape {
            let mut up = Vector::zeros();
            up[D - 1] = self.offset;
            pose.position = (Vector::from(pose.position) + pose.rotate(&up)).into();
        }
        pose
    }
}

/// The parallel shape where it is one of the same kind; a half-space is moved instead.
fn in_closed_form<const D: usize>(shape: &Shape<D>, offset: f64) -> Option<Shape<D>> {
    let grown = |length: f64| Some(length + offset).filter(|length| *length > 0.0);
    match *shape {
        Shape::HalfSpace => Some(Shape::HalfSpace),
        Shape::Ball { radius } => Some(Shape::Ball { radius: grown(radius)? }),
        Shape::Capsule { radius, half_height } => Some(Shape::Capsule { radius: grown(radius)?, half_height }),
        // Inwards edges stay sharp; outwards they become round.
        Shape::Cylinder { radius, half_height } if offset < 0.0 => {
            Some(Shape::Cylinder { radius: grown(radius)?, half_height: grown(half_height)? })
        }
        _ => None,
    }
}

/// A signed distance that is less by an offset.
struct Offset<const D: usize> {
    distance: Distance<D>,
    offset: f64,
}

enum Distance<const D: usize> {
    Shape(Shape<D>),
    Facets(Facets<D>),
    Function(Arc<dyn SignedDistance<D>>),
}

impl<const D: usize> SignedDistance<D> for Offset<D> {
    fn evaluate(&self, x: &[[f64; D]], phi: &mut [f64], gradient: &mut [[f64; D]]) -> Result<(), usize> {
        if let Distance::Function(function) = &self.distance {
            function.evaluate(x, phi, gradient)?;
        } else {
            for ((x, phi), gradient) in x.iter().zip(&mut *phi).zip(gradient) {
                let (found, slope) = self.distance.at(&(*x).into());
                (*phi, *gradient) = (found, slope.into());
            }
        }
        phi.iter_mut().for_each(|phi| *phi -= self.offset);
        Ok(())
    }
}

impl<const D: usize> Distance<D> {
    /// What is not known becomes an error of the function.
    fn at(&self, x: &Vector<D>) -> (f64, Vector<D>) {
        match self {
            Distance::Shape(shape) => signed_distance(shape, x).unwrap_or((f64::NAN, Vector::zeros())),
            Distance::Facets(facets) => facets.at(x),
            Distance::Function(_) => (f64::NAN, Vector::zeros()),
        }
    }
}

/// The facets of a shape, in its own frame.
struct Facets<const D: usize> {
    facets: Vec<[u32; D]>,
    points: Vec<Vector<D>>,
    /// For what lies around a point.
    tree: FacetTree<D>,
    /// For the nearest.
    boxes: Tree<D>,
}

impl<const D: usize> Facets<D> {
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

    fn at(&self, x: &Vector<D>) -> (f64, Vector<D>) {
        let side = FacetSide {
            facets: &self.facets,
            points: &self.points,
            tree: &self.tree,
            aabb: self.tree.aabb(),
            is_upright: false,
        };
        let found = distance_from_facets(&side, &self.boxes, x);
        (found.phi, found.gradient)
    }
}
