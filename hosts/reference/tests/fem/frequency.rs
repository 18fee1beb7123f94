//! Largest eigenfrequencies against closed forms and against all eigenvalues.

use crate::{distorted_2d, distorted_3d, material, models, part, random_field};
use fmc_contact::CellType;
use fmc_shapes::{Mesh, cuboid_hex8, rectangle_quad4, regular_polygon, star_quad4};
use fmc_solid::fem::{Law, Material, Model, Part};
use nalgebra::DMatrix;

fn frequencies<const D: usize>(model: &Model<D>, displacement: &[[f64; D]]) -> [f64; 2] {
    let mass = model.lumped_mass();
    [model.largest_frequency(displacement, &mass), model.frequency_bound(displacement, &mass)]
}

/// The stiffest motion of a regular cell is to swell: with stress σ = (Dλ + 2μ) ε and u = ε x about its centre,
/// ω² = 4 σ/ε / ρL² for a square or cube of side L. A regular simplex of circumradius R and height h = (D + 1)R/D has
/// ∇N_a = x_a/(R h) and a (D + 1)th of its mass at each node: ω² = D σ/ε / ρR².
#[test]
fn regular_cells_swell_at_their_closed_form() {
    let equilateral = regular_polygon(3, 0.7).coords;
    let corner = |x: f64, y: f64, z: f64| [x, y, z].map(|x| x * 0.7 / 3f64.sqrt());
    let tetrahedron =
        vec![corner(1.0, 1.0, 1.0), corner(-1.0, 1.0, -1.0), corner(1.0, -1.0, -1.0), corner(-1.0, -1.0, 1.0)];
    let (law, shear, lame) =
        (Law::NeoHookean, material(Law::NeoHookean).shear_modulus(), material(Law::NeoHookean).lame());
    let check = |computed: [f64; 2], squared: f64| {
        let exact = (squared / 2.5).sqrt();
        assert!(computed[0] >= exact * (1.0 - 1e-12) && computed[0] <= exact * 1.001, "{computed:?} {exact}");
        assert!((computed[1] / exact - 1.0).abs() < 1e-12, "{computed:?} {exact}");
    };
    let flat = |cell_type, mesh| {
        let model = Model::new(vec![part::<2>(cell_type, mesh, law)]).unwrap();
        frequencies(&model, &vec![[0.0; 2]; model.node_count()])
    };
    let solid = |cell_type, mesh| {
        let model = Model::new(vec![part::<3>(cell_type, mesh, law)]).unwrap();
        frequencies(&model, &vec![[0.0; 3]; model.node_count()])
    };
    let (plane, space) = (2.0 * lame + 2.0 * shear, 3.0 * lame + 2.0 * shear);
    let triangle = Mesh { coords: equilateral, conn: vec![0, 1, 2], nodes_per_cell: 3 };
    check(flat(CellType::Tri3, triangle), 2.0 * plane / 0.49);
    check(flat(CellType::Quad4, rectangle_quad4([0.0; 2], [0.7; 2], [1; 2])), 4.0 * plane / 0.49);
    let tetrahedron = Mesh { coords: tetrahedron, conn: vec![0, 1, 2, 3], nodes_per_cell: 4 };
    check(solid(CellType::Tet4, tetrahedron), 3.0 * space / 0.49);
    check(solid(CellType::Hex8, cuboid_hex8([0.0; 3], [0.7; 3], [1; 3])), 4.0 * space / 0.49);
}

/// A bar without lateral effect (ν = 0) in cells of length h: ω = 2c/h, where neighbours move against each other.
#[test]
fn bar_is_stable_for_the_time_of_a_wave_through_a_cell() {
    let material = Material { law: Law::LinearElastic, young: 900.0, poisson: 0.0, density: 1.0 };
    let mesh = rectangle_quad4([0.0; 2], [10.0, 0.1], [100, 1]);
    let strip = Part { name: "bar".into(), cell_type: CellType::Quad4, mesh, material };
    let model = Model::new(vec![strip]).unwrap();
    let [estimate, bound] = frequencies(&model, &vec![[0.0; 2]; model.node_count()]);
    assert!((estimate / 600.0 - 1.0).abs() < 5.1e-4 && (bound / 600.0 - 1.0).abs() < 1e-12, "{estimate} {bound}");
    let mesh = cuboid_hex8([0.0; 3], [10.0, 0.1, 0.1], [100, 1, 1]);
    let model = Model::new(vec![Part { name: "bar".into(), cell_type: CellType::Hex8, mesh, material }]).unwrap();
    let [estimate, bound] = frequencies(&model, &vec![[0.0; 3]; model.node_count()]);
    assert!((estimate / 600.0 - 1.0).abs() < 5.1e-4 && (bound / 600.0 - 1.0).abs() < 1e-12, "{estimate} {bound}");
}

/// Largest root of all eigenvalues of M^(−1/2) K M^(−1/2), K assembled from the entries.
fn from_all_eigenvalues<const D: usize>(model: &Model<D>, displacement: &[[f64; D]], mass: &[f64]) -> f64 {
    let tangent = model.tangent(displacement);
    let mut matrix = DMatrix::<f64>::zeros(tangent.size, tangent.size);
    for (row, column, value) in tangent.iter() {
        matrix[(row, column)] += value / (mass[row / D] * mass[column / D]).sqrt();
    }
    matrix.symmetric_eigenvalues().max().sqrt()
}

fn estimate_lies_between<const D: usize>(models: Vec<Model<D>>) {
    for model in models {
        let displacement = random_field::<D>(model.node_count(), 0.03, 8);
        // Masses need not be those of the model: here some nodes carry more.
        let mut mass = model.lumped_mass();
        mass.iter_mut().step_by(3).for_each(|mass| *mass *= 1.5);
        let exact = from_all_eigenvalues(&model, &displacement, &mass);
        let estimate = model.largest_frequency(&displacement, &mass);
        let bound = model.frequency_bound(&displacement, &mass);
        assert!(estimate >= exact * (1.0 - 1e-9) && estimate <= exact * (1.0 + 5.1e-4), "{estimate} {exact}");
        assert!(bound >= exact * (1.0 - 1e-12), "{bound} {exact}");
        // Four times the mass, half the frequency.
        mass.iter_mut().for_each(|mass| *mass *= 4.0);
        assert!((model.frequency_bound(&displacement, &mass) / bound - 0.5).abs() < 1e-12);
    }
}

#[test]
fn estimate_is_the_largest_of_all_and_the_bound_above() {
    estimate_lies_between(models(distorted_2d()));
    estimate_lies_between(models(distorted_3d()));
}

/// The paper's star. Its stable step is known to be near 6.48 µs on the paper's mesh; ours has as many cells on the same
/// outline, but lays them out in its own way, and comes within a tenth.
#[test]
fn star_is_stable_near_the_known_step() {
    let material = Material { law: Law::NeoHookean, young: 73.2e6, poisson: 0.4, density: 1010.0 };
    let mesh = star_quad4(4, 0.1, 0.03, 12, 2);
    let model = Model::new(vec![Part { name: "star".into(), cell_type: CellType::Quad4, mesh, material }]).unwrap();
    let rest = vec![[0.0; 2]; model.node_count()];
    let [estimate, bound] = frequencies(&model, &rest);
    let exact = from_all_eigenvalues(&model, &rest, &model.lumped_mass());
    assert!((2.0 / exact - 6.48e-6).abs() < 0.1 * 6.48e-6, "{exact}");
    assert!(estimate >= exact && estimate < 1.0006 * exact && bound > exact, "{estimate} {bound} {exact}");
}
