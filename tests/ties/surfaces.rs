//! Ties of named parts of surfaces, beside which the same bodies are in contact.

use crate::blocks::{in_space, in_the_plane};
use crate::scene::Scene;
use crate::{K, largest, tied};
use fmc_contact::contact::{Cohesive, PairOptions, TangentPart};
use fmc_contact::overlap::Partner::{Body, Obstacle as Rigid};
use fmc_contact::{Contact, EnergyLaw, Error, Obstacle, Options, Pose, Shape};
use fmc_shapes::{Diagonals, cuboid_hex8, cuboid_tet4, rectangle_quad4, rectangle_tri3};

/// Facets of a body whose nodes all fulfil something, without deformation.
fn facets<const D: usize>(
    contact: &Contact<D>,
    scene: &Scene<D>,
    body: usize,
    holds: impl Fn(&[f64; D]) -> bool,
) -> Vec<usize> {
    let all = contact.boundary_facets().into_iter().enumerate();
    let weights = contact.point_weights();
    let place = |point: u32| -> [f64; D] {
        let mut x = [0.0; D];
        for (node, weight) in weights.row(point as usize) {
            (0..D).for_each(|axis| x[axis] += weight * scene.coords[node as usize][axis]);
        }
        x
    };
    all.filter(|(_, facet)| facet.body == body && facet.nodes.iter().all(|&n| holds(&place(n))))
        .map(|(n, _)| n)
        .collect()
}

/// Contact of two bodies tied by the facets of both that fulfil something.
fn tied_where<const D: usize>(scene: &Scene<D>, reach: f64, holds: impl Fn(&[f64; D]) -> bool) -> Contact<D> {
    let mut contact = scene.contact(Options::new(EnergyLaw::depth(K)));
    let parts = [0, 1].map(|body| {
        let own = facets(&contact, scene, body, &holds);
        contact.add_surface(&own).expect("a surface")
    });
    let options = PairOptions::tied(reach).between(parts);
    contact.set_pair_options([0, 1].map(Body), Some(options)).expect("a tie");
    contact
}

fn whole_faces<const D: usize>(scenes: &[Scene<D>], reach: f64) {
    for scene in scenes {
        let near = |x: &[f64; D]| (x[D - 1] - 0.5).abs() < 0.05;
        let (whole, parts) = (tied(scene, reach), tied_where(scene, reach, near));
        assert_eq!(whole.tie([0, 1]), parts.tie([0, 1]));
        let first = scene.first_node[1];
        let mut coords = scene.coords.clone();
        for (node, x) in coords.iter_mut().enumerate().skip(first) {
            x[D - 1] += 0.01 + 1e-3 * (node as f64).sin();
        }
        let [of_whole, of_parts] = [&whole, &parts].map(|one| one.evaluate(&coords).expect("an evaluation"));
        assert_eq!(of_whole.forces, of_parts.forces);
        assert_eq!(of_whole.energy.to_bits(), of_parts.energy.to_bits());
        let [a, b] = [&whole, &parts].map(|one| one.tie_nodes(&coords).expect("nodes"));
        assert_eq!(a, b);
    }
}

/// Where the parts are all that faces one another, nothing is changed.
#[test]
fn whole_faces_are_tied_as_whole_bodies_are() {
    whole_faces(&in_the_plane(0.0), 0.0);
    whole_faces(&in_the_plane(0.03), 0.1);
    whole_faces(&in_space(0.03)[..12], 0.1);
}

/// Two blocks of a width of 1, one on the other at a height of 1/2, in `n` facets below and `m` above.
fn blocks_of(kind: usize, [n, m]: [usize; 2]) -> Scene<2> {
    let one = |low: [f64; 2], high: [f64; 2], cells| match kind {
        0 => rectangle_quad4(low, high, cells),
        _ => rectangle_tri3(low, high, cells, Diagonals::Alternating),
    };
    Scene::of(&[&one([0.0, 0.0], [1.0, 0.5], [n, 2]), &one([0.0, 0.5], [1.0, 1.0], [m, 2])])
}

