//! A body inside another is pushed out.

use crate::depth;
use crate::scene::Scene;
use fmc_shapes::{Diagonals, cuboid_tet4, rectangle_tri3};

/// The force on a rigid square inside a large one is k/2 ∫ |∇g| of the large one over it: k/2 times its area, towards
/// the nearest side, where it lies below one side only.
#[test]
fn force_is_towards_the_nearest_side() {
    let large = rectangle_tri3([-1.0, -1.0], [1.0, 1.0], [10, 10], Diagonals::Alternating);
    let small = rectangle_tri3([-0.2, 0.5], [0.2, 0.9], [2, 2], Diagonals::Same);
    let scene = Scene::of(&[&large, &small]);
    let found = scene.evaluate(depth(1e3));
    assert!((found.volume - 0.16).abs() < 1e-12);
    assert!((found.bodies[1].force[1] - 80.0).abs() < 1e-9, "{:?}", found.bodies);
    assert!(found.warnings.is_empty(), "{:?}", found.warnings);
    let large = cuboid_tet4([-1.0; 3], [1.0; 3], [6, 6, 6]);
    let small = cuboid_tet4([-0.2, -0.2, 0.5], [0.2, 0.2, 0.9], [2, 2, 2]);
    let found = Scene::of(&[&large, &small]).evaluate(depth(1e3));
    assert!((found.bodies[1].force[2] / 32.0 - 1.0).abs() < 0.05, "{:?}", found.bodies);
}

/// Flow along the force brings it out.
#[test]
fn it_comes_out() {
    let large = rectangle_tri3([-1.0, -1.0], [1.0, 1.0], [9, 9], Diagonals::Alternating);
    let small = rectangle_tri3([-0.2, -0.2], [0.2, 0.2], [2, 2], Diagonals::Same).translated([0.13, 0.21]);
    let scene = Scene::of(&[&large, &small]);
    let contact = scene.contact(depth(1.0));
    let mut coords = scene.coords.clone();
    let mut moves = 0;
    loop {
        let found = contact.evaluate(&coords).expect("valid coordinates");
        let force = found.bodies[1].force;
        let size = force[0].hypot(force[1]);
        if found.volume < 1e-4 {
            break;
        }
        moves += 1;
        assert!(moves < 60 && size > 0.0, "stuck at {:?} with V = {}", coords[scene.first_node[1]], found.volume);
        let step = 0.05f64.min(size);
        scene.nodes_of(1).for_each(|n| (0..2).for_each(|i| coords[n][i] += step * force[i] / size));
    }
}
