//! What cells of second order can do beyond the straight ones.

use crate::{distorted_2d, distorted_3d, largest, material, models, part, straight_2d, straight_3d};
use fmc_contact::CellType;
use fmc_shapes::{Mesh, cuboid_hex8, disc_tri3, rectangle_quad4, second_order};
use fmc_solid::fem::{Error, Law, Model};

/// u_i = Σ c (x_j − ½)(x_k + ¼): every product of two coordinates with a coefficient of its own.
fn coefficient(i: usize, j: usize, k: usize) -> f64 {
    0.03 * ((5 * i + 3 * j + 2 * k) % 7) as f64 - 0.07
}

/// A quadratic displacement has a linear stress σ and a uniform body force −div σ: both with the surface load σ n balance the internal
/// force at every node. Exact where cells of all quadratic functions have straight edges.
fn quadratic_displacement_is_met<const D: usize>(cell_type: CellType, mesh: Mesh<D>) {
    let model = Model::new(vec![part(cell_type, mesh, Law::LinearElastic)]).unwrap();
    let (lame, shear) = (material(Law::LinearElastic).lame(), material(Law::LinearElastic).shear_modulus());
    let displacement: Vec<[f64; D]> = (model.coords().iter())
        .map(|x| {
            let product = |i: usize, j: usize, k: usize| coefficient(i, j, k) * (x[j] - 0.5) * (x[k] + 0.25);
            std::array::from_fn(|i| (0..D * D).map(|m| product(i, m / D, m % D)).sum())
        })
        .collect();
    let gradient = |x: &[f64; D], i: usize, l: usize| -> f64 {
        (0..D).map(|k| coefficient(i, l, k) * (x[k] + 0.25) + coefficient(i, k, l) * (x[k] - 0.5)).sum()
    };
    let stress = |x: &[f64; D], i: usize, j: usize| {
        let trace: f64 = (0..D).map(|k| gradient(x, k, k)).sum();
        shear * (gradient(x, i, j) + gradient(x, j, i)) + if i == j { lame * trace } else { 0.0 }
    };
    // ∂²u_i / ∂x_j ∂x_l.
    let second = |i: usize, j: usize, l: usize| coefficient(i, j, l) + coefficient(i, l, j);
    let body = std::array::from_fn(|i| {
        let each = |j: usize| (lame + shear) * second(j, j, i) + shear * second(i, j, j);
        -(0..D).map(each).sum::<f64>()
    });
    let mut force = vec![[0.0; D]; model.node_count()];
    model.internal(&displacement, &mut force);
    let faces = model.faces_where(0, |_| true);
    let load = model.surface_load(&faces, |x, n| std::array::from_fn(|i| (0..D).map(|j| stress(x, i, j) * n[j]).sum()));
    let weight = model.body_load(0, body);
    let size = largest(&force);
    assert!(size > 1.0);
    for ((f, load), weight) in force.iter().zip(&load).zip(&weight) {
        for i in 0..D {
            assert!((f[i] - load[i] - weight[i]).abs() < 1e-12 * size, "{cell_type:?}: {f:?} {load:?} {weight:?}");
        }
    }
}

#[test]
fn quadratic_displacements_are_exact() {
    let ([triangles, quads], [tetrahedra, _]) = (
        [straight_2d()[0].1.clone(), straight_2d()[1].1.clone()],
        [straight_3d()[0].1.clone(), straight_3d()[1].1.clone()],
    );
    quadratic_displacement_is_met(CellType::Tri6, second_order(&triangles, 6));
    quadratic_displacement_is_met(CellType::Quad9, second_order(&quads, 9));
    quadratic_displacement_is_met(CellType::Tet10, second_order(&tetrahedra, 10));
    // Without a node in their middle they have all quadratic functions as parallelograms only; the loads on warped faces are
    // not of so low a degree.
    let (square, cube) =
        (rectangle_quad4([0.0; 2], [1.0, 2.0], [3, 2]), cuboid_hex8([0.0; 3], [1.0, 2.0, 1.0], [2; 3]));
    quadratic_displacement_is_met(
        CellType::Quad8,
        second_order(&square, 8).mapped(|[x, y]| [x + 0.3 * y, y - 0.2 * x]),
    );
    let leaning = |[x, y, z]: [f64; 3]| [x + 0.3 * y, y - 0.2 * z, z + 0.1 * x];
    quadratic_displacement_is_met(CellType::Hex20, second_order(&cube, 20).mapped(leaning));
    quadratic_displacement_is_met(CellType::Hex27, second_order(&cube, 27).mapped(leaning));
}

