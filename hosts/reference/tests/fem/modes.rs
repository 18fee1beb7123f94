//! Incompatible modes: uniform stress is met, and so is bending, which cells without them resist by shear.

use crate::consistency::{force_and_stiffness_are_derivatives, rigid_motion_costs_nothing};
use crate::patch::constant_stress_balances_its_traction;
use crate::{homogeneous, part, straight_2d, straight_3d};
use fmc_contact::CellType;
use fmc_shapes::{Mesh, cuboid_hex8, rectangle_quad4};
use fmc_solid::fem::{Law, Model};

/// Distorted cells, with modes in all of them and in every other.
fn bending<const D: usize>(mut meshes: Vec<(CellType, Mesh<D>)>) -> Vec<Model<D>> {
    let (cell_type, mesh) = meshes.remove(1);
    assert!(matches!(cell_type, CellType::Quad4 | CellType::Hex8));
    let model = || Model::new(vec![part(cell_type, mesh.clone(), Law::LinearElastic)]).unwrap();
    vec![model().with_incompatible_modes(|_| true), model().with_incompatible_modes(|cell| cell % 2 == 0)]
}

#[test]
fn uniform_stress_is_met_and_stiffness_is_consistent() {
    constant_stress_balances_its_traction(bending(straight_2d()));
    constant_stress_balances_its_traction(bending(straight_3d()));
    force_and_stiffness_are_derivatives(bending(straight_2d()));
    force_and_stiffness_are_derivatives(bending(straight_3d()));
    rigid_motion_costs_nothing(bending(straight_2d()));
    rigid_motion_costs_nothing(bending(straight_3d()));
}

/// A bar from x = 0 to 4 and z = −½ to ½ of cells 1 × 1 × 1, bent to the curvature κ about y, with ν = 0.3 and free sides. The closed form of the
/// corners is u = κxz, v = −νκyz, w = −κx²/2 − νκ(z² − y²)/2: its force balances the moment's at the ends alone, and its stress is Eκz.
#[test]
fn bars_of_one_layer_bend_as_beams() {
    let (kappa, nu, young) = (0.01, 0.3, 100.0);
    let mesh = cuboid_hex8([0.0, -0.5, -0.5], [4.0, 0.5, 0.5], [4, 1, 1]);
    let plain = Model::new(vec![part(CellType::Hex8, mesh, Law::LinearElastic)]).unwrap();
    let bent =
        |[x, y, z]: [f64; 3]| [kappa * x * z, -nu * kappa * y * z, -0.5 * kappa * (x * x + nu * (z * z - y * y))];
    let field: Vec<[f64; 3]> = plain.coords().iter().map(|x| bent(*x)).collect();
    let forces = |model: &Model<3>| {
        let mut force = vec![[0.0; 3]; model.node_count()];
        let energy = model.internal(&field, &mut force);
        let inside = model.coords().iter().zip(&force).filter(|(x, _)| x[0] > 0.5 && x[0] < 3.5);
        let off = inside.flat_map(|(_, f)| f.iter().map(|f| f.abs())).fold(0.0, f64::max);
        (energy, off)
    };
    // Without modes the energy is half as much again as that of a beam, ½ E I κ² L.
    let beam = 0.5 * young / 12.0 * kappa * kappa * 4.0;
    let (stiff, _) = forces(&plain);
    assert!(stiff > 1.5 * beam, "{stiff} {beam}");
    let model = plain.with_incompatible_modes(|_| true);
    let (energy, off) = forces(&model);
    assert!((energy / beam - 1.0).abs() < 1e-12 && off < 1e-13, "{energy} {beam}, {off}");
    for (cell, points) in model.point_stresses(&field).chunks(8).enumerate() {
        for (number, stress) in points.iter().enumerate() {
            let z = if number < 4 { -1.0 } else { 1.0 } * 0.5 / 3f64.sqrt();
            let expected = [young * kappa * z, 0.0, 0.0, 0.0, 0.0, 0.0];
            let off = stress.0.iter().zip(expected).map(|(s, e)| (s - e).abs()).fold(0.0, f64::max);
            assert!(off < 1e-12, "{cell} {number}: {stress:?}");
        }
    }
}

/// Plates of plane stress as narrow beams; modes of other laws and cells are none.
#[test]
fn plates_bend_as_beams_and_other_cells_are_as_before() {
    let mesh = rectangle_quad4([0.0, -0.5], [3.0, 0.5], [3, 1]);
    let plate = Model::new(vec![part(CellType::Quad4, mesh.clone(), Law::PlaneStress)]).unwrap();
    let plate = plate.with_incompatible_modes(|_| true);
    let bent = |[x, y]: [f64; 2]| [0.01 * x * y, -0.005 * (x * x + 0.3 * y * y)];
    let field: Vec<[f64; 2]> = plate.coords().iter().map(|x| bent(*x)).collect();
    let energy = plate.internal(&field, &mut vec![[0.0; 2]; plate.node_count()]);
    assert!((energy / (0.5 * 100.0 / 12.0 * 1e-4 * 3.0) - 1.0).abs() < 1e-12, "{energy}");
    let rubber = || Model::new(vec![part(CellType::Quad4, mesh.clone(), Law::NeoHookean)]).unwrap();
    let stretched = homogeneous(&rubber(), [[0.1, 0.05], [0.0, -0.02]]);
    let field: Vec<[f64; 2]> = field.iter().zip(&stretched).map(|(a, b)| [a[0] + b[0], a[1] + b[1]]).collect();
    let [a, b] = [rubber(), rubber().with_incompatible_modes(|_| true)].map(|model| {
        let mut force = vec![[0.0; 2]; model.node_count()];
        (model.internal(&field, &mut force), force)
    });
    assert_eq!(a, b);
}
