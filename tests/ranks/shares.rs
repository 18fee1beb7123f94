//! How the work is divided, by counts.

use crate::communicator::on_ranks;
use crate::scene::{Scene, exact};
use fmc_contact::contact::TangentPart;
use fmc_contact::{EnergyLaw, Options, RankCounts};
use fmc_shapes::cuboid_hex8;

fn counts(cells: usize, size: usize, law: EnergyLaw) -> Vec<RankCounts> {
    let a = cuboid_hex8([0.0; 3], [1.0, 1.0, 0.2], [cells, cells, 2]);
    let b = cuboid_hex8([0.01, 0.02, 0.199], [0.98, 0.97, 0.4], [cells - 1, cells - 1, 2]);
    let scene = Scene::of(&[&a, &b]);
    on_ranks(size, None, |_, own| {
        let mut contact = scene.contact(Options { law, ..exact() });
        contact.set_communicator(Some(own)).unwrap();
        contact.evaluate_tangent(&scene.coords, TangentPart::Symmetric).unwrap();
        contact.rank_counts()
    })
}

/// Whole faces in contact, four ranks: the busiest has a quarter, and at most a twentieth of that more.
#[test]
fn whole_faces_are_divided_evenly() {
    for law in [EnergyLaw::volume(1.0), EnergyLaw::fiber(1.0), EnergyLaw::depth(1.0)] {
        let counts = counts(48, 4, law);
        let busiest = counts.iter().map(|counts| counts.own_item_count).max().unwrap();
        assert!(busiest as f64 <= 0.2625 * counts[0].item_count as f64, "{law:?}: {counts:?}");
        assert!(
            counts.iter().all(|other| other.item_count == counts[0].item_count && other.call_count < 40),
            "{counts:?}"
        );
    }
}

/// Every rank receives what all found, whatever their number: what is added by a rank more is the few bytes in which each says how
/// much follows, and its number and length before every chunk are those of one rank fewer.
#[test]
fn what_a_rank_receives_is_what_all_found() {
    for law in [EnergyLaw::volume(1.0), EnergyLaw::fiber(1.0), EnergyLaw::depth(1.0)] {
        let [two, four, seven] = [2, 4, 7].map(|size| counts(64, size, law)[0]);
        println!("{law:?}: received on 2, 4, 7 ranks {two:?} {four:?} {seven:?}");
        assert_eq!((two.item_count, two.call_count), (four.item_count, four.call_count));
        assert_eq!((two.item_count, two.call_count), (seven.item_count, seven.call_count));
        let a_rank_more = (four.received_bytes - two.received_bytes) / 2;
        assert!(a_rank_more <= 16 * two.call_count);
        assert_eq!(seven.received_bytes - four.received_bytes, 3 * a_rank_more);
    }
}

/// What would take longer to send than to do is done by all, with two calls in which they agree.
#[test]
fn little_work_is_not_shared() {
    for counts in counts(3, 7, EnergyLaw::volume(1.0)) {
        assert_eq!((counts.item_count, counts.call_count), (0, 2));
        assert!(counts.sent_bytes <= 2 * 16);
    }
}
