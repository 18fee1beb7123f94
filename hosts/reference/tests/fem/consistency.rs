//! Energy, force and stiffness are derivatives of one another; motions of rigid bodies cost nothing.

use crate::{distorted_2d, distorted_3d, homogeneous, largest, models, part, random_field};
use fmc_contact::CellType;
use fmc_shapes::{cuboid_hex8, cuboid_tet4, random_rotation, rectangle_quad4};
use fmc_solid::fem::{Law, Model};

fn moved<const D: usize>(u: &[[f64; D]], du: &[[f64; D]], step: f64) -> Vec<[f64; D]> {
    u.iter().zip(du).map(|(u, du)| std::array::from_fn(|i| u[i] + step * du[i])).collect()
}

fn dot<const D: usize>(a: &[[f64; D]], b: &[[f64; D]]) -> f64 {
    a.as_flattened().iter().zip(b.as_flattened()).map(|(a, b)| a * b).sum()
}

/// Central differences with a step of 1e-5 of a distortion by 5 % of a cell: truncation and rounding near 1e-9.
pub(crate) fn force_and_stiffness_are_derivatives<const D: usize>(models: Vec<Model<D>>) {
    for model in models {
        let count = model.node_count();
        let (u, du) = (random_field::<D>(count, 0.02, 1), random_field::<D>(count, 1.0, 2));
        let internal = |u: &[[f64; D]]| {
            let mut force = vec![[f64::NAN; D]; count];
            let energy = model.internal(u, &mut force);
            (energy, force)
        };
        let step = 1e-5;
        let (force, (more, ahead), (less, behind)) =
            (internal(&u).1, internal(&moved(&u, &du, step)), internal(&moved(&u, &du, -step)));
        let power = dot(&force, &du);
        assert!(
            (power - (more - less) / (2.0 * step)).abs() < 1e-7 * dot(&force, &force).sqrt() * dot(&du, &du).sqrt()
        );

        let mut product = vec![[f64::NAN; D]; count];
        model.stiffness_product(&u, &du, &mut product);
        let tangent = model.tangent(&u);
        let by_entries = tangent.product(du.as_flattened());
        let size = largest(&product);
        for k in 0..count * D {
            let difference = (ahead.as_flattened()[k] - behind.as_flattened()[k]) / (2.0 * step);
            assert!((product.as_flattened()[k] - difference).abs() < 1e-6 * size);
            assert!((product.as_flattened()[k] - by_entries[k]).abs() < 1e-12 * size);
        }
        // Symmetric to the last bit, entry against transposed entry of the same cell.
        let mut other = tangent.clone();
        std::mem::swap(&mut other.rows, &mut other.columns);
        let sorted = |triplets: &fmc_solid::fem::Triplets| {
            let mut entries: Vec<_> = triplets.iter().map(|(i, j, value)| (i, j, value.to_bits())).collect();
            entries.sort_unstable();
            entries
        };
        assert_eq!(sorted(&tangent), sorted(&other));
    }
}

#[test]
fn force_is_energy_gradient_and_stiffness_force_gradient() {
    force_and_stiffness_are_derivatives(models(distorted_2d()));
    force_and_stiffness_are_derivatives(models(distorted_3d()));
}

/// Small strains see no small rotation (H antisymmetric), the neo-Hookean solid no rotation at all.
pub(crate) fn rigid_motion_costs_nothing<const D: usize>(models: Vec<Model<D>>) {
    for model in models {
        let h: [[f64; D]; D] = match model.parts()[0].material.law {
            Law::LinearElastic | Law::PlaneStress => {
                std::array::from_fn(|i| std::array::from_fn(|j| 0.3 * (j as f64 - i as f64)))
            }
            Law::NeoHookean => {
                let turn: [[f64; D]; D] = random_rotation(3);
                std::array::from_fn(|i| std::array::from_fn(|j| turn[i][j] - f64::from(i == j)))
            }
        };
        let displacement = moved(&homogeneous(&model, h), &vec![[1.0; D]; model.node_count()], 5.0);
        let mut force = vec![[f64::NAN; D]; model.node_count()];
        let energy = model.internal(&displacement, &mut force);
        // Displacements near 5 are known to 1e-15, strains in cells of 0.3 to 1e-14.
        assert!(energy.abs() < 1e-12 && largest(&force) < 1e-11, "{energy} {}", largest(&force));
    }
}

#[test]
fn rigid_motions_cost_nothing() {
    rigid_motion_costs_nothing(models(distorted_2d()));
    rigid_motion_costs_nothing(models(distorted_3d()));
}

/// Forces of a body on itself have no resultant.
#[test]
fn internal_forces_balance() {
    for model in models(distorted_3d()) {
        let mut force = vec![[0.0; 3]; model.node_count()];
        model.internal(&random_field(model.node_count(), 0.02, 4), &mut force);
        (0..3).for_each(|axis| assert!(force.iter().map(|f| f[axis]).sum::<f64>().abs() < 1e-13 * 100.0));
    }
}

/// Several blocks of cells, several parts, one to three threads.
fn threads_change_no_bit<const D: usize>(parts: Vec<fmc_solid::fem::Part<D>>) {
    let results = [1, 2, 3].map(|threads| {
        let model = Model::new(parts.clone()).unwrap().with_threads(threads).unwrap();
        let mut u = random_field::<D>(model.node_count(), 0.002, 1);
        // Blocks of very unlike energy, whose sum tells their order.
        let count = u.len() as f64;
        u.iter_mut().enumerate().for_each(|(node, u)| *u = u.map(|u| u * (node as f64 / count).powi(2)));
        let (mut force, mut product) = (vec![[0.0; D]; u.len()], vec![[0.0; D]; u.len()]);
        let energy = model.internal(&u, &mut force);
        model.stiffness_product(&u, &force, &mut product);
        let all =
            force.into_iter().chain(product).flatten().chain([energy, model.frequency_bound(&u, &model.lumped_mass())]);
        all.map(f64::to_bits).collect::<Vec<_>>()
    });
    assert!(results[0] == results[1] && results[0] == results[2]);
}

#[test]
fn threads_change_no_bit_in_any_element() {
    let square = rectangle_quad4([0.0; 2], [1.0; 2], [90, 90]);
    // By itself: beside a part of more energy the last bits of this one would not show.
    threads_change_no_bit(vec![part(CellType::Quad4, square.clone(), Law::NeoHookean)]);
    threads_change_no_bit(vec![
        part(CellType::Quad4, square.clone(), Law::NeoHookean),
        part(CellType::Tri3, square.translated([2.0, 0.0]).triangulated(), Law::LinearElastic),
    ]);
    threads_change_no_bit(vec![
        part(CellType::Tet4, cuboid_tet4([0.0; 3], [1.0; 3], [7; 3]), Law::NeoHookean),
        part(CellType::Hex8, cuboid_hex8([0.0; 3], [1.0; 3], [11; 3]).translated([2.0, 0.0, 0.0]), Law::LinearElastic),
    ]);
}
