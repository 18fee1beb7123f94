//! The fiber law: energy taken line by line, along the normal of the contact.

use crate::pairs::{plane_scene, solid_scene};
use crate::scene::energy_gradient::Differences;
use crate::scene::table::{by_laws, differentiable, exactly, is_one_patch, is_quadrature, local_laws, uncorrected};
use crate::scene::{Scene, by_lines, distance, exact, fibers, norm, size_sum};
use crate::tangent::deviation;
use fmc_contact::{Contact, EnergyLaw, Error, Estimator, FiberOptions, FiberPattern, Obstacle, Options, Pose, Shape};
use fmc_shapes::{Diagonals, ball_tet4, cuboid_hex8, cuboid_tet4, rectangle_quad4, rectangle_tri3};
use std::f64::consts::PI;

/// The steps of `energy_gradient`.
const STEPS: [f64; 2] = [1e-6, 2e-7];

/// Whether it could be tried: the energy has a step where contact reaches a sharp edge between two patches, as these deep
/// overlaps do where there are two.
fn force_is_energy_gradient<const D: usize>(scene: &Scene<D>, options: Options, size: f64) -> bool {
    let mut contact = scene.contact(options);
    if contact.keep_patches(&scene.coords).unwrap() > 1 {
        return false;
    }
    let differences = Differences { steps: &STEPS.map(|h| h * size), tolerance: 1e-6, loaded: 1, others: 7 };
    differences.check(&contact, &scene.coords);
    true
}

#[test]
fn force_is_energy_gradient_in_2d() {
    let mut tried = 0;
    for seed in 0..9 {
        let size = [1.0, 1e-3, 1e3][seed as usize % 3];
        let scene = plane_scene(seed).mapped(|x| x.map(|x| x * size));
        for options in differentiable(&local_laws(size), 0.03 * size, seed) {
            tried += usize::from(force_is_energy_gradient(&scene, options, size));
        }
    }
    assert!(tried >= 12, "only {tried} of 27 have one patch");
}

#[test]
fn force_is_energy_gradient_in_3d() {
    let mut tried = 0;
    for seed in 0..4 {
        let size = [1.0, 1e-3][seed as usize % 2];
        let scene = solid_scene(seed).mapped(|x| x.map(|x| x * size));
        let law = local_laws(size)[seed as usize % 2];
        for options in differentiable(&[law], 0.07 * size, seed) {
            tried += usize::from(force_is_energy_gradient(&scene, options, size));
        }
    }
    assert!(tried >= 3, "only {tried} of 6 have one patch");
}

/// Blocks whose warped side walls lie in the overlap, seen nearly edge-on and folded: lines beside an inner edge of the
/// wall have two spans, past it one.
#[test]
fn walls_in_the_overlap_are_felt() {
    let mut tried = 0;
    for seed in 0..6 {
        let block = |z: f64, seed: u64| {
            let [low, high] = [z, z + 1.0];
            let block = match seed % 2 {
                0 => cuboid_hex8([0.0, 0.0, low], [1.0, 1.0, high], [1 + (seed % 3) as usize; 3]),
                _ => cuboid_tet4([0.0, 0.0, low], [1.0, 1.0, high], [1 + (seed % 3) as usize; 3]),
            };
            block.jittered(0.12, seed, |_| true)
        };
        let scene = Scene::of(&[&block(0.0, seed), &block(0.9, seed + 100)]);
        let options = exactly(EnergyLaw::fiber(3.0));
        tried += usize::from(force_is_energy_gradient(&scene, options, 1.0));
        let mut contact = scene.contact(options);
        if contact.keep_patches(&scene.coords).unwrap() == 1 {
            let found = deviation(&contact, &scene.coords, 1.0, 7);
            assert!(found < 1e-6, "seed {seed}: {found:.1e}");
        }
        let found = scene.evaluate(options);
        let size = found.forces.iter().flatten().fold(0.0, |m: f64, f| m.max(f.abs()));
        let sum: f64 = (0..3).map(|i| (found.bodies[0].force[i] + found.bodies[1].force[i]).abs()).sum();
        // Facets at 1e-3 of edge-on make rounding a thousand times larger.
        assert!(sum < 1e-10 * size, "seed {seed}: {sum:.1e} of {size}");
    }
    assert!(tried >= 3, "only {tried} of 6 have one patch");
}

