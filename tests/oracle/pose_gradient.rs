//! What an obstacle feels: the derivative of the overlap by its position, rotation and scale, against central differences
//! of the same estimate.

use crate::scene::table::{exactly, local_laws, uncorrected};
use crate::scene::{Scene, consistent_lines, cross, exact};
use fmc_contact::overlap::PoseGradient;
use fmc_contact::{Contact, Obstacle, Options, Pose, Shape};
use fmc_shapes::{Mesh, disc_tri3, icosphere, random_polygon, random_polyhedron, random_rotation, regular_polygon};
use std::sync::Arc;

/// Steps of the differences; the shorter one for estimates that have a kink, or the steep rim of a ball, within the longer.
const STEPS: [f64; 3] = [1e-6, 2e-7, 1e-5];

/// Pose turned about the origin of space, shape and position, by an angle about an axis (2D: the third).
fn turned<const D: usize>(pose: &Pose<D>, axis: usize, angle: f64) -> Pose<D> {
    let (p, q) = ((axis + 1) % 3, (axis + 2) % 3);
    let (s, c) = angle.sin_cos();
    let turn = |v: [f64; D]| -> [f64; D] {
        let mut v = v;
        (v[p], v[q]) = (c * v[p] - s * v[q], s * v[p] + c * v[q]);
        v
    };
    // Columns of the rotation are the shape's axes in space.
    let columns: [[f64; D]; D] = std::array::from_fn(|j| turn(std::array::from_fn(|i| pose.rotation[i][j])));
    let rotation = std::array::from_fn(|i| std::array::from_fn(|j| columns[j][i]));
    Pose { position: turn(pose.position), rotation, scale: pose.scale }
}

fn volume_and_gradient<const D: usize>(
    contact: &mut Contact<D>,
    coords: &[[f64; D]],
    pose: Pose<D>,
) -> (f64, PoseGradient<D>) {
    contact.set_pose(0, pose).unwrap();
    let overlap = contact.overlaps(coords).unwrap().remove(0);
    (overlap.volume, overlap.pose_gradient.unwrap())
}

fn gradient_matches<const D: usize>(body: &Mesh<D>, shape: &Shape<D>, pose: Pose<D>, options: Options, tolerance: f64) {
    let scene = Scene::of(&[body]);
    let mut contact = scene.contact(options);
    contact.add_obstacle(Obstacle { shape: shape.clone(), pose }).unwrap();
    // Of a local law, along lines that stay.
    contact.keep_patches(&scene.coords).unwrap();
    let (_, gradient) = volume_and_gradient(&mut contact, &scene.coords, pose);
    let size = gradient.position.norm();
    assert!(size > 0.1, "{shape:?} is met");
    let mut check = |what: &str, found: f64, moved: &dyn Fn(f64) -> Pose<D>| {
        let mut slope = |h: f64| {
            let mut at = |h: f64| volume_and_gradient(&mut contact, &scene.coords, moved(h)).0;
            (at(h) - at(-h)) / (2.0 * h)
        };
        let matches = STEPS.iter().any(|&h| (found - slope(h)).abs() < tolerance * size);
        assert!(matches, "{shape:?} by {what}: {found} against {}", slope(STEPS[0]));
    };
    for axis in 0..D {
        check("position", gradient.position[axis], &|h| {
            let mut moved = pose;
            moved.position[axis] += h;
            moved
        });
    }
    for axis in if D == 2 { 2..3 } else { 0..3 } {
        check("rotation", gradient.rotation[axis], &|h| turned(&pose, axis, h));
    }
    check("scale", gradient.scale, &|h| pose.scaled(pose.scale + h));

    if options.law.is_fiber() {
        return;
    }
    // Forces and moments of an evaluation are these derivatives, times −k.
    let contact_forces = contact_at(&mut contact, &scene, pose);
    for axis in 0..D {
        assert!((contact_forces.0[axis] + gradient.position[axis]).abs() < 1e-13 * size);
    }
    assert!((0..3).all(|axis| (contact_forces.1[axis] + gradient.rotation[axis]).abs() < 1e-13 * size));
}

fn contact_at<const D: usize>(contact: &mut Contact<D>, scene: &Scene<D>, pose: Pose<D>) -> ([f64; D], [f64; 3]) {
    contact.set_pose(0, pose).unwrap();
    let found = contact.evaluate(&scene.coords).unwrap();
    (found.obstacles[0].force, found.obstacles[0].moment)
}

