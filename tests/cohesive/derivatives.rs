//! Forces are the derivative of the energy, tangents that of the forces, and no rigid motion has any.

use crate::scene::Scene;
use crate::{held, in_space, in_the_plane, largest, law};
use fmc_contact::Contact;
use fmc_contact::contact::{Cohesive, Ppr, Softening, TangentPart};
use fmc_shapes::random_rotation;

fn field<const D: usize>(coords: &[[f64; D]], seed: f64) -> Vec<[f64; D]> {
    let wave = |node: usize, axis: usize| (seed + 1.7 * node as f64 + 2.9 * axis as f64).sin();
    (0..coords.len()).map(|node| std::array::from_fn(|axis| wave(node, axis))).collect()
}

fn plus<const D: usize>(coords: &[[f64; D]], by: f64, step: &[[f64; D]]) -> Vec<[f64; D]> {
    coords.iter().zip(step).map(|(x, d)| std::array::from_fn(|axis| x[axis] + by * d[axis])).collect()
}

fn dot<const D: usize>(a: &[[f64; D]], b: &[[f64; D]]) -> f64 {
    a.iter().flatten().zip(b.iter().flatten()).map(|(a, b)| a * b).sum()
}

fn turned<const D: usize>(coords: &[[f64; D]]) -> Vec<[f64; D]> {
    let turn = random_rotation::<D>(5);
    let one =
        |x: &[f64; D]| -> [f64; D] { std::array::from_fn(|i| 2.0 + (0..D).map(|j| turn[i][j] * x[j]).sum::<f64>()) };
    coords.iter().map(one).collect()
}

/// Rounding of coordinates of 3 by a stiffness of 2e3; a damaged interface turns with its forces.
fn rests<const D: usize>(scenes: &[Scene<D>], softening: Softening) {
    for scene in scenes {
        let mut contact = held(scene, Cohesive { softening, reach: 0.1, ..law() });
        let around = |coords: &[[f64; D]]| contact.evaluate(coords).expect("an evaluation");
        for coords in [&scene.coords, &turned(&scene.coords)] {
            let found = around(coords);
            assert!(largest(&found.forces) < 1e-11 && found.energy < 1e-24, "{:e}", largest(&found.forces));
        }
        let strained = plus(&scene.coords, 0.01, &field(&scene.coords, 0.3));
        contact.begin_step(&scene.coords).expect("a step");
        contact.commit_step(&strained).expect("a step");
        let (here, there) = (contact.evaluate(&strained), contact.evaluate(&turned(&strained)));
        let (here, there) = (here.expect("an evaluation"), there.expect("an evaluation"));
        assert!((here.energy - there.energy).abs() < 1e-10 * here.energy);
        let size = |x: &[f64; D]| x.iter().map(|x| x * x).sum::<f64>().sqrt();
        for (a, b) in here.forces.iter().zip(&there.forces) {
            assert!((size(a) - size(b)).abs() < 1e-9);
        }
    }
}

#[test]
fn no_rigid_motion_strains_an_interface() {
    for softening in [Softening::Linear, Softening::Exponential] {
        for gap in [0.0, 0.03, -0.03] {
            rests(&in_the_plane(gap), softening);
            rests(&in_space(gap), softening);
        }
    }
}

