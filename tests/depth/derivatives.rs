//! Force and tangent against differences, and the balance of forces, on meshes that were moved at random.

use crate::depth;
use crate::scene::{Scene, cross, norm, size_sum};
use fmc_contact::Contact;
use fmc_contact::contact::TangentPart;
use fmc_shapes::{Diagonals, Mesh, Splitmix, cuboid_hex8, cuboid_tet4, rectangle_quad4, rectangle_tri3};

/// Two blocks that were disturbed after their depths had been found, at random places.
fn scene<const D: usize>(meshes: [&Mesh<D>; 2], seed: u64) -> (Scene<D>, Vec<[f64; D]>) {
    let scene = Scene::of(&meshes);
    let mut random = Splitmix::new(seed);
    let mut coords = scene.coords.clone();
    let shift: [f64; D] =
        std::array::from_fn(|i| if i + 1 == D { random.between(-0.5, -0.2) } else { random.between(-0.4, 0.4) });
    let turn = random.between(-0.5, 0.5);
    for node in scene.nodes_of(1) {
        let x = &mut coords[node];
        (x[0], x[D - 1]) = (x[0] * turn.cos() - x[D - 1] * turn.sin(), x[0] * turn.sin() + x[D - 1] * turn.cos());
        x.iter_mut().zip(shift).for_each(|(x, s)| *x += s);
    }
    coords.iter_mut().flatten().for_each(|x| *x += random.between(-0.02, 0.02));
    (scene, coords)
}

fn pairs<const D: usize>(lower: &[Mesh<D>], upper: &[Mesh<D>], mut visit: impl FnMut(Contact<D>, Vec<[f64; D]>)) {
    for (seed, (lower, upper)) in lower.iter().zip(upper).enumerate() {
        let (scene, coords) = scene([lower, upper], seed as u64);
        visit(scene.contact(depth(30.0)), coords);
    }
}

pub(crate) fn in_plane(visit: impl FnMut(Contact<2>, Vec<[f64; 2]>)) {
    let below = ([0.0, -1.0], [1.5, 0.0]);
    let above = ([0.3, 0.0], [1.3, 0.8]);
    let lower = [
        rectangle_tri3(below.0, below.1, [5, 3], Diagonals::Alternating),
        rectangle_quad4(below.0, below.1, [4, 3]),
        rectangle_quad4(below.0, below.1, [5, 2]),
        rectangle_tri3(below.0, below.1, [3, 3], Diagonals::Same),
    ];
    let upper = [
        rectangle_tri3(above.0, above.1, [3, 3], Diagonals::Same),
        rectangle_tri3(above.0, above.1, [4, 2], Diagonals::Alternating),
        rectangle_quad4(above.0, above.1, [2, 1]),
        rectangle_tri3(above.0, above.1, [1, 1], Diagonals::Same),
    ];
    pairs(&lower, &upper, visit);
}

pub(crate) fn in_space(visit: impl FnMut(Contact<3>, Vec<[f64; 3]>)) {
    let below = ([0.0, 0.0, -1.0], [1.5, 1.2, 0.0]);
    let above = ([0.3, 0.1, 0.0], [1.3, 1.0, 0.8]);
    let lower = [
        cuboid_tet4(below.0, below.1, [3, 2, 2]),
        cuboid_hex8(below.0, below.1, [3, 2, 2]),
        cuboid_hex8(below.0, below.1, [2, 2, 3]),
    ];
    let upper = [
        cuboid_tet4(above.0, above.1, [2, 2, 2]),
        cuboid_tet4(above.0, above.1, [1, 2, 1]),
        cuboid_hex8(above.0, above.1, [2, 2, 1]),
    ];
    pairs(&lower, &upper, visit);
}

