//! Ties beside the options of pairs: with a period between their faces, and with a jump.

use crate::blocks::in_the_plane;
use crate::scene::Scene;
use crate::{K, largest, tied};
use fmc_contact::contact::{PairOptions, TangentPart};
use fmc_contact::overlap::Partner::Body;
use fmc_contact::{Contact, EnergyLaw, Error, Options};
use fmc_shapes::{Diagonals, Mesh, cuboid_hex8, cuboid_tet4, rectangle_quad4, rectangle_tri3, second_order};

/// Facets all of whose nodes have the coordinate `at` along an axis, without deformation.
fn face<const D: usize>(contact: &mut Contact<D>, scene: &Scene<D>, body: usize, axis: usize, at: f64) -> usize {
    let weights = contact.point_weights();
    let coordinate = |point: u32| -> f64 {
        weights.row(point as usize).map(|(node, weight)| weight * scene.coords[node as usize][axis]).sum()
    };
    let all = contact.boundary_facets().into_iter().enumerate();
    let is_in = |nodes: &[u32]| nodes.iter().all(|&node| (coordinate(node) - at).abs() < 1e-9);
    let facets: Vec<usize> =
        all.filter(|(_, facet)| facet.body == body && is_in(&facet.nodes)).map(|(number, _)| number).collect();
    contact.add_surface(&facets).expect("a surface")
}

/// A block of size 1 whose face at x = 1 is not divided as that at x = 0, and so for the other axes: nodes slide in their faces.
fn cell<const D: usize>(mut mesh: Mesh<D>) -> Mesh<D> {
    for x in &mut mesh.coords {
        let old = *x;
        for axis in 0..D {
            let bend = 0.06 * (std::f64::consts::TAU * old[axis]).sin();
            x[axis] += bend * (0..D).filter(|other| *other != axis).map(|other| old[other]).sum::<f64>();
        }
    }
    mesh
}

/// A cell tied to itself along every axis; ties 1 to D.
fn periodic<const D: usize>(scene: &Scene<D>) -> Contact<D> {
    let mut contact = scene.contact(Options::new(EnergyLaw::depth(K)));
    for axis in 0..D {
        let surfaces = [1.0, 0.0].map(|at| face(&mut contact, scene, 0, axis, at));
        let period = std::array::from_fn(|k| if k == axis { 1.0 } else { 0.0 });
        let number = contact.add_tie(surfaces, period, 0.0).expect("a tie");
        assert_eq!(number, axis + 1);
        let summary = contact.added_tie(number).expect("a tie");
        assert!((summary.area - 1.0).abs() < 1e-9 && summary.largest_gap == 0.0, "{summary:?}");
    }
    contact
}

fn gradient<const D: usize>(i: usize, j: usize) -> f64 {
    0.1 * (1.0 + (i * D + j) as f64) - 0.15
}

/// x → x + H x, moved on.
fn strained<const D: usize>(coords: &[[f64; D]]) -> Vec<[f64; D]> {
    let one =
        |x: &[f64; D]| std::array::from_fn(|i| 2.0 + x[i] + (0..D).map(|j| gradient::<D>(i, j) * x[j]).sum::<f64>());
    coords.iter().map(one).collect()
}

fn affine<const D: usize>(mesh: Mesh<D>) {
    let scene = Scene::of(&[&cell(mesh)]);
    let mut contact = periodic(&scene);
    assert!(largest(&contact.evaluate(&scene.coords).expect("an evaluation").forces) < 1e-12 * K);
    let coords = strained(&scene.coords);
    assert!(largest(&contact.evaluate(&coords).expect("an evaluation").forces) > 1e-3 * K);
    for axis in 0..D {
        contact.set_tie_jump(axis + 1, std::array::from_fn(|i| gradient::<D>(i, axis))).expect("a jump");
    }
    let found = contact.evaluate(&coords).expect("an evaluation");
    assert!(largest(&found.forces) < 1e-12 * K, "{:e}", largest(&found.forces));
    assert_eq!(found.pairs.len(), D);
}

/// A homogeneous strain of a cell whose opposite faces do not match: with jumps of strain times period no tie has a force.
#[test]
fn cells_follow_every_homogeneous_strain() {
    let flat = || rectangle_tri3([0.0; 2], [1.0; 2], [4, 5], Diagonals::Alternating);
    affine(rectangle_quad4([0.0; 2], [1.0; 2], [5, 4]));
    affine(second_order(&flat(), 6));
    affine(flat());
    affine(cuboid_tet4([0.0; 3], [1.0; 3], [2, 3, 3]));
    affine(cuboid_hex8([0.0; 3], [1.0; 3], [3, 2, 3]));
}

