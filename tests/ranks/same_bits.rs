//! Every rank gets the bits of one rank alone: for all laws, both estimators, friction, cells of second order, obstacles and a
//! body with itself; on 2, 3, 4 and 7 ranks, with threads or without.

use crate::communicator::on_ranks;
use crate::scene::{Scene, by_lines, consistent_lines, exact, lines};
use fmc_contact::contact::{Friction, TangentPart};
use fmc_contact::{Communicator, Contact, EnergyLaw, Estimator, Obstacle, Options, Pose, Shape};
use fmc_shapes::{Mesh, cuboid_hex8, cuboid_tet4, rectangle_quad4, second_order};

/// Blocks that press each other over a face, with meshes that do not match; enough for all to have something to do.
pub(crate) fn plane_blocks() -> [Mesh<2>; 2] {
    let a = rectangle_quad4([0.0, 0.0], [2.0, 1.0], [300, 3]);
    [a, rectangle_quad4([0.21, 0.99], [1.73, 1.9], [257, 2]).rotated(0.001)]
}

pub(crate) fn solid_blocks() -> [Mesh<3>; 2] {
    let a = cuboid_hex8([0.0; 3], [2.0, 1.9, 0.6], [22, 21, 2]);
    let b = cuboid_tet4([0.2, 0.13, 0.583], [1.71, 1.64, 1.3], [17, 16, 2]);
    [a, b.rotated([1.0, 0.3, 0.2], 0.003)]
}

pub(crate) fn options<const D: usize>() -> Vec<Options> {
    let spacing = if D == 2 { 2e-3 } else { 4e-2 };
    let laws = [EnergyLaw::volume(40.0), EnergyLaw::fiber(30.0), EnergyLaw::depth(50.0)];
    let mut all: Vec<Options> = laws
        .iter()
        .flat_map(|law| [exact(), lines(spacing, 2)].map(|options| Options { law: *law, ..options }))
        .collect();
    all.push(consistent_lines(spacing, 5));
    all.push(by_lines(EnergyLaw::fiber(7.0)));
    let friction = Friction { coefficient: 0.4, stiffness: Some(20.0), ..Friction::default() };
    all.extend(laws.map(|law| Options { law, friction, ..exact() }));
    all
}

/// All that can be asked, told to the last bit. Tangents that are refused are so on all ranks, in the same words.
fn everything<const D: usize>(contact: &mut Contact<D>, coords: &[[f64; D]], moved: &[[f64; D]]) -> Vec<String> {
    let mut told = Vec::new();
    if contact.options().friction.is_active() {
        contact.begin_step(coords).unwrap();
    }
    let here = if contact.options().friction.is_active() { moved } else { coords };
    told.push(format!("{:?}", contact.evaluate(here)));
    for part in [TangentPart::Symmetric, TangentPart::Semidefinite] {
        told.push(format!("{:?}", contact.tangent(here, part)));
        told.push(format!("{:?}", contact.evaluate_tangent(here, part)));
    }
    told.push(format!("{:?}", contact.overlaps(here)));
    told.push(format!("{:?}", contact.nodal_contact(here)));
    told.push(format!("{:?}", contact.contact_points(here)));
    told.push(format!("{:?}", contact.trace(here)));
    told.push(format!("{:?}", contact.gap_constraints(here, 0.02)));
    if contact.options().friction.is_active() {
        contact.commit_step(here).unwrap();
        told.push(format!("{:?}", contact.slip()));
        told.push(format!("{:?}", contact.evaluate(coords)));
    }
    told
}

