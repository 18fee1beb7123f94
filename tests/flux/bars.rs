//! Two bars in series, solved with the contact between them: the closed form of their temperatures.

use crate::scene::Scene;
use crate::{K, field, flux, largest, out_of, pressed};
use fmc_contact::contact::{Conductance, PairOptions};
use fmc_contact::overlap::Partner::Body;
use fmc_contact::{Contact, EnergyLaw, Options};
use fmc_shapes::{Diagonals, Mesh, cuboid_tet4, random_rotation, rectangle_tri3};
use nalgebra::{DMatrix, DVector};

/// Conductivities of both bars.
const CONDUCTIVITY: [f64; 2] = [1.0, 2.0];

/// Matrix of the bodies' own conduction: linear simplices.
fn conduction<const D: usize>(scene: &Scene<D>) -> DMatrix<f64> {
    let mut matrix = DMatrix::zeros(scene.coords.len(), scene.coords.len());
    for (body, (_, conn)) in scene.blocks.iter().enumerate() {
        for cell in conn.chunks_exact(D + 1) {
            let x = |k: usize| scene.coords[cell[k] as usize];
            let edges = DMatrix::from_fn(D, D, |i, k| x(k + 1)[i] - x(0)[i]);
            let factorial = if D == 2 { 2.0 } else { 6.0 };
            let volume: f64 = edges.determinant().abs() / factorial;
            let inverse = edges.try_inverse().expect("a cell with a volume");
            let slope = |k: usize, axis: usize| match k {
                0 => -(0..D).map(|row| inverse[(row, axis)]).sum::<f64>(),
                _ => inverse[(k - 1, axis)],
            };
            for a in 0..=D {
                for b in 0..=D {
                    let product: f64 = (0..D).map(|axis| slope(a, axis) * slope(b, axis)).sum();
                    matrix[(cell[a] as usize, cell[b] as usize)] += CONDUCTIVITY[body] * volume * product;
                }
            }
        }
    }
    matrix
}

/// The temperatures in equilibrium, with those of some nodes held.
fn equilibrium<const D: usize>(
    contact: &Contact<D>,
    scene: &Scene<D>,
    h: &Conductance,
    held: impl Fn(usize) -> Option<f64>,
) -> Vec<f64> {
    let mut matrix = conduction(scene);
    let found = flux(contact, &scene.coords, &vec![0.0; scene.coords.len()], h);
    for row in 0..scene.coords.len() {
        for entry in found.matrix.offsets[row]..found.matrix.offsets[row + 1] {
            matrix[(row, found.matrix.cols[entry] as usize)] += found.matrix.values[entry];
        }
    }
    let mut right = DVector::zeros(scene.coords.len());
    for node in 0..scene.coords.len() {
        if let Some(value) = held(node) {
            matrix.row_mut(node).fill(0.0);
            matrix[(node, node)] = 1.0;
            right[node] = value;
        }
    }
    matrix.lu().solve(&right).expect("a solution").iter().copied().collect()
}

/// Bars of length 1 and 0.7 along the last axis, with a gap between them, 3 at the bottom and −2 at the top: the flux by area that their nodes
/// must have at this conductance, and the largest difference of all temperatures from the closed form.
fn difference<const D: usize>(scene: &Scene<D>, contact: &Contact<D>, tables: &Conductance, gap: f64, h: f64) -> f64 {
    let last = D - 1;
    let top = 1.7 + gap;
    let density = 5.0 / (1.0 / CONDUCTIVITY[0] + 1.0 / h + 0.7 / CONDUCTIVITY[1]);
    let expected = field(scene, |mesh, x| match mesh {
        0 => 3.0 - density * x[last] / CONDUCTIVITY[0],
        _ => -2.0 + density * (top - x[last]) / CONDUCTIVITY[1],
    });
    let ends = |node: usize| {
        let x = scene.coords[node][last];
        (x < 1e-9 || x > top - 1e-9).then_some(expected[node])
    };
    let found = equilibrium(contact, scene, tables, ends);
    let flux = flux(contact, &scene.coords, &found, tables);
    let sums = [out_of(scene, &flux, 0) - density, out_of(scene, &flux, 1) + density];
    let all: Vec<f64> = found.iter().zip(&expected).map(|(a, b)| a - b).chain(sums).collect();
    largest(&all)
}

fn bars_in_the_plane(gap: f64) -> [Mesh<2>; 2] {
    let below = rectangle_tri3([0.0, 0.0], [1.0, 1.0], [3, 4], Diagonals::Same);
    let above = rectangle_tri3([0.0, 1.0 + gap], [1.0, 1.7 + gap], [5, 3], Diagonals::Alternating);
    [below, above]
}