/// A flat patch: pressure k δ, whatever the meshes and however the pair is turned.
#[test]
fn flat_patches_have_uniform_pressure() {
    let (k, depth) = (7.0, 1e-3);
    for angle in [0.0, 0.3, 1.2, 2.9] {
        let lower = rectangle_tri3([0.0, 0.0], [1.0, 1.0], [7, 3], Diagonals::Alternating);
        let upper = rectangle_quad4([-0.2, 1.0 - depth], [1.3, 2.0], [5, 2]);
        let scene = Scene::of(&[&lower.rotated(angle), &upper.rotated(angle)]);
        for options in [exactly(EnergyLaw::fiber(k)), uncorrected(EnergyLaw::fiber(k), 1e-3, 1)] {
            let contact = scene.evaluate(options);
            // Lines that leave through a side wall are shortened over a width of the depth times the tilt of the
            // direction, which is rounded to 1/1024; and a sampled width is known to one line.
            let tolerance = if options.estimator == Estimator::Exact { 1e-5 } else { 2e-3 };
            assert!((contact.energy / (0.5 * k * depth * depth) - 1.0).abs() < tolerance, "{}", contact.energy);
            let force = contact.bodies[1].force;
            let expected = [-k * depth * angle.sin(), k * depth * angle.cos()];
            assert!(distance(&[force], &[expected]) < tolerance * k * depth, "{force:?} against {expected:?}");
            assert!((contact.penetration / depth - 1.0).abs() < 1e-5);
        }
    }
}

/// In 3D too, where the walls of upright blocks are seen edge-on.
#[test]
fn flat_patches_of_blocks() {
    let (k, depth) = (7.0, 1e-3);
    let lower = cuboid_tet4([0.0; 3], [1.0; 3], [3, 2, 2]);
    let upper = cuboid_hex8([-0.2, 0.1, 1.0 - depth], [0.7, 1.3, 2.0], [2, 3, 1]);
    for turn in [0.0, 0.4] {
        let scene =
            Scene::of(&[&lower.clone().rotated([1.0, 2.0, 0.5], turn), &upper.clone().rotated([1.0, 2.0, 0.5], turn)]);
        for options in [exactly(EnergyLaw::fiber(k)), uncorrected(EnergyLaw::fiber(k), 3e-3, 1)] {
            let contact = scene.evaluate(options);
            let force = norm(&[contact.bodies[1].force]);
            // As in 2D; a sampled area of 0.7 by 0.9 is known to some lines of its rim.
            let tolerance = if options.estimator == Estimator::Exact { 1e-5 } else { 5e-3 };
            assert!((force / (k * depth * 0.63) - 1.0).abs() < tolerance, "{force}");
        }
    }
}

/// A tip of 45° flanks into a half-space: ∫ ½ k L² = k h³/3, and its derivative in the depth h.
#[test]
fn wedge_on_a_plane() {
    let (k, h) = (5.0, 0.2);
    let wedge =
        rectangle_quad4([-0.5, -0.5], [0.5, 0.5], [6, 5]).rotated(PI / 4.0).translated([0.1, 0.5f64.sqrt() - h]);
    for estimator in [exactly(EnergyLaw::fiber(k)), uncorrected(EnergyLaw::fiber(k), 1e-3, 1)] {
        let mut contact = Scene::of(&[&wedge]).contact(estimator);
        contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0; 2]) }).unwrap();
        let found = contact.evaluate(&wedge.coords).unwrap();
        // The direction comes from sampled normals and is rounded to 1/1024: second order in the tilt.
        let tolerance = if estimator.estimator == Estimator::Exact { 2e-6 } else { 1e-4 };
        assert!((found.energy / (k * h.powi(3) / 3.0) - 1.0).abs() < tolerance, "{}", found.energy);
        assert!((found.bodies[0].force[1] / (k * h * h) - 1.0).abs() < tolerance, "{:?}", found.bodies[0]);
        assert!((found.obstacles[0].force[1] + found.bodies[0].force[1]).abs() < tolerance * k * h * h);
    }
}