/// Left halves are tied, right ones touch.
fn half_tied(scene: &Scene<2>) -> Contact<2> {
    tied_where(scene, 0.05, |x| (x[1] - 0.5).abs() < 1e-9 && x[0] < 0.5 + 1e-9)
}

/// A body that is moved as a whole by u: the tie answers by K u on half of the face, either way; the contact presses by K u on the other half
/// where u goes in, and leaves the face where it goes out. Contact by the depth ends with the last facet that is not tied, but for a film
/// and the corners of cells, of u/h in parts.
#[test]
fn one_half_holds_and_the_other_presses() {
    for kind in 0..2 {
        for cells in [[4, 6], [2, 4], [2, 2]] {
            let scene = blocks_of(kind, cells);
            let contact = half_tied(&scene);
            assert!((contact.tie([0, 1]).unwrap().unwrap().area - 0.5).abs() < 1e-12);
            for (u, on_contact) in [(1e-6, 0.0), (-1e-6, 1.0)] {
                let mut coords = scene.coords.clone();
                coords[scene.first_node[1]..].iter_mut().for_each(|x| x[1] += u);
                let found = contact.evaluate(&coords).expect("an evaluation");
                let right = |x: &[f64; 2]| x[0] > 0.5 + 1e-9;
                let first = scene.first_node[1];
                let force: f64 = found.forces[first..].iter().map(|f| f[1]).sum();
                let expected = -K * u * (0.5 + 0.5 * on_contact);
                assert!((force / expected - 1.0).abs() < 1e-5, "{kind} {cells:?} {u}: {force:e} for {expected:e}");
                let on_right: f64 =
                    (first..coords.len()).filter(|&n| right(&scene.coords[n])).map(|n| found.forces[n][1]).sum();
                // All but the part of the middle node: half of a facet.
                let h = 1.0 / cells[1] as f64;
                let expected = -K * u * on_contact * (0.5 - 0.5 * h);
                assert!((on_right - expected).abs() < 1e-4 * K * u.abs(), "{on_right:e} for {expected:e}");
                let of_contact: Vec<_> = found.pairs.iter().filter(|pair| pair.contact_area > 0.0).collect();
                assert_eq!(of_contact.len(), if on_contact > 0.0 { 2 } else { 1 }, "{:?}", found.pairs);
            }
        }
    }
}

/// Corners of an L: the faces below are tied, those beside it press, and the other way round.
#[test]
fn of_two_faces_of_an_l_one_is_tied() {
    // A block in the corner of an L: what is left of a square without a quarter.
    let mut l = rectangle_quad4([0.0, 0.0], [2.0, 2.0], [8, 8]);
    let is_left = |cell: &&[u32]| cell.iter().any(|&node| l.coords[node as usize].iter().any(|x| *x < 1.0 - 1e-9));
    l.conn = l.conn.chunks_exact(4).filter(is_left).flatten().copied().collect();
    let block = rectangle_quad4([1.0, 1.0], [2.0, 2.0], [3, 3]);
    let scene = Scene::of(&[&l, &block]);
    let first = scene.first_node[1];
    for (axis, other) in [(1, 0), (0, 1)] {
        let contact = tied_where(&scene, 0.05, |x| (x[axis] - 1.0).abs() < 1e-9 && x[other] > 1.0 - 1e-9);
        assert!((contact.tie([0, 1]).unwrap().unwrap().area - 1.0).abs() < 1e-12);
        for (u, presses) in [(1e-6, false), (-1e-6, true)] {
            let mut coords = scene.coords.clone();
            coords[first..].iter_mut().for_each(|x| x[other] += u);
            let forces = contact.evaluate(&coords).expect("an evaluation").forces;
            let force: f64 = forces[first..].iter().map(|f| f[other]).sum();
            // The tie shears by K u, the contact presses as much.
            let expected = -K * u * if presses { 2.0 } else { 1.0 };
            assert!((force / expected - 1.0).abs() < 1e-5, "{axis} {u}: {force:e} for {expected:e}");
            // Into the tied face nothing presses but the tie.
            let mut coords = scene.coords.clone();
            coords[first..].iter_mut().for_each(|x| x[axis] += u);
            let forces = contact.evaluate(&coords).expect("an evaluation").forces;
            let force: f64 = forces[first..].iter().map(|f| f[axis]).sum();
            assert!((force / (-K * u) - 1.0).abs() < 1e-5, "{axis} {u}: {force:e}");
        }
    }
}

