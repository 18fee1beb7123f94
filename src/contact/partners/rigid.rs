//! Obstacles in the form in which the estimators take them.

use crate::Error;
use crate::configuration::{FacetSide, FacetTree};
use crate::geometry::aabb::Aabb;
use crate::geometry::plane::Plane;
use crate::geometry::shapes::{self, Part};
use crate::geometry::{Bodies, Obstacle, Pose, Shape, Surface, Vector};

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
    /// Facets of a polytope, and of a cuboid for the exact estimator, in the shape's frame.
    facets: Option<(Surface<D>, Vec<Vector<D>>)>,
    /// What stands for a compound.
    distance: Option<Shape<D>>,
}

impl<const D: usize> Rigid<D> {
    /// Checks shape and pose. `index` is the number that errors name.
    pub(crate) fn new(obstacle: Obstacle<D>, index: usize) -> Result<Self, Error> {
        check_pose(&obstacle.pose, index)?;
        let positive = |name, value: f64| {
            if value.is_finite() && value > 0.0 { Ok(()) } else { Err(Error::NotPositive { name, value }) }
        };
        let mut distance = None;
        let facets = match &obstacle.shape {
            Shape::HalfSpace | Shape::SignedDistance(_) => None,
            Shape::Ball { radius } => {
                positive("radius", *radius)?;
                None
            }
            Shape::Cylinder { radius, half_height }
            | Shape::Cone { radius, half_height }
            | Shape::Capsule { radius, half_height } => {
                positive("radius", *radius)?;
                positive("half_height", *half_height)?;
                None
            }
            Shape::Cuboid { half_extents } => {
                half_extents.iter().try_for_each(|&h| positive("half_extent", h))?;
                let (points, facets) = cuboid(half_extents);
                Some(closed(&points, &facets)?)
            }
            Shape::Polytope { points, facets } => Some(closed(points, facets)?),
            Shape::ConvexHull { points } => {
                let (points, facets) = shapes::convex_hull(points)?;
                Some(closed(&points, &facets)?)
            }
            Shape::HeightField(field) => {
                let (points, facets) = field.solid()?;
                Some(closed(&points, &facets)?)
            }
            Shape::Compound { parts } => {
                // What holds for an obstacle holds for a part.
                let parts = parts.iter().map(|part| Self::new(part.clone(), index)).collect::<Result<Vec<_>, _>>()?;
                distance = Some(shapes::compound(parts.iter().map(Self::part).collect())?);
                None
            }
        };
        Ok(Self { obstacle, facets, distance })
    }

    /// The obstacle as a part of a compound.
    fn part(&self) -> Part<'_, D> {
        let facets = self.facets.as_ref().map(|(surface, points)| (points.as_slice(), surface.facets.as_slice()));
        Part { shape: self.implicit(), facets, pose: self.obstacle.pose }
    }

    /// The shape as the estimators see it where it has no facets.
    pub(crate) fn implicit(&self) -> &Shape<D> {
        self.distance.as_ref().unwrap_or(&self.obstacle.shape)
    }

    /// Its facets, and where their corners are, in the shape's frame.
    pub(crate) fn facets(&self) -> Option<&(Surface<D>, Vec<Vector<D>>)> {
        self.facets.as_ref()
    }

    /// Brings the facets of this obstacle, where the estimator is to see it so, to where it stands.
    pub(crate) fn place(&self, prefers_facets: bool, placed: &mut Option<Placed<D>>) {
        let is_optional = matches!(self.obstacle.shape, Shape::Cuboid { .. });
        let Some((surface, points)) = self.facets.as_ref().filter(|_| prefers_facets || !is_optional) else {
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
        let facets: &[[u32; D]] = self.facets.as_ref().map_or(&[], |(surface, _)| &surface.facets);
        FacetSide {
            facets,
            points: &placed.points,
            tree: &placed.tree,
            aabb: placed.tree.aabb(),
            is_upright: placed.is_upright,
        }
    }

    /// Whether its box meets another.
    pub(crate) fn may_meet(&self, placed: Option<&Placed<D>>, aabb: &Aabb<D>) -> bool {
        match (placed, &self.obstacle.shape) {
            (Some(placed), _) => placed.tree.aabb().meets(aabb),
            (None, Shape::HalfSpace) => Plane::of(&self.obstacle.pose).least(aabb) <= aabb.rounding(),
            (None, shape) => shape.bounding_radius().is_none_or(|radius| {
                let reach = radius * self.obstacle.pose.scale;
                let center = Vector::from(self.obstacle.pose.position);
                Aabb { min: center, max: center }.inflated(reach).meets(aabb)
            }),
        }
    }
}

/// Checks a pose.
pub(crate) fn check_pose<const D: usize>(pose: &Pose<D>, obstacle: usize) -> Result<(), Error> {
    if pose.is_proper() { Ok(()) } else { Err(Error::BadPose { obstacle }) }
}

/// A closed surface that is one body, cavities and all.
fn closed<const D: usize>(points: &[[f64; D]], facets: &[[u32; D]]) -> Result<(Surface<D>, Vec<Vector<D>>), Error> {
    let surface = Surface::from_facets(points, facets, Bodies::Ids(&vec![0; facets.len()]))?;
    let placed = surface.points(points);
    Ok((surface, placed))
}

/// Corners and facets of a box; corner c has coordinate +half on axis i where bit i of c is set.
fn cuboid<const D: usize>(half: &[f64; D]) -> (Vec<[f64; D]>, Vec<[u32; D]>) {
    let points =
        (0..1u32 << D).map(|c| std::array::from_fn(|i| if c >> i & 1 == 1 { half[i] } else { -half[i] })).collect();
    const EDGES: [[u32; 2]; 4] = [[0, 1], [1, 3], [3, 2], [2, 0]];
    const SQUARES: [[u32; 4]; 6] = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let facets = match D {
        2 => EDGES.iter().map(|e| std::array::from_fn(|k| e[k])).collect(),
        _ => SQUARES
            .iter()
            .flat_map(|s| [[s[0], s[1], s[2]], [s[0], s[2], s[3]]])
            .map(|t| std::array::from_fn(|k| t[k]))
            .collect(),
    };
    (points, facets)
}
