//! A mesh in parts has the bits of the whole: for all laws, both estimators, friction, cells of second order, obstacles and a
//! body with itself; on 1 to 7 ranks, wherever the border runs, with ranks that have no surface, or no cells.

use crate::communicator::on_ranks;
use crate::parts::{Part, compare, of_whole, told};
use crate::same_bits::{options, plane_blocks, solid_blocks};
use crate::scene::{Scene, exact};
use fmc_contact::{Contact, EnergyLaw, Obstacle, Options, PartitionedContact};
use fmc_shapes::{Mesh, cuboid_hex8, rectangle_quad4, second_order};

/// Two answers of every step of a path.
fn along<const D: usize>(
    path: &[Vec<[f64; D]>],
    friction: bool,
    mut contact: impl FnMut(&[[f64; D]], Step) -> Vec<String>,
) -> Vec<Vec<String>> {
    let mut told = Vec::new();
    for (number, coords) in path.iter().enumerate() {
        if number == 0 && friction {
            contact(coords, Step::Begin);
        }
        told.push(contact(coords, Step::Ask));
        if number % 2 == 1 && friction {
            contact(coords, Step::Commit);
        }
    }
    told
}

#[derive(Clone, Copy, PartialEq)]
enum Step {
    Begin,
    Ask,
    Commit,
}

fn take<const D: usize>(contact: &mut Contact<D>, coords: &[[f64; D]], step: Step) {
    match step {
        Step::Begin => contact.begin_step(coords).unwrap(),
        Step::Commit => contact.commit_step(coords).unwrap(),
        Step::Ask => {}
    }
}

/// Everything of a path of coordinates, in parts and whole. `owner` tells the rank of a cell.
pub(crate) fn same_in_parts<const D: usize>(
    scene: &Scene<D>,
    path: &[Vec<[f64; D]>],
    options: Options,
    obstacles: &[Obstacle<D>],
    size: usize,
    owner: impl Fn(usize, [f64; D]) -> usize + Sync,
) {
    let friction = options.friction.is_active();
    let mut whole = scene.contact(options);
    obstacles.iter().for_each(|obstacle| assert!(whole.add_obstacle(obstacle.clone()).is_ok()));
    let expected = along(path, friction, |coords, step| {
        take(&mut whole, coords, step);
        if step == Step::Ask { of_whole(&whole, coords) } else { Vec::new() }
    });
    let on_all = on_ranks(size, None, |rank, own| {
        let part = Part::of(scene, |cell, x| owner(cell, x) == rank);
        let blocks = part.blocks();
        let mut parts = PartitionedContact::new(own, &part.given(&blocks), options, 0.02).unwrap();
        obstacles.iter().for_each(|obstacle| assert!(parts.contact_mut().add_obstacle(obstacle.clone()).is_ok()));
        along(path, friction, |coords, step| {
            parts.set_coords(&part.here(coords)).unwrap();
            let here = parts.coords().to_vec();
            take(parts.contact_mut(), &here, step);
            if step == Step::Ask {
                told(parts.contact(), &here, parts.node_numbers(), coords.len())
            } else {
                Vec::new()
            }
        })
    });
    for (rank, found) in on_all.iter().enumerate() {
        for (number, (found, expected)) in found.iter().zip(&expected).enumerate() {
            compare(found, expected, &format!("step {number}, rank {rank} of {size}, {options:?}"));
        }
    }
}

/// The second body slides: half of a cell, then over many.
pub(crate) fn sliding<const D: usize>(scene: &Scene<D>, cell: f64) -> Vec<Vec<[f64; D]>> {
    let first = scene.first_node[1];
    let moved = |by: f64| {
        let moved = scene.coords.iter().enumerate().map(|(node, x)| {
            let mut x = *x;
            x[0] += if node >= first { by } else { 0.0 };
            x
        });
        moved.collect()
    };
    [0.0, 0.5, 0.6, 7.0, 0.7].iter().map(|cells| moved(cells * cell)).collect()
}

pub(crate) fn stripes<const D: usize>(size: usize, width: f64) -> impl Fn(usize, [f64; D]) -> usize {
    move |_, x| ((x[0] / width * size as f64).max(0.0) as usize).min(size - 1)
}

