//! What laws keep from step to step.

use crate::laws::weakening;
use crate::scene::Scene;
use crate::{BODIES, DELTA, along, depth, in_plane, in_space, rub};
use fmc_contact::{Contact, ContactForces, Error};

const LAW: [f64; 3] = [0.6, 0.2, 2.0 * DELTA];

fn contact<const D: usize>(scene: &Scene<D>) -> Contact<D> {
    let mut contact = scene.contact(depth());
    rub(&mut contact, BODIES, weakening(LAW));
    contact.begin_step(&scene.coords).expect("a step");
    contact
}

/// Forces of four steps. Every step may be tried elsewhere first, and every one may be begun in a new contact.
fn run<const D: usize>(scene: &Scene<D>, is_cut: bool, is_restarted: bool) -> (Vec<ContactForces<D>>, Vec<f64>) {
    let (mut now, mut found) = (contact(scene), Vec::new());
    let at = |by: f64| along(scene, by * DELTA);
    for step in 1..=4 {
        let coords = at(0.9 * f64::from(step));
        if is_cut {
            for by in [5.0, 0.9 * f64::from(step) - 0.4] {
                now.evaluate(&at(by)).expect("forces");
                now.freeze_friction(&at(by)).expect("frozen");
                now.release_friction();
            }
        }
        found.push(now.evaluate(&coords).expect("forces"));
        now.commit_step(&coords).expect("a step");
        if is_restarted {
            let (slip, history) = (now.slip().expect("slip"), now.friction_history().expect("a history"));
            now = contact(scene);
            now.begin_step(&coords).expect("a step");
            now.set_slip(&slip).expect("slip");
            now.set_friction_history(&history).expect("a history");
            assert_eq!(now.friction_history().expect("a history"), history);
        }
    }
    let history = now.friction_history().expect("a history");
    (found, history)
}

#[test]
fn steps_are_tried_again_and_restarted_bit_by_bit() {
    let (forces, history) = run(&in_plane(), false, false);
    assert!(history.iter().filter(|x| **x > DELTA).count() > 3, "{history:?}");
    for (is_cut, is_restarted) in [(true, false), (false, true), (true, true)] {
        let (again, kept) = run(&in_plane(), is_cut, is_restarted);
        assert!(again == forces && kept == history, "{is_cut} {is_restarted}");
    }
    let (forces, history) = run(&in_space(), false, false);
    assert!(run(&in_space(), true, true) == (forces, history));
}

#[test]
fn the_history_has_its_rows_and_is_forgotten_with_the_law() {
    let scene = in_plane();
    let mut one = contact(&scene);
    assert_eq!(one.friction_history(), Ok(Vec::new()));
    one.commit_step(&along(&scene, 3.0 * DELTA)).expect("a step");
    let (slip, history) = (one.slip().expect("slip"), one.friction_history().expect("a history"));
    assert!(slip.len() == history.len() && history.iter().any(|x| *x > 0.0));
    let short = one.set_friction_history(&history[1..]);
    assert_eq!(short, Err(Error::Length { array: "history", expected: history.len(), found: history.len() - 1 }));
    let mut bad = history.clone();
    bad[2] = f64::NAN;
    assert!(matches!(one.set_friction_history(&bad), Err(Error::BadEntry { array: "history", entry: 2, .. })));
    assert_eq!(one.friction_history().as_ref(), Ok(&history));
    // Other options keep law and history; another law begins anew.
    let options = one.pair_options(BODIES).expect("a pair").expect("options");
    one.set_pair_options(BODIES, Some(fmc_contact::contact::PairOptions { gap_offset: -1e-5, ..options }))
        .expect("options");
    assert_eq!(one.friction_history().as_ref(), Ok(&history));
    rub(&mut one, BODIES, weakening(LAW));
    assert_eq!(one.friction_history(), Ok(vec![0.0; history.len()]));
    one.set_pair_options(BODIES, None).expect("options");
    assert_eq!(one.friction_history(), Ok(Vec::new()));
}

/// What separates begins anew, as its slip does.
#[test]
fn a_facet_that_comes_back_begins_with_zeros() {
    let scene = in_plane();
    let mut one = contact(&scene);
    one.commit_step(&along(&scene, 3.0 * DELTA)).expect("a step");
    assert!(!one.friction_history().expect("a history").is_empty());
    one.commit_step(&crate::moved(&scene, [3.0 * DELTA, 2.0 * DELTA])).expect("a step");
    assert_eq!(one.friction_history(), Ok(Vec::new()));
}
