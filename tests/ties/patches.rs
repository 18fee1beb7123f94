//! A small patch in the midst of a large facet is held, and does not turn as on a hinge.

use crate::scene::Scene;
use crate::{K, tied};
use fmc_contact::Contact;
use fmc_shapes::{cuboid_hex8, rectangle_quad4};

/// The energy of a small turn of the second body about the middle of the patch, in the plane of two axes.
fn turned<const D: usize>(
    scene: &Scene<D>,
    contact: &Contact<D>,
    centre: [f64; D],
    [i, j]: [usize; 2],
    angle: f64,
) -> f64 {
    let mut coords = scene.coords.clone();
    for x in &mut coords[scene.first_node[1]..] {
        let arm: [f64; D] = std::array::from_fn(|axis| x[axis] - centre[axis]);
        (x[i], x[j]) = (x[i] - angle * arm[j], x[j] + angle * arm[i]);
    }
    contact.evaluate(&coords).expect("an evaluation").energy
}

/// By the jump itself the energy is K/2 φ² s³/12, and K/2 φ² s⁴/12 about an axis in the face of a square. Means over three edges leave
/// more than half of it, over the one large facet they would leave (s/h)² = 1/400.
#[test]
fn a_small_block_does_not_turn() {
    let (s, angle) = (0.05f64, 1e-4f64);
    let low = 0.5 - 0.5 * s;
    for swapped in [false, true] {
        let large = rectangle_quad4([0.0, 0.0], [1.0, 0.5], [1, 1]);
        let small = rectangle_quad4([low, 0.5], [low + s, 0.55], [3, 1]);
        let scene = if swapped { Scene::of(&[&small, &large]) } else { Scene::of(&[&large, &small]) };
        let found = turned(&scene, &tied(&scene, 0.0), [0.5, 0.5], [0, 1], angle)
            / (0.5 * K * angle * angle * s.powi(3) / 12.0);
        assert!((0.5..1.0 + 1e-9).contains(&found), "{found}");
    }
    let large = cuboid_hex8([0.0; 3], [1.0, 1.0, 0.5], [1, 1, 1]);
    let small = cuboid_hex8([low, low, 0.5], [low + s, low + s, 0.55], [3, 3, 1]);
    let scene = Scene::of(&[&large, &small]);
    for axes in [[1, 2], [0, 2]] {
        let found =
            turned(&scene, &tied(&scene, 0.0), [0.5; 3], axes, angle) / (0.5 * K * angle * angle * s.powi(4) / 12.0);
        assert!((0.5..1.0 + 1e-9).contains(&found), "{found}");
    }
}

/// Where many facets meet, the larger ones hold: as many means as they have nodes.
#[test]
fn the_larger_facets_hold() {
    let scene = Scene::of(&[
        &rectangle_quad4([0.0, 0.0], [1.0, 0.5], [5, 1]),
        &rectangle_quad4([0.0, 0.5], [1.0, 1.0], [35, 1]),
    ]);
    assert_eq!(tied(&scene, 0.0).tie([0, 1]).expect("bodies").expect("a tie").count, 6);
}
