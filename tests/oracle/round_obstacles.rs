//! Ball, cylinder, cone and capsule, and their likes in 2D, by lines: against closed forms, and where there is none
//! against points thrown at random.

use crate::membership::{cover, in_shape, thrown};
use crate::scene::{Scene, isotropic, lines, norm};
use fmc_contact::overlap::Overlap;
use fmc_contact::{Contact, Obstacle, Options, Pose, Shape};
use fmc_shapes::{Diagonals, Mesh, cuboid_tet4, random_polygon, random_polyhedron, random_rotation, rectangle_tri3};
use std::f64::consts::PI;

/// A shape with its volume and the measure of its boundary.
struct Solid<const D: usize> {
    shape: Shape<D>,
    volume: f64,
    surface: f64,
}

const R: f64 = 0.7;
const H: f64 = 0.6;

/// Disc, rectangle, isosceles triangle, stadium.
fn plane_shapes() -> Vec<Solid<2>> {
    let (radius, half_height) = (R, H);
    let slant = R.hypot(2.0 * H);
    vec![
        Solid { shape: Shape::Ball { radius }, volume: PI * R * R, surface: 2.0 * PI * R },
        Solid { shape: Shape::Cuboid { half_extents: [R, H] }, volume: 4.0 * R * H, surface: 4.0 * (R + H) },
        Solid { shape: Shape::Cylinder { radius, half_height }, volume: 4.0 * R * H, surface: 4.0 * (R + H) },
        Solid { shape: Shape::Cone { radius, half_height }, volume: 2.0 * R * H, surface: 2.0 * (R + slant) },
        Solid {
            shape: Shape::Capsule { radius, half_height },
            volume: PI * R * R + 4.0 * R * H,
            surface: 2.0 * PI * R + 4.0 * H,
        },
    ]
}

fn solid_shapes() -> Vec<Solid<3>> {
    let (radius, half_height) = (R, H);
    let slant = R.hypot(2.0 * H);
    let disc = PI * R * R;
    vec![
        Solid { shape: Shape::Ball { radius }, volume: 4.0 / 3.0 * R * disc, surface: 4.0 * disc },
        Solid {
            shape: Shape::Cuboid { half_extents: [R, H, 0.5] },
            volume: 4.0 * R * H,
            surface: 8.0 * (R * H + 0.5 * (R + H)),
        },
        Solid {
            shape: Shape::Cylinder { radius, half_height },
            volume: 2.0 * H * disc,
            surface: 2.0 * disc + 4.0 * PI * R * H,
        },
        Solid {
            shape: Shape::Cone { radius, half_height },
            volume: 2.0 / 3.0 * H * disc,
            surface: disc + PI * R * slant,
        },
        Solid {
            shape: Shape::Capsule { radius, half_height },
            volume: (4.0 / 3.0 * R + 2.0 * H) * disc,
            surface: 4.0 * disc + 4.0 * PI * R * H,
        },
    ]
}

fn overlap<const D: usize>(body: &Mesh<D>, shape: &Shape<D>, pose: Pose<D>, options: Options) -> Overlap<D> {
    let scene = Scene::of(&[body]);
    let mut contact: Contact<D> = scene.contact(options);
    contact.add_obstacle(Obstacle { shape: shape.clone(), pose }).unwrap();
    contact.overlaps(&scene.coords).unwrap().remove(0)
}

fn close(found: f64, expected: f64, tolerance: f64, what: &str) {
    assert!((found / expected - 1.0).abs() < tolerance, "{what}: {found} instead of {expected}");
}

/// Wholly inside a block, however it stands: its own volume and surface, no force and no moment, and D V per relative
/// growth.
fn swallowed<const D: usize>(block: &Mesh<D>, solids: &[Solid<D>], spacing: f64, sampling: f64) {
    for solid in solids {
        for (seed, scale) in [(1, 1.0), (2, 0.6), (3, 1.3)] {
            let position = std::array::from_fn(|i| 0.1 * seed as f64 - 0.07 * i as f64);
            let pose = Pose { position, rotation: random_rotation(seed), scale };
            let what = format!("{:?}, scale {scale}", solid.shape);
            let found = overlap(block, &solid.shape, pose, lines(spacing * scale, seed));
            let d = D as i32;
            close(found.volume, solid.volume * scale.powi(d), sampling, &what);
            // The contact area is half of the boundary.
            close(2.0 * found.contact_area, solid.surface * scale.powi(d - 1), 3.0 * sampling, &what);
            let gradient = found.pose_gradient.unwrap();
            close(gradient.scale, D as f64 * solid.volume * scale.powi(d - 1), 3.0 * sampling, &what);
            let push = norm(&[gradient.position.into()]) / (solid.surface * scale.powi(d - 1));
            assert!(push < 3.0 * sampling, "{what}: {push:e}");
        }
    }
}

