//! Von Mises stress and the stress out of the plane.

use crate::{LAWS, homogeneous, material, part};
use fmc_contact::CellType;
use fmc_shapes::{Mesh, cuboid_hex8, rectangle_quad4};
use fmc_solid::fem::{Law, Model, Stress};

/// Stretch s along x, nothing else moves. Hooke: σ_xx − σ_zz = 2μ (s − 1). Neo-Hookean: σ = (a F Fᵀ + b J I)/J, so
/// σ_xx − σ_zz = G s^(−5/3) (s² − 1). In both σ_yy = σ_zz, and the difference is von Mises' stress.
fn uniaxial_strain<const D: usize>(cell_type: CellType, mesh: Mesh<D>) {
    for law in LAWS {
        let model = Model::new(vec![part(cell_type, mesh.clone(), law)]).unwrap();
        for s in [0.6f64, 1.0 + 1e-6, 1.5] {
            let mut h = [[0.0; D]; D];
            h[0][0] = s - 1.0;
            let shear = material(law).shear_modulus();
            let expected = match law {
                Law::LinearElastic => 2.0 * shear * (s - 1.0),
                Law::NeoHookean => shear * s.powf(-5.0 / 3.0) * (s * s - 1.0),
            };
            for stress in model.stresses(&homogeneous(&model, h)) {
                let [xx, yy, zz, ..] = stress.0;
                assert!((xx - zz - expected).abs() < 1e-13 * 100.0 && (yy - zz).abs() < 1e-13 * 100.0);
                assert!((stress.von_mises() - expected.abs()).abs() < 1e-13 * 100.0);
            }
        }
    }
}

#[test]
fn uniaxial_strain_has_its_von_mises_stress() {
    uniaxial_strain(CellType::Quad4, rectangle_quad4([0.0; 2], [1.0, 2.0], [2, 2]));
    uniaxial_strain(CellType::Hex8, cuboid_hex8([0.0; 3], [1.0, 2.0, 1.0], [2; 3]));
}

#[test]
fn pure_shear_and_pressure() {
    assert_eq!(Stress([-3.0, -3.0, -3.0, 0.0, 0.0, 0.0]).von_mises(), 0.0);
    for shear in 3..6 {
        let mut stress = Stress::default();
        stress.0[shear] = -2.0;
        assert!((stress.von_mises() - 2.0 * 3f64.sqrt()).abs() < 1e-15);
    }
}