/// A rigid ball into a block: w = π k (h⁴/4 + (R − h) h³/3) and F = dw/dh; both are smooth shapes, so no mesh error.
#[test]
fn ball_into_a_block() {
    let (k, radius, h) = (3.0, 0.5, 0.1);
    let block = cuboid_hex8([-0.7, -0.6, -0.5], [0.6, 0.7, 0.0], [5, 4, 2]);
    let mut contact = Scene::of(&[&block]).contact(uncorrected(EnergyLaw::fiber(k), 2.5e-3, 3));
    let pose = Pose::at([0.01, 0.02, radius - h]);
    contact.add_obstacle(Obstacle { shape: Shape::Ball { radius }, pose }).unwrap();
    let found = contact.evaluate(&block.coords).unwrap();
    let energy = PI * k * (h.powi(4) / 4.0 + (radius - h) * h.powi(3) / 3.0);
    let force = PI * k * (h.powi(3) * 2.0 / 3.0 + (radius - h) * h * h);
    // Some 25 000 lines in the disc of contact: the error of a lattice falls like N^-3/4.
    assert!((found.energy / energy - 1.0).abs() < 1e-3, "{} against {energy}", found.energy);
    assert!((found.obstacles[0].force[2] / force - 1.0).abs() < 1e-3, "{:?} against {force}", found.obstacles[0]);
}

/// Sampled lines tend to the exact integral, nodal force by nodal force.
#[test]
fn lines_tend_to_the_exact_integral() {
    let law = EnergyLaw::fiber(1.0);
    let solid = Scene::of(&[
        &ball_tet4(0.5, 2, 3),
        &cuboid_tet4([-0.6, -0.6, 0.0], [0.6, 0.6, 0.5], [4; 3]).translated([0.03, 0.02, 0.4]),
    ]);
    // Four times finer: the error falls like the spacing in 2D, and like its 3/2nd power in 3D (N^-3/4), bar chance.
    let scenes: Vec<_> = (0..12).map(plane_scene).filter(|scene| patch_count(scene) == 1).collect();
    let mean = |spacing| scenes.iter().map(|s| error(s, law, spacing)).sum::<f64>() / scenes.len() as f64;
    let errors = [1e-2, 2.5e-3].map(mean);
    assert!(scenes.len() > 3 && errors[0] < 1e-1 && errors[1] < 0.4 * errors[0], "{errors:?}");
    let errors = [2e-2, 5e-3].map(|spacing| error(&solid, law, spacing));
    assert!(errors[0] < 5e-3 && errors[1] < 1e-3, "{errors:?}");
}

fn patch_count<const D: usize>(scene: &Scene<D>) -> usize {
    scene.contact(exactly(EnergyLaw::fiber(1.0))).keep_patches(&scene.coords).unwrap()
}

/// Relative difference of all nodal forces, sampled against exact.
fn error<const D: usize>(scene: &Scene<D>, law: EnergyLaw, spacing: f64) -> f64 {
    let [sampled, exact] = [uncorrected(law, spacing, 0), exactly(law)].map(|options| scene.evaluate(options).forces);
    distance(&sampled, &exact) / norm(&exact)
}

