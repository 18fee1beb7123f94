//! The tangent is the derivative of the force.

use crate::pairs::{plane_scene, solid_scene};
use crate::scene::table::{exactly, laws, local_laws, uncorrected};
use crate::scene::{Scene, consistent_lines};
use fmc_contact::contact::{Tangent, TangentPart};
use fmc_contact::{Contact, EnergyLaw, Obstacle, Options, Pose, Shape};
use fmc_shapes::{Splitmix, ball_tet4, cuboid_hex8, cuboid_tet4, rectangle_quad4};

/// Dense columns of the tangent at some nodes, by name and by difference: the largest deviation over the largest entry.
///
/// Central differences of the force with the better of two steps: it jumps where a crossing passes an edge.
pub(crate) fn deviation<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]], size: f64, every: usize) -> f64 {
    let tangent = contact.tangent(coords, TangentPart::Full).unwrap();
    assert!(is_symmetric(&tangent));
    let touched: Vec<usize> = {
        let mut rows: Vec<usize> =
            tangent.blocks.iter().map(|b| b.row as usize).filter(|&n| n < coords.len()).collect();
        rows.dedup();
        rows
    };
    assert!(!touched.is_empty());
    let of_parts = tangent.rank_one.iter().flat_map(|p| p.vector.iter().flatten().map(|g| p.factor * g * g));
    let largest = tangent.triplets().map(|(_, _, v)| v.abs()).chain(of_parts).fold(0.0, f64::max);
    let mut worst: f64 = 0.0;
    for &node in touched.iter().step_by(every) {
        for axis in 0..D {
            let mut unit = vec![[0.0; D]; coords.len()];
            unit[node][axis] = 1.0;
            let column = tangent.product(&unit);
            let of_step = |h: f64| {
                let force = |h: f64| {
                    let mut moved = coords.to_vec();
                    moved[node][axis] += h;
                    contact.evaluate(&moved).unwrap().forces
                };
                let (plus, minus) = (force(h), force(-h));
                (0..coords.len())
                    .flat_map(|n| (0..D).map(move |i| (n, i)))
                    .map(|(n, i)| ((minus[n][i] - plus[n][i]) / (2.0 * h) - column[n][i]).abs())
                    .fold(0.0, f64::max)
            };
            worst = worst.max(of_step(1e-6 * size).min(of_step(1e-7 * size)) / largest);
        }
    }
    worst
}

fn is_symmetric<const D: usize>(tangent: &Tangent<D>) -> bool {
    let entries: std::collections::BTreeMap<(usize, usize), f64> =
        tangent.triplets().map(|(row, col, value)| ((row, col), value)).collect();
    let largest = entries.values().fold(0.0, |m: f64, v| m.max(v.abs()));
    entries.iter().all(|(&(row, col), value)| {
        entries.get(&(col, row)).is_some_and(|other| (value - other).abs() <= 1e-12 * largest)
    })
}

/// With one patch kept by a local law; `None` where there are several, whose borders these deep overlaps reach.
fn kept<const D: usize>(scene: &Scene<D>, options: Options) -> Option<Contact<D>> {
    let mut contact = scene.contact(options);
    let patches = usize::from(options.law.is_fiber());
    (contact.keep_patches(&scene.coords).unwrap() == patches).then_some(contact)
}

/// The default and the local law with a quadratic profile, for bodies of this size: those whose exact integral has an exact
/// second derivative at every depth.
fn smooth(size: f64) -> [EnergyLaw; 2] {
    let [depth, _, quadratic, _] = laws(size);
    [depth, quadratic]
}

#[test]
fn of_lines_in_2d() {
    let mut tried = 0;
    for seed in 0..12 {
        let size = [1.0, 1e-3, 1e3][seed as usize % 3];
        let scene = plane_scene(seed).mapped(|x| x.map(|x| x * size));
        for law in local_laws(size) {
            let Some(contact) = kept(&scene, uncorrected(law, 0.03 * size, seed)) else { continue };
            let found = deviation(&contact, &scene.coords, size, 1);
            assert!(found < 1e-6, "seed {seed}: {found}");
            tried += 1;
        }
    }
    assert!(tried > 6);
}

