//! A body that overlaps itself is two bodies that do.

use crate::depth;
use crate::scene::{Scene, distance, size_sum};
use fmc_contact::Options;
use fmc_shapes::{Diagonals, cuboid_tet4, rectangle_tri3};

#[test]
fn two_blocks_under_one_number() {
    let lower = rectangle_tri3([0.0, -1.0], [1.0, 0.0], [5, 5], Diagonals::Same).rotated(0.1);
    let upper = rectangle_tri3([0.1, -0.1], [0.8, 0.6], [3, 4], Diagonals::Alternating);
    as_two(&lower, &upper);
    let lower = cuboid_tet4([0.0, 0.0, -1.0], [1.0, 1.0, 0.0], [3, 3, 3]).rotated([1.0, 2.0, 3.0], 0.1);
    let upper = cuboid_tet4([0.1, 0.2, -0.1], [0.8, 0.9, 0.6], [2, 3, 2]);
    as_two(&lower, &upper);
}

fn as_two<const D: usize>(lower: &fmc_shapes::Mesh<D>, upper: &fmc_shapes::Mesh<D>) {
    // Depths are found while they are apart.
    let away = upper.clone().mapped(|x| x.map(|x| x + 5.0));
    let coords = Scene::of(&[lower, upper]).coords;
    let at = |scene: Scene<D>, options| scene.contact(options).evaluate(&coords).expect("valid coordinates");
    let two = at(Scene::of(&[lower, &away]), depth(7.0));
    let one = at(Scene::new().with(lower, 0).with(&away, 0), Options { self_contact: true, ..depth(7.0) });
    assert!(two.volume > 1e-3 && two.energy > 0.0);
    assert!((one.volume - two.volume).abs() < 1e-12, "{} {}", one.volume, two.volume);
    assert!((one.energy - two.energy).abs() < 1e-12 * two.energy);
    assert!(distance(&one.forces, &two.forces) < 1e-12 * size_sum(&two.forces));
}
