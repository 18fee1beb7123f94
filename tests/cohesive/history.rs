//! Damage that stays: unloading to the origin, loading again, steps that are tried again, restarts, and threads.

use crate::{held, in_space, in_the_plane, law, moved};
use fmc_contact::contact::{PairOptions, PointDamage, TangentPart};
use fmc_contact::overlap::Partner::Body;
use fmc_contact::{EnergyLaw, Error, Options};

/// k, the opening where damage begins and where it ends, by the law's formulas.
const STIFFNESS: f64 = 50.0 * 4.0 / 0.1;
const ONSET: f64 = 2.0 / STIFFNESS;
const END: f64 = 2.0 * 0.1 / 2.0;

fn damage(opening: f64) -> f64 {
    (END * (opening - ONSET) / (opening * (END - ONSET))).clamp(0.0, 1.0)
}

#[test]
fn unloading_goes_to_the_origin_and_loading_comes_back() {
    let scene = &in_the_plane(0.0)[0];
    let mut contact = held(scene, law());
    let force = |contact: &fmc_contact::Contact<2>, way: f64| {
        let forces = contact.evaluate(&moved(scene, [0.0, way])).expect("an evaluation").forces;
        -forces[scene.first_node[1]..].iter().map(|f| f[1]).sum::<f64>()
    };
    assert_eq!(contact.commit_step(&scene.coords), Err(Error::NoStep));
    contact.begin_step(&scene.coords).expect("a step");
    let mut energies = Vec::new();
    for way in [0.01, 0.004, 0.01, 0.03, 0.0, 0.06, 0.02] {
        let before = contact.damage().expect("points")[0].damage;
        // Tried, and tried again: nothing of it stays.
        let tried = force(&contact, 0.08);
        assert_eq!(tried, force(&contact, 0.08));
        assert_eq!(contact.damage().expect("points")[0].damage, before);
        let expected = before.max(damage(way));
        assert!((force(&contact, way) - (1.0 - expected) * STIFFNESS * way).abs() < 1e-10, "at {way}");
        let coords = moved(scene, [0.0, way]);
        let energy = contact.evaluate(&coords).expect("an evaluation").energy;
        contact.commit_step(&coords).expect("a step");
        // The energy does not jump as a step is accepted, and what is dissipated never falls.
        assert!((contact.evaluate(&coords).expect("an evaluation").energy - energy).abs() < 1e-13);
        let told = contact.cohesive([0, 1], &coords).expect("bodies").expect("an interface");
        energies.push(told.dissipated);
        assert!(contact.damage().expect("points").iter().all(|point| (point.damage - expected).abs() < 1e-9));
    }
    assert!(energies.is_sorted());
    // The triangle under the curve less what unloading from 0.06 gives back.
    let force_at = 2.0 * (END - 0.06) / (END - ONSET);
    let under = 0.1 - 0.5 * force_at * (END - 0.06);
    assert!((energies[6] - (under - 0.5 * force_at * 0.06)).abs() < 1e-11);
    let points = contact.cohesive_points(&moved(scene, [0.0, 0.06])).expect("points");
    assert!(
        points.iter().all(|point| (point.opening - 0.06).abs() < 1e-14 && (point.traction[1] + force_at).abs() < 1e-10)
    );
    assert!((points.iter().map(|point| point.area).sum::<f64>() - 1.0).abs() < 1e-14);
    assert!(points.iter().all(|point| (point.position[1] - 0.5).abs() < 1e-15 && point.bodies == [0, 1]));
}

/// A bent, half broken interface: another contact with the damage of one gives its bits, with any number of threads.
#[test]
fn a_restart_and_threads_give_the_same_bits() {
    for scene in &in_space(0.0) {
        let bent = |by: f64| -> Vec<[f64; 3]> {
            let start = scene.first_node[1];
            let moved = |(node, x): (usize, &[f64; 3])| {
                let part = if node < start { 0.0 } else { by };
                [x[0] + 0.2 * part * x[0] * x[1], x[1] - part * x[0] * x[2], x[2] + part * x[0] * (1.0 + x[1])]
            };
            scene.coords.iter().enumerate().map(moved).collect()
        };
        let mut contact = held(scene, law());
        contact.begin_step(&scene.coords).expect("a step");
        for by in [0.004, 0.012, 0.007] {
            contact.commit_step(&bent(by)).expect("a step");
        }
        let kept = contact.damage().expect("points");
        assert!(kept.iter().any(|point| point.damage == 0.0) && kept.iter().any(|point| point.damage > 0.5));
        for threads in [1, 3] {
            let mut other = scene.contact(Options { threads, ..Options::new(EnergyLaw::depth(1.0)) });
            let options = Some(PairOptions::with_cohesive(law()));
            other.set_pair_options([0, 1].map(Body), options).expect("an interface");
            other.begin_step(&bent(0.007)).expect("a step");
            other.set_damage(&kept).expect("damage");
            for by in [0.003, 0.015] {
                assert_eq!(contact.evaluate(&bent(by)), other.evaluate(&bent(by)));
                let part = TangentPart::Full;
                assert_eq!(contact.tangent(&bent(by), part), other.tangent(&bent(by), part));
            }
            other.commit_step(&bent(0.015)).expect("a step");
            assert_ne!(other.damage().expect("points"), kept);
        }
    }
}

#[test]
fn damage_is_set_point_by_point_or_refused() {
    let scene = &in_the_plane(0.0)[1];
    let mut contact = held(scene, law());
    let count = contact.damage().expect("points").len();
    assert!(contact.damage().expect("points").iter().all(|point| *point == PointDamage::default()));
    // Broken at first: a crack.
    let broken = PointDamage { damage: 1.0, dissipated: 0.0 };
    contact.set_damage(&vec![broken; count]).expect("damage");
    assert_eq!(contact.evaluate(&moved(scene, [0.01, 0.02])).expect("an evaluation").energy, 0.0);
    let too_few = contact.set_damage(&vec![broken; count - 1]);
    assert_eq!(too_few, Err(Error::Length { array: "damage", expected: count, found: count - 1 }));
    for (damage, dissipated) in [(-0.1, 0.0), (1.1, 0.0), (f64::NAN, 0.0), (0.5, -1.0), (0.5, f64::INFINITY)] {
        let found = contact.set_damage(&vec![PointDamage { damage, dissipated }; count]);
        assert!(matches!(found, Err(Error::NotPositive { .. })));
    }
    assert_eq!(contact.damage().expect("points"), vec![broken; count]);
}