/// Force and moment on an obstacle against the energy at other poses, under laws whose pressure varies over the contact; and
/// the measure along their lines against its own derivative, by the scale too. Whether there is one patch, as it takes:
/// at an edge between two, the energy has a step.
fn local_laws_match<const D: usize>(
    body: &Mesh<D>,
    shape: &Shape<D>,
    pose: Pose<D>,
    options: Options,
    tolerance: f64,
) -> bool {
    let scene = Scene::of(&[body]);
    let mut contact = scene.contact(options);
    contact.add_obstacle(Obstacle { shape: shape.clone(), pose }).unwrap();
    if contact.keep_patches(&scene.coords).unwrap() != 1 {
        return false;
    }
    let (force, moment) = contact_at(&mut contact, &scene, pose);
    let size = force.iter().map(|f| f * f).sum::<f64>().sqrt();
    let mut check = |what: &str, found: f64, moved: &dyn Fn(f64) -> Pose<D>| {
        let mut slope = |h: f64| {
            let mut at = |h: f64| {
                contact.set_pose(0, moved(h)).unwrap();
                contact.evaluate(&scene.coords).unwrap().energy
            };
            (at(h) - at(-h)) / (2.0 * h)
        };
        let matches = STEPS.iter().any(|&h| (found + slope(h)).abs() < tolerance * size);
        assert!(matches, "{shape:?} under {options:?} by {what}: {found} against {}", -slope(STEPS[0]));
    };
    for axis in 0..D {
        check("position", force[axis], &|h| {
            let mut moved = pose;
            moved.position[axis] += h;
            moved
        });
    }
    for axis in if D == 2 { 2..3 } else { 0..3 } {
        check("rotation", moment[axis], &|h| turned(&pose, axis, h));
    }
    gradient_matches(body, shape, pose, options, tolerance);
    true
}

/// Blunt bodies a little way in each other, so that there is one patch.
#[test]
fn local_laws_by_every_shape_in_2d() {
    let (radius, half_height) = (0.6, 0.5);
    let polygon = regular_polygon(7, 0.7);
    let distance = |x: &[f64; 2]| {
        let length = x[0].hypot(x[1]);
        (length - 0.6, [x[0] / length, x[1] / length])
    };
    let flat = [
        Shape::Cuboid { half_extents: [0.5, 0.7] },
        Shape::Polytope { facets: polygon.facets(), points: polygon.coords },
    ];
    let round = [
        Shape::HalfSpace,
        Shape::Ball { radius },
        Shape::Cylinder { radius, half_height },
        Shape::Cone { radius, half_height },
        Shape::Capsule { radius, half_height },
        Shape::SignedDistance(Arc::new(distance)),
    ];
    let mut tried = 0;
    let [quadratic, linear] = local_laws(1.0);
    for law in [quadratic, linear] {
        // What is no polynomial is integrated by points, whose sum has another slope.
        let exact = if law == quadratic { flat.as_slice() } else { &[] };
        for (shape, options) in exact
            .iter()
            .map(|s| (s, exactly(law)))
            .chain(flat.iter().chain(&round).map(|s| (s, uncorrected(law, 0.01, 4))))
        {
            tried += usize::from(local_laws_match(&disc_tri3(1.0, 15), shape, shallow_pose(), options, 1e-5));
        }
    }
    assert!(tried >= 10, "only {tried} of 18 have one patch");
}

#[test]
fn local_laws_by_every_shape_in_3d() {
    let (radius, half_height) = (0.6, 0.5);
    let sphere = icosphere(0.7, 1);
    let flat = [
        Shape::Cuboid { half_extents: [0.5, 0.7, 0.6] },
        Shape::Polytope { facets: sphere.facets(), points: sphere.coords },
    ];
    let round = [Shape::HalfSpace, Shape::Ball { radius }, Shape::Capsule { radius, half_height }];
    let body = random_polyhedron(1, 1.0, 0.15, 1, 3);
    let mut tried = 0;
    let [quadratic, linear] = local_laws(1.0);
    for (shape, options) in flat
        .iter()
        .map(|s| (s, exactly(quadratic)))
        .chain(flat.iter().chain(&round).map(|s| (s, uncorrected(linear, 0.03, 4))))
    {
        tried += usize::from(local_laws_match(&body, shape, shallow_pose(), options, 1e-5));
    }
    assert!(tried >= 5, "only {tried} of 7 have one patch");
}

