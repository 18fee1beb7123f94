//! Faces between the cells of different ranks, which are no surface, go to the ranks that may have the other side.

use crate::communicator::on_ranks;
use crate::partition::{same_in_parts, stripes};
use crate::parts::Part;
use crate::scene::{Scene, exact};
use fmc_contact::{Communicator, EnergyLaw, Error, Obstacle, Options, PartitionedContact, Pose, Shape};
use fmc_shapes::{cuboid_hex8, second_order};

/// A host whose ranks cannot send to single others.
struct GathersOnly(Box<dyn Communicator>);

impl Communicator for GathersOnly {
    fn rank(&self) -> usize {
        self.0.rank()
    }

    fn size(&self) -> usize {
        self.0.size()
    }

    fn all_gather(&self, send: &[u8], counts: &[usize], received: &mut [u8]) -> Result<(), i32> {
        self.0.all_gather(send, counts, received)
    }
}

/// Two cells of second order on a plane, whose common edge bulges beyond all corners: its middle is one node of the surface, not one
/// of each rank.
#[test]
fn an_edge_that_bulges_is_of_both() {
    let mut scene = Scene::of(&[&second_order(&cuboid_hex8([0.0; 3], [2.0, 1.0, 1.0], [2, 1, 1]), 20)]);
    for [_, y, z] in &mut scene.coords {
        *z *= 1.0 + 0.8 * *y * (1.0 - *y);
    }
    let plane = Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0, 0.0, 0.01]) };
    let options = Options { law: EnergyLaw::volume(40.0), ..exact() };
    same_in_parts(&scene, std::slice::from_ref(&scene.coords), options, &[plane], 2, stripes(2, 2.0));
}

/// Eight slabs beside one another: a slab has faces in common with two others, however many there are. Where the host has no operation
/// for it all receive all, and know the same.
#[test]
fn a_rank_receives_those_of_its_neighbours() {
    let scene = Scene::of(&[&cuboid_hex8([0.0; 3], [8.0, 4.0, 4.0], [16, 12, 12])]);
    let options = Options { law: EnergyLaw::volume(40.0), ..exact() };
    let found = |size, gathers_only: bool| {
        on_ranks(size, None, |rank, own| {
            let own: Box<dyn Communicator> = if gathers_only { Box::new(GathersOnly(own)) } else { own };
            let part = Part::of(&scene, |cell, x| stripes(size, 8.0)(cell, x) == rank);
            let parts = PartitionedContact::new(own, &part.given(&part.blocks()), options, 0.0).unwrap();
            (parts.counts().facet_count, parts.contact().rank_counts())
        })
    };
    // A face is its body, the number of its corners and these; a node its body and its number. Faces of the surface that end at a border
    // may be there too.
    let of_neighbour = (144 + 48) * (4 + 8 + 4 * 8) + 48 * (4 + 8);
    let [single, all] = [false, true].map(|gathers_only| found(8, gathers_only));
    let of_ends = single[0].1.received_bytes;
    for (rank, (facets, counts)) in single.iter().enumerate() {
        println!("{facets} facets; {counts:?}");
        assert_eq!(*facets, 4 * (2 * 144 + 4 * 16 * 12));
        let second = if (1..7).contains(&rank) { of_neighbour } else { 0 };
        assert_eq!(counts.received_bytes, of_ends + second, "rank {rank}");
    }
    for (facets, counts) in all {
        assert_eq!(facets, 4 * (2 * 144 + 4 * 16 * 12));
        assert!(counts.received_bytes > of_ends + 12 * of_neighbour, "{counts:?}");
    }
}

/// One rank that can send to single others among some that cannot.
#[test]
fn all_ranks_can_or_none() {
    let scene = Scene::of(&[&cuboid_hex8([0.0; 3], [3.0, 1.0, 1.0], [3, 1, 1])]);
    let options = Options { law: EnergyLaw::volume(40.0), ..exact() };
    let errors = on_ranks(3, None, |rank, own| {
        let own: Box<dyn Communicator> = if rank == 1 { own } else { Box::new(GathersOnly(own)) };
        let part = Part::of(&scene, |cell, _| cell == rank);
        PartitionedContact::new(own, &part.given(&part.blocks()), options, 0.0).err()
    });
    for error in errors {
        assert!(matches!(error, Some(Error::RanksDiffer { .. })), "{error:?}");
    }
}

/// Of three cells with a common face each on a rank of its own.
#[test]
fn a_face_of_three_cells_is_refused() {
    let mut scene = Scene::of(&[&cuboid_hex8([0.0; 3], [2.0, 1.0, 1.0], [2, 1, 1])]);
    let (_, conn) = &mut scene.blocks[0];
    let again = conn[8..].to_vec();
    conn.extend(again);
    scene.ids.push(scene.ids[0]);
    let options = Options { law: EnergyLaw::volume(40.0), ..exact() };
    let errors = on_ranks(3, None, |rank, own| {
        let part = Part::of(&scene, |cell, _| cell == rank);
        PartitionedContact::new(own, &part.given(&part.blocks()), options, 0.0).err()
    });
    println!("{errors:?}");
    assert!(errors.iter().all(Option::is_some));
    assert!(errors.iter().any(|error| matches!(error, Some(Error::NonManifold { .. }))));
}
