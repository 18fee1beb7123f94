//! Obstacles that were moved through bodies.
//!
//! Contact is measured where an obstacle stands, and knows nothing of its way. Two things tell that it has passed through a body on a straight
//! way: its middle has been inside the body and is out again; or a facet that faced one side of the obstacle has come in there and is now
//! nearer to the opposite side, or out by it. What is pressed, rolled over, slid along or let go stays on its side.

use super::bring::with_state;
use super::parts::Contact;
use super::points::moved_out;
use super::state::State;
use crate::Error;
use crate::configuration::FacetSide;
use crate::contact::partners::Sides;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::{Motion, Pose, Vector};
use crate::overlap::Partner;
use std::borrow::Cow;

/// Cosine of the angle between two directions from which on they are rather opposite than across.
const OPPOSITE: f64 = -std::f64::consts::FRAC_1_SQRT_2;

/// Where an obstacle stood.
#[derive(Clone, Copy)]
pub(crate) struct Stood<const D: usize> {
    pub(crate) obstacle: usize,
    pub(crate) pose: Pose<D>,
    /// Whether that is known from a step or an equilibrium, and not only from when it was added: those that overlap bodies there were not yet
    /// put where they belong.
    pub(crate) is_of_step: bool,
}

/// An obstacle and a body that have passed through one another.
pub(crate) struct Passed {
    pub(crate) obstacle: usize,
    pub(crate) body: usize,
    /// How far the obstacle went, and by what angle it turned, in radians.
    pub(crate) length: f64,
    pub(crate) angle: f64,
    pub(crate) is_of_step: bool,
}

/// Those of obstacles that were moved, with the bodies at these coordinates, ascending. A body of which only some cells are here is not looked
/// at.
pub(crate) fn passed<const D: usize>(
    contact: &Contact<D>,
    coords: &[[f64; D]],
    stood: &[Stood<D>],
) -> Result<Vec<Passed>, Error> {
    if stood.is_empty() || contact.mesh.surface.submesh.is_some() {
        return Ok(Vec::new());
    }
    let points = contact.mesh.points(coords)?;
    // As they were evaluated last.
    let points = moved_out(contact, &points).map_or(points, Cow::Owned);
    with_state(contact, &points, |state| Ok(stood.iter().flat_map(|one| of_obstacle(contact, state, one)).collect()))
}

fn of_obstacle<const D: usize>(contact: &Contact<D>, state: &State<D>, stood: &Stood<D>) -> Vec<Passed> {
    let Contact { mesh, partners, method, .. } = contact;
    let Some(rigid) = partners.obstacles.get(stood.obstacle) else { return Vec::new() };
    let motion = Motion::new(stood.pose, rigid.obstacle.pose);
    let poses = motion.poses();
    let Some(sides) = Sides::new(rigid, state.placed[stood.obstacle].as_ref()) else { return Vec::new() };
    let reached = poses.iter().fold(Aabb::empty(), |reached, pose| {
        let origin = Vector::from(pose.position);
        reached.union(&Aabb { min: origin, max: origin }.inflated(sides.radius * pose.scale))
    });
    let &Stood { obstacle, is_of_step, .. } = stood;
    let has = |body: &usize| partners.has(&[Partner::Body(*body), Partner::Obstacle(obstacle)], method.options());
    let has_passed = |body: &usize| {
        let side = state.configuration.body(&mesh.surface, *body);
        reached.meets(&side.aabb) && is_passed(&side, &sides, &poses, &reached, is_of_step)
    };
    let found = |body| Passed { obstacle, body, length: motion.length(), angle: motion.angle, is_of_step };
    (0..mesh.surface.body_count()).filter(has).filter(has_passed).map(found).collect()
}

fn is_passed<const D: usize>(
    body: &FacetSide<D>,
    sides: &Sides<D>,
    poses: &[Pose<D>],
    reached: &Aabb<D>,
    is_of_step: bool,
) -> bool {
    let mut is_passed = sides.middle.is_some_and(|middle| comes_out(body, &middle, poses));
    if sides.radius == f64::INFINITY {
        return is_passed;
    }
    for facet in body.facets_in(reached) {
        let corners = body.corners(facet as usize);
        let centre = corners.iter().sum::<Vector<D>>() / D as f64;
        let Some(through) = sides.of_way(&centre, poses) else { continue };
        if through.starts_inside && !is_of_step {
            return false;
        }
        let Some(normal) = area_vector(&corners).try_normalize(0.0) else { continue };
        let [first, last] = through.sides;
        is_passed |= normal.dot(&first) <= OPPOSITE && first.dot(&last) <= OPPOSITE;
    }
    is_passed
}