/// With its centre this far from a body of radius 1.
fn shallow_pose<const D: usize>() -> Pose<D> {
    let away: [f64; 3] = [0.9, -0.9, 0.4];
    Pose { position: std::array::from_fn(|i| away[i]), rotation: random_rotation(5), scale: 0.9 }
}

fn plane_pose() -> Pose<2> {
    Pose { position: [0.5, -0.4], rotation: random_rotation(5), scale: 0.9 }
}

fn solid_pose() -> Pose<3> {
    Pose { position: [0.5, -0.4, 0.3], rotation: random_rotation(5), scale: 0.9 }
}

/// Rounding and truncation of the differences, 1e-16/1e-6 and 1e-12 times third derivatives.
#[test]
fn exact_overlap_with_flat_obstacles() {
    let polygon = random_polygon(7, 0.8, 0.4, 11).boundary();
    let polytope = Shape::Polytope { facets: polygon.facets(), points: polygon.coords };
    for shape in [Shape::HalfSpace, Shape::Cuboid { half_extents: [0.5, 0.7] }, polytope] {
        gradient_matches(&random_polygon(9, 1.0, 0.5, 3), &shape, plane_pose(), exact(), 1e-7);
    }
    let sphere = icosphere(0.8, 1);
    let polytope = Shape::Polytope { facets: sphere.facets(), points: sphere.coords };
    for shape in [Shape::HalfSpace, Shape::Cuboid { half_extents: [0.5, 0.7, 0.6] }, polytope] {
        gradient_matches(&random_polyhedron(1, 1.0, 0.3, 1, 3), &shape, solid_pose(), exact(), 1e-7);
    }
}

/// A line that grazes a round shape has a chord like √(distance from the rim), whose differences are poor: 1e-5.
#[test]
fn lines_through_every_shape_in_2d() {
    let (radius, half_height) = (0.6, 0.5);
    let polygon = regular_polygon(7, 0.7);
    let distance = |x: &[f64; 2]| {
        let length = x[0].hypot(x[1]);
        (length - 0.6, [x[0] / length, x[1] / length])
    };
    let shapes = [
        Shape::HalfSpace,
        Shape::Ball { radius },
        Shape::Cuboid { half_extents: [0.5, 0.7] },
        Shape::Cylinder { radius, half_height },
        Shape::Cone { radius, half_height },
        Shape::Capsule { radius, half_height },
        Shape::Polytope { facets: polygon.facets(), points: polygon.coords },
        Shape::SignedDistance(Arc::new(distance)),
    ];
    for shape in shapes {
        gradient_matches(&random_polygon(9, 1.0, 0.5, 3), &shape, plane_pose(), consistent_lines(0.02, 4), 1e-5);
    }
}

#[test]
fn lines_through_every_shape_in_3d() {
    let (radius, half_height) = (0.6, 0.5);
    let sphere = icosphere(0.7, 1);
    let shapes = [
        Shape::HalfSpace,
        Shape::Ball { radius },
        Shape::Cuboid { half_extents: [0.5, 0.7, 0.6] },
        Shape::Cylinder { radius, half_height },
        Shape::Cone { radius, half_height },
        Shape::Capsule { radius, half_height },
        Shape::Polytope { facets: sphere.facets(), points: sphere.coords },
        Shape::SignedDistance(Arc::new(|x: &[f64; 3]| {
            let length = x.iter().map(|x| x * x).sum::<f64>().sqrt();
            (length - 0.6, x.map(|x| x / length))
        })),
    ];
    for shape in shapes {
        gradient_matches(&random_polyhedron(1, 1.0, 0.3, 1, 3), &shape, solid_pose(), consistent_lines(0.07, 4), 1e-5);
    }
}

/// An obstacle's moment about the origin is that of its force at the place where it acts: a ball is pushed through its
/// centre.
#[test]
fn ball_is_pushed_through_its_centre() {
    let body = random_polyhedron(1, 1.0, 0.3, 1, 3);
    let scene = Scene::of(&[&body]);
    let pose = Pose::at([0.6, -0.5, 0.4]);
    let mut contact = scene.contact(consistent_lines(0.05, 1));
    contact.add_obstacle(Obstacle { shape: Shape::Ball { radius: 0.6 }, pose }).unwrap();
    let (force, moment) = contact_at(&mut contact, &scene, pose);
    let expected = cross(&pose.position, &force);
    assert!((0..3).all(|i| (moment[i] - expected[i]).abs() < 1e-13));
}