/// Two tips of one body in a corner: two patches, each with a direction of its own, and nothing counted twice.
#[test]
fn patches_have_their_own_directions() {
    let (k, depth) = (2.0, 0.01);
    let floor = rectangle_quad4([0.0, -1.0], [2.0, 0.0], [8, 3]);
    let mut corner = floor.clone();
    corner.append(&rectangle_quad4([-1.0, -1.0], [0.0, 2.0], [4, 12]));
    let corner = corner.welded(1e-9);
    let block = rectangle_quad4([-depth, -depth], [1.0, 1.0], [5, 5]);
    // Cut the corner off, so that the two faces do not share a patch.
    let mut block = block;
    for x in &mut block.coords {
        if x[0] < 0.1 && x[1] < 0.1 {
            *x = [0.05, 0.05];
        }
    }
    let scene = Scene::of(&[&corner, &block]);
    let mut contact = scene.contact(exactly(EnergyLaw::fiber(k)));
    assert_eq!(contact.keep_patches(&scene.coords).unwrap(), 2);
    let forces = contact.evaluate(&scene.coords).unwrap();
    let expected = k * depth;
    let force = forces.bodies[1].force;
    // The bevelled corner leaves some 0.82 of the faces in contact; both sides alike, and balanced.
    assert!((force[0] / force[1] - 1.0).abs() < 1e-6 && force[0] > 0.75 * expected && force[0] < expected, "{force:?}");
    let sum: f64 = (0..2).map(|i| (forces.bodies[0].force[i] + force[i]).abs()).sum();
    assert!(sum < 1e-12 * expected);
}

/// Two squares that overlap by an upright strip at their sides push one another sideways, not up and down.
#[test]
fn strips_are_left_across() {
    let square = |x: f64, y: f64| rectangle_quad4([x, y], [x + 1.0, y + 1.0], [1, 1]);
    let scene = Scene::of(&[&square(0.0, 0.0), &square(0.9, -0.2)]);
    for options in [exactly(EnergyLaw::fiber(1e4)), by_lines(EnergyLaw::fiber(1e4))] {
        let contact = scene.evaluate(options);
        let force = contact.bodies[1].force;
        // 1e4 times the depth of 0.1, over the height of 0.8.
        assert!((force[0] - 800.0).abs() < 2.0 && force[1].abs() < 2.0, "{force:?}");
    }
}

/// Exact integration is invariant under translation: ΣF = 0 without correction; lines are corrected.
#[test]
fn forces_balance() {
    let mut tried = 0;
    for seed in 0..12 {
        let scene = plane_scene(seed);
        for options in by_laws([exact(), fibers(FiberOptions::default())], &local_laws(1.0)) {
            if is_quadrature(&options) || options.estimator == Estimator::Exact && !is_one_patch(&scene, options) {
                continue;
            }
            let contact = scene.evaluate(options);
            let sum: [f64; 2] = std::array::from_fn(|i| contact.forces.iter().map(|f| f[i]).sum());
            assert!(norm(&[sum]) < 1e-12 * size_sum(&contact.forces), "seed {seed}, {options:?}: {sum:?}");
            tried += usize::from(options.estimator == Estimator::Exact);
        }
    }
    assert!(tried >= 4, "only {tried} of 12 have one patch");
}

#[test]
fn isotropic_fibers_are_refused() {
    let pattern = FiberPattern::Isotropic { length: None };
    let estimator = Estimator::Fibers(FiberOptions { pattern, ..FiberOptions::default() });
    let options = Options { estimator, ..Options::new(EnergyLaw::fiber(1.0)) };
    let refused = Contact::new(plane_scene(0).surface(), options).err();
    assert!(matches!(refused, Some(Error::Unsupported { .. })));
}

/// Lines that are shown are those from which forces come.
#[test]
fn lines_of_local_laws_are_those_that_are_shown() {
    let scene = Scene::of(&[
        &rectangle_tri3([-1.0, -1.0], [1.0, 0.0], [4, 2], Diagonals::Same),
        &rectangle_tri3([-0.5, -0.01], [0.5, 1.0], [3, 3], Diagonals::Same),
    ]);
    let contact = scene.contact(uncorrected(EnergyLaw::fiber(1.0), 0.01, 1));
    let traces = contact.trace(&scene.coords).unwrap();
    let found = contact.evaluate(&scene.coords).unwrap();
    assert_eq!(traces.iter().map(|t| t.crossings.len()).sum::<usize>(), found.crossing_count);
    // All of them upright, along the normal of the contact.
    assert!(traces.iter().all(|t| (t.end[0] - t.start[0]).abs() < 1e-3 * (t.end[1] - t.start[1]).abs()));
}