/// Lines some 100 (2D) or 40² (3D) per family across the shape; an end is off by half a spacing at most, at random.
#[test]
fn shapes_within_a_block() {
    let block = rectangle_tri3([-2.0; 2], [2.0; 2], [6, 6], Diagonals::Same);
    swallowed(&block, &plane_shapes(), 0.01, 2e-3);
    let block = cuboid_tet4([-2.0; 3], [2.0; 3], [3; 3]);
    swallowed(&block, &solid_shapes(), 0.03, 2e-3);
}

/// A plane through the centre of a shape that is its own mirror image there halves it, however it is turned, and the
/// force is as large as the section.
#[test]
fn faces_through_the_centre_halve_a_shape() {
    let block = rectangle_tri3([-2.0, -3.0], [2.0, 0.0], [6, 5], Diagonals::Same);
    for solid in plane_shapes().iter().filter(|s| !matches!(s.shape, Shape::Cone { .. })) {
        for seed in 0..3 {
            let pose = Pose { position: [0.2, 0.0], rotation: random_rotation(seed), scale: 1.0 };
            let found = overlap(&block, &solid.shape, pose, lines(0.004, seed));
            close(found.volume, 0.5 * solid.volume, 2e-3, &format!("{:?}", solid.shape));
        }
    }
    let block = cuboid_tet4([-2.0, -2.0, -3.0], [2.0, 2.0, 0.0], [3; 3]);
    for solid in solid_shapes().iter().filter(|s| !matches!(s.shape, Shape::Cone { .. })) {
        for seed in 0..3 {
            let pose = Pose { position: [0.2, -0.1, 0.0], rotation: random_rotation(seed), scale: 1.0 };
            let found = overlap(&block, &solid.shape, pose, lines(0.03, seed));
            close(found.volume, 0.5 * solid.volume, 4e-3, &format!("{:?}", solid.shape));
            if let Shape::Ball { radius } = solid.shape {
                let force = found.pose_gradient.unwrap().position;
                close(force.norm(), PI * radius * radius, 1e-2, "section of the ball");
                close(-force[2], PI * radius * radius, 1e-2, "section of the ball");
                close(found.penetration, radius, 1e-2, "depth of the ball");
            }
        }
    }
}

/// Isotropic fibers see the same halves: the mean over 40 seeds within 3.5 of its standard errors, which one of 2 000 honest
/// means misses.
#[test]
fn isotropic_fibers_through_halved_shapes() {
    let block = rectangle_tri3([-2.0, -3.0], [2.0, 0.0], [6, 5], Diagonals::Same);
    let half_space = Solid { shape: Shape::HalfSpace, volume: 0.0, surface: 0.0 };
    for solid in plane_shapes().iter().chain([&half_space]).filter(|s| !matches!(s.shape, Shape::Cone { .. })) {
        let upright = solid.volume == 0.0;
        // A half-space on its head, 1 deep in the block.
        let rotation = if upright { [[-1.0, 0.0], [0.0, -1.0]] } else { random_rotation(3) };
        let position = if upright { [0.2, -1.0] } else { [0.2, 0.0] };
        let pose = Pose { position, rotation, scale: 1.0 };
        let values: Vec<f64> =
            (0..40).map(|seed| overlap(&block, &solid.shape, pose, isotropic(0.4, 2_000, seed)).volume).collect();
        let mean = values.iter().sum::<f64>() / 40.0;
        let error = (values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / (39.0 * 40.0)).sqrt();
        let expected = if upright { 4.0 } else { 0.5 * solid.volume };
        assert!(error < 0.02 * expected);
        assert!((mean - expected).abs() < 3.5 * error, "{:?}: {mean} ± {error} of {expected}", solid.shape);
    }
}

