//! A body that overlaps itself is two bodies that do.

use crate::exactly;
use crate::scene::{Scene, distance, size_sum};
use fmc_contact::{EnergyLaw, Options};
use fmc_shapes::{Diagonals, rectangle_quad4, rectangle_tri3};

#[test]
fn two_rings_under_one_number() {
    let lower = rectangle_tri3([0.0, -1.0], [1.0, 0.0], [5, 5], Diagonals::Same);
    let upper = rectangle_quad4([0.2, -0.1], [0.8, 0.6], [3, 4]).mapped(|[r, z]| [r, z + 0.05 * r]);
    // Depths are found while they are apart.
    let away = upper.clone().mapped(|x| x.map(|x| x + 5.0));
    let coords = Scene::of(&[&lower, &upper]).coords;
    let of = |scene: Scene<2>, options| scene.contact(options).evaluate(&coords).expect("valid coordinates");
    for law in [EnergyLaw::depth(7.0), EnergyLaw::volume(7.0)] {
        let two = of(Scene::of(&[&lower, &away]), exactly(law));
        let itself = Options { self_contact: true, ..exactly(law) };
        let one = of(Scene::new().with(&lower, 0).with(&away, 0), itself);
        assert!(two.volume > 1e-2 && two.energy > 0.0);
        assert!((one.volume / two.volume - 1.0).abs() < 1e-12, "{law:?}: {} {}", one.volume, two.volume);
        assert!((one.energy / two.energy - 1.0).abs() < 1e-12, "{law:?}: {} {}", one.energy, two.energy);
        assert!(distance(&one.forces, &two.forces) < 1e-12 * size_sum(&two.forces), "{law:?}");
    }
}