#[test]
fn in_the_plane() {
    let scene = Scene::of(&plane_blocks().each_ref());
    let path = sliding(&scene, 7e-3);
    for (k, options) in options::<2>().into_iter().enumerate() {
        for size in [k, k + 2].map(|k| [1, 2, 3, 4, 7][k % 5]) {
            same_in_parts(&scene, &path, options, &[], size, stripes(size, 2.0));
        }
        match k % 3 {
            0 => same_in_parts(&scene, &path, options, &[], 3, |cell, _| cell % 3),
            1 => {
                same_in_parts(&scene, &path, options, &[], 4, |_, x| usize::from(x[1] > 0.7) + usize::from(x[1] > 1.3))
            }
            _ => {}
        }
    }
}

#[test]
fn in_space() {
    let scene = Scene::of(&solid_blocks().each_ref());
    let path = &sliding(&scene, 0.09)[..2];
    for options in options::<3>() {
        same_in_parts(&scene, path, options, &[], 3, stripes(3, 2.0));
    }
    same_in_parts(&scene, path, exact(), &[], 4, |cell, _| cell % 4);
}

#[test]
fn with_cells_of_second_order() {
    let [a, b] = plane_blocks();
    let scene = Scene::of(&[&second_order(&a, 8), &second_order(&b, 9)]);
    for law in [EnergyLaw::volume(40.0), EnergyLaw::fiber(30.0), EnergyLaw::depth(50.0)] {
        same_in_parts(&scene, &sliding(&scene, 7e-3), Options { law, ..exact() }, &[], 3, stripes(3, 2.0));
    }
}

/// Faces that are curved without deformation, which are measured as such.
#[test]
fn with_curved_faces() {
    let [a, b] = plane_blocks();
    let scene =
        Scene::of(&[&second_order(&a, 8), &second_order(&b, 9)]).mapped(|[x, y]| [x, y + 0.05 * (3.0 * x).sin()]);
    let options = Options { law: EnergyLaw::depth(50.0), ..exact() };
    for size in [1, 5] {
        same_in_parts(&scene, &sliding(&scene, 7e-3), options, &[], size, stripes(size, 2.0));
    }
    same_in_parts(&scene, &sliding(&scene, 7e-3), options, &[], 3, |cell, _| cell % 3);
    let solid = |cells: [usize; 3]| second_order(&cuboid_hex8([0.0; 3], [2.0, 1.0, 0.6], cells), 20);
    let above = |mut mesh: Mesh<3>| {
        mesh.coords.iter_mut().for_each(|x| *x = [0.3 + 0.8 * x[0], 0.1 + 0.8 * x[1], 0.595 + x[2]]);
        mesh
    };
    let scene = Scene::of(&[&solid([11, 5, 1]), &above(solid([9, 4, 1]))]);
    let scene = scene.mapped(|[x, y, z]| [x, y, z + 0.05 * (3.0 * x + y).sin()]);
    let path = &sliding(&scene, 0.09)[..2];
    same_in_parts(&scene, path, options, &[], 3, stripes(3, 2.0));
}

/// A small zone in a large mesh: few facets are gathered, and the same few on all ranks.
#[test]
fn little_is_gathered() {
    let a = rectangle_quad4([0.0, 0.0], [60.0, 1.0], [6000, 20]);
    let b = rectangle_quad4([0.2, 0.995], [0.7, 1.5], [47, 40]);
    let scene = Scene::of(&[&a, &b]);
    let options = Options { law: EnergyLaw::depth(50.0), ..exact() };
    same_in_parts(&scene, std::slice::from_ref(&scene.coords), options, &[], 4, stripes(4, 60.0));
    let counts = |size| {
        on_ranks(size, None, |rank, own| {
            let part = Part::of(&scene, |cell, x| stripes(size, 60.0)(cell, x) == rank);
            let parts = PartitionedContact::new(own, &part.given(&part.blocks()), options, 0.0).unwrap();
            (parts.counts(), parts.contact().rank_counts())
        })
    };
    let alone = counts(1)[0].0.gathered_facet_count;
    for (counts, work) in [counts(4), counts(7)].concat() {
        println!("{counts:?} {work:?}; {alone} facets on one rank");
        // Near the contact is what lies within two cells, of a size that ranks take from the largest of their mean extents.
        assert!(counts.gathered_facet_count.abs_diff(alone) * 50 <= alone, "{counts:?}");
        assert_eq!(counts.facet_count, 2 * (6000 + 20 + 47 + 40));
        assert!(counts.gathered_facet_count < counts.facet_count / 20, "{counts:?}");
    }
}