fn field<const D: usize>(coords: &[[f64; D]], seed: f64) -> Vec<[f64; D]> {
    let wave = |node: usize, axis: usize| (seed + 1.7 * node as f64 + 2.9 * axis as f64).sin();
    (0..coords.len()).map(|node| std::array::from_fn(|axis| wave(node, axis))).collect()
}

fn moved<const D: usize>(coords: &[[f64; D]], by: f64, step: &[[f64; D]]) -> Vec<[f64; D]> {
    coords.iter().zip(step).map(|(x, d)| std::array::from_fn(|axis| x[axis] + by * d[axis])).collect()
}

/// Central differences over a step at which rounding, that of films below facets included, and curvature are both below 1e-6.
fn differences<const D: usize>(scene: &Scene<D>, contact: &Contact<D>, down: f64) {
    let mut start = scene.coords.clone();
    start[scene.first_node[1]..].iter_mut().for_each(|x| x[D - 1] -= down);
    let (start, step) = (moved(&start, 0.1 * down, &field(&start, 0.3)), field(&start, 4.1));
    let at = |coords: &[[f64; D]]| contact.evaluate(coords).expect("an evaluation");
    let found = at(&start);
    assert!(found.pairs.len() == 2 && found.pairs.iter().all(|pair| pair.energy > 0.0), "{:?}", found.pairs);
    let dot =
        |a: &[[f64; D]], b: &[[f64; D]]| a.iter().flatten().zip(b.iter().flatten()).map(|(a, b)| a * b).sum::<f64>();
    let h = 1e-5 * down;
    let slope = (at(&moved(&start, h, &step)).energy - at(&moved(&start, -h, &step)).energy) / (2.0 * h);
    let force = -dot(&found.forces, &step);
    assert!((slope - force).abs() < 1e-6 * force.abs().max(K * down), "{slope:e} for {force:e}");
    let tangent = contact.tangent(&start, TangentPart::Full).expect("a tangent");
    let expected = tangent.product(&step);
    let [more, less] = [h, -h].map(|h| at(&moved(&start, h, &step)).forces);
    let scale = largest(&expected);
    for ((row, more), less) in expected.iter().zip(&more).zip(&less) {
        for axis in 0..D {
            let slope = -(more[axis] - less[axis]) / (2.0 * h);
            assert!((slope - row[axis]).abs() < 1e-6 * scale, "{slope:e} for {:e} of {scale:e}", row[axis]);
        }
    }
}

#[test]
fn forces_are_the_derivative_of_the_energy_and_the_tangent_is_theirs() {
    for kind in 0..2 {
        for cells in [[4, 6], [2, 2]] {
            let scene = blocks_of(kind, cells);
            differences(&scene, &half_tied(&scene), 0.02);
        }
    }
    let below = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.5]];
    let above = [[0.0, 0.0, 0.5], [1.0, 1.0, 1.0]];
    for scene in [
        Scene::of(&[&cuboid_tet4(below[0], below[1], [2, 2, 1]), &cuboid_tet4(above[0], above[1], [2, 1, 1])]),
        Scene::of(&[&cuboid_hex8(below[0], below[1], [2, 2, 1]), &cuboid_hex8(above[0], above[1], [2, 1, 1])]),
    ] {
        let contact = tied_where(&scene, 0.05, |x| (x[2] - 0.5).abs() < 1e-9 && x[0] < 0.5 + 1e-9);
        assert!((contact.tie([0, 1]).unwrap().unwrap().area - 0.5).abs() < 1e-12);
        differences(&scene, &contact, 0.02);
    }
}

