//! Two blocks, one on the other, under uniform pressure: the stress is uniform whatever the meshes.

use crate::scene::{exact, lines, part, solved};
use fmc_contact::{CellType, EnergyLaw, Options};
use fmc_reference::fem::{Constraints, Model};
use fmc_reference::statics::Problem;
use fmc_shapes::{Diagonals, Mesh, cuboid_hex8, cuboid_tet4, rectangle_quad4, rectangle_tri3};

const PRESSURE: f64 = 1.0;

/// Largest |σ_nn + p|/p, with the normal along the last axis.
fn stress_error<const D: usize>(cell: CellType, meshes: [Mesh<D>; 2], contact: Options) -> f64 {
    let [lower, upper] = meshes;
    let top = upper.coords.iter().map(|x| x[D - 1]).fold(0.0, f64::max);
    let model = Model::new(vec![part("lower", cell, lower), part("upper", cell, upper)]).unwrap();
    let mut supports = Constraints::default();
    for body in 0..2 {
        for axis in 0..D - 1 {
            supports.prescribe(model.nodes_where(body, |x| x[axis].abs() < 1e-9), axis, 0.0);
        }
    }
    supports.prescribe(model.nodes_where(0, |x| x[D - 1].abs() < 1e-9), D - 1, 0.0);
    let load = model.surface_load(&model.faces_where(1, |x| x[D - 1] > top - 1e-9), |_, n| n.map(|n| -PRESSURE * n));
    let (at, _) = solved(Problem { supports, load, ..Problem::new(model, contact) });
    at.model()
        .stresses(at.displacement())
        .iter()
        .map(|stress| (stress.0[D - 1] + PRESSURE).abs() / PRESSURE)
        .fold(0.0, f64::max)
}

fn plane(cell: CellType) -> [Mesh<2>; 2] {
    let block = |bottom: f64, n: usize| {
        let (min, max) = ([0.0, bottom], [1.0, bottom + 0.5]);
        match cell {
            CellType::Quad4 => rectangle_quad4(min, max, [n, n / 2]),
            _ => rectangle_tri3(min, max, [n, n / 2], Diagonals::Alternating),
        }
    };
    [block(0.0, 10).skewed(0.2), block(0.5, 7).skewed(-0.15)]
}

fn solid(cell: CellType) -> [Mesh<3>; 2] {
    let block = |bottom: f64, n: usize| {
        let (min, max) = ([0.0, 0.0, bottom], [1.0, 1.0, bottom + 0.5]);
        match cell {
            CellType::Hex8 => cuboid_hex8(min, max, [n, n, n / 2]),
            _ => cuboid_tet4(min, max, [n, n, n / 2]),
        }
    };
    [block(0.0, 5).skewed(0.2), block(0.5, 4).skewed(-0.15)]
}

#[test]
fn blocks_in_2d_exactly() {
    for cell in [CellType::Tri3, CellType::Quad4] {
        let error = stress_error(cell, plane(cell), exact(EnergyLaw::fiber(2e5)));
        println!("{cell:?} {error:.2e}");
        assert!(error < 1e-9, "{cell:?}: {error}");
    }
}

#[test]
fn blocks_in_2d_with_16_lines_a_facet() {
    for cell in [CellType::Tri3, CellType::Quad4] {
        let error = stress_error(cell, plane(cell), lines(EnergyLaw::fiber(2e5), 0.1 / 16.0));
        println!("{cell:?} {error:.2e}");
        assert!(error < 5e-3, "{cell:?}: {error}");
    }
}

#[test]
fn blocks_in_3d_exactly() {
    for cell in [CellType::Tet4, CellType::Hex8] {
        let error = stress_error(cell, solid(cell), exact(EnergyLaw::fiber(2e5)));
        println!("{cell:?} {error:.2e}");
        assert!(error < 1e-9, "{cell:?}: {error}");
    }
}

#[test]
fn blocks_in_3d_with_16_lines_a_facet() {
    for cell in [CellType::Tet4, CellType::Hex8] {
        let error = stress_error(cell, solid(cell), lines(EnergyLaw::fiber(2e5), 0.2 / 4.0));
        println!("{cell:?} {error:.2e}");
        assert!(error < 5e-3, "{cell:?}: {error}");
    }
}
