//! What lies wholly inside moves freely there: neither side feels a force, however it is measured.

use crate::scene::table::exactly;
use crate::scene::{Scene, by_lines, exact, fibers, lines};
use fmc_contact::contact::TangentPart;
use fmc_contact::{EnergyLaw, FiberOptions, Obstacle, Options, Pose, Shape};
use fmc_shapes::{cuboid_hex8, rectangle_quad4};

const K: f64 = 1e4;

fn nothing_acts<const D: usize>(scene: &Scene<D>, shape: Shape<D>, at: [f64; D], options: Options) {
    let mut contact = scene.contact(options);
    contact.add_obstacle(Obstacle { shape, pose: Pose::at(at) }).expect("a valid obstacle");
    let found = contact.evaluate(&scene.coords).expect("valid coordinates");
    assert!(found.volume > 0.0 && found.warnings.len() == 1, "{:?}", found.warnings);
    assert!(found.forces.iter().flatten().all(|f| *f == 0.0));
    let obstacle = &found.obstacles[0];
    assert!(obstacle.force.iter().chain(&obstacle.moment).all(|f| *f == 0.0), "{options:?}: {obstacle:?}");
    if options.law.is_fiber() {
        let tangent = contact.tangent(&scene.coords, TangentPart::Full).expect("a tangent");
        let entries = || tangent.blocks.iter().flat_map(|block| block.value.as_flattened());
        assert!(entries().all(|k| k.abs() < 1e-9 * K), "{options:?}: {:?}", tangent.blocks);
    }
}

#[test]
fn on_a_swallowed_obstacle() {
    let square = Scene::of(&[&rectangle_quad4([0.0; 2], [1.0; 2], [3, 3])]);
    let cube = Scene::of(&[&cuboid_hex8([0.0; 3], [1.0; 3], [2; 3])]);
    let (fiber, volume) = (EnergyLaw::fiber(K), EnergyLaw::volume(K));
    for options in [
        by_lines(fiber),
        Options { law: fiber, ..lines(0.05, 3) },
        Options { law: volume, ..fibers(FiberOptions::default()) },
        Options { law: volume, ..fibers(FiberOptions { momentum_correction: false, ..FiberOptions::default() }) },
    ] {
        nothing_acts(&square, Shape::Ball { radius: 0.2 }, [0.43, 0.52], options);
        nothing_acts(&cube, Shape::Ball { radius: 0.2 }, [0.43, 0.52, 0.6], options);
    }
    for options in [exactly(fiber), Options { law: volume, ..exact() }] {
        nothing_acts(&square, Shape::Cuboid { half_extents: [0.2; 2] }, [0.43, 0.52], options);
        nothing_acts(&cube, Shape::Cuboid { half_extents: [0.2; 3] }, [0.43, 0.52, 0.6], options);
    }
}
