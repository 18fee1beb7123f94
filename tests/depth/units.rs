//! The law knows no unit and no numbering.

use crate::depth;
use crate::scene::{Scene, distance, lines, size_sum};
use fmc_contact::{EnergyLaw, Obstacle, Options, Pose, Shape};
use fmc_shapes::{Splitmix, cuboid_hex8, cuboid_tet4};

fn scene() -> Scene<3> {
    let lower = cuboid_tet4([0.0, 0.0, -1.0], [1.0, 1.0, 0.0], [4, 3, 3]);
    let upper = cuboid_hex8([0.1, 0.2, -0.1], [0.9, 0.8, 0.9], [2, 3, 2]).rotated([1.0, 2.0, 3.0], 0.05);
    Scene::of(&[&lower, &upper])
}

/// In another unit of length, s of which make one of before, energies grow as s⁴ and forces as s³.
#[test]
fn another_unit_of_length() {
    let scene = scene();
    let with_obstacle = |scene: &Scene<3>, s: f64| {
        let mut contact = scene.contact(depth(2.0));
        let shape = Shape::Cuboid { half_extents: [0.6 * s, 0.6 * s, 0.2 * s] };
        contact.add_obstacle(Obstacle { shape, pose: Pose::at([0.5 * s, 0.5 * s, -1.1 * s]) }).expect("an obstacle");
        contact.evaluate(&scene.coords).expect("valid coordinates")
    };
    let before = with_obstacle(&scene, 1.0);
    assert_eq!(before.pairs.len(), 2);
    for s in [1e-6, 1e5] {
        let found = with_obstacle(&scene.clone().mapped(|x| x.map(|x| s * x)), s);
        assert!((found.energy / s.powi(4) / before.energy - 1.0).abs() < 1e-12, "{s:e}");
        let forces: Vec<[f64; 3]> = found.forces.iter().map(|f| f.map(|f| f / s.powi(3))).collect();
        assert!(distance(&forces, &before.forces) < 1e-12 * size_sum(&before.forces), "{s:e}");
    }
}

/// Nodes in another order, and bodies too, exactly and on the same lines.
#[test]
fn another_numbering() {
    renumbered(depth(2.0));
    renumbered(Options { law: EnergyLaw::depth(2.0), ..lines(0.03, 1) });
}

fn renumbered(options: Options) {
    let scene = scene();
    let before = scene.evaluate(options);
    let count = scene.coords.len();
    let mut order: Vec<usize> = (0..count).collect();
    let mut random = Splitmix::new(5);
    for last in (1..count).rev() {
        order.swap(last, (random.between(0.0, 1.0) * (last + 1) as f64) as usize % (last + 1));
    }
    // Node n is now number order[n].
    let mut other = scene.clone();
    other.blocks.iter_mut().flat_map(|block| &mut block.1).for_each(|n| *n = order[*n as usize] as u32);
    (0..count).for_each(|n| other.coords[order[n]] = scene.coords[n]);
    other.ids.iter_mut().for_each(|id| *id = 1 - *id);
    let found = other.evaluate(options);
    assert!((found.energy / before.energy - 1.0).abs() < 1e-12);
    let forces: Vec<[f64; 3]> = (0..count).map(|n| found.forces[order[n]]).collect();
    assert!(distance(&forces, &before.forces) < 1e-12 * size_sum(&before.forces));
}