fn bars_in_space(gap: f64) -> [Mesh<3>; 2] {
    let below = cuboid_tet4([0.0; 3], [1.0, 1.0, 1.0], [2, 3, 2]);
    let above = cuboid_tet4([0.0, 0.0, 1.0 + gap], [1.0, 1.0, 1.7 + gap], [3, 2, 2]);
    [below, above]
}

/// By a stack of a gap, tables and the conductance that they must have there.
fn cases() -> Vec<(f64, Conductance, f64)> {
    let tables = Conductance {
        by_pressure: vec![[0.0, 1.0], [1.0, 4.0], [2.0, 5.0]],
        by_gap: vec![[0.0, 1.0], [0.1, 0.4], [0.3, 0.2]],
    };
    vec![
        (-0.01, Conductance::constant(3.7), 3.7),
        // The pressure is K times the penetration: 1.5.
        (-0.015, tables.clone(), 4.5),
        (-0.004, tables.clone(), 2.2),
        (0.2, tables.clone(), 0.3),
        (0.05, tables, 0.7),
    ]
}

#[test]
fn bars_in_series_have_the_temperatures_of_the_closed_form() {
    for (gap, tables, h) in cases() {
        let flat = Scene::of(&bars_in_the_plane(gap).each_ref());
        let off = difference(&flat, &pressed(&flat), &tables, gap, h);
        assert!(off < 1e-9, "{gap}: {off:e}");
        let space = Scene::of(&bars_in_space(gap).each_ref());
        let off = difference(&space, &pressed(&space), &tables, gap, h);
        assert!(off < 1e-9, "{gap}: {off:e}");
    }
}

/// The pressure is that of the law at the penetration; with `volume` that of the pair.
#[test]
fn the_pressure_is_that_of_the_law() {
    let tables = Conductance { by_pressure: vec![[0.0, 1.0], [10.0, 11.0]], by_gap: Vec::new() };
    let scene = Scene::of(&bars_in_the_plane(-0.01).each_ref());
    for (law, pressure) in [(EnergyLaw::depth(K), 1.0), (EnergyLaw::fiber(2.0 * K), 2.0), (EnergyLaw::volume(3.0), 3.0)]
    {
        let off = difference(&scene, &scene.contact(Options::new(law)), &tables, -0.01, 1.0 + pressure);
        assert!(off < 1e-9, "{law:?}: {off:e}");
    }
}

/// A gap offset moves where contact begins, and from where gaps count.
#[test]
fn gap_offsets_count() {
    let tables = Conductance { by_pressure: vec![[0.0, 1.0], [10.0, 11.0]], by_gap: vec![[0.0, 1.0], [0.1, 0.5]] };
    for (gap, offset, h) in [(-0.03, -0.01, 3.0), (-0.03, -0.05, 0.9)] {
        let scene = Scene::of(&bars_in_the_plane(gap).each_ref());
        let mut contact = pressed(&scene);
        let options = PairOptions { gap_offset: offset, ..PairOptions::default() };
        contact.set_pair_options([Body(0), Body(1)], Some(options)).expect("options");
        let off = difference(&scene, &contact, &tables, gap, h);
        assert!(off < 1e-9, "{gap} {offset}: {off:e}");
    }
}

/// A perfect contact leaves no jump: the temperature of one bar of one material is linear.
#[test]
fn a_perfect_contact_has_no_jump() {
    for gap in [-0.001, 0.0] {
        let scene = Scene::of(&bars_in_the_plane(gap).each_ref());
        let off = difference(&scene, &pressed(&scene), &Conductance::constant(1e8), gap, 1e8);
        // The matrix has a condition of 1e9.
        assert!(off < 1e-6, "{off:e}");
    }
}

/// What lies elsewhere has the same flux.
#[test]
fn turned_bars_have_the_same_flux() {
    for (gap, tables, _) in cases() {
        let scene = Scene::of(&bars_in_space(gap).each_ref());
        let values = field(&scene, |mesh, x| (1.0 + mesh as f64) * (x[0] - 2.0 * x[1] * x[2]).sin());
        let there = flux(&pressed(&scene), &scene.coords, &values, &tables);
        let turn = random_rotation::<3>(11);
        let turned = scene.mapped(|x| std::array::from_fn(|i| 0.3 + (0..3).map(|j| turn[i][j] * x[j]).sum::<f64>()));
        let here = flux(&pressed(&turned), &turned.coords, &values, &tables);
        let off: Vec<f64> = here.flux.iter().zip(&there.flux).map(|(a, b)| a - b).collect();
        assert!(largest(&off) < 1e-12 * largest(&there.flux).max(1e-3), "{gap}: {:e}", largest(&off));
    }
}