fn whatever_the_number_of_ranks<const D: usize>(
    scene: &Scene<D>,
    options: Options,
    obstacles: &[Obstacle<D>],
    counts: &[usize],
) {
    let moved: Vec<[f64; D]> = scene
        .coords
        .iter()
        .enumerate()
        .map(|(node, x)| {
            let mut x = *x;
            if node >= scene.coords.len() / 2 {
                x[0] += 1e-3
            }
            x
        })
        .collect();
    let found = |communicator: Option<Box<dyn Communicator>>, threads: usize| {
        let mut contact = scene.contact(Options { threads, ..options });
        obstacles.iter().for_each(|obstacle| {
            contact.add_obstacle(obstacle.clone()).unwrap();
        });
        contact.set_communicator(communicator).unwrap();
        let told = everything(&mut contact, &scene.coords, &moved);
        (told, contact.rank_counts().item_count)
    };
    let (alone, _) = found(None, 1);
    for &size in counts {
        let on_all = on_ranks(size, None, |rank, own| found(Some(own), 1 + rank % 2));
        for (rank, (told, shared)) in on_all.iter().enumerate() {
            for (number, (told, alone)) in told.iter().zip(&alone).enumerate() {
                assert!(told == alone, "answer {number} of rank {rank} of {size}, {options:?}");
            }
            // The exact volume clips few facets, those near the curve in which the boundaries cross; in the plane the law depth has no
            // more than facets to share; and here lines are few.
            let is_little = match options.law {
                _ if !(2..4).contains(&size) || options.estimator != Estimator::Exact => true,
                EnergyLaw::Volume { .. } => true,
                EnergyLaw::Depth { .. } => D == 2,
                _ => false,
            };
            assert!(is_little || *shared > 0, "nothing was shared: {options:?}");
        }
    }
}

#[test]
fn in_the_plane() {
    let [a, b] = plane_blocks();
    let scene = Scene::of(&[&a, &b]);
    options::<2>().into_iter().for_each(|options| whatever_the_number_of_ranks(&scene, options, &[], &[1, 2, 3, 4, 7]));
}

#[test]
fn in_space() {
    let [a, b] = solid_blocks();
    let scene = Scene::of(&[&a, &b]);
    options::<3>().into_iter().for_each(|options| whatever_the_number_of_ranks(&scene, options, &[], &[3]));
}

#[test]
fn with_cells_of_second_order() {
    let [a, b] = plane_blocks();
    let scene = Scene::of(&[&second_order(&a, 8), &second_order(&b, 9)]);
    for law in [EnergyLaw::volume(40.0), EnergyLaw::fiber(30.0), EnergyLaw::depth(50.0)] {
        whatever_the_number_of_ranks(&scene, Options { law, ..exact() }, &[], &[3]);
    }
    let curved = scene.mapped(|[x, y]| [x, y + 0.05 * (3.0 * x).sin()]);
    whatever_the_number_of_ranks(&curved, Options { law: EnergyLaw::depth(50.0), ..exact() }, &[], &[3]);
}

#[test]
fn with_obstacles_and_a_body_that_may_touch_itself() {
    let [a, _] = solid_blocks();
    let scene = Scene::of(&[&a]);
    let at = |x| Pose::at(x);
    let obstacles = [
        Obstacle { shape: Shape::HalfSpace, pose: at([0.0, 0.0, 0.01]) },
        Obstacle { shape: Shape::Ball { radius: 0.8 }, pose: at([1.0, 1.0, 1.39]) },
        Obstacle { shape: Shape::Cuboid { half_extents: [0.6, 0.7, 0.2] }, pose: at([0.9, 0.8, 0.79]) },
    ];
    let auto = |law| Options { self_contact: true, ..Options::new(law) };
    for law in [EnergyLaw::volume(40.0), EnergyLaw::fiber(30.0), EnergyLaw::depth(50.0)] {
        whatever_the_number_of_ranks(&scene, auto(law), &obstacles, &[3]);
    }
}

/// A rank takes some 16 000 lines at once.
#[test]
fn with_many_lines() {
    let scene = Scene::of(&solid_blocks().each_ref());
    for law in [EnergyLaw::volume(40.0), EnergyLaw::fiber(30.0), EnergyLaw::depth(50.0)] {
        let options = Options { law, ..lines(5e-3, 2) };
        let alone = scene.evaluate(options);
        let on_all = on_ranks(3, None, |_, own| {
            let mut contact = scene.contact(options);
            contact.set_communicator(Some(own)).unwrap();
            (contact.evaluate(&scene.coords).unwrap(), contact.rank_counts())
        });
        for (found, counts) in on_all {
            assert!(counts.item_count >= 6 && counts.own_item_count < counts.item_count, "{law:?}: {counts:?}");
            assert_eq!(format!("{found:?}"), format!("{alone:?}"), "{law:?}");
        }
    }
}
