//! Threads and ranks: the same bits, and the calls of the law on the thread that evaluates.

use crate::communicator::on_ranks;
use crate::laws::{Facet, One};
use crate::scene::Scene;
use crate::{BODIES, DELTA, along, depth, in_space, rub};
use fmc_contact::{Contact, Options};
use std::thread;

fn contact(scene: &Scene<3>, threads: usize) -> Contact<3> {
    let mut contact = scene.contact(Options { threads, ..depth() });
    let own = thread::current().id();
    let law = One(1, move |facet: &Facet| {
        assert_eq!(thread::current().id(), own, "a thread of the library");
        (0.3 * facet.pressure + 1e-3 * facet.history[0], 0.3, 0.0, vec![facet.history[0] + 1.0])
    });
    rub(&mut contact, BODIES, law);
    contact
}

#[test]
fn threads_and_ranks_give_the_same_bits() {
    let scene = in_space();
    let run = |mut contact: Contact<3>| {
        contact.begin_step(&scene.coords).expect("a step");
        contact.commit_step(&along(&scene, DELTA)).expect("a step");
        let found = contact.evaluate(&along(&scene, 5.0 * DELTA)).expect("forces");
        (found, contact.friction_history().expect("a history"))
    };
    let alone = run(contact(&scene, 1));
    assert!(alone.1.contains(&1.0));
    assert!(run(contact(&scene, 4)) == alone);
    for found in on_ranks(2, None, |_, communicator| {
        let mut contact = contact(&scene, 1);
        contact.set_communicator(Some(communicator)).expect("ranks");
        run(contact)
    }) {
        assert!(found == alone);
    }
}