/// Mass and weight of a body are those of its volume ∫ x·n dA / D, and every node has a mass.
fn masses_add_up<const D: usize>(models: Vec<Model<D>>) {
    for model in models {
        let faces = model.faces_where(0, |_| true);
        let flux = model.surface_load(&faces, |x, n| {
            let along: f64 = (0..D).map(|i| x[i] * n[i]).sum();
            [along; D]
        });
        let volume = flux.iter().map(|f| f[0]).sum::<f64>() / D as f64;
        let (mass, weight) = (model.lumped_mass(), model.body_load(0, [1.0; D]));
        assert!(mass.iter().all(|&mass| mass > 0.0));
        let name = &model.parts()[0].name;
        assert!((mass.iter().sum::<f64>() / (2.5 * volume) - 1.0).abs() < 1e-12, "{name}");
        assert!((weight.iter().map(|w| w[0]).sum::<f64>() / volume - 1.0).abs() < 1e-12, "{name}");
    }
}

#[test]
fn masses_and_weights_add_up_on_curved_cells() {
    masses_add_up(models(distorted_2d()));
    masses_add_up(models(distorted_3d()));
}

/// The nine nodes of a rectangle are those of Simpson's rule in both directions.
#[test]
fn nine_nodes_share_the_mass_as_simpson_has_it() {
    let mesh = second_order(&rectangle_quad4([0.0; 2], [2.0, 3.0], [1, 1]), 9);
    let mass = Model::new(vec![part(CellType::Quad9, mesh, Law::NeoHookean)]).unwrap().lumped_mass();
    for (node, mass) in mass.iter().enumerate() {
        let share = [1.0, 4.0, 16.0][usize::from(node > 3) + usize::from(node == 8)];
        assert!((mass - 15.0 * share / 36.0).abs() < 1e-13, "{node}: {mass}");
    }
}

/// Uniform pressure on a curved surface: ∫ p n dA closes, and does the work p dV when the body swells.
#[test]
fn pressure_on_a_circle_does_the_work_of_the_swelling_area() {
    let mesh = second_order(&disc_tri3(2.0, 16), 6).rounded([0.0; 2], 2.0);
    let model = Model::new(vec![part(CellType::Tri6, mesh, Law::LinearElastic)]).unwrap();
    let load = model.surface_load(&model.faces_where(0, |_| true), |_, n| *n);
    (0..2).for_each(|i| assert!(load.iter().map(|l| l[i]).sum::<f64>().abs() < 1e-14));
    let work: f64 = load.iter().zip(model.coords()).map(|(l, x)| l[0] * x[0] + l[1] * x[1]).sum();
    let mass: f64 = model.lumped_mass().iter().sum::<f64>() / 2.5;
    assert!((work / (2.0 * mass) - 1.0).abs() < 1e-13);
    // Order 4 in the edges: 16 of them enclose the disc to some 1e-5; straight ones to 2.6e-2.
    assert!((mass / (4.0 * std::f64::consts::PI) - 1.0).abs() < 6e-5, "{mass}");
}

#[test]
fn a_node_far_off_turns_a_cell_inside_out() {
    let mut mesh = second_order(&rectangle_quad4([0.0; 2], [1.0; 2], [1, 1]), 9);
    mesh.coords[4] = [1.2, 0.0];
    let error = Model::new(vec![part(CellType::Quad9, mesh, Law::NeoHookean)]).unwrap_err();
    assert!(matches!(error, Error::InvertedCell { cell: 0, .. }), "{error}");
}
