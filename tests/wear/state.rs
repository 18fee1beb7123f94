//! What is kept from step to step: the same bits after a restart, and on any number of threads and ranks.

use crate::communicator::on_ranks;
use crate::scene::Scene;
use crate::{WEAR, in_plane, in_space, laws, moved, wearing};
use fmc_contact::contact::TangentPart;
use fmc_contact::{Contact, Error, Options};

/// All that a host sees.
fn look<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]]) -> String {
    let tangent = contact.evaluate_tangent(coords, TangentPart::Full);
    let rest = (contact.wear(), contact.worn_facets(), contact.slip(), contact.nodal_contact(coords));
    format!("{tangent:?} {rest:?}")
}

fn path<const D: usize>(scene: &Scene<D>) -> Vec<Vec<[f64; D]>> {
    (0..6).map(|step| moved(scene, 1, [0.04 * f64::from(step), -1e-4 * f64::from(step % 3)])).collect()
}

fn restarted<const D: usize>(scene: &Scene<D>, options: Options) {
    let path = path(scene);
    let mut contact = wearing(scene, options);
    contact.begin_step(&path[0]).expect("a step");
    for (now, next) in path[1..].iter().zip(&path[2..]) {
        contact.augment(now, 0.02, 0.0).expect("multipliers");
        contact.commit_step(now).expect("a step");
        let mut other = wearing(scene, options);
        other.set_multipliers(&contact.multipliers()).expect("multipliers");
        other.set_worn_facets(&contact.worn_facets()).expect("worn facets");
        assert_eq!(other.evaluate(next).err(), Some(Error::NoStep));
        other.begin_step(now).expect("a step");
        other.set_slip(&contact.slip().expect("a step")).expect("a slip");
        assert!(look(&contact, next) == look(&other, next), "{options:?}");
        other.commit_step(next).expect("a step");
        contact.begin_step(now).expect("the same step again");
        let mut third = wearing(scene, options);
        third.set_multipliers(&contact.multipliers()).expect("multipliers");
        third.set_worn_facets(&contact.worn_facets()).expect("worn facets");
        third.begin_step(now).expect("a step");
        third.set_slip(&contact.slip().expect("a step")).expect("a slip");
        third.commit_step(next).expect("a step");
        assert!(look(&third, next) == look(&other, next), "{options:?}");
    }
}

#[test]
fn a_restart_goes_on_as_if_nothing_had_stopped() {
    for options in laws(0.3).into_iter().chain(laws(0.0)) {
        in_plane().iter().for_each(|scene| restarted(scene, options));
        restarted(&in_space()[1], options);
    }
}

/// All steps, one after the other.
fn walked<const D: usize>(contact: &mut Contact<D>, scene: &Scene<D>) -> String {
    let path = path(scene);
    contact.begin_step(&path[0]).expect("a step");
    for coords in &path[1..] {
        contact.commit_step(coords).expect("a step");
    }
    look(contact, &path[5])
}

#[test]
fn the_same_bits_on_any_number_of_threads_and_ranks() {
    for options in laws(0.3).into_iter().chain(laws(0.0)) {
        let scene = &in_space()[0];
        let alone = walked(&mut wearing(scene, options), scene);
        assert!(walked(&mut wearing(scene, Options { threads: 4, ..options }), scene) == alone);
        let all = on_ranks(3, None, |_, rank| {
            let mut contact = wearing(scene, options);
            contact.set_communicator(Some(rank)).expect("ranks");
            walked(&mut contact, scene)
        });
        assert!(all.iter().all(|found| *found == alone));
    }
}

/// A host that moves its nodes to the worn surface starts from zero, with the same forces.
#[test]
fn nodes_that_go_to_the_worn_surface() {
    let scene = &in_plane()[0];
    let mut contact = wearing(scene, laws(0.0)[0]);
    contact.begin_step(&scene.coords).expect("a step");
    let coords = moved(scene, 1, [0.3, 0.0]);
    contact.commit_step(&coords).expect("a step");
    let before = contact.evaluate(&coords).expect("forces").forces;
    let depth = contact.wear().expect("a step").depth;
    let mut onto = coords.clone();
    for (node, x) in onto.iter_mut().enumerate() {
        // Outwards is up for the plate, down for the block.
        x[1] += if node < scene.first_node[1] { -depth[node] } else { depth[node] };
    }
    contact.set_worn_facets(&[]).expect("nothing worn");
    contact.begin_step(&onto).expect("a step");
    let after = contact.evaluate(&onto).expect("forces").forces;
    let largest = before.iter().flatten().fold(0.0f64, |most, f| most.max(f.abs()));
    for (one, other) in before.iter().flatten().zip(after.iter().flatten()) {
        assert!((one - other).abs() < 1e-9 * largest, "{one} {other}");
    }
    assert!(WEAR[0] > 0.0 && contact.wear().expect("a step").volumes == [0.0; 2]);
}