#[test]
fn of_the_exact_integral_in_2d() {
    let mut tried = 0;
    for seed in 0..12 {
        let size = [1.0, 1e-3, 1e3][seed as usize % 3];
        let scene = plane_scene(seed).mapped(|x| x.map(|x| x * size));
        for law in smooth(size) {
            let Some(contact) = kept(&scene, exactly(law)) else { continue };
            let found = deviation(&contact, &scene.coords, size, 1);
            assert!(found < 1e-6, "seed {seed}, {law:?}: {found}");
            tried += usize::from(law.is_fiber());
        }
    }
    assert!(tried > 3);
}

#[test]
fn in_3d() {
    let mut tried = 0;
    for seed in 0..3 {
        let scene = solid_scene(seed);
        if let Some(contact) = kept(&scene, uncorrected(local_laws(1.0)[seed as usize % 2], 0.07, seed)) {
            let found = deviation(&contact, &scene.coords, 1.0, 3);
            assert!(found < 1e-6, "seed {seed}, lines: {found}");
            tried += 1;
        }
        for law in smooth(1.0) {
            let Some(contact) = kept(&scene, exactly(law)) else { continue };
            let found = deviation(&contact, &scene.coords, 1.0, 3);
            assert!(found < 1e-6, "seed {seed}, {law:?}: {found}");
            tried += usize::from(law.is_fiber());
        }
    }
    assert!(tried >= 2, "only {tried} of 6 have one patch");
    let scene = Scene::of(&[
        &ball_tet4(0.5, 2, 3),
        &cuboid_tet4([-0.6, -0.6, 0.0], [0.6, 0.6, 0.5], [4; 3]).translated([0.03, 0.02, 0.4]),
    ]);
    let [depth, quadratic] = smooth(1.0);
    for options in [exactly(depth), exactly(quadratic), uncorrected(quadratic, 0.02, 1)] {
        let contact = kept(&scene, options).unwrap();
        let found = deviation(&contact, &scene.coords, 1.0, 3);
        assert!(found < 1e-6, "ball, {options:?}: {found}");
    }
}

/// Faces that are not flat pass their share on to four nodes.
#[test]
fn with_curved_faces() {
    let a = cuboid_hex8([0.0; 3], [1.0; 3], [2; 3]).jittered(0.2, 3, |_| true);
    let mut b = cuboid_hex8([0.0; 3], [0.8; 3], [2, 1, 2]).jittered(0.2, 4, |_| true);
    // Walls that lean outwards: upright ones, jittered, have their shadows within the step of the differences.
    b.coords.iter_mut().for_each(|x| *x = [0.4 + (x[0] - 0.4) * (0.7 + x[2]), 0.4 + (x[1] - 0.4) * (0.7 + x[2]), x[2]]);
    let b = b.translated([0.1, 0.12, 0.95]);
    let scene = Scene::of(&[&a, &b]);
    let [depth, quadratic] = smooth(1.0);
    for options in [exactly(depth), exactly(quadratic), uncorrected(quadratic, 0.03, 1)] {
        let contact = kept(&scene, options).unwrap();
        let found = deviation(&contact, &scene.coords, 1.0, 2);
        assert!(found < 1e-6, "{options:?}: {found}");
    }
}

/// The rows of an obstacle are the derivative of its reaction with respect to the nodes, its columns that of the forces
/// with respect to its position.
#[test]
fn of_obstacles() {
    let block = rectangle_quad4([-0.5, -0.5], [0.5, 0.5], [6, 5]).rotated(0.7).translated([0.1, 0.75]);
    let triangle =
        Shape::Polytope { points: vec![[-1.0, -1.0], [1.0, -1.0], [0.1, 0.05]], facets: vec![[0, 1], [1, 2], [2, 0]] };
    for shape in [Shape::HalfSpace, triangle] {
        let volume = EnergyLaw::Volume { stiffness: 2.0, exponent: 2.0 };
        let [depth, quadratic] = smooth(1.0);
        for options in [exactly(depth), exactly(quadratic), uncorrected(quadratic, 1e-2, 5), exactly(volume)] {
            let mut contact = Scene::of(&[&block]).contact(options);
            let at = |x: [f64; 2]| Pose::at([x[0], x[1] + 0.1]);
            contact.add_obstacle(Obstacle { shape: shape.clone(), pose: at([0.0; 2]) }).unwrap();
            assert_eq!(contact.keep_patches(&block.coords).unwrap(), usize::from(options.law.is_fiber()));
            let tangent = contact.tangent(&block.coords, TangentPart::Full).unwrap();
            let mut largest = tangent.triplets().fold(0.0, |m: f64, (_, _, v)| m.max(v.abs()));
            largest = tangent
                .rank_one
                .iter()
                .flat_map(|p| p.vector.iter().flatten().map(|g| p.factor * g * g))
                .fold(largest, f64::max);
            let count = block.coords.len();
            for axis in 0..2 {
                let h = 1e-6;
                let mut found = |h: f64| {
                    let mut x = [0.0; 2];
                    x[axis] = h;
                    contact.set_pose(0, at(x)).unwrap();
                    let found = contact.evaluate(&block.coords).unwrap();
                    let mut forces = found.forces;
                    forces.push(found.obstacles[0].force);
                    forces
                };
                let (plus, minus) = (found(h), found(-h));
                let mut unit = vec![[0.0; 2]; count + 1];
                unit[count][axis] = 1.0;
                for (node, column) in tangent.product(&unit).iter().enumerate() {
                    for i in 0..2 {
                        let slope = (minus[node][i] - plus[node][i]) / (2.0 * h);
                        assert!(
                            (slope - column[i]).abs() < 1e-6 * largest,
                            "{node} {i}: {slope} against {}",
                            column[i]
                        );
                    }
                }
            }
        }
    }
}