/// What is known of the energy: in a step in which damage stays, or grows with the same energy of fracture in both modes, it is that of the
/// forces; else forces are its derivative at the damage there is.
fn differences<const D: usize>(scene: &Scene<D>, contact: &Contact<D>, by: f64, has_energy: bool) {
    let (coords, step) = (plus(&scene.coords, by, &field(&scene.coords, 0.3)), field(&scene.coords, 4.1));
    let (found, tangent) = contact.evaluate_tangent(&coords, TangentPart::Full).expect("an evaluation");
    let force = found.forces.iter().flatten().map(|f| f.abs()).sum::<f64>();
    let sums = (0..D).map(|axis| found.forces.iter().map(|f| f[axis]).sum::<f64>().abs());
    assert!(sums.fold(0.0, f64::max) < 1e-13 * force.max(1.0));
    let moment = |i: usize, j: usize| {
        coords.iter().zip(&found.forces).map(|(x, f)| x[i] * f[j] - x[j] * f[i]).sum::<f64>().abs()
    };
    assert!((1..D).all(|j| (0..j).all(|i| moment(i, j) < 1e-13 * force.max(1.0))));
    // Damage begins over 1e-3: a step of 1e-7 leaves (1e-4)² of curvature, and rounding of 1e-16 by 1e-7.
    let h = 1e-7;
    let [more, less] = [h, -h].map(|by| contact.evaluate(&plus(&coords, by, &step)).expect("an evaluation"));
    if has_energy {
        let slope = (more.energy - less.energy) / (2.0 * h);
        assert!((slope + dot(&found.forces, &step)).abs() < 1e-6 * force, "{slope} {}", dot(&found.forces, &step));
    }
    let product = tangent.product(&step);
    let change: Vec<_> = plus(&more.forces, -1.0, &less.forces).iter().map(|f| f.map(|f| -f / (2.0 * h))).collect();
    let off = largest(&plus(&product, -1.0, &change));
    assert!(off < 1e-5 * largest(&product), "{off:e} of {:e}", largest(&product));
    let other = field(&scene.coords, 7.7);
    let symmetric = contact.tangent(&coords, TangentPart::Symmetric).expect("a tangent");
    let (ab, ba) = (dot(&other, &symmetric.product(&step)), dot(&step, &symmetric.product(&other)));
    assert!((ab - ba).abs() < 1e-12 * largest(&product) * other.len() as f64);
    let both = 0.5 * (dot(&other, &product) + dot(&step, &tangent.product(&other)));
    assert!((both - ab).abs() < 1e-12 * largest(&product) * other.len() as f64);
    let secant = contact.tangent(&coords, TangentPart::Semidefinite).expect("a tangent");
    for seed in 0..5 {
        let d = field(&scene.coords, f64::from(seed));
        assert!(dot(&d, &secant.product(&d)) >= 0.0);
    }
}

/// Whole, while damage grows, and after unloading; on meshes of all kinds, with gaps.
fn derivatives<const D: usize>(scenes: &[Scene<D>], law: Cohesive) {
    let is_alike = law.normal_energy == law.shear_energy;
    for scene in scenes {
        let mut contact = held(scene, Cohesive { reach: 0.1, ..law });
        differences(scene, &contact, 2e-4, true);
        differences(scene, &contact, 0.02, is_alike);
        contact.begin_step(&scene.coords).expect("a step");
        contact.commit_step(&plus(&scene.coords, 0.02, &field(&scene.coords, 0.3))).expect("a step");
        differences(scene, &contact, 0.01, true);
        differences(scene, &contact, 0.025, is_alike);
    }
}

/// With the same energy in both modes no traction ends before the other: there is one potential where openings grow from nothing, and one below the
/// largest openings. After a step some grow, and some do not.
#[test]
fn forces_and_tangents_of_the_potential_against_differences() {
    fn of<const D: usize>(scenes: &[Scene<D>], ppr: Cohesive) {
        let is_alike = ppr.normal_energy == ppr.shear_energy;
        for scene in scenes {
            let mut contact = held(scene, ppr);
            differences(scene, &contact, 2e-4, is_alike);
            differences(scene, &contact, 0.02, is_alike);
            contact.begin_step(&scene.coords).expect("a step");
            contact.commit_step(&plus(&scene.coords, 0.02, &field(&scene.coords, 0.3))).expect("a step");
            differences(scene, &contact, 0.01, true);
            differences(scene, &contact, 0.025, false);
            contact.commit_step(&plus(&scene.coords, 0.02, &field(&scene.coords, 1.9))).expect("a step");
            differences(scene, &contact, 0.025, false);
        }
    }
    let softening = Softening::Ppr(Ppr { normal_shape: 3.0, shear_shape: 2.0, normal_slope: 0.2, shear_slope: 0.3 });
    for cohesive in [law(), Cohesive { shear_strength: 3.0, ..Cohesive::new(2.0, 0.2) }] {
        for gap in [0.0, 0.03] {
            of(&in_the_plane(gap), Cohesive { softening, reach: 0.1, ..cohesive });
            of(&in_space(gap), Cohesive { softening, reach: 0.1, ..cohesive });
        }
    }
}

#[test]
fn forces_and_tangents_against_differences() {
    for softening in [Softening::Linear, Softening::Exponential] {
        for cohesive in [law(), Cohesive { shear_strength: 3.0, ..Cohesive::new(2.0, 0.1) }] {
            let cohesive = Cohesive { softening, ..cohesive };
            for gap in [0.0, 0.03] {
                derivatives(&in_the_plane(gap), cohesive);
                derivatives(&in_space(gap), cohesive);
            }
        }
    }
}
