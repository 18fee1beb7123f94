//! The step of explicit hosts against dense eigenvalues.

use crate::pairs::{plane_scene, solid_scene};
use crate::scene::Scene;
use crate::scene::table::{exactly, is_depth, uncorrected};
use fmc_contact::contact::TangentPart;
use fmc_contact::{EnergyLaw, Error, Obstacle, Options, Pose, Shape};
use fmc_shapes::{Splitmix, cuboid_hex8, rectangle_quad4};
use nalgebra::DMatrix;

/// 2/√λ, λ the largest eigenvalue of M^(−1/2) K M^(−1/2) on the nodes of the mesh.
fn limit<const D: usize>(
    scene: &Scene<D>,
    options: Options,
    obstacle: Option<Obstacle<D>>,
    masses: &[f64],
) -> [f64; 2] {
    let mut contact = scene.contact(options);
    obstacle.map(|obstacle| contact.add_obstacle(obstacle).unwrap());
    let tangent = contact.tangent(&scene.coords, TangentPart::Full).unwrap();
    let count = scene.coords.len();
    let mut matrix = DMatrix::zeros(count * D, count * D);
    for col in 0..count * D {
        let mut unit = vec![[0.0; D]; count];
        unit[col / D][col % D] = 1.0;
        for (row, value) in tangent.product(&unit).as_flattened().iter().enumerate() {
            matrix[(row, col)] = value / (masses[row / D] * masses[col / D]).sqrt();
        }
    }
    let largest = matrix.symmetric_eigenvalues().max();
    [contact.stable_step(&scene.coords, masses).unwrap(), 2.0 / largest.sqrt()]
}

fn check<const D: usize>(scene: &Scene<D>, options: Options, obstacle: Option<Obstacle<D>>) {
    let mut random = Splitmix::new(5);
    for range in [[1.0, 1.0], [0.1, 10.0]] {
        let masses: Vec<f64> = scene.coords.iter().map(|_| random.between(range[0], range[1])).collect();
        let [step, limit] = limit(scene, options, obstacle.clone(), &masses);
        assert!(step <= limit && step >= 0.9 * limit, "{step} against {limit}: {options:?}");
    }
}

#[test]
fn the_step_is_a_little_below_the_limit() {
    let quadratic = EnergyLaw::Volume { stiffness: 2.0, exponent: 2.0 };
    for law in [EnergyLaw::depth(3.0), EnergyLaw::fiber(3.0), quadratic] {
        for seed in 0..4 {
            let pose = Pose::at([0.3; 2]);
            check(&plane_scene(seed), exactly(law), None);
            check(&plane_scene(seed), exactly(law), Some(Obstacle { shape: Shape::HalfSpace, pose }));
            if !is_depth(&law) {
                check(&plane_scene(seed), uncorrected(law, 0.02, seed), None);
            }
        }
        check(&solid_scene(1), exactly(law), None);
    }
    // More unknowns in contact than the iteration takes steps.
    let plate = |z: f64| cuboid_hex8([0.0, 0.0, z], [1.0, 1.0, z + 0.2], [8, 8, 1]);
    let plates = Scene::of(&[&plate(0.0), &plate(0.19)]);
    check(&plates, exactly(EnergyLaw::depth(3.0)), None);
    check(&plates, exactly(EnergyLaw::fiber(3.0)), None);
}

#[test]
fn nothing_touches_or_a_mass_is_missing() {
    let scene = plane_scene(0);
    let contact = scene.contact(exactly(EnergyLaw::fiber(1.0)));
    let forces = contact.evaluate(&scene.coords).unwrap().forces;
    let touched = forces.iter().position(|force| *force != [0.0; 2]).unwrap();
    let mut masses: Vec<f64> = forces.iter().map(|force| if *force == [0.0; 2] { 0.0 } else { 1.0 }).collect();
    assert!(contact.stable_step(&scene.coords, &masses).unwrap().is_finite());
    for mass in [0.0, -1.0, f64::NAN] {
        masses[touched] = mass;
        let refused = contact.stable_step(&scene.coords, &masses);
        assert!(matches!(refused, Err(Error::NotPositiveMass { node, .. }) if node == touched), "{refused:?}");
    }
    let short = contact.stable_step(&scene.coords, &masses[1..]);
    assert!(matches!(short, Err(Error::Length { array: "masses", .. })), "{short:?}");

    let mut apart = scene.clone();
    let second = apart.nodes_of(1);
    apart.coords[second].iter_mut().for_each(|x| x[0] += 10.0);
    let step = apart.contact(exactly(EnergyLaw::fiber(1.0))).stable_step(&apart.coords, &vec![0.0; masses.len()]);
    assert_eq!(step, Ok(f64::INFINITY));
}

/// A stiffness that is found from masses costs a tenth of the bodies' own step where whole faces touch.
#[test]
fn a_stiffness_from_masses_costs_a_tenth_of_the_step() {
    // Flat cells in layers: nodes of the faces in contact have less mass for their area than those of the walls.
    [[4, 4], [2, 6], [1, 12]].into_iter().for_each(costs_a_tenth);
}

/// Of two squares of so many cells.
fn costs_a_tenth(cells: [usize; 2]) {
    let [below, above] =
        [rectangle_quad4([0.0, -1.0], [1.0, 1e-4], cells), rectangle_quad4([0.0, 0.0], [1.0, 1.0], cells)];
    let of_one = (cells[0] + 1) * (cells[1] + 1);
    let scene = Scene::of(&[&below, &above]);
    let mut contact = scene.contact(exactly(EnergyLaw::depth(0.0)));
    assert!(matches!(contact.evaluate(&scene.coords), Err(Error::NoStiffness)));
    // Lumped masses of density 1.
    let mut masses = vec![0.0; scene.coords.len()];
    let cell = 1.0 / (cells[0] * cells[1]) as f64;
    for node in 0..masses.len() {
        let [x, y] = scene.coords[node];
        let is_side = |v: f64, ends: [f64; 2]| ends.iter().any(|end| (v - end).abs() < 1e-3);
        let halves = usize::from(is_side(x, [0.0, 1.0]))
            + usize::from(is_side(y, if node < of_one { [-1.0, 0.0] } else { [0.0, 1.0] }));
        masses[node] = cell * 0.5f64.powi(halves as i32);
    }
    let limit = 0.1;
    contact.stiffness_from_masses(&scene.coords, &masses, limit).expect("a stiffness");
    let step = contact.stable_step(&scene.coords, &masses).expect("a step");
    let both = 1.0 / (1.0 / (limit * limit) + 1.0 / (step * step)).sqrt();
    assert!((0.8..0.95).contains(&(both / limit)), "{cells:?}: {}", both / limit);
    for wrong in [0.0, -1.0, f64::NAN] {
        assert!(matches!(contact.stiffness_from_masses(&scene.coords, &masses, wrong), Err(Error::NotPositive { .. })));
    }
    masses[0] = -1.0;
    let refused = contact.stiffness_from_masses(&scene.coords, &masses, limit);
    assert!(matches!(refused, Err(Error::NotPositiveMass { node: 0, .. })), "{refused:?}");
    // A given one would count.
    masses[0] = 1.0;
    contact.set_options(exactly(EnergyLaw::depth(2.0))).expect("options");
    let refused = contact.stiffness_from_masses(&scene.coords, &masses, limit);
    assert!(matches!(refused, Err(Error::Unsupported { .. })), "{refused:?}");
}
