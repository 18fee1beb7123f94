//! A law of the host that repeats the library's bilinear law gives what that gives.

use crate::laws::{ENERGY, PointByPoint, bilinear};
use crate::scene::Scene;
use crate::{held, in_space, in_the_plane, largest, moved, plus, waved};
use fmc_contact::contact::{Cohesive, PairOptions, TangentPart};
use fmc_contact::overlap::Partner::Body;
use fmc_contact::{Contact, EnergyLaw, Options};

fn cohesive<const D: usize>(scene: &Scene<D>) -> Contact<D> {
    let mut contact = scene.contact(Options::new(EnergyLaw::depth(1.0)));
    let law = Cohesive { shear_strength: 3.0, shear_energy: ENERGY[1], reach: 0.1, ..Cohesive::new(2.0, ENERGY[0]) };
    contact.set_pair_options([Body(0), Body(1)], Some(PairOptions::with_cohesive(law))).expect("an interface");
    contact
}

/// Both do the same arithmetic in another order, with some hundred additions per node: 1e-12 of the largest number there is.
fn alike<const D: usize>(own: &Contact<D>, library: &Contact<D>, coords: &[[f64; D]]) {
    for part in [TangentPart::Full, TangentPart::Symmetric] {
        let [(a, ka), (b, kb)] = [own, library].map(|one| one.evaluate_tangent(coords, part).expect("an evaluation"));
        let size = largest(&b.forces);
        assert!(largest(&plus(&a.forces, -1.0, &b.forces)) <= 1e-12 * size, "forces");
        assert!((a.energy - b.energy).abs() <= 1e-12 * b.energy, "{} {}", a.energy, b.energy);
        let all = |tangent: &fmc_contact::contact::Tangent<D>| -> Vec<f64> {
            tangent.blocks.iter().flat_map(|block| block.value.as_flattened().to_vec()).collect()
        };
        let (ka, kb) = (all(&ka), all(&kb));
        let most = kb.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        assert!(ka.len() == kb.len() && ka.iter().zip(&kb).all(|(a, b)| (a - b).abs() <= 1e-12 * most), "{part:?}");
    }
    let (points, theirs) = (own.law_points(coords).expect("points"), library.cohesive_points(coords).expect("points"));
    assert_eq!(points.len(), theirs.len());
    for (a, b) in points.iter().zip(&theirs) {
        assert!(a.position == b.position && a.area == b.area && a.bodies == b.bodies);
        assert!((a.history[0] - b.damage).abs() < 1e-12 && (a.history[1] - b.dissipated).abs() < 1e-12);
        assert!((a.jump[0] - b.opening).abs() < 1e-15);
        let in_space = |i: usize| (0..D).map(|axis| a.axes[axis][i] * a.traction[axis]).sum::<f64>();
        assert!((0..D).all(|i| (in_space(i) - b.traction[i]).abs() < 1e-11));
    }
}

/// Whole, loaded, unloaded, pressed, loaded further in another mode, broken; and once more after a restart.
fn repeats<const D: usize>(scenes: &[Scene<D>]) {
    let law = || PointByPoint { count: 2, law: bilinear };
    for scene in scenes {
        let (mut own, mut library) = (held(scene, law()), cohesive(scene));
        let path =
            [(2e-4, 0.3), (0.01, 0.3), (0.004, 0.3), (0.02, 1.9), (-0.01, 0.3), (0.025, 0.3), (0.02, 4.1), (0.01, 1.9)];
        own.begin_step(&scene.coords).expect("a step");
        library.begin_step(&scene.coords).expect("a step");
        for (number, (by, seed)) in path.into_iter().enumerate() {
            let coords = waved(scene, by, seed);
            alike(&own, &library, &coords);
            own.commit_step(&coords).expect("a step");
            library.commit_step(&coords).expect("a step");
            alike(&own, &library, &coords);
            if number == 3 {
                let damage = library.damage().expect("points");
                assert!(damage.iter().any(|point| point.damage > 0.0 && point.damage < 1.0));
                let (history, forces) = (own.law_history().expect("a history"), own.evaluate(&coords));
                own = held(scene, law());
                own.begin_step(&coords).expect("a step");
                own.set_law_history(&history).expect("a history");
                assert_eq!(own.evaluate(&coords), forces);
            }
        }
        // Torn off, with a part of it whole no more.
        let mut by = [0.0; D];
        by[D - 1] = 0.11;
        let coords = moved(scene, by);
        alike(&own, &library, &coords);
        own.commit_step(&coords).expect("a step");
        assert!(own.law_history().expect("a history").iter().step_by(2).any(|damage| *damage == 1.0));
    }
}

#[test]
fn it_gives_the_same_forces_tangents_energies_and_history() {
    for gap in [0.0, 0.03] {
        repeats(&in_the_plane(gap));
        repeats(&in_space(gap));
    }
}

/// With another mesh without deformation points have the history of the nearest that there were, as damage.
#[test]
fn history_goes_along_to_other_points() {
    let scene = &in_the_plane(0.0)[0];
    let (mut own, mut library) = (held(scene, PointByPoint { count: 2, law: bilinear }), cohesive(scene));
    let coords = waved(scene, 0.02, 0.3);
    let other: Vec<[f64; 2]> = scene.coords.iter().map(|x| [x[0] + 0.1 * x[0] * (1.0 - x[0]), x[1]]).collect();
    for contact in [&mut own, &mut library] {
        contact.begin_step(&scene.coords).expect("a step");
        contact.commit_step(&coords).expect("a step");
        contact.set_reference(&other).expect("a mesh");
    }
    assert!(library.damage().expect("points").iter().any(|point| point.damage > 0.5));
    alike(&own, &library, &coords);
}
