//! The tangent against differences.

use crate::laws::{Answer, Facet, One, norm, stribeck};
use crate::scene::Scene;
use crate::{
    BODIES, DELTA, ON_PLANE, along, depth, flat_block, flat_cuboid, in_plane, in_space, on_plane, rub, waved,
    waved_across,
};
use fmc_contact::Contact;
use fmc_contact::contact::{FrictionLaw, TangentPart};

/// A limit that curves with the pressure and the slip, and another one by the way before.
fn curved() -> impl FrictionLaw {
    One(1, |facet: &Facet| -> Answer {
        let (p, s) = (facet.pressure, norm(facet.slip) / DELTA);
        let (bend, rise) = (1.0 + 0.4 * p, 1.0 - 0.2 * (-s).exp() + 0.1 * s);
        let before = 1.0 + facet.history[0];
        let limit = 0.3 * p / bend * rise * before;
        let by_pressure = 0.3 / (bend * bend) * rise * before;
        let by_slip = 0.3 * p / bend * (0.2 * (-s).exp() + 0.1) / DELTA * before;
        (limit, by_pressure, by_slip, vec![0.1 * s])
    })
}

/// Largest difference between the tangent and forces, by the largest product, along these directions, in the second step.
fn error<const D: usize>(
    contact: &mut Contact<D>,
    scene_is_of_two: bool,
    steps: [Vec<[f64; D]>; 3],
    directions: &[Vec<[f64; D]>],
) -> f64 {
    contact.set_time_step(0.01).expect("a time");
    contact.begin_step(&steps[0]).expect("a step");
    contact.commit_step(&steps[1]).expect("a step");
    let coords = &steps[2];
    let told = contact.evaluate(coords).expect("forces").friction;
    // What sticks are walls beside the contact.
    assert!(told.slip_area > 100.0 * told.stick_area, "{told:?}");
    let tangent = contact.tangent(coords, TangentPart::Full).expect("a tangent");
    let (mut worst, mut largest) = (0.0f64, 0.0f64);
    for direction in directions {
        let step = 1e-4 * DELTA;
        let at = |h: f64| {
            let one = |(x, d): (&[f64; D], &[f64; D])| std::array::from_fn(|i| x[i] + h * d[i]);
            contact.evaluate(&coords.iter().zip(direction).map(one).collect::<Vec<_>>()).expect("forces").forces
        };
        let (plus, minus) = (at(step), at(-step));
        for (node, product) in tangent.product(direction).iter().enumerate() {
            for axis in 0..D {
                // Walls that stand in a plane stick along it, and their area changes.
                if axis < D - 1 || scene_is_of_two {
                    let slope = (minus[node][axis] - plus[node][axis]) / (2.0 * step);
                    (worst, largest) = (worst.max((slope - product[axis]).abs()), largest.max(product[axis].abs()));
                }
            }
        }
    }
    worst / largest
}

/// The last body as a whole along every axis.
fn rigid<const D: usize>(scene: &Scene<D>) -> Vec<Vec<[f64; D]>> {
    let last = scene.nodes_of(scene.first_node.len() - 1);
    let one = |axis: usize| {
        let of = |node: usize| std::array::from_fn(|i| f64::from(u8::from(i == axis && last.contains(&node))));
        (0..scene.coords.len()).map(of).collect()
    };
    (0..D).map(one).collect()
}

fn any<const D: usize>(scene: &Scene<D>) -> Vec<Vec<[f64; D]>> {
    [0.3, 1.1].map(|by| waved(&vec![[0.0; D]; scene.coords.len()], by)).to_vec()
}

fn steps<const D: usize>(scene: &Scene<D>) -> [Vec<[f64; D]>; 3] {
    [0.0, 1.5, 4.0].map(|by| waved_across(&along(scene, by * DELTA), 0.05 * DELTA))
}

/// A body that moves as a whole changes no area and does not turn: the tangent is the derivative, but for what differences leave of curvature.
#[test]
fn along_rigid_motions_the_tangent_is_exact() {
    let ((scene, mut one), (_, mut other)) = (on_plane(&flat_block(), depth()), on_plane(&flat_block(), depth()));
    rub(&mut one, ON_PLANE, curved());
    rub(&mut other, ON_PLANE, stribeck([0.1, 0.2, 0.05, 0.5]));
    for contact in [&mut one, &mut other] {
        let found = error(contact, false, steps(&scene), &rigid(&scene));
        assert!(found < 1e-6, "{found:e}");
    }
    let (scene, mut contact) = on_plane(&flat_cuboid(), depth());
    rub(&mut contact, ON_PLANE, curved());
    let found = error(&mut contact, false, steps(&scene), &rigid(&scene)[..2]);
    assert!(found < 1e-6, "{found:e}");
}

/// Else as of the library's own friction: the tangent leaves out that points move over facets of 0.3, by penetration / size.
#[test]
fn along_all_other_motions_it_is_that_of_friction() {
    let most = 2.0 * DELTA / 0.3;
    let mut contact = in_plane().contact(depth());
    rub(&mut contact, BODIES, curved());
    let found = error(&mut contact, true, steps(&in_plane()), &any(&in_plane()));
    assert!(found < most, "{found:e} of {most:e}");
    let mut contact = in_space().contact(depth());
    rub(&mut contact, BODIES, curved());
    let found = error(&mut contact, true, steps(&in_space()), &any(&in_space()));
    assert!(found < most, "{found:e} of {most:e}");
}

/// Frozen at the same place the forces are the same, and the tangent is symmetric.
#[test]
fn frozen_friction_has_the_limits_of_where_it_was_frozen() {
    let scene = in_space();
    let mut contact = scene.contact(depth());
    rub(&mut contact, BODIES, curved());
    let [start, first, last] = steps(&scene);
    contact.begin_step(&start).expect("a step");
    contact.commit_step(&first).expect("a step");
    let free = contact.evaluate(&last).expect("forces").forces;
    contact.freeze_friction(&last).expect("frozen");
    let frozen = contact.evaluate(&last).expect("forces").forces;
    let size = free.as_flattened().iter().fold(0.0, |most: f64, f| most.max(f.abs()));
    let off =
        free.as_flattened().iter().zip(frozen.as_flattened()).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
    assert!(off < 1e-12 * size, "{off:e} of {size:e}");
    let tangent = contact.tangent(&last, TangentPart::Full).expect("a tangent");
    let [x, y] = [0, 1].map(|at| any(&scene)[at].clone());
    let dot = |a: &[[f64; 3]], b: &[[f64; 3]]| -> f64 {
        a.as_flattened().iter().zip(b.as_flattened()).map(|(a, b)| a * b).sum()
    };
    let (one, other) = (dot(&tangent.product(&x), &y), dot(&tangent.product(&y), &x));
    assert!((one - other).abs() < 1e-12 * dot(&tangent.product(&x), &x), "{one} {other}");
}
