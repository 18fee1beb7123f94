//! Obstacles in the form in which the estimators take them.

use crate::Error;
use crate::configuration::{FacetSide, FacetTree};
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::plane::Plane;
use crate::geometry::shapes::{Extent, Faces, ImplicitShape, Solid};
use crate::geometry::{Obstacle, Pose, Vector};

/// Facets of an obstacle where it stands.
pub(crate) struct Placed<const D: usize> {
    points: Vec<Vector<D>>,
    tree: FacetTree<D>,
    pose: Pose<D>,
    /// Whether its surface hangs together and does not cross itself.
    is_upright: bool,
}

/// An obstacle whose values have been checked.
pub(crate) struct Rigid<const D: usize> {
    pub(crate) obstacle: Obstacle<D>,
    /// Where it stood when it was added.
    pub(crate) added: Pose<D>,
    solid: Solid<D>,
}

impl<const D: usize> Rigid<D> {
    /// Checks shape and pose. `index` is the number that errors name.
    pub(crate) fn new(obstacle: Obstacle<D>, index: usize) -> Result<Self, Error> {
        let solid = obstacle.solid(index)?;
        Ok(Self { added: obstacle.pose, obstacle, solid })
    }

    /// Its shape, in a frame of its own.
    pub(crate) fn solid(&self) -> &Solid<D> {
        &self.solid
    }

    /// Brings the facets of this obstacle, where the estimator is to see it so, to where it stands.
    pub(crate) fn place(&self, prefers_facets: bool, placed: &mut Option<Placed<D>>) {
        let is_optional = self.solid.implicit().is_some();
        let Some(Faces { surface, points, .. }) = self.solid.faces().filter(|_| prefers_facets || !is_optional) else {
            *placed = None;
            return;
        };
        let pose = self.obstacle.pose;
        if placed.as_ref().is_some_and(|placed| placed.pose == pose) {
            return;
        }
        let points: Vec<Vector<D>> = points.iter().map(|x| pose.place(x)).collect();
        match placed {
            Some(placed) => {
                placed.tree.update(&surface.facets, &surface.vertices[0], &points, false);
                (placed.points, placed.pose) = (points, pose);
            }
            None => {
                let tree = FacetTree::new(&surface.facets, &surface.vertices[0], &points);
                let new = placed.insert(Placed { tree, points, pose, is_upright: false });
                new.is_upright = surface.is_one_sheet(0) && !self.side(new).may_cross_itself();
            }
        }
    }

    /// The obstacle as a side of a pair.
    pub(crate) fn side<'a>(&'a self, placed: &'a Placed<D>) -> FacetSide<'a, D> {
        let facets: &[[u32; D]] = self.solid.faces().map_or(&[], |faces| &faces.surface.facets);
        FacetSide {
            facets,
            points: &placed.points,
            tree: &placed.tree,
            aabb: placed.tree.aabb(),
            is_upright: placed.is_upright,
            rigid: self.solid.faces(),
        }
    }

    /// Whether its box meets another.
    pub(crate) fn may_meet(&self, placed: Option<&Placed<D>>, aabb: &Aabb<D>) -> bool {
        let pose = &self.obstacle.pose;
        match (placed, self.solid.implicit().and_then(ImplicitShape::extent)) {
            (Some(placed), _) => placed.tree.aabb().meets(aabb),
            (None, Some(Extent::HalfSpace)) => Plane::of(pose).least(aabb) <= aabb.rounding(),
            (None, Some(Extent::Bounded { radius, .. })) => {
                let center = Vector::from(pose.position);
                Aabb { min: center, max: center }.inflated(radius * pose.scale).meets(aabb)
            }
            // How far it reaches is not known.
            (None, None) => true,
        }
    }
}
