//! Sections against the bodies that they sweep, in 3D.

use crate::depth;
use crate::scene::Scene;
use fmc_contact::Options;
use fmc_shapes::{Mesh, rectangle_quad4};
use std::f64::consts::TAU;

const SECTORS: usize = 96;

/// The ring that a section of quadrilaterals sweeps, in sectors.
fn revolved(section: &Mesh<2>) -> Mesh<3> {
    let count = section.coords.len() as u32;
    let of_sector = |sector: usize| {
        let angle = TAU * sector as f64 / SECTORS as f64;
        section.coords.iter().map(move |[r, z]| [r * angle.cos(), r * angle.sin(), *z])
    };
    let coords = (0..SECTORS).flat_map(of_sector).collect();
    let mut conn = Vec::new();
    for sector in 0..SECTORS as u32 {
        let next = (sector + 1) % SECTORS as u32;
        for cell in section.cells() {
            // Seen from the next sector, (r, z) turn the other way.
            conn.extend(cell.iter().map(|node| next * count + node));
            conn.extend(cell.iter().map(|node| sector * count + node));
        }
    }
    Mesh { coords, conn, nodes_per_cell: 8 }
}

/// A ring with an inclined foot on another: forces of the sections by those of the 3D meshes, whose polygons have an area
/// that is less by (2π/n)²/6 and whose radial forces point along the bisectors of their sides.
#[test]
fn rings_against_their_solids() {
    let lower = rectangle_quad4([0.5, -0.6], [1.6, 0.0], [7, 4]);
    let upper = rectangle_quad4([0.8, 0.0], [1.3, 0.5], [4, 4]).mapped(|[r, z]| [r, z + 0.2 * (r - 1.0) - 0.05]);
    let flat = Scene::of(&[&lower, &upper]).evaluate(depth(100.0));
    let solid = Options { axisymmetric: false, ..depth(100.0) };
    let round = Scene::of(&[&revolved(&lower), &revolved(&upper)]).evaluate(solid);
    let near = |found: f64, expected: f64| {
        assert!((found / expected - 1.0).abs() < 3e-3, "{found} against {expected}");
    };
    near(flat.energy, round.energy);
    near(flat.volume, round.volume);
    near(flat.contact_area, round.contact_area);
    near(flat.bodies[1].force[1], round.bodies[1].force[2]);
    let counts = [lower.coords.len(), upper.coords.len()];
    let largest = flat.forces.iter().flatten().fold(0.0f64, |m, f| m.max(f.abs()));
    for body in 0..2 {
        for node in 0..counts[body] {
            let mut sum = [0.0; 2];
            for sector in 0..SECTORS {
                let angle = TAU * sector as f64 / SECTORS as f64;
                let f = round.forces[body * counts[0] * SECTORS + sector * counts[body] + node];
                sum[0] += f[0] * angle.cos() + f[1] * angle.sin();
                sum[1] += f[2];
            }
            let found = flat.forces[body * counts[0] + node];
            let off = (0..2).map(|i| (found[i] - sum[i]).abs()).fold(0.0, f64::max);
            assert!(off < 4e-3 * largest, "{found:?} against {sum:?} of {largest}");
        }
    }
}
