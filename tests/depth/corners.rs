//! A block in the corner of one body: floor and wall push as those of two bodies would, however much deeper it is in the
//! one than in the other.

use crate::depth;
use crate::scene::Scene;
use fmc_shapes::{Mesh, cuboid_hex8, cuboid_tet4, rectangle_quad4};

const K: f64 = 1e6;

/// Ratios of the two penetrations from 1 : 1 to 1 : 1000, either the larger.
fn penetrations() -> impl Iterator<Item = [f64; 2]> {
    let ratios = [1.0, 2.0, 4.0, 10.0, 100.0, 1000.0];
    ratios.into_iter().flat_map(|ratio| [[8e-4 / ratio, 8e-4], [8e-4, 8e-4 / ratio]])
}

/// Forces on the block against k δ A of each wall, with A the area above the floor, or beside the wall. What both walls
/// have in common, and the rims, are of the order of the penetration by the size of a cell.
fn check<const D: usize>(corner: &Mesh<D>, block: impl Fn([f64; 2]) -> Mesh<D>, width: f64) {
    for [aside, down] in penetrations() {
        let scene = Scene::of(&[&block([aside, down]), corner]);
        let found = scene.evaluate(depth(K));
        let expected = [K * aside * 0.3 * width, K * down * 0.4 * width];
        for (found, expected) in [found.bodies[0].force[0], found.bodies[0].force[1]].into_iter().zip(expected) {
            assert!((found / expected - 1.0).abs() < 0.01, "{aside:e} and {down:e}: {found} for {expected}");
        }
        assert!(found.warnings.is_empty(), "{:?}", found.warnings);
    }
}

#[test]
fn floor_and_wall_of_one_mesh_push_as_two_bodies() {
    let mut corner = rectangle_quad4([-0.5, -0.5], [1.0, 0.0], [6, 2]);
    corner.append(&rectangle_quad4([-0.5, 0.0], [0.0, 0.8], [2, 4]));
    let block = |[aside, down]: [f64; 2]| rectangle_quad4([-aside, -down], [0.4, 0.3], [2, 2]);
    check(&corner.welded(1e-9), block, 1.0);
}

#[test]
fn floor_and_wall_of_one_mesh_push_as_two_bodies_in_3d() {
    let mut corner = cuboid_hex8([-0.5, -0.5, 0.0], [1.0, 0.0, 1.0], [6, 2, 4]);
    corner.append(&cuboid_hex8([-0.5, 0.0, 0.0], [0.0, 0.8, 1.0], [2, 4, 4]));
    let block = |[aside, down]: [f64; 2]| cuboid_tet4([-aside, -down, 0.2], [0.4, 0.3, 0.7], [2, 2, 2]);
    check(&corner.welded(1e-9), block, 0.5);
}

/// While the block comes down along the wall, energy and force have no step.
#[test]
fn energy_is_continuous_along_the_wall() {
    let mut corner = rectangle_quad4([-0.5, -0.5], [1.0, 0.0], [6, 2]);
    corner.append(&rectangle_quad4([-0.5, 0.0], [0.0, 0.8], [2, 4]));
    let scene = Scene::of(&[&rectangle_quad4([-5e-4, 0.0], [0.4, 0.3], [2, 2]), &corner.welded(1e-9)]);
    let contact = scene.contact(depth(K));
    let at = |down: f64| {
        let mut coords = scene.coords.clone();
        scene.nodes_of(0).for_each(|n| coords[n][1] -= down);
        let found = contact.evaluate(&coords).expect("valid coordinates");
        (found.energy, found.bodies[0].force[1])
    };
    let step = 5e-6;
    let found: Vec<(f64, f64)> = (0..400).map(|n| at(step * f64::from(n) - 1e-3)).collect();
    let largest = found.iter().fold(0.0f64, |m, (energy, _)| m.max(*energy));
    for pair in found.windows(2) {
        let beyond = pair[1].0 - pair[0].0 - 0.5 * step * (pair[0].1 + pair[1].1);
        assert!(beyond.abs() < 1e-4 * largest, "{beyond} of {largest}");
    }
}