/// Other interfaces of parts, and the contact beside them.
#[test]
fn all_interfaces_may_be_of_parts() {
    let scene = blocks_of(0, [4, 6]);
    let u = -1e-6;
    let mut coords = scene.coords.clone();
    coords[scene.first_node[1]..].iter_mut().for_each(|x| x[1] += u);
    for interface in [
        PairOptions::no_separation(0.05),
        PairOptions::with_cohesive(Cohesive { stiffness: K, reach: 0.05, ..Cohesive::new(10.0, 1.0) }),
    ] {
        let mut contact = half_tied(&scene);
        contact.set_pair_options([1, 0].map(Body), Some(interface.between([2, 1]))).expect("an interface");
        let told = contact.pair_options([0, 1].map(Body)).unwrap().unwrap();
        assert_eq!(told.surfaces, Some([1, 2]));
        assert_eq!(contact.pair_options([1, 0].map(Body)).unwrap().unwrap().surfaces, Some([2, 1]));
        contact.begin_step(&scene.coords).expect("a step");
        let forces = contact.evaluate(&coords).expect("an evaluation").forces;
        let force: f64 = forces[scene.first_node[1]..].iter().map(|f| f[1]).sum();
        assert!((force / (-K * u) - 1.0).abs() < 1e-5, "{force:e}");
        differences(&scene, &contact, 0.02);
    }
}

/// Nothing is changed by what is refused; and a tie of parts is released, made again and found again.
#[test]
fn parts_are_refused_released_and_found_again() {
    let scene = blocks_of(0, [4, 6]);
    let mut contact = scene.contact(Options::new(EnergyLaw::depth(K)));
    contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0, -1.0]) }).expect("an obstacle");
    let count = contact.boundary_facets().len();
    let missing = contact.add_surface(&[0, count, 1]).expect_err("no such facet");
    assert_eq!(missing, Error::NoSuchNumber { array: "facets", entry: 1, number: [count; 2] });
    assert!(matches!(contact.add_surface(&[]), Err(Error::Unsupported { .. })));
    let low = facets(&contact, &scene, 0, |x| x[1] == 0.5 && x[0] < 0.6);
    let high = facets(&contact, &scene, 1, |x| x[1] == 0.5 && x[0] < 0.6);
    let far = facets(&contact, &scene, 1, |x| x[1] == 1.0);
    let [a, b, far] = [low, high, far].map(|own| contact.add_surface(&own).expect("a surface"));
    assert_eq!([a, b, far], [1, 2, 3]);
    let before = PairOptions::tied(0.05).between([a, b]);
    contact.set_pair_options([0, 1].map(Body), Some(before)).expect("a tie");
    let mut coords = scene.coords.clone();
    coords[scene.first_node[1]..].iter_mut().for_each(|x| x[1] -= 1e-3);
    let forces = contact.evaluate(&coords).expect("an evaluation").forces;
    let tie = contact.tie([0, 1]).expect("a tie");
    let law = |law| PairOptions { law: Some(law), ..before };
    for (partners, options) in [
        ([Body(0), Body(1)], before.between([a, 4])),
        ([Body(0), Body(1)], before.between([0, b])),
        ([Body(0), Body(1)], before.between([b, a])),
        ([Body(0), Body(1)], before.between([a, far])),
        ([Body(0), Body(1)], PairOptions::default().between([a, b])),
        ([Body(0), Body(1)], PairOptions::rough().between([a, b])),
        ([Body(0), Body(1)], law(EnergyLaw::volume(K))),
        ([Body(0), Body(1)], law(EnergyLaw::fiber(K))),
        ([Body(0), Body(1)], PairOptions { excluded: true, surfaces: None, ..before }),
        ([Body(0), Body(0)], before.between([a, a])),
        ([Body(0), Rigid(0)], before),
    ] {
        contact.set_pair_options(partners, Some(options)).expect_err("no tie");
        assert_eq!(contact.pair_options([0, 1].map(Body)), Ok(Some(before)));
        assert_eq!(contact.tie([0, 1]), Ok(tie));
        assert_eq!(contact.evaluate(&coords).expect("an evaluation").forces, forces);
    }
    contact.set_pair_options([0, 1].map(Body), None).expect("contact");
    let plain = scene.contact(Options::new(EnergyLaw::depth(K))).evaluate(&coords).expect("an evaluation").forces;
    assert_eq!(contact.evaluate(&coords).expect("an evaluation").forces, plain);
    contact.set_pair_options([1, 0].map(Body), Some(before.between([b, a]))).expect("a tie");
    assert_eq!(contact.evaluate(&coords).expect("an evaluation").forces, forces);
    // On another mesh without deformation the same facets are tied.
    let twice: Vec<_> = scene.coords.iter().map(|x| x.map(|x| 2.0 * x)).collect();
    contact.set_reference(&twice).expect("a reference");
    assert!((contact.tie([0, 1]).unwrap().unwrap().area - 1.0).abs() < 1e-12);
    contact.set_reference(&scene.coords).expect("a reference");
    assert_eq!(contact.evaluate(&coords).expect("an evaluation").forces, forces);
}