/// Central differences with a step of 1e-5: their error is 1e-10 by truncation where the energy is smooth within the
/// step, and 1e-11 by rounding; a facet that passes a face within it adds a jump of the second derivative times the step.
pub(crate) fn force_is_the_slope_of_the_energy<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]], within: f64) {
    let at = contact.evaluate(coords).expect("valid coordinates");
    let largest = at.forces.iter().flatten().fold(0.0f64, |m, f| m.max(f.abs()));
    assert!(at.volume > 1e-3 && largest > 0.0);
    let mut random = Splitmix::new(7);
    for _ in 0..6 {
        let direction: Vec<[f64; D]> =
            coords.iter().map(|_| std::array::from_fn(|_| random.between(-1.0, 1.0))).collect();
        let energy = |h: f64| {
            let moved: Vec<[f64; D]> =
                coords.iter().zip(&direction).map(|(x, d)| std::array::from_fn(|i| x[i] + h * d[i])).collect();
            contact.evaluate(&moved).expect("valid coordinates").energy
        };
        let slope = (energy(1e-5) - energy(-1e-5)) / 2e-5;
        let along: f64 = at.forces.iter().flatten().zip(direction.iter().flatten()).map(|(f, d)| f * d).sum();
        assert!((along + slope).abs() < within * size_sum(&at.forces), "{along} against {slope}");
    }
}

pub(crate) fn forces_balance<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]]) {
    let at = contact.evaluate(coords).expect("valid coordinates");
    let sizes = size_sum(&at.forces);
    let force: [f64; D] = std::array::from_fn(|i| at.forces.iter().map(|f| f[i]).sum());
    let moment: [f64; 3] = std::array::from_fn(|i| coords.iter().zip(&at.forces).map(|(x, f)| cross(x, f)[i]).sum());
    assert!(norm(&[force]) < 1e-13 * sizes, "{force:?} of {sizes}");
    assert!(norm(&[moment]) < 1e-13 * sizes, "{moment:?} of {sizes}");
}

/// Differences of the force, as those of the energy.
pub(crate) fn tangent_is_the_slope_of_the_force<const D: usize>(
    contact: &Contact<D>,
    coords: &[[f64; D]],
    within: f64,
) {
    let tangent = contact.tangent(coords, TangentPart::Full).expect("valid coordinates");
    let mut random = Splitmix::new(8);
    for _ in 0..4 {
        let direction: Vec<[f64; D]> =
            coords.iter().map(|_| std::array::from_fn(|_| random.between(-1.0, 1.0))).collect();
        let forces = |h: f64| {
            let moved: Vec<[f64; D]> =
                coords.iter().zip(&direction).map(|(x, d)| std::array::from_fn(|i| x[i] + h * d[i])).collect();
            contact.evaluate(&moved).expect("valid coordinates").forces
        };
        let product = tangent.product(&direction);
        let error = |h: f64| {
            let (plus, minus) = (forces(h), forces(-h));
            let slopes = plus.iter().flatten().zip(minus.iter().flatten()).map(|(p, m)| (m - p) / (2.0 * h));
            slopes.zip(product.iter().flatten()).map(|(s, p)| (s - p).abs()).fold(0.0, f64::max)
        };
        let largest = product.iter().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
        let found = error(1e-6).min(error(1e-7));
        assert!(found < within * largest, "{found} of {largest}");
    }
    let both = contact.evaluate_tangent(coords, TangentPart::Full).expect("valid coordinates");
    assert_eq!(both, (contact.evaluate(coords).expect("valid coordinates"), tangent));
}

/// All of it.
pub(crate) fn check_all<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]]) {
    force_is_the_slope_of_the_energy(contact, coords, 1e-7);
    forces_balance(contact, coords);
    tangent_is_the_slope_of_the_force(contact, coords, 1e-6);
    semidefinite_part_is_semidefinite(contact, coords);
}

/// xᵀ K x is not negative.
fn semidefinite_part_is_semidefinite<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]]) {
    let tangent = contact.tangent(coords, TangentPart::Semidefinite).expect("valid coordinates");
    let mut matrix = nalgebra::DMatrix::<f64>::zeros(coords.len() * D, coords.len() * D);
    tangent.triplets().for_each(|(row, col, value)| matrix[(row, col)] += value);
    assert!((&matrix - matrix.transpose()).amax() < 1e-12 * matrix.amax());
    let eigenvalues = matrix.symmetric_eigenvalues();
    assert!(eigenvalues.max() > 0.0 && eigenvalues.min() > -1e-12 * eigenvalues.max(), "{}", eigenvalues.min());
}

#[test]
fn in_the_plane() {
    in_plane(|contact, coords| {
        check_all(&contact, &coords);
    });
}

#[test]
fn in_space_too() {
    in_space(|contact, coords| {
        check_all(&contact, &coords);
    });
}
