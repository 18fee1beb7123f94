//! A mesh in parts has the bits of the whole: for all laws, both estimators, friction, cells of second order, obstacles and a
//! body with itself; on 1 to 7 ranks, wherever the border runs, with ranks that have no surface, or no cells.

use crate::communicator::on_ranks;
use crate::parts::{Part, compare, of_whole, told};
use crate::same_bits::{options, plane_blocks, solid_blocks};
use crate::scene::{Scene, consistent_lines, exact};
use fmc_contact::contact::Friction;
use fmc_contact::{
    CarriedSlip, Contact, EnergyLaw, Obstacle, Options, PartitionedContact, Pose, Shape, SignedDistance,
};
use fmc_shapes::{ball_tet4, disc_tri3, rectangle_quad4, second_order};
use std::sync::Arc;

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
fn same_in_parts<const D: usize>(
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
            parts.bring(&part.here(coords)).unwrap();
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
fn sliding<const D: usize>(scene: &Scene<D>, cell: f64) -> Vec<Vec<[f64; D]>> {
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

fn stripes<const D: usize>(size: usize, width: f64) -> impl Fn(usize, [f64; D]) -> usize {
    move |_, x| ((x[0] / width * size as f64).max(0.0) as usize).min(size - 1)
}

#[test]
fn in_the_plane() {
    let scene = Scene::of(&plane_blocks().each_ref());
    let path = sliding(&scene, 7e-3);
    for options in options::<2>() {
        for size in [1, 2, 3, 4, 7] {
            same_in_parts(&scene, &path, options, &[], size, stripes(size, 2.0));
        }
        // A border along every face, and one below the surface.
        same_in_parts(&scene, &path, options, &[], 3, |cell, _| cell % 3);
        same_in_parts(&scene, &path, options, &[], 4, |_, x| usize::from(x[1] > 0.7) + usize::from(x[1] > 1.3));
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

#[test]
fn with_obstacles_and_a_body_that_may_touch_itself() {
    let [a, b] = solid_blocks();
    let scene = Scene::of(&[&a, &b]);
    let path = [scene.coords.clone()];
    let obstacles = [
        Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0, 0.0, 0.01]) },
        Obstacle { shape: Shape::Ball { radius: 0.8 }, pose: Pose::at([1.0, 1.0, -0.78]) },
        Obstacle { shape: Shape::Cuboid { half_extents: [0.6, 0.7, 0.2] }, pose: Pose::at([0.9, 0.8, 1.49]) },
    ];
    for self_contact in [false, true] {
        for law in [EnergyLaw::volume(40.0), EnergyLaw::fiber(30.0), EnergyLaw::depth(50.0)] {
            let options = Options { self_contact, ..Options::new(law) };
            same_in_parts(&scene, &path, options, &obstacles, 3, stripes(3, 2.0));
        }
    }
}

/// A small zone in a large mesh: few facets are gathered, and the same few on all ranks.
#[test]
fn little_is_gathered() {
    let a = rectangle_quad4([0.0, 0.0], [60.0, 1.0], [6000, 20]);
    let b = rectangle_quad4([0.2, 0.995], [0.7, 1.5], [47, 40]);
    let scene = Scene::of(&[&a, &b]);
    let options = Options { law: EnergyLaw::depth(50.0), ..exact() };
    same_in_parts(&scene, &[scene.coords.clone()], options, &[], 4, stripes(4, 60.0));
    let counts = on_ranks(4, None, |rank, own| {
        let part = Part::of(&scene, |cell, x| stripes(4, 60.0)(cell, x) == rank);
        PartitionedContact::new(own, &part.given(&part.blocks()), options, 0.0).unwrap().counts()
    });
    for counts in counts {
        assert_eq!(counts.facet_count, 2 * (6000 + 20 + 47 + 40));
        assert!(counts.gathered_facet_count < counts.facet_count / 20, "{counts:?}");
    }
}

/// A body inside another, whose depth is measured from facets that are nowhere near.
#[test]
fn swallowed() {
    let a = rectangle_quad4([0.0, 0.0], [2.0, 2.0], [80, 80]);
    let b = rectangle_quad4([0.9, 0.8], [1.13, 1.04], [7, 6]).rotated(0.01);
    let scene = Scene::of(&[&a, &b]);
    for law in [EnergyLaw::volume(40.0), EnergyLaw::depth(50.0)] {
        let options = Options { law, ..exact() };
        same_in_parts(&scene, &[scene.coords.clone()], options, &[], 4, |_, x| {
            usize::from(x[0] > 0.3) * 2 + usize::from(x[1] > 1.7)
        });
    }
}

/// Faces in a plane of symmetry, from which no depth is measured, and an axis.
#[test]
fn symmetry_and_an_axis() {
    let a = rectangle_quad4([0.0, 0.0], [2.0, 1.0], [40, 10]);
    let b = rectangle_quad4([0.0, 0.98], [0.5, 1.5], [11, 9]);
    let scene = Scene::of(&[&a, &b]);
    let in_plane = |x: &[f64; 2]| x[0] == 0.0;
    let nodes =
        |coords: &[[f64; 2]]| (0..coords.len() as u32).filter(|&n| in_plane(&coords[n as usize])).collect::<Vec<_>>();
    for axisymmetric in [false, true] {
        let options = Options { law: EnergyLaw::depth(50.0), axisymmetric, ..exact() };
        let mut whole = scene.contact(options);
        whole.set_symmetry_nodes(&nodes(&scene.coords)).unwrap();
        let expected = of_whole(&whole, &scene.coords);
        let found = on_ranks(3, None, |rank, own| {
            let part = Part::of(&scene, |cell, _| cell % 3 == rank);
            let mut parts = PartitionedContact::new(own, &part.given(&part.blocks()), options, 0.02).unwrap();
            parts.set_symmetry_nodes(&nodes(&part.coords)).unwrap();
            parts.bring(&part.coords).unwrap();
            told(parts.contact(), parts.coords(), parts.node_numbers(), scene.coords.len())
        });
        found.iter().for_each(|found| compare(found, &expected, "symmetry"));
    }
}

/// Kept patches and frozen friction stay where other cells are gathered, and so does a step that began elsewhere.
#[test]
fn what_was_kept_and_frozen_stays() {
    let a = rectangle_quad4([0.0, 0.0], [20.0, 1.0], [2000, 10]);
    let b = rectangle_quad4([0.2, 0.995], [0.7, 1.5], [47, 40]);
    let scene = Scene::of(&[&a, &b]);
    // In the end by some thirty cells, farther than what was gathered for where it began.
    let path = sliding(&scene, 0.2);
    for (law, commits) in
        [(EnergyLaw::fiber(30.0), true), (EnergyLaw::depth(50.0), true), (EnergyLaw::depth(5.0), false)]
    {
        let friction = Friction { coefficient: 0.4, stiffness: Some(20.0), ..Friction::default() };
        let options = Options { law, friction, ..exact() };
        let do_all = |contact: &mut Contact<2>, coords: &[[f64; 2]], number: usize| match number {
            0 => contact.begin_step(coords).unwrap(),
            1 => {
                if commits {
                    contact.commit_step(coords).unwrap();
                }
                contact.freeze_friction(coords).unwrap();
                contact.keep_patches(coords).map(drop).unwrap();
            }
            _ => {}
        };
        let mut whole = scene.contact(options);
        let mut expected = Vec::new();
        for (number, coords) in path.iter().enumerate() {
            do_all(&mut whole, coords, number);
            expected.push(of_whole(&whole, coords));
        }
        let found = on_ranks(3, None, |rank, own| {
            let part = Part::of(&scene, |cell, x| stripes(3, 20.0)(cell, x) == rank);
            let mut parts = PartitionedContact::new(own, &part.given(&part.blocks()), options, 0.02).unwrap();
            let mut found = Vec::new();
            for (number, coords) in path.iter().enumerate() {
                parts.bring(&part.here(coords)).unwrap();
                let here = parts.coords().to_vec();
                do_all(parts.contact_mut(), &here, number);
                found.push(told(parts.contact(), &here, parts.node_numbers(), coords.len()));
            }
            assert!(parts.counts().gather_count > 2);
            found
        });
        for found in found {
            for (number, (found, expected)) in found.iter().zip(&expected).enumerate() {
                compare(found, expected, &format!("step {number}, {law:?}"));
            }
        }
    }
}

/// A run with friction on three ranks goes on with two, and ends with the bits of one.
#[test]
fn a_restart_on_another_number_of_ranks() {
    let scene = Scene::of(&plane_blocks().each_ref());
    let path = sliding(&scene, 7e-3);
    let friction = Friction { coefficient: 0.4, stiffness: Some(20.0), ..Friction::default() };
    let options = Options { law: EnergyLaw::depth(50.0), friction, ..exact() };
    let mut whole = scene.contact(options);
    whole.begin_step(&path[0]).unwrap();
    whole.commit_step(&path[1]).unwrap();
    whole.commit_step(&path[2]).unwrap();
    let expected = of_whole(&whole, &path[3]);
    let run = |size: usize, from: Option<&[CarriedSlip<2>]>, steps: &[usize]| {
        on_ranks(size, None, |rank, own| {
            let part = Part::of(&scene, |cell, x| stripes(size, 2.0)(cell, x) == rank);
            let mut parts = PartitionedContact::new(own, &part.given(&part.blocks()), options, 0.02).unwrap();
            for (number, &step) in steps.iter().enumerate() {
                parts.bring(&part.here(&path[step])).unwrap();
                let here = parts.coords().to_vec();
                match number {
                    0 => parts.contact_mut().begin_step(&here).unwrap(),
                    _ => parts.contact_mut().commit_step(&here).unwrap(),
                }
                if let (Some(slip), 0) = (from, number) {
                    parts.set_slip(slip).unwrap();
                }
            }
            parts.bring(&part.here(&path[3])).unwrap();
            let told = told(parts.contact(), parts.coords(), parts.node_numbers(), scene.coords.len());
            (parts.slip().unwrap(), told)
        })
    };
    let before = run(3, None, &[0, 1]);
    assert!(before[0].0.len() > 100 && before.iter().all(|(slip, _)| *slip == before[0].0));
    for (_, found) in run(2, Some(&before[0].0), &[1, 2]) {
        compare(&found, &expected, "after a restart");
    }
}

/// Round bodies, whose boxes meet beside the contact, apart and together; lines whose spacing follows from the boxes; and
/// depth below a ball, which is summed over all facets that are seen through it from the middle of the body.
#[test]
fn round_bodies() {
    let a = disc_tri3(1.0, 160);
    let b = disc_tri3(0.8, 130).translated([0.3, 1.75]);
    let scene = Scene::of(&[&a, &b]);
    let ball = Obstacle { shape: Shape::Ball { radius: 0.5 }, pose: Pose::at([-1.3, 0.65]) };
    for law in [EnergyLaw::volume(40.0), EnergyLaw::fiber(30.0), EnergyLaw::depth(50.0)] {
        for options in [exact(), Options::new(law), consistent_lines(1e-3, 5)] {
            let options = Options { law, ..options };
            same_in_parts(&scene, &sliding(&scene, 0.01), options, &[ball.clone()], 3, stripes(3, 1.5));
        }
    }
    let [a, b] = [ball_tet4(1.0, 3, 6), ball_tet4(0.7, 3, 5).translated([0.3, 0.2, 1.6])];
    let scene = Scene::of(&[&a, &b]);
    for law in [EnergyLaw::volume(40.0), EnergyLaw::fiber(30.0), EnergyLaw::depth(50.0)] {
        same_in_parts(&scene, &sliding(&scene, 0.01)[..1], Options { law, ..exact() }, &[], 3, |cell, _| cell % 3);
    }
}

/// A distance that a host gives: of a bar.
#[derive(Debug)]
struct Bar;

impl SignedDistance<2> for Bar {
    fn evaluate(&self, x: &[[f64; 2]], phi: &mut [f64], gradient: &mut [[f64; 2]]) -> Result<(), usize> {
        for ((x, phi), gradient) in x.iter().zip(phi).zip(gradient) {
            *phi = x[1] + 0.1 * (3.0 * x[0]).sin();
            *gradient = [0.3 * (3.0 * x[0]).cos(), 1.0];
        }
        Ok(())
    }
}

/// A tall body, of which little is gathered, on obstacles of all kinds one by one.
#[test]
fn a_tall_body_on_obstacles() {
    let scene = Scene::of(&[&rectangle_quad4([0.0, 0.0], [2.0, 5.0], [40, 100]).rotated(0.01)]);
    let pentagon = (0..5).map(|k| f64::from(k) * std::f64::consts::TAU / 5.0).map(|a| [0.5 * a.cos(), 0.5 * a.sin()]);
    let shapes = [
        (Shape::HalfSpace, [0.0, 0.03]),
        (Shape::Cuboid { half_extents: [0.4, 0.2] }, [1.0, -0.16]),
        (Shape::Cuboid { half_extents: [3.0, 0.2] }, [1.0, -0.16]),
        (Shape::ConvexHull { points: pentagon.collect() }, [1.0, -0.42]),
        (Shape::Ball { radius: 0.5 }, [1.0, -0.45]),
        (Shape::Capsule { radius: 0.3, half_height: 0.4 }, [1.0, -0.65]),
        (Shape::SignedDistance(Arc::new(Bar)), [0.0, 0.03]),
    ];
    for (shape, at) in shapes {
        let obstacle = [Obstacle { shape, pose: Pose::at(at) }];
        for law in [EnergyLaw::volume(40.0), EnergyLaw::fiber(30.0), EnergyLaw::depth(50.0)] {
            for options in [exact(), Options::new(law)] {
                let options = Options { law, ..options };
                same_in_parts(&scene, &[scene.coords.clone()], options, &obstacle, 3, |_, x| {
                    usize::from(x[1] > 0.07) + usize::from(x[1] > 2.0)
                });
            }
        }
    }
}
