//! Threads and ranks give the same bits, and ask laws on the calling thread, pair by pair, in the same order.

use crate::communicator::on_ranks;
use crate::laws::{PointByPoint, bilinear};
use crate::options;
use crate::scene::Scene;
use fmc_contact::contact::{InterfaceLaw, LawFailure, LawPoints, LawResponse, TangentPart};
use fmc_contact::overlap::Partner::Body;
use fmc_contact::{Contact, EnergyLaw, Options};
use fmc_shapes::cuboid_hex8;
use std::sync::{Arc, Mutex};
use std::thread::{ThreadId, current};

type Calls = Arc<Mutex<Vec<([usize; 2], Vec<f64>, ThreadId)>>>;

struct Recorded(Calls);

impl InterfaceLaw for Recorded {
    fn history_count(&self) -> usize {
        2
    }

    fn respond(&self, points: &LawPoints<'_>, response: &mut LawResponse<'_>) -> Result<(), LawFailure> {
        self.0.lock().expect("a list").push((points.bodies, points.jumps.to_vec(), current().id()));
        PointByPoint { count: 2, law: bilinear }.respond(points, response)
    }
}

/// Three blocks, one above the other, and a fourth that presses from above, so that there is work to share.
fn scene() -> Scene<3> {
    let block = |z: f64, cells: [usize; 3]| cuboid_hex8([0.0, 0.0, z], [1.0, 1.0, z + 0.5], cells);
    let blocks = [block(0.0, [2, 1, 1]), block(0.5, [1, 2, 1]), block(1.0, [2, 2, 1]), block(1.49, [3, 3, 1])];
    Scene::of(&blocks.iter().collect::<Vec<_>>())
}

fn contact(scene: &Scene<3>, threads: usize, calls: &Calls) -> Contact<3> {
    let mut contact = scene.contact(Options { threads, ..Options::new(EnergyLaw::depth(100.0)) });
    for pair in [[2, 1], [0, 1]] {
        contact.set_law_pair(pair.map(Body), options(), Arc::new(Recorded(Arc::clone(calls)))).expect("an interface");
    }
    contact
}

#[test]
fn threads_and_ranks_give_the_same_bits_and_the_same_calls() {
    let scene = scene();
    // Every joint opens on one side; the last block goes along with the third, and still presses.
    let bent = |by: f64| -> Vec<[f64; 3]> {
        let joints = |node: usize| scene.first_node[1..3].iter().filter(|first| node >= **first).count() as f64;
        let moved = |(node, x): (usize, &[f64; 3])| [x[0], x[1] - by * x[0] * x[2], x[2] + by * joints(node) * x[0]];
        scene.coords.iter().enumerate().map(moved).collect()
    };
    let run = |mut contact: Contact<3>, calls: &Calls| {
        contact.begin_step(&scene.coords).expect("a step");
        contact.commit_step(&bent(0.02)).expect("a step");
        let found = contact.evaluate_tangent(&bent(0.03), TangentPart::Full).expect("an evaluation");
        assert!(found.0.pairs.len() == 3 && found.0.energy > 0.0);
        let history = contact.law_history().expect("a history");
        assert!(history.iter().any(|x| *x > 0.5));
        let calls = std::mem::take(&mut *calls.lock().expect("a list"));
        assert!(calls.iter().all(|(.., thread)| *thread == current().id()));
        let order: Vec<[usize; 2]> = calls.iter().map(|(bodies, ..)| *bodies).collect();
        assert_eq!(order, [[0, 1], [1, 2]].repeat(order.len() / 2));
        let asked: Vec<_> = calls.into_iter().map(|(bodies, jumps, _)| (bodies, jumps)).collect();
        (found, history, asked)
    };
    let calls = Calls::default();
    let expected = run(contact(&scene, 1, &calls), &calls);
    let threaded = run(contact(&scene, 3, &calls), &calls);
    assert!(threaded == expected);
    let by_rank = on_ranks(2, None, |_, communicator| {
        let calls = Calls::default();
        let mut contact = contact(&scene, 1, &calls);
        contact.set_communicator(Some(communicator)).expect("ranks");
        run(contact, &calls)
    });
    assert!(by_rank.iter().all(|found| *found == expected));
}
