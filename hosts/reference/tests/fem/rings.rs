//! Bodies of revolution.

use crate::{LAWS, material, part};
use fmc_contact::CellType;
use fmc_shapes::{Splitmix, rectangle_quad4};
use fmc_solid::fem::{Law, Model};
use std::f64::consts::PI;

fn rings(law: Law) -> Model<2> {
    let mesh = rectangle_quad4([0.5, -1.0], [2.0, 3.0], [3, 2]);
    Model::axisymmetric(vec![part(CellType::Quad4, mesh, law)], &[]).unwrap()
}

/// Volume, surface load and weight are those of a ring: to rounding, since the Gauss points meet r exactly.
#[test]
fn measures_are_those_of_a_ring() {
    let model = rings(Law::LinearElastic);
    assert!(model.is_axisymmetric());
    let volume = PI * (4.0 - 0.25) * 4.0;
    assert!((model.volume(0) - volume).abs() < 1e-12 * volume);
    let sum = |load: Vec<[f64; 2]>, axis: usize| load.iter().map(|f| f[axis]).sum::<f64>();
    assert!((sum(model.body_load(0, [0.0, 3.0]), 1) - 3.0 * volume).abs() < 1e-12 * volume);
    let top = model.faces_where(0, |x| x[1] == 3.0);
    let pressed = model.surface_load(&top, |_, normal| *normal);
    assert!((sum(pressed, 1) - PI * (4.0 - 0.25)).abs() < 1e-12 * volume);
}

/// Forces are the gradient of the energy, and tangents and products that of the forces: central differences with an error of 1e-9 of the stiffness.
#[test]
fn forces_and_tangents_are_derivatives() {
    let mut random = Splitmix::new(5);
    for law in LAWS {
        let model = rings(law);
        let count = model.node_count();
        let mut field = |size: f64| -> Vec<[f64; 2]> {
            (0..count).map(|_| std::array::from_fn(|_| random.between(-size, size))).collect()
        };
        let (u, du) = (field(0.1), field(1.0));
        let moved = |step: f64| -> Vec<[f64; 2]> {
            u.iter().zip(&du).map(|(u, d)| std::array::from_fn(|k| u[k] + step * d[k])).collect()
        };
        let at = |u: &[[f64; 2]]| {
            let mut force = vec![[0.0; 2]; count];
            let energy = model.internal(u, &mut force);
            (energy, force)
        };
        let step = 1e-5;
        let ((more, ahead), (less, behind), (_, force)) = (at(&moved(step)), at(&moved(-step)), at(&u));
        let power: f64 = force.as_flattened().iter().zip(du.as_flattened()).map(|(f, d)| f * d).sum();
        let scale = material(law).young * 4.0 * PI;
        assert!((power - (more - less) / (2.0 * step)).abs() < 1e-6 * scale, "{law:?}");
        let mut product = vec![[0.0; 2]; count];
        model.stiffness_product(&u, &du, &mut product);
        let by_tangent = model.tangent(&u).product(du.as_flattened());
        for k in 0..2 * count {
            let difference = (ahead.as_flattened()[k] - behind.as_flattened()[k]) / (2.0 * step);
            assert!((product.as_flattened()[k] - difference).abs() < 1e-6 * scale, "{law:?} {k}");
            assert!((product.as_flattened()[k] - by_tangent[k]).abs() < 1e-11 * scale, "{law:?} {k}");
        }
    }
}

/// u = (s − 1)(r, z) is the dilation of space: the pressure K (s³ − 1) of the neo-Hookean solid, and 3K (s − 1) of Hooke's, without shear.
#[test]
fn dilation_is_that_of_space() {
    for law in LAWS {
        let model = rings(law);
        let s = 1.1f64;
        let u: Vec<[f64; 2]> = model.coords().iter().map(|x| x.map(|x| (s - 1.0) * x)).collect();
        let bulk = material(law).bulk_modulus();
        let expected = if law == Law::NeoHookean { bulk * (s.powi(3) - 1.0) } else { 3.0 * bulk * (s - 1.0) };
        for stress in model.point_stresses(&u) {
            let [rr, zz, hoop, rz, ..] = stress.0;
            assert!(
                [rr, zz, hoop].iter().all(|p| (p - expected).abs() < 1e-12 * bulk) && rz.abs() < 1e-12 * bulk,
                "{stress:?}"
            );
        }
    }
}

#[test]
fn a_cell_across_the_axis_is_refused() {
    let mesh = rectangle_quad4([-2.0, 0.0], [1.0, 1.0], [1, 1]);
    assert!(Model::axisymmetric(vec![part(CellType::Quad4, mesh, Law::LinearElastic)], &[]).is_err());
}