/// The volume law, m = 1 and 2: facets that turn, curves in which the boundaries cross, and the part of rank one.
#[test]
fn of_the_volume_law_in_2d() {
    for seed in 0..9 {
        let size = [1.0, 1e-2, 1e2][seed as usize % 3];
        let scene = plane_scene(seed).mapped(|x| x.map(|x| x * size));
        for m in [1.0, 2.0] {
            let law = EnergyLaw::Volume { stiffness: 2.0, exponent: m };
            let found = deviation(&scene.contact(exactly(law)), &scene.coords, size, 1);
            assert!(found < 1e-6, "seed {seed}, m {m}, exact: {found}");
            let lines = Options { law, ..consistent_lines(0.03 * size, seed) };
            let found = deviation(&scene.contact(lines), &scene.coords, size, 1);
            assert!(found < 1e-6, "seed {seed}, m {m}, lines: {found}");
        }
    }
}

#[test]
fn of_the_volume_law_in_3d() {
    for seed in 0..2 {
        let scene = solid_scene(seed);
        for m in [1.0, 2.0] {
            let law = EnergyLaw::Volume { stiffness: 2.0, exponent: m };
            let found = deviation(&scene.contact(exactly(law)), &scene.coords, 1.0, 3);
            assert!(found < 1e-6, "seed {seed}, m {m}, exact: {found}");
            let lines = Options { law, ..consistent_lines(0.07, seed) };
            let found = deviation(&scene.contact(lines), &scene.coords, 1.0, 3);
            assert!(found < 1e-6, "seed {seed}, m {m}, lines: {found}");
        }
    }
    let a = cuboid_hex8([0.0; 3], [1.0; 3], [2; 3]).jittered(0.2, 3, |_| true);
    let b = cuboid_hex8([0.0; 3], [0.8; 3], [2, 1, 2]).jittered(0.2, 4, |_| true);
    let scene = Scene::of(&[&a, &b.rotated([0.3, 1.0, 0.2], 0.7).translated([0.5, 0.6, 0.55])]);
    let found = deviation(&scene.contact(exactly(EnergyLaw::volume(1.0))), &scene.coords, 1.0, 2);
    assert!(found < 1e-6, "curved faces: {found}");
}

/// Without the part that can be negative no displacement finds a negative stiffness.
#[test]
fn the_semidefinite_part_is() {
    let mut random = Splitmix::new(7);
    for seed in 0..6 {
        let scene = plane_scene(seed);
        let [depth, quadratic] = smooth(1.0);
        for options in [exactly(depth), exactly(quadratic), uncorrected(quadratic, 0.01, seed)] {
            let tangent = scene.contact(options).tangent(&scene.coords, TangentPart::Semidefinite).unwrap();
            assert!(is_symmetric(&tangent));
            for _ in 0..20 {
                let u: Vec<[f64; 2]> =
                    scene.coords.iter().map(|_| [random.between(-1.0, 1.0), random.between(-1.0, 1.0)]).collect();
                let work: f64 = tangent.product(&u).iter().zip(&u).map(|(f, u)| f[0] * u[0] + f[1] * u[1]).sum();
                assert!(work >= 0.0);
            }
        }
    }
}