/// Force and energy against differences: by the nodes, and by the jump; the tangent against forces. The energy is quadratic.
#[test]
fn forces_are_derivatives_by_nodes_and_by_the_jump() {
    let scene = Scene::of(&[&cell(rectangle_tri3([0.0; 2], [1.0; 2], [3, 4], Diagonals::Alternating))]);
    let mut contact = periodic(&scene);
    let coords: Vec<[f64; 2]> = scene
        .coords
        .iter()
        .enumerate()
        .map(|(n, x)| [x[0] + 0.01 * (n as f64).sin(), x[1] - 0.02 * (2.0 * n as f64).cos()])
        .collect();
    let jump = [0.03, -0.02];
    contact.set_tie_jump(2, jump).expect("a jump");
    let energy = |contact: &Contact<2>, coords: &[[f64; 2]]| contact.evaluate(coords).expect("an evaluation").energy;
    let forces = contact.evaluate(&coords).expect("an evaluation").forces;
    let tangent = contact.tangent(&coords, TangentPart::Full).expect("a tangent");
    let h = 1e-3;
    for node in 0..coords.len() {
        for axis in 0..2 {
            let moved = |by: f64| {
                let mut coords = coords.clone();
                coords[node][axis] += by;
                coords
            };
            let slope = (energy(&contact, &moved(h)) - energy(&contact, &moved(-h))) / (2.0 * h);
            assert!((slope + forces[node][axis]).abs() < 1e-10 * K, "{node} {axis}");
            let [more, less] = [h, -h].map(|by| contact.evaluate(&moved(by)).expect("an evaluation").forces);
            let mut unit = vec![[0.0; 2]; coords.len()];
            unit[node][axis] = 1.0;
            for ((column, more), less) in tangent.product(&unit).iter().zip(&more).zip(&less) {
                assert!((0..2).all(|k| (column[k] + (more[k] - less[k]) / (2.0 * h)).abs() < 1e-10 * K));
            }
        }
    }
    let force = contact.tie_force(2, &coords).expect("a force");
    for axis in 0..2 {
        let [more, less] = [h, -h].map(|by| {
            let mut jump = jump;
            jump[axis] += by;
            contact.set_tie_jump(2, jump).expect("a jump");
            energy(&contact, &coords)
        });
        assert!(((more - less) / (2.0 * h) - force[axis]).abs() < 1e-10 * K, "{axis}");
    }
}