/// Left out, the pair has its tie and no contact: forces are those of the tie alone, either way, and options of contact are refused.
#[test]
fn a_pair_that_is_left_out_keeps_its_named_parts() {
    let scene = blocks_of(0, [4, 6]);
    let mut contact = half_tied(&scene);
    let parts = PairOptions { excluded: true, ..PairOptions::tied(0.05) }.between([1, 2]);
    contact.set_pair_options([0, 1].map(Body), Some(parts)).expect("a tie without contact");
    for u in [1e-3, -1e-3] {
        let mut coords = scene.coords.clone();
        coords[scene.first_node[1]..].iter_mut().for_each(|x| x[1] += u);
        let found = contact.evaluate(&coords).expect("an evaluation");
        let force: f64 = found.forces[scene.first_node[1]..].iter().map(|f| f[1]).sum();
        assert!((force + K * u * 0.5).abs() < 1e-12 * K, "{force}");
        assert_eq!((found.pairs.len(), found.volume), (1, 0.0));
    }
    for options in [
        PairOptions { friction_coefficient: Some(0.3), ..parts },
        PairOptions { gap_offset: -0.1, ..parts },
        PairOptions { surfaces: None, ..parts },
    ] {
        let error = contact.set_pair_options([0, 1].map(Body), Some(options)).expect_err("a conflict");
        assert!(matches!(error, Error::OfPair { .. }), "{error}");
    }
}

/// Gaps are those of the faces that are not tied, and friction acts there.
#[test]
fn gaps_and_friction_are_those_of_the_other_faces() {
    let scene = blocks_of(0, [4, 6]);
    let mut contact = half_tied(&scene);
    let gaps = contact.gap_constraints(&scene.coords, 0.01).expect("gaps");
    assert!(gaps.nodes.iter().all(|&node| scene.coords[node as usize][0] > 0.5 - 0.3), "{:?}", gaps.nodes);
    let rubs = PairOptions { friction_coefficient: Some(0.3), ..PairOptions::tied(0.05).between([1, 2]) };
    contact.set_pair_options([0, 1].map(Body), Some(rubs)).expect("a tie with friction beside it");
    let mut coords = scene.coords.clone();
    coords[scene.first_node[1]..].iter_mut().for_each(|x| x[1] -= 1e-6);
    contact.begin_step(&coords).expect("a step");
    let mut slid = coords.clone();
    slid[scene.first_node[1]..].iter_mut().for_each(|x| x[0] += 1e-3);
    let [still, slid] = [&coords, &slid].map(|coords| contact.evaluate(coords).expect("an evaluation").forces);
    let first = scene.first_node[1];
    let sheared: f64 = slid[first..].iter().zip(&still[first..]).map(|(slid, still)| slid[0] - still[0]).sum();
    let expected = -K * 1e-3 * 0.5 - 0.3 * K * 1e-6 * 0.5;
    assert!((sheared - expected).abs() < 1e-2 * 0.3 * K * 1e-6 * 0.5, "{sheared:e} for {expected:e}");
    let nodes = contact.nodal_contact(&coords).expect("nodes");
    let area: f64 = nodes.area.iter().sum();
    assert!((area - 1.0).abs() < 1e-4, "{area}");
}
