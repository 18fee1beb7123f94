//! A block in the corner of one body: floor and wall push as those of two bodies would, however much deeper it is in the
//! one than in the other.

use crate::scene::table::exactly;
use crate::scene::{Scene, lines};
use fmc_contact::{EnergyLaw, Obstacle, Options, Pose, Shape, Warning};
use fmc_shapes::{Mesh, cuboid_hex8, rectangle_quad4};

const K: f64 = 1e6;

/// Floor below y = 0 and wall left of x = 0, in one piece.
fn corner_2d() -> Mesh<2> {
    let mut corner = rectangle_quad4([-0.5, -0.5], [1.0, 0.0], [6, 2]);
    corner.append(&rectangle_quad4([-0.5, 0.0], [0.0, 0.8], [2, 4]));
    corner.welded(1e-9)
}

fn corner_3d() -> Mesh<3> {
    let mut corner = cuboid_hex8([-0.5, -0.5, 0.0], [1.0, 0.0, 1.0], [6, 2, 4]);
    corner.append(&cuboid_hex8([-0.5, 0.0, 0.0], [0.0, 0.8, 1.0], [2, 4, 4]));
    corner.welded(1e-9)
}

/// A block this far in the wall and in the floor.
fn block_2d(aside: f64, down: f64) -> Mesh<2> {
    rectangle_quad4([-aside, -down], [0.4, 0.3], [1, 1])
}

fn block_3d(aside: f64, down: f64) -> Mesh<3> {
    cuboid_hex8([-aside, -down, 0.2], [0.4, 0.3, 0.7], [2, 2, 2])
}

/// Ratios of the two penetrations from 1 : 1 to 1 : 1000, either the larger.
fn penetrations() -> impl Iterator<Item = [f64; 2]> {
    let ratios = [1.0, 2.0, 4.0, 10.0, 100.0, 1000.0];
    ratios.into_iter().flat_map(|ratio| [[8e-4 / ratio, 8e-4], [8e-4, 8e-4 / ratio]])
}

fn methods() -> [(Options, f64); 2] {
    // Sampled lines know the area in contact to a few thousandths.
    [(exactly(EnergyLaw::fiber(K)), 1e-9), (Options { law: EnergyLaw::fiber(K), ..lines(1e-3, 1) }, 0.01)]
}

/// Forces on the block against k A δ of each wall, with A the area above the floor, or beside the wall.
fn check<const D: usize>(found: [f64; D], [aside, down]: [f64; 2], width: f64, tolerance: f64, what: &str) {
    let expected = [K * aside * 0.3 * width, K * down * 0.4 * width];
    for (found, expected) in found.into_iter().zip(expected) {
        assert!((found / expected - 1.0).abs() < tolerance, "{what}, {aside:e} and {down:e}: {found} for {expected}");
    }
}

#[test]
#[ignore = "lines of the one patch run through the other's whole depth, and patches much deeper than others are left out"]
fn floor_and_wall_of_one_polygon_push_as_two_bodies() {
    let outline = [[-0.5, -0.5], [1.0, -0.5], [1.0, 0.0], [0.0, 0.0], [0.0, 0.8], [-0.5, 0.8]];
    let facets: Vec<[u32; 2]> = (0..6).map(|i| [i, (i + 1) % 6]).collect();
    for [aside, down] in penetrations() {
        let block = block_2d(aside, down);
        for (options, tolerance) in methods() {
            let mut contact = Scene::of(&[&block]).contact(options);
            let shape = Shape::Polytope { points: outline.to_vec(), facets: facets.clone() };
            contact.add_obstacle(Obstacle { shape, pose: Pose::at([0.0; 2]) }).unwrap();
            let found = contact.evaluate(&block.coords).unwrap().bodies[0].force;
            check(found, [aside, down], 1.0, tolerance, "polygon");
        }
    }
}

#[test]
#[ignore = "lines of the one patch run through the other's whole depth, and patches much deeper than others are left out"]
fn floor_and_wall_of_one_mesh_push_as_two_bodies() {
    for [aside, down] in penetrations() {
        let scene = Scene::of(&[&block_2d(aside, down), &corner_2d()]);
        for (options, tolerance) in methods() {
            let found = scene.evaluate(options);
            check(found.bodies[0].force, [aside, down], 1.0, tolerance, "mesh");
        }
    }
}

#[test]
#[ignore = "lines of the one patch run through the other's whole depth, and patches much deeper than others are left out"]
fn floor_and_wall_of_one_mesh_push_as_two_bodies_in_3d() {
    for [aside, down] in penetrations() {
        let scene = Scene::of(&[&block_3d(aside, down), &corner_3d()]);
        for (options, tolerance) in methods() {
            let estimator = if tolerance < 1e-3 { options.estimator } else { lines(8e-3, 1).estimator };
            let found = scene.evaluate(Options { estimator, ..options });
            check(found.bodies[0].force, [aside, down], 0.5, tolerance, "mesh");
        }
    }
}

/// While the block comes down along the wall, the energy is that of both contacts, and has no step.
#[test]
#[ignore = "lines of the one patch run through the other's whole depth, and patches much deeper than others are left out"]
fn energy_is_continuous_along_the_wall() {
    let aside: f64 = 5e-4;
    for (options, tolerance) in methods() {
        for step in 0..60 {
            let down = 1e-3 - 5e-5 * f64::from(step);
            let block = block_2d(aside, down);
            let scene = Scene::of(&[&block, &corner_2d()]);
            let found = scene.evaluate(options).energy;
            let height = 0.3 - (-down).max(0.0);
            let expected = 0.5 * K * (aside * aside * height + down.max(0.0).powi(2) * 0.4);
            assert!((found / expected - 1.0).abs() < tolerance.max(2e-9), "{down:e}: {found} for {expected}");
        }
    }
}

/// Until then, what is left out is told, with its size.
#[test]
fn a_patch_that_is_left_out_is_named() {
    for [aside, down] in [[1e-4, 5e-3], [1e-5, 2e-3]] {
        let scene = Scene::of(&[&block_2d(aside, down), &corner_2d()]);
        for (options, _) in methods() {
            let found = scene.evaluate(options);
            let told = found.warnings.iter().find_map(|warning| match warning {
                Warning::PatchLeftOut { normal, area, depth, .. } => Some((*normal, *area, *depth)),
                _ => None,
            });
            let (normal, area, depth) = told.expect("a warning");
            assert!(normal[1] < -0.99 && (area / 0.4 - 1.0).abs() < 0.05, "{normal:?}, {area}");
            assert!(depth > 0.9 * down && depth < 2.0 * down, "{depth} for {down}");
        }
    }
}