/// Two bodies that lie on one another, gaps included: without a jump as by the options of their pair, bit for bit. With one the body moves by it.
#[test]
fn without_a_jump_it_is_the_tie_of_the_pair() {
    for gap in [0.0, 0.03] {
        for scene in &in_the_plane(gap) {
            let near = |contact: &mut Contact<2>| {
                [[0, 0], [1, 1]].map(|[body, _]| {
                    let facets: Vec<usize> = contact
                        .boundary_facets()
                        .iter()
                        .enumerate()
                        .filter(|(_, f)| f.body == body)
                        .map(|(n, _)| n)
                        .collect();
                    contact.add_surface(&facets).expect("a surface")
                })
            };
            let of_pair = tied(scene, 0.1);
            let mut added = scene.contact(Options::new(EnergyLaw::depth(K)));
            let surfaces = near(&mut added);
            let touching = added.add_tie(surfaces, [0.0; 2], 0.1).expect_err("bodies in contact");
            assert!(matches!(touching, Error::Unsupported { .. }), "{touching}");
            added.set_pair_options([0, 1].map(Body), Some(PairOptions::excluded())).expect("options");
            assert_eq!(added.add_tie(surfaces, [0.0; 2], 0.1), Ok(1));
            let mut coords = scene.coords.clone();
            let first = scene.first_node[1];
            coords[first..].iter_mut().enumerate().for_each(|(n, x)| x[1] += 0.01 + 1e-3 * (n as f64).sin());
            let [a, b] = [&of_pair, &added].map(|one| one.evaluate(&coords).expect("an evaluation"));
            assert_eq!(a.forces, b.forces);
            assert_eq!(a.energy.to_bits(), b.energy.to_bits());
            assert_eq!(of_pair.tie([0, 1]).unwrap(), Some(added.added_tie(1).unwrap()));
            assert_eq!(of_pair.tie_nodes(&coords), added.tie_nodes(&coords));
            let force = added.tie_force(1, &coords).expect("a force");
            assert!((0..2).all(|k| (force[k] + b.pairs[0].force[k]).abs() < 1e-12 * K));
            // The second body moved by −jump is where the first is less far above it.
            added.set_tie_jump(1, [0.02, -0.05]).expect("a jump");
            let moved: Vec<[f64; 2]> = coords
                .iter()
                .enumerate()
                .map(|(n, x)| if n < first { *x } else { [x[0] - 0.02, x[1] + 0.05] })
                .collect();
            let found = added.evaluate(&moved).expect("an evaluation").forces;
            let off = found.iter().zip(&a.forces).map(|(f, g)| [f[0] - g[0], f[1] - g[1]]).collect::<Vec<_>>();
            assert!(largest(&off) < 1e-12 * K, "{:e}", largest(&off));
            assert!(added.tie_constraints().is_err());
            let open = added.set_pair_options([0, 1].map(Body), None).expect_err("contact beside it");
            assert!(matches!(open, Error::Unsupported { .. }), "{open}");
            // The same with its parts named in the other order.
            assert_eq!(added.add_tie([surfaces[1], surfaces[0]], [0.0; 2], 0.1), Ok(2));
            added.remove_tie(1).expect("the tie");
            added.set_tie_jump(2, [-0.02, 0.05]).expect("a jump");
            let other = added.evaluate(&moved).expect("an evaluation").forces;
            let off = other.iter().zip(&a.forces).map(|(f, g)| [f[0] - g[0], f[1] - g[1]]).collect::<Vec<_>>();
            assert!(largest(&off) < 1e-12 * K, "{:e}", largest(&off));
            let swapped = added.tie_force(2, &moved).expect("a force");
            assert!((0..2).all(|k| (force[k] + swapped[k]).abs() < 1e-12 * K));
            added.remove_tie(2).expect("the tie");
            assert!(added.evaluate(&moved).expect("an evaluation").pairs.is_empty());
            assert!(
                added.remove_tie(1).is_err() && added.tie_force(1, &coords).is_err() && added.added_tie(0).is_err()
            );
        }
    }
}

/// What is refused changes nothing; another mesh without deformation has the same tie, with its jump.
#[test]
fn ties_are_refused_and_found_again() {
    let scene =
        Scene::of(&[&rectangle_quad4([0.0; 2], [1.0; 2], [2, 2]), &rectangle_quad4([0.0, 3.0], [1.0, 4.0], [2, 2])]);
    let mut contact = scene.contact(Options::new(EnergyLaw::depth(K)));
    let [left, right] = [0.0, 1.0].map(|at| face(&mut contact, &scene, 0, 0, at));
    let both = contact.add_surface(&(0..contact.boundary_facets().len()).collect::<Vec<_>>()).expect("a surface");
    for (surfaces, period, reach) in [
        ([right, 9], [1.0, 0.0], 0.0),
        ([0, left], [1.0, 0.0], 0.0),
        ([right, both], [1.0, 0.0], 0.0),
        ([right, right], [1.0, 0.0], 0.0),
        ([right, left], [0.5, 0.0], 0.0),
        ([left, right], [1.0, 0.0], 0.0),
        ([right, left], [1.0, f64::NAN], 0.0),
        ([right, left], [1.0, 0.0], -1.0),
    ] {
        assert!(contact.add_tie(surfaces, period, reach).is_err(), "{surfaces:?} {period:?} {reach}");
    }
    assert_eq!(contact.add_tie([right, left], [1.0, 0.0], 0.0), Ok(1));
    assert!(contact.set_tie_jump(1, [f64::INFINITY, 0.0]).is_err() && contact.set_tie_jump(2, [0.0; 2]).is_err());
    contact.set_tie_jump(1, [0.1, 0.2]).expect("a jump");
    let mut coords = scene.coords.clone();
    coords.iter_mut().for_each(|x| *x = [1.1 * x[0], x[1] + 0.2 * x[0]]);
    assert!(largest(&contact.evaluate(&coords).expect("an evaluation").forces) < 1e-12 * K);
    let turned: Vec<[f64; 2]> = scene.coords.iter().map(|x| [x[0], 2.0 * x[1]]).collect();
    contact.set_reference(&turned).expect("a reference");
    assert!((contact.added_tie(1).unwrap().area - 2.0).abs() < 1e-12);
    assert!(largest(&contact.evaluate(&coords).expect("an evaluation").forces) < 1e-12 * K);
    assert!(contact.set_options(Options::new(EnergyLaw::volume(K))).is_err());
}