/// Whether a point of an obstacle that starts outside a body has been inside and is out again.
fn comes_out<const D: usize>(body: &FacetSide<D>, point: &Vector<D>, poses: &[Pose<D>]) -> bool {
    let way: Vec<Vector<D>> = poses.iter().map(|pose| pose.place(point)).collect();
    let mut depth = body.winding_number(&way[0]);
    if depth > 0 {
        return false;
    }
    way.windows(2).flat_map(|piece| body.passages(&piece[0], &piece[1])).any(|passage| {
        depth += if passage.leaves { -1 } else { 1 };
        passage.leaves && depth == 0
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::{EnergyLaw, Options};
    use crate::geometry::{Bodies, CellBlock, CellType, Obstacle, Shape, Surface};
    use std::sync::Arc;

    /// Cells of a strip from −3 to 3, from −0.2 to 0 in the last axis, and in 3D from −1 to 1 across.
    fn strip<const D: usize>() -> Contact<D> {
        let counts = if D == 2 { [40, 1, 2] } else { [24, 8, 2] };
        let corner = |axis: usize, k: usize| match (D, axis) {
            (_, 0) => -3.0 + 6.0 * k as f64 / counts[0] as f64,
            (3, 1) => -1.0 + 2.0 * k as f64 / counts[1] as f64,
            _ => -0.2 + 0.2 * k as f64 / counts[2] as f64,
        };
        let (nj, nk) = (if D == 3 { counts[1] + 1 } else { 1 }, counts[2] + 1);
        let node = |i: usize, j: usize, k: usize| ((i * nj + j) * nk + k) as u32;
        let (mut coords, mut conn) = (Vec::new(), Vec::new());
        for i in 0..=counts[0] {
            for j in 0..nj {
                for k in 0..nk {
                    let place = [i, if D == 3 { j } else { k }, k];
                    coords.push(std::array::from_fn(|axis| corner(axis, place[axis])));
                    if i < counts[0] && k < counts[2] && D == 2 {
                        conn.extend([node(i, 0, k), node(i + 1, 0, k), node(i + 1, 0, k + 1), node(i, 0, k + 1)]);
                    } else if i < counts[0] && k < counts[2] && j < counts[1] {
                        for k in [k, k + 1] {
                            conn.extend([node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k)]);
                        }
                    }
                }
            }
        }
        let cell_type = if D == 2 { CellType::Quad4 } else { CellType::Hex8 };
        let blocks = [CellBlock { cell_type, conn: &conn }];
        Contact::new(
            Surface::from_cells(&coords, &blocks, Bodies::Connected).unwrap(),
            Options::new(EnergyLaw::depth(1.0)),
        )
        .unwrap()
    }

    /// Bodies that a shape passes through on its way, each from where a step began, or from where it was added.
    fn bodies_on_way<const D: usize>(shape: Shape<D>, from: Pose<D>, to: Pose<D>, is_of_step: bool) -> usize {
        let mut contact = strip::<D>();
        let coords = contact.surface().reference().to_vec();
        let obstacle = contact.add_obstacle(Obstacle { shape, pose: from }).unwrap();
        contact.set_pose(obstacle, to).unwrap();
        passed(&contact, &coords, &[Stood { obstacle, pose: from, is_of_step }]).unwrap().len()
    }

    fn up<const D: usize>(x: f64, height: f64) -> Pose<D> {
        Pose::at(std::array::from_fn(|axis| {
            if axis == 0 {
                x
            } else if axis == D - 1 {
                height
            } else {
                0.0
            }
        }))
    }

    /// A box given by its facets, as a polytope.
    fn polytope(half: [f64; 2]) -> Shape<2> {
        let [x, y] = half;
        let points = vec![[-x, -y], [x, -y], [x, y], [-x, y]];
        Shape::Polytope { points, facets: vec![[0, 1], [1, 2], [2, 3], [3, 0]] }
    }

    fn shapes_2d() -> Vec<(&'static str, Shape<2>)> {
        vec![
            ("ball", Shape::Ball { radius: 0.5 }),
            ("cuboid", Shape::Cuboid { half_extents: [0.4, 0.5] }),
            ("capsule", Shape::Capsule { radius: 0.2, half_height: 0.3 }),
            ("polytope", polytope([0.4, 0.5])),
            ("function", Shape::SignedDistance(Arc::new(|x: &[f64; 2]| (x[0].hypot(x[1]) - 0.5, *x)))),
        ]
    }

    #[test]
    fn an_obstacle_that_is_moved_through_a_strip_is_found() {
        for is_of_step in [false, true] {
            for (name, shape) in shapes_2d() {
                for (x, to) in [(0.01, -0.8), (0.0, -0.8), (0.075, -0.8), (0.01, -0.4), (0.01, -30.0)] {
                    let found = bodies_on_way(shape.clone(), up(x, 0.5), up(x, to), is_of_step);
                    assert_eq!(found, 1, "{name} {x} {to} {is_of_step}");
                    // From pressed in a little, as every obstacle in contact is.
                    assert_eq!(bodies_on_way(shape.clone(), up(x, 0.499), up(x, to), true), 1, "{name} {x} {to}");
                }
            }
            let ball = Shape::<3>::Ball { radius: 0.5 };
            assert_eq!(bodies_on_way(ball, up(0.01, 0.5), up(0.3, -0.8), is_of_step), 1);
            let cuboid = Shape::<3>::Cuboid { half_extents: [0.4, 0.4, 0.5] };
            assert_eq!(bodies_on_way(cuboid, up(0.01, 0.5), up(0.01, -0.4), is_of_step), 1);
        }
    }

    /// Nothing that goes on on one side is told: pressed by less than half of the obstacle, slid and rolled by more than the contact is wide,
    /// off the end, let go, from deep inside too, and turned in place.
    #[test]
    fn an_obstacle_that_stays_on_its_side_is_not_told() {
        for (name, shape) in shapes_2d() {
            for (from, to) in [
                ([0.01, 0.5], [0.01, 0.5]),
                ([0.01, 0.5], [0.01, 0.2]),
                ([0.01, 0.45], [0.6, 0.45]),
                ([0.01, 0.45], [2.0, 0.45]),
                ([-2.5, 0.45], [4.0, 0.47]),
                ([0.01, 0.45], [0.01, 0.6]),
                ([0.01, 0.45], [5.0, 30.0]),
                ([0.01, 0.2], [0.01, 1.0]),
                ([0.01, 0.0], [0.01, 1.0]),
                ([0.01, -0.1], [0.01, 1.0]),
                ([5.0, 0.45], [5.0, -0.8]),
            ] {
                for is_of_step in [false, true] {
                    let found = bodies_on_way(shape.clone(), Pose::at(from), Pose::at(to), is_of_step);
                    assert_eq!(found, 0, "{name} {from:?} {to:?} {is_of_step}");
                }
            }
            // Added in the middle of the strip, and put below it before anything was asked.
            assert_eq!(bodies_on_way(shape, up(0.0, -0.1), up(0.0, -1.0), false), 0, "{name}");
        }
        for angle in [-2.0, 0.3, 1.5, std::f64::consts::PI] {
            let (ball, end) = (Shape::Ball { radius: 0.5 }, up::<2>(0.01 - 0.5 * angle, 0.49).turned(angle));
            assert_eq!(bodies_on_way(ball.clone(), up(0.01, 0.49), end, true), 0, "{angle}");
            let spun = up::<2>(0.01, 0.49).turned(angle);
            assert_eq!(bodies_on_way(ball, up(0.01, 0.49), spun, true), 0, "{angle}");
        }
        let half_space = Shape::<2>::HalfSpace;
        assert_eq!(bodies_on_way(half_space, up(0.0, -0.2), up(0.0, 0.3), true), 0);
        let ball = Shape::<3>::Ball { radius: 0.5 };
        assert_eq!(bodies_on_way(ball, up(0.01, 0.45), up(1.3, 0.45), true), 0);
    }

    /// A bar that turns about a point beside the strip sweeps through it, though both ends of its middle's way are straight above and below.
    #[test]
    fn an_obstacle_that_turns_through_a_strip_is_found() {
        let bar = Shape::Polytope {
            points: vec![[-2.0, -0.05], [-1.0, -0.05], [-1.0, 0.05], [-2.0, 0.05]],
            facets: vec![[0, 1], [1, 2], [2, 3], [3, 0]],
        };
        let found = |angle: f64| {
            bodies_on_way(bar.clone(), up::<2>(3.5, -0.1).turned(-0.5), up::<2>(3.5, -0.1).turned(angle - 0.5), true)
        };
        assert_eq!([found(1.0), found(0.2), found(-2.0)], [1, 0, 0]);
    }
}