/// A depth h of a ball, a cone on its tip, a lying and a standing cylinder in the block: the paper's shapes.
#[test]
fn caps_and_tips() {
    let block = cuboid_tet4([-2.0, -2.0, -3.0], [2.0, 2.0, 0.0], [3; 3]);
    let h = 0.2;
    let at = |z: f64| Pose::at([0.1, -0.2, z]);
    let check = |shape: Shape<3>, pose: Pose<3>, volume: f64, slope: f64| {
        let found = overlap(&block, &shape, pose, lines(0.01, 4));
        close(found.volume, volume, 4e-3, &format!("{shape:?}"));
        close(-found.pose_gradient.unwrap().position[2], slope, 1e-2, &format!("{shape:?}"));
    };
    check(Shape::Ball { radius: R }, at(R - h), PI * h * h * (R - h / 3.0), PI * h * (2.0 * R - h));
    let (radius, half_height) = (R, H);
    let tip = R * h / (2.0 * H);
    let upside_down = at(H - h).turned_about([1.0, 0.0, 0.0], PI);
    check(Shape::Cone { radius, half_height }, upside_down, PI * tip * tip * h / 3.0, PI * tip * tip);
    check(Shape::Cylinder { radius, half_height }, at(H - h), PI * R * R * h, PI * R * R);
    // Lying: the segment of the disc, as long as the cylinder.
    let lying = at(R - h).turned_about([0.0, 1.0, 0.0], 0.5 * PI);
    let angle = ((R - h) / R).acos();
    let segment = R * R * (angle - 0.5 * (2.0 * angle).sin());
    check(Shape::Cylinder { radius, half_height }, lying, segment * 2.0 * H, 2.0 * R * angle.sin() * 2.0 * H);
    // The capsule's lower end is a ball.
    check(Shape::Capsule { radius, half_height }, at(R + H - h), PI * h * h * (R - h / 3.0), PI * h * (2.0 * R - h));
    let block = rectangle_tri3([-2.0, -3.0], [2.0, 0.0], [6, 5], Diagonals::Same);
    let found = overlap(&block, &Shape::Ball { radius: R }, Pose::at([0.1, R - h]), lines(0.001, 4));
    close(found.volume, segment, 2e-3, "segment of the disc");
    close(-found.pose_gradient.unwrap().position[1], 2.0 * R * angle.sin(), 1e-2, "chord of the disc");
}

/// Anywhere in concave bodies: points thrown at random, 4 standard errors.
#[test]
fn shapes_across_concave_bodies() {
    for (seed, solid) in plane_shapes().iter().enumerate() {
        let seed = seed as u64;
        let body = random_polygon(9, 1.0, 0.5, seed);
        let pose = Pose { position: [0.5, -0.4], rotation: random_rotation(seed), scale: 0.9 };
        let inside = |x: &[f64; 2]| usize::from(in_shape(&solid.shape, &pose, x)) * cover(&body, x);
        let [volume, error] = thrown([[-1.6; 2], [1.6; 2]], 100_000, seed, inside);
        let found = overlap(&body, &solid.shape, pose, lines(0.004, seed));
        assert!((found.volume - volume).abs() < 4.0 * error + 1e-3, "{:?}: {} of {volume}", solid.shape, found.volume);
    }
    for (seed, solid) in solid_shapes().iter().enumerate() {
        let seed = seed as u64;
        let body = random_polyhedron(1, 1.0, 0.3, 1, seed);
        let pose = Pose { position: [0.5, -0.4, 0.3], rotation: random_rotation(seed), scale: 0.9 };
        let inside = |x: &[f64; 3]| if in_shape(&solid.shape, &pose, x) { cover(&body, x) } else { 0 };
        let [volume, error] = thrown([[-1.4; 3], [1.4; 3]], 100_000, seed, inside);
        let found = overlap(&body, &solid.shape, pose, lines(0.03, seed));
        assert!((found.volume - volume).abs() < 4.0 * error + 3e-3, "{:?}: {} of {volume}", solid.shape, found.volume);
    }
}
