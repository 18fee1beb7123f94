//! What is wrong with a part of a mesh is told on all ranks, and none waits.

use crate::communicator::on_ranks;
use crate::parts::Part;
use crate::scene::{Scene, exact};
use fmc_contact::{Contact, Error, Obstacle, PartitionedContact, Pose, Shape};
use fmc_shapes::rectangle_quad4;

fn scene() -> Scene<2> {
    let a = rectangle_quad4([0.0, 0.0], [2.0, 1.0], [40, 20]);
    Scene::of(&[&a, &rectangle_quad4([0.2, 0.99], [1.7, 3.9], [30, 60])])
}

fn half(scene: &Scene<2>, rank: usize) -> Part<2> {
    Part::of(scene, |_, x| usize::from(x[0] > 1.0) == rank)
}

/// What both ranks answer where `change` has changed their parts.
fn made(change: impl Fn(usize, &mut Part<2>) + Sync) -> Vec<Option<Error>> {
    let scene = scene();
    on_ranks(2, None, |rank, own| {
        let mut part = half(&scene, rank);
        change(rank, &mut part);
        PartitionedContact::new(own, &part.given(&part.blocks()), exact(), 0.0).err()
    })
}

#[test]
fn parts_that_do_not_fit() {
    assert_eq!(made(|_, _| {}), [None, None]);
    let short = made(|rank, part| part.node_numbers.truncate(part.node_numbers.len() - rank));
    assert!(matches!(short[1], Some(Error::Length { array: "node_numbers", .. })));
    assert_eq!(short[0], Some(Error::OnOtherRank { rank: 1 }));
    let twice = made(|rank, part| part.node_numbers[7] = part.node_numbers[7 - rank]);
    assert!(matches!(twice[1], Some(Error::Unsupported { what }) if what.contains("one number")), "{twice:?}");
    // Both ranks have the cells of the left half.
    let scene = scene();
    let same = on_ranks(2, None, |_, own| {
        let part = half(&scene, 0);
        PartitionedContact::new(own, &part.given(&part.blocks()), exact(), 0.0).err()
    });
    assert!(
        same.iter().all(|error| matches!(error, Some(Error::Unsupported { what }) if what.contains("two parts"))),
        "{same:?}"
    );
}

/// Whole meshes are no parts, and parts by themselves are refused what is of the whole.
#[test]
fn places_and_calls_that_do_not_fit() {
    let scene = scene();
    let told = on_ranks(2, None, |rank, own| {
        let part = half(&scene, rank);
        let mut parts = PartitionedContact::new(own, &part.given(&part.blocks()), exact(), 0.0).unwrap();
        let mut moved = part.coords.clone();
        // All nodes that both have, of which rank 1 says that they are elsewhere.
        moved.iter_mut().filter(|x| x[0] == 1.0).for_each(|x| x[1] += 1e-9 * rank as f64);
        let elsewhere = parts.set_coords(&moved).unwrap_err();
        assert!(matches!(elsewhere, Error::RanksDiffer { .. } | Error::OnOtherRank { .. }), "{elsewhere:?}");
        parts.set_coords(&part.coords).unwrap();
        let here = parts.coords().to_vec();
        let before = parts.contact().evaluate(&here).unwrap();
        // Its own nodes may move a little without being brought, but not to where nothing was gathered.
        let far: Vec<[f64; 2]> = here.iter().map(|x| [x[0], x[1] + if x[1] > 0.995 { -0.5 } else { 0.0 }]).collect();
        assert!(matches!(parts.contact().evaluate(&far), Err(Error::NotGathered { .. } | Error::InvertedCell { .. })));
        let below = Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0, 0.3]) };
        parts.contact_mut().add_obstacle(below).unwrap();
        assert!(matches!(parts.contact().evaluate(&here), Err(Error::NotGathered { body: 0 })));
        assert!(parts.set_coords(&part.coords).unwrap());
        assert!(parts.contact().evaluate(parts.coords()).unwrap().volume > before.volume);
        let refused = |found: Result<(), Error>| assert!(matches!(found, Err(Error::Unsupported { .. })), "{found:?}");
        let contact: &mut Contact<2> = parts.contact_mut();
        refused(contact.set_communicator(None));
        refused(contact.set_symmetry_nodes(&[0]));
        refused(contact.set_basis(None));
        refused(contact.gap_constraints(&here, 0.1).map(drop));
        before.volume.to_bits()
    });
    assert_eq!(told[0], told[1]);
}
