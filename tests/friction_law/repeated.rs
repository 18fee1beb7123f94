//! The coefficient times the pressure by a law of the host is the library's own friction.

use crate::laws::{capped, coulomb};
use crate::scene::{Scene, table::exactly};
use crate::{
    BODIES, DELTA, STIFFNESS, along, depth, flat_block, flat_cuboid, in_plane, in_space, on_plane, rub, waved,
};
use fmc_contact::contact::{Friction, TangentPart};
use fmc_contact::overlap::Partner::{Body, Obstacle};
use fmc_contact::{Contact, EnergyLaw, Options};

/// Largest difference of what two contacts answer, by the largest of it: forces, tangent, and what is told of friction.
fn differences<const D: usize>([one, other]: [&Contact<D>; 2], coords: &[[f64; D]]) -> f64 {
    let direction: Vec<[f64; D]> = (0..coords.len())
        .map(|node| std::array::from_fn(|axis| (0.3 + node as f64 + 5.1 * axis as f64).cos()))
        .collect();
    let asked = [one, other].map(|contact| {
        let forces = contact.evaluate(coords).expect("forces");
        let mut lists = vec![forces.forces.as_flattened().to_vec()];
        for part in [TangentPart::Full, TangentPart::Symmetric, TangentPart::Semidefinite] {
            lists.push(contact.tangent(coords, part).expect("a tangent").product(&direction).as_flattened().to_vec());
        }
        let told = forces.friction;
        lists.push(vec![told.stored, told.dissipated]);
        lists.push(vec![told.stick_area, told.slip_area]);
        lists
    });
    let [one, other] = asked;
    let mut worst = 0.0f64;
    for (a, b) in one.iter().zip(&other) {
        let size = a.iter().fold(f64::MIN_POSITIVE, |most: f64, x| most.max(x.abs()));
        worst = a.iter().zip(b).fold(worst, |worst, (a, b)| worst.max((a - b).abs() / size));
    }
    worst
}

/// Three steps, in which it sticks, slides, and slides back; forces and tangent also while friction is frozen.
fn goes_alike<const D: usize>(scene: &Scene<D>, mut both: [Contact<D>; 2]) {
    both.iter_mut().for_each(|contact| contact.begin_step(&scene.coords).expect("a step"));
    for by in [0.1, 3.0, 1.5] {
        let coords = waved(&along(scene, by * DELTA), 0.05 * DELTA);
        let found = differences(both.each_ref(), &coords);
        // Sums in another order: rounding.
        assert!(found < 1e-12, "by {by}: {found:e}");
        both.iter_mut().for_each(|contact| contact.freeze_friction(&coords).expect("frozen"));
        let found = differences(both.each_ref(), &waved(&coords, 0.02 * DELTA));
        assert!(found < 1e-12, "frozen, by {by}: {found:e}");
        both.iter_mut().for_each(|contact| contact.commit_step(&coords).expect("a step"));
    }
}

fn both<const D: usize>(
    scene: &Scene<D>,
    options: Options,
    law: impl fmc_contact::contact::FrictionLaw + 'static,
) -> [Contact<D>; 2] {
    let mut own = scene.contact(Options { friction: Friction { coefficient: 0.0, ..options.friction }, ..options });
    rub(&mut own, BODIES, law);
    [scene.contact(options), own]
}

#[test]
fn coulomb_by_the_host_is_that_of_the_library() {
    for law in [EnergyLaw::depth(STIFFNESS), EnergyLaw::fiber(STIFFNESS), EnergyLaw::volume(STIFFNESS)] {
        let stiffness = matches!(law, EnergyLaw::Volume { .. }).then_some(500.0);
        let options = Options { friction: Friction { stiffness, ..Friction::coulomb(0.3) }, ..exactly(law) };
        goes_alike(&in_plane(), both(&in_plane(), options, coulomb(0.3)));
        goes_alike(&in_space(), both(&in_space(), options, coulomb(0.3)));
    }
    let memoryless = Friction { memoryless_slip: Some(2.0 * DELTA), ..Friction::coulomb(0.3) };
    let options = Options { friction: memoryless, ..depth() };
    goes_alike(&in_plane(), both(&in_plane(), options, coulomb(0.3)));
    let options = Options { friction: Friction::coulomb(0.3), axisymmetric: true, ..depth() };
    let ring = Scene { coords: in_plane().coords.iter().map(|x| [x[0] + 1.5, x[1]]).collect(), ..in_plane() };
    goes_alike(&ring, both(&ring, options, coulomb(0.3)));
}

#[test]
fn on_an_obstacle_too() {
    let options = Options { friction: Friction::coulomb(0.3), ..depth() };
    let pair = [Body(0), Obstacle(0)];
    let ((scene, library), (_, mut own)) = (on_plane(&flat_block(), options), on_plane(&flat_block(), depth()));
    rub(&mut own, pair, coulomb(0.3));
    goes_alike(&scene, [library, own]);
    let ((scene, library), (_, mut own)) = (on_plane(&flat_cuboid(), options), on_plane(&flat_cuboid(), depth()));
    rub(&mut own, pair, coulomb(0.3));
    goes_alike(&scene, [library, own]);
}

/// Two blocks that are one body, against itself.
#[test]
fn in_self_contact_too() {
    let scene = Scene { ids: vec![0; in_plane().ids.len()], ..in_plane() };
    let options = Options { friction: Friction::coulomb(0.3), self_contact: true, ..depth() };
    let mut own = scene.contact(Options { friction: Friction::default(), ..options });
    rub(&mut own, [Body(0); 2], coulomb(0.3));
    goes_alike(&scene, [scene.contact(options), own]);
}

/// Multipliers move surfaces out, and raise the pressure that the law is asked with.
#[test]
fn with_multipliers_too() {
    let options = Options { friction: Friction::coulomb(0.3), ..depth() };
    let scene = in_space();
    let mut both = both(&scene, options, coulomb(0.3));
    both.iter_mut().for_each(|contact| contact.begin_step(&scene.coords).expect("a step"));
    let coords = along(&scene, 3.0 * DELTA);
    let before = both[0].evaluate(&coords).expect("forces").friction.dissipated;
    for contact in &mut both {
        contact.augment(&coords, 0.1, 0.0).expect("multipliers");
    }
    let after = both[1].evaluate(&coords).expect("forces").friction.dissipated;
    assert!(after > 1.2 * before, "{before} {after}");
    let found = differences(both.each_ref(), &waved(&coords, 0.02 * DELTA));
    assert!(found < 1e-12, "{found:e}");
}

/// A cap is the shear limit of the library, where all points of a facet are beyond it or none is.
#[test]
fn a_cap_is_a_shear_limit() {
    for limit in [0.1, 0.5] {
        let friction = Friction { shear_limit: limit, ..Friction::coulomb(0.3) };
        let (scene, library) = on_plane(&flat_block(), Options { friction, ..depth() });
        let (_, mut own) = on_plane(&flat_block(), depth());
        rub(&mut own, [Body(0), Obstacle(0)], capped(0.3, limit));
        goes_alike(&scene, [library, own]);
    }
}
