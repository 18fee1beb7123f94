//! One rigid mesh led past the other: neither energy nor force may step.

use crate::depth;
use crate::scene::Scene;
use fmc_shapes::{Diagonals, Mesh, cuboid_tet4, rectangle_tri3};

/// Positions of a scan.
const POSITIONS: usize = 400;

/// Largest energy step beyond the work of the force, in parts of the largest energy.
fn energy_step<const D: usize>(scene: &Scene<D>, positions: usize, place: impl Fn(f64) -> [f64; D]) -> f64 {
    let contact = scene.contact(depth(1e3));
    let at = |s: f64| {
        let shift = place(s);
        let mut coords = scene.coords.clone();
        scene.nodes_of(1).for_each(|n| coords[n].iter_mut().zip(shift).for_each(|(x, d)| *x += d));
        let found = contact.evaluate(&coords).expect("valid coordinates");
        (found.energy, found.bodies[1].force, shift)
    };
    let found: Vec<_> = (0..=positions).map(|n| at(n as f64 / positions as f64)).collect();
    let largest = found.iter().fold(0.0f64, |m, (energy, _, _)| m.max(*energy));
    let step = |pair: &[(f64, [f64; D], [f64; D])]| {
        let [(e, f, x), (e1, f1, x1)] = pair else { return 0.0 };
        let work: f64 = (0..D).map(|i| 0.5 * (f[i] + f1[i]) * (x1[i] - x[i])).sum();
        (e1 - e + work).abs()
    };
    assert!(largest > 0.0);
    found.windows(2).map(step).fold(0.0, f64::max) / largest
}

/// The step at all positions and at a quarter of them: it falls as the square of the distance, or is rounding.
fn check<const D: usize>(name: &str, scene: &Scene<D>, place: impl Fn(f64) -> [f64; D] + Copy) {
    let (fine, coarse) = (energy_step(scene, POSITIONS, place), energy_step(scene, POSITIONS / 4, place));
    println!("{name}: {fine:.1e} at {POSITIONS} positions, {coarse:.1e} at a quarter");
    assert!(fine <= 5e-4, "{name}: {fine}");
    assert!(fine <= 0.25 * coarse + 1e-10, "{name}: {fine} against {coarse}");
}

fn turned<const D: usize>(mesh: Mesh<D>, degrees: f64) -> Mesh<D> {
    let (s, c) = degrees.to_radians().sin_cos();
    mesh.mapped(|mut x| {
        (x[0], x[D - 1]) = (c * x[0] - s * x[D - 1], s * x[0] + c * x[D - 1]);
        x
    })
}

fn scans<const D: usize>(lower: &Mesh<D>, upper: &Mesh<D>) {
    // The lower block is 2 wide and 1 deep, its upper face at 0; the upper one 0.5 wide, its lower corner or face at 0.
    let along = |x: f64, z: f64| -> [f64; D] {
        std::array::from_fn(|i| {
            if i == 0 {
                x
            } else if i + 1 == D {
                z
            } else {
                0.3
            }
        })
    };
    for degrees in [45.0, 30.0] {
        let scene = Scene::of(&[lower, &turned(upper.clone(), degrees)]);
        check(&format!("corner at {degrees} in"), &scene, |s| along(0.903, 0.05 - 0.2 * s));
    }
    let tilted = Scene::of(&[lower, &turned(upper.clone(), 30.0)]);
    check("corner along the face", &tilted, |s| along(0.6 + 0.6 * s, -0.1));
    check("corner over the edge", &tilted, |s| along(1.6 + 0.7 * s, -0.1));
    let upright = Scene::of(&[lower, upper]);
    check("face on face, past side walls", &upright, |s| along(1.2 + 0.9 * s, -0.1));
    check("down the side", &upright, |s| along(1.9, 0.1 - 1.0 * s));
    let leaning = Scene::of(&[lower, &turned(upper.clone(), 2.0)]);
    check("turned by 2 degrees, to its full depth", &leaning, |s| along(0.71, 0.05 - 0.6 * s));
}

#[test]
fn in_the_plane() {
    let lower = rectangle_tri3([0.0, -1.0], [2.0, 0.0], [9, 5], Diagonals::Alternating);
    let upper = rectangle_tri3([0.0, 0.0], [0.5, 0.5], [3, 3], Diagonals::Same);
    scans(&lower, &upper);
}

#[test]
fn in_space() {
    let lower = cuboid_tet4([0.0, 0.0, -1.0], [2.0, 1.0, 0.0], [6, 3, 3]);
    let upper = cuboid_tet4([0.0, 0.0, 0.0], [0.5, 0.5, 0.5], [2, 2, 2]);
    scans(&lower, &upper);
}

/// A block that slides over the face of a larger one feels no force along it, wherever its nodes are; but within a
/// cell of the walls of that one the depth is interpolated, and T / N is some 1e-4.
fn slides<const D: usize>(lower: &Mesh<D>, upper: &Mesh<D>) {
    let scene = Scene::of(&[lower, upper]);
    let contact = scene.contact(depth(1e3));
    for n in 0..40 {
        let mut coords = scene.coords.clone();
        for node in scene.nodes_of(1) {
            coords[node][0] += 0.35 + 0.02 * f64::from(n);
            coords[node][D - 1] -= 2e-3;
            if D == 3 {
                coords[node][1] += 0.2;
            }
        }
        let force = contact.evaluate(&coords).expect("valid coordinates").bodies[1].force;
        let normal = force[D - 1];
        assert!(normal > 0.0);
        assert!(force[..D - 1].iter().all(|tangential| tangential.abs() < 1e-9 * normal), "{n}: {force:?}");
    }
}

#[test]
fn no_force_along_a_face() {
    let lower = rectangle_tri3([0.0, -1.0], [2.0, 0.0], [9, 5], Diagonals::Alternating);
    slides(&lower, &rectangle_tri3([0.0, 0.0], [0.5, 0.5], [3, 3], Diagonals::Same));
    let lower = cuboid_tet4([0.0, -1.0, -1.0], [2.0, 1.5, 0.0], [6, 8, 3]);
    slides(&lower, &cuboid_tet4([0.0, 0.0, 0.0], [0.5, 0.5, 0.5], [2, 2, 2]));
}
