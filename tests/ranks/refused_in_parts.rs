//! What is wrong with a part of a mesh is told on all ranks, and none waits.

use crate::communicator::on_ranks;
use crate::parts::Part;
use crate::scene::{Scene, exact};
use fmc_contact::{Contact, EnergyLaw, Error, Obstacle, Options, PartitionedContact, Pose, Shape};
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

/// Planes of symmetry that leave a body without surface are refused as of the whole mesh, on all ranks alike, and what was said before stays. A
/// rank whose own part of a body has no surface left is fine where another has some.
#[test]
fn bodies_without_surface() {
    let scene = scene();
    let (across, up) = ([1.0, 0.0], [0.0, 1.0]);
    let upper = [[[0.2, 0.0], across], [[1.7, 0.0], across], [[0.0, 0.99], up], [[0.0, 3.9], up]];
    let on_rank = |rank: usize, own, is_by_nodes: bool| {
        // The upper third of the upper body is on rank 0, with its top and parts of its sides.
        let part = Part::of(&scene, |_, x| usize::from(x[1] < 2.9) == rank);
        let mut parts = PartitionedContact::new(own, &part.given(&part.blocks()), by_depth(), 0.0).unwrap();
        let before = bits(&mut parts, &part.coords);
        let on = |planes: &[[[f64; 2]; 2]], x: &[f64; 2]| {
            let height = |[point, normal]: &[[f64; 2]; 2]| (0..2).map(|i| (x[i] - point[i]) * normal[i]).sum::<f64>();
            x[1] > 0.985 && planes.iter().any(|plane| height(plane).abs() < 1e-9)
        };
        let name = |parts: &mut PartitionedContact<2>, planes: &[[[f64; 2]; 2]]| match is_by_nodes {
            false => parts.set_symmetry_planes(planes),
            true => {
                let named = part.coords.iter().enumerate().filter(|(_, x)| on(planes, x)).map(|(node, _)| node as u32);
                parts.set_symmetry_nodes(&named.collect::<Vec<_>>())
            }
        };
        let refused = name(&mut parts, &upper);
        assert!(
            matches!(refused, Err(Error::Unsupported { what }) if what.contains("whole surface")),
            "{rank}: {refused:?}"
        );
        assert_eq!(bits(&mut parts, &part.coords), before);
        // But for the bottom, which rank 1 has.
        let but_for_bottom = [upper[0], upper[1], upper[3]];
        name(&mut parts, &but_for_bottom).unwrap();
        bits(&mut parts, &part.coords)
    };
    let planes = on_ranks(2, None, |rank, own| on_rank(rank, own, false));
    assert_eq!(planes[0], planes[1]);
    let nodes = on_ranks(2, None, |rank, own| on_rank(rank, own, true));
    assert_eq!(nodes[0], nodes[1]);
    // As with the whole mesh.
    let mut whole = scene.contact(by_depth());
    assert!(matches!(whole.set_symmetry_planes(&upper), Err(Error::Unsupported { .. })));
    whole.set_symmetry_planes(&[upper[0], upper[1], upper[3]]).unwrap();
    assert_eq!(whole.evaluate(&scene.coords).unwrap().energy.to_bits(), planes[0]);
}

/// Of the energy, once the mesh is at its coordinates.
fn bits(parts: &mut PartitionedContact<2>, coords: &[[f64; 2]]) -> u64 {
    parts.set_coords(coords).unwrap();
    parts.contact().evaluate(parts.coords()).unwrap().energy.to_bits()
}

fn by_depth() -> Options {
    Options { law: EnergyLaw::depth(1.0), ..exact() }
}
