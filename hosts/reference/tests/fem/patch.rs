//! A linear displacement field is met exactly, however distorted the cells.

use crate::{LAWS, distorted_2d, distorted_3d, homogeneous, largest, material, models, part};
use fmc_contact::CellType;
use fmc_shapes::cuboid_hex8;
use fmc_solid::fem::{Cells, Law, Model};

/// First Piola–Kirchhoff stress of a stretch and shear in the plane, written out by hand, F_zz = 1 in all cases:
/// F = [[s, g], [0, 1]] has J = s, cof F = [[1, 0], [−g, s]] and cof_zz = s.
fn stress(law: Law, s: f64, g: f64) -> [[f64; 3]; 3] {
    let (lame, shear, bulk) = (material(law).lame(), material(law).shear_modulus(), material(law).bulk_modulus());
    let e = s - 1.0;
    match law {
        Law::LinearElastic | Law::PlaneStress => {
            [[(lame + 2.0 * shear) * e, shear * g, 0.0], [shear * g, lame * e, 0.0], [0.0, 0.0, lame * e]]
        }
        Law::NeoHookean => {
            let a = shear * s.powf(-2.0 / 3.0);
            let b = bulk * (s - 1.0) - a * (s * s + g * g + 2.0) / (3.0 * s);
            [[a * s + b, a * g, 0.0], [-b * g, a + b * s, 0.0], [0.0, 0.0, a + b * s]]
        }
    }
}

/// Inner nodes feel nothing; those of the boundary feel what the traction P N on all faces makes, which also checks
/// faces, normals and surface loads, those of warped quadrilaterals included.
pub(crate) fn constant_stress_balances_its_traction<const D: usize>(models: Vec<Model<D>>) {
    for model in models {
        let mut h = [[0.0; D]; D];
        (h[0][0], h[0][1]) = (0.2, -0.15);
        let displacement = homogeneous(&model, h);
        let law = model.parts()[0].material.law;
        let p = stress(law, 1.2, -0.15);
        let mut force = vec![[0.0; D]; model.node_count()];
        model.internal(&displacement, &mut force);
        let faces = model.faces_where(0, |_| true);
        let load = model.surface_load(&faces, |_, n| std::array::from_fn(|i| (0..D).map(|j| p[i][j] * n[j]).sum()));
        assert!(largest(&force) > 1.0);
        for (f, l) in force.iter().zip(&load) {
            (0..D).for_each(|i| assert!((f[i] - l[i]).abs() < 1e-13 * 100.0, "{law:?}: {f:?} {l:?}"));
        }
        // Cauchy stress P Fᵀ/J in every cell.
        let (f, jacobian) = ([[1.2, -0.15, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], 1.2);
        let cauchy = |i: usize, j: usize| match law {
            Law::LinearElastic | Law::PlaneStress => p[i][j],
            Law::NeoHookean => (0..3).map(|k| p[i][k] * f[j][k]).sum::<f64>() / jacobian,
        };
        let expected = [cauchy(0, 0), cauchy(1, 1), cauchy(2, 2), cauchy(0, 1), cauchy(1, 2), cauchy(2, 0)];
        let cells = model.stresses(&displacement);
        assert_eq!(cells.len(), model.cell_count());
        for stress in cells.iter().chain(&model.nodal_stresses(&cells)) {
            stress.0.iter().zip(expected).for_each(|(s, e)| assert!((s - e).abs() < 1e-12 * 100.0, "{law:?}: {s} {e}"));
        }
    }
}

/// A box of hexahedra whose last column is of upright wedges: one body.
#[test]
fn constant_stress_goes_through_cells_of_two_types() {
    let mut mesh = cuboid_hex8([0.0; 3], [2.0, 1.0, 3.0], [3, 2, 2]).jittered(0.3, 6, |_| true);
    let (mut hexahedra, mut conn) = (Vec::new(), Vec::new());
    for (number, cell) in mesh.cells().enumerate() {
        match number % 3 {
            2 => conn.extend([0, 1, 2, 4, 5, 6, 0, 2, 3, 4, 6, 7].map(|k| cell[k])),
            _ => hexahedra.extend_from_slice(cell),
        }
    }
    mesh.conn = hexahedra;
    let cells = Cells { part: 0, cell_type: CellType::Wedge6, conn };
    let mixed = LAWS.map(|law| {
        Model::with_cells(vec![part(CellType::Hex8, mesh.clone(), law)], std::slice::from_ref(&cells)).unwrap()
    });
    assert_eq!((mixed[0].cell_count(), mixed[0].faces_where(0, |_| true).len()), (8 + 8, 2 * 8 + 2 * 4 + 2 * 6));
    assert_eq!(mixed[0].cells(0).filter(|(cell_type, _)| *cell_type == CellType::Wedge6).count(), 8);
    let weight: f64 = mixed[0].body_load(0, [1.0, 0.0, 0.0]).iter().map(|f| f[0]).sum();
    assert!((weight - mixed[0].volume(0)).abs() < 1e-12);
    assert_eq!(mixed[0].surface().unwrap().body_ids(), [0]);
    constant_stress_balances_its_traction(mixed.into());
    let lost = Model::with_cells(vec![part(CellType::Hex8, mesh, Law::NeoHookean)], &[]).unwrap_err();
    assert!(matches!(lost, fmc_solid::fem::Error::UnusedNode { .. }), "{lost}");
}

#[test]
fn constant_stress_balances_its_traction_in_all_elements() {
    constant_stress_balances_its_traction(models(distorted_2d()));
    constant_stress_balances_its_traction(models(distorted_3d()));
}
