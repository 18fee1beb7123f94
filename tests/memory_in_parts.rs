//! Memory of a rank that has a part of a mesh, and how much of the mesh it receives: a small contact on a large body.

#[path = "ranks/communicator.rs"]
mod communicator;
#[path = "ranks/parts.rs"]
#[allow(dead_code)]
mod parts;
#[path = "scene/scene.rs"]
mod scene;

use communicator::on_ranks;
use fmc_contact::{EnergyLaw, Options, PartitionedContact};
use fmc_shapes::cuboid_hex8;
use parts::Part;
use peak_alloc::PeakAlloc;
use scene::{Scene, exact};
use std::sync::Barrier;

#[global_allocator]
static HEAP: PeakAlloc = PeakAlloc;

/// Four ranks: each holds at most 0.35 of what one has that holds the whole mesh, and receives a twentieth of the facets.
#[test]
fn a_rank_holds_its_part_and_what_is_near() {
    let a = cuboid_hex8([0.0; 3], [4.0, 4.0, 1.0], [100, 100, 20]);
    let b = cuboid_hex8([0.3, 0.3, 0.998], [0.6, 0.6, 1.3], [10, 10, 10]);
    let scene = Scene::of(&[&a, &b]);
    let options = Options { law: EnergyLaw::depth(50.0), ..exact() };
    let before = HEAP.current_usage();
    let whole = scene.contact(options);
    let volume = whole.evaluate(&scene.coords).unwrap().volume;
    let of_whole = HEAP.current_usage() - before;
    drop(whole);
    let given: Vec<Part<3>> = (0..4).map(|rank| Part::of(&scene, |_, x| (x[1] as usize).min(3) == rank)).collect();
    let all_here = Barrier::new(4);
    let before = HEAP.current_usage();
    let found = on_ranks(4, None, |rank, own| {
        let (part, blocks) = (&given[rank], given[rank].blocks());
        let mut parts = PartitionedContact::new(own, &part.given(&blocks), options, 0.0).unwrap();
        let calls = parts.contact().rank_counts().call_count;
        parts.set_coords(&part.coords).unwrap();
        assert_eq!(parts.contact().rank_counts().call_count - calls, 7, "boxes, coordinates, and whether all are well");
        assert_eq!(parts.contact().evaluate(parts.coords()).unwrap().volume, volume);
        all_here.wait();
        let usage = HEAP.current_usage() - before;
        all_here.wait();
        (usage, parts.counts(), parts.contact().rank_counts())
    });
    for (usage, counts, ranks) in found {
        println!("{:.3} of {of_whole} B, {counts:?}, {ranks:?}", usage as f64 / 4.0 / of_whole as f64);
        assert!(usage as f64 / 4.0 <= 0.35 * of_whole as f64);
        assert!(counts.gathered_facet_count * 20 <= counts.facet_count);
        // For every facet that it receives, not for every facet of the mesh.
        assert!(ranks.received_bytes < 3000 * counts.gathered_facet_count as u64, "{ranks:?}");
    }
}
