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
                Law::LinearElastic | Law::PlaneStress => 2.0 * shear * (s - 1.0),
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

/// Stretched along x alone a plate has σ_xx = E/(1 − ν²) ε, σ_yy = ν σ_xx and σ_zz = 0, and its nodes feel it. In space there is none.
#[test]
fn plates_have_plane_stress() {
    let mesh = rectangle_quad4([0.0; 2], [2.0, 1.0], [4, 3]);
    let model = Model::new(vec![part(CellType::Quad4, mesh, Law::PlaneStress)]).unwrap();
    let displacement = homogeneous(&model, [[0.01, 0.0], [0.0, 0.0]]);
    let expected = 100.0 / 0.91 * 0.01;
    for stress in model.stresses(&displacement) {
        let [xx, yy, zz, ..] = stress.0;
        assert!((xx - expected).abs() < 1e-13 && (yy - 0.3 * expected).abs() < 1e-13 && zz == 0.0);
    }
    let mut force = vec![[0.0; 2]; model.node_count()];
    let energy = model.internal(&displacement, &mut force);
    let right: f64 = model.nodes_where(0, |x| x[0] == 2.0).into_iter().map(|node| force[node][0]).sum();
    assert!((right - expected).abs() < 1e-13 && (energy - expected * 0.01).abs() < 1e-14);
    let space = part(CellType::Hex8, cuboid_hex8([0.0; 3], [1.0; 3], [1; 3]), Law::PlaneStress);
    assert_eq!(Model::new(vec![space]).unwrap_err(), fmc_solid::fem::Error::PlaneStress { part: "Hex8".into() });
}
