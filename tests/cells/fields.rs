//! What is handed out beside forces, and friction, on cells of every type.

use crate::scene::{Scene, cross, size_sum, table::exactly};
use crate::{boxes, pair};
use fmc_contact::contact::Friction;
use fmc_contact::overlap::Partner;
use fmc_contact::{EnergyLaw, Options};

const DELTA: f64 = 1e-3;

/// A block on a larger one, each of every type on one of another.
fn scenes() -> impl Iterator<Item = Scene<3>> {
    let lower = boxes([-0.5, -0.5, -1.0], [1.5, 1.5, 0.0], [3, 3, 3]);
    let upper = boxes([0.0, 0.0, -DELTA], [1.0, 1.0, 1.0 - DELTA], [2, 2, 3]);
    (0..lower.len()).map(move |k| pair(&lower[k], &upper[(k + 3) % upper.len()]))
}

/// Each side's nodes and shape functions give back where it is, and pressures the force.
#[test]
fn contact_points() {
    for scene in scenes() {
        for law in [EnergyLaw::depth(1e3), EnergyLaw::fiber(1e3)] {
            let contact = scene.contact(exactly(law));
            let points = contact.contact_points(&scene.coords).expect("points");
            let mut force = 0.0;
            for point in &points {
                force += point.pressure * point.area * point.normal[2].abs() * if law.is_fiber() { 1.0 } else { 0.0 };
                for (side, partner) in point.sides.iter().zip(point.partners) {
                    assert!(matches!(partner, Partner::Body(_)));
                    let (nodes, weights) = (&side.nodes[..side.node_count], &side.weights[..side.node_count]);
                    if nodes.is_empty() {
                        continue;
                    }
                    assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-12);
                    let at = |i: usize| -> f64 {
                        nodes.iter().zip(weights).map(|(&n, w)| w * scene.coords[n as usize][i]).sum()
                    };
                    assert!((0..3).all(|i| (at(i) - side.position[i]).abs() < 1e-12));
                }
            }
            let whole = contact.evaluate(&scene.coords).expect("forces").bodies[1].force[2];
            assert!(!points.is_empty() && (!law.is_fiber() || (force / whole - 1.0).abs() < 1e-9), "{force} {whole}");
        }
    }
}

/// ∫ N dA over the upper block's face is its area, the pressure there k δ.
#[test]
fn nodal_areas_and_pressures() {
    for scene in scenes() {
        for law in [EnergyLaw::depth(1e3), EnergyLaw::fiber(1e3)] {
            let nodal = scene.contact(exactly(law)).nodal_contact(&scene.coords).expect("fields");
            let face = scene.nodes_of(1).filter(|&n| nodal.area[n] > 0.1 * DELTA && scene.coords[n][2] < 0.0);
            let (mut area, mut load) = (0.0, 0.0);
            face.for_each(|n| {
                area += nodal.area[n];
                load += nodal.area[n] * nodal.pressure[n];
            });
            // Walls are sunk in by δ, and count with the law `depth`: 4 δ of area, of half the pressure or less.
            assert!((area - 1.0).abs() < 5.0 * DELTA, "{law:?}: {area}");
            assert!((load / (1e3 * DELTA) - 1.0).abs() < 2e-2, "{law:?}: {load}");
        }
    }
}

/// A block that slides has μ times its load against it; forces and moments balance.
#[test]
fn friction() {
    for scene in scenes() {
        for law in [EnergyLaw::depth(1e3), EnergyLaw::fiber(1e3)] {
            let mut contact = scene.contact(Options { friction: Friction::coulomb(0.3), ..exactly(law) });
            contact.begin_step(&scene.coords).expect("a step");
            let mut coords = scene.coords.clone();
            scene.nodes_of(1).for_each(|n| coords[n][0] += 0.02);
            let found = contact.evaluate(&coords).expect("forces");
            let [along, load] = [found.bodies[1].force[0], found.bodies[1].force[2]];
            assert!((along / load + 0.3).abs() < 3e-3, "{law:?}: {along} of {load}");
            let sizes = size_sum(&found.forces);
            for i in 0..3 {
                let force: f64 = found.forces.iter().map(|f| f[i]).sum();
                let moment: f64 = coords.iter().zip(&found.forces).map(|(x, f)| cross(x, f)[i]).sum();
                assert!(force.abs() < 1e-12 * sizes && moment.abs() < 1e-12 * sizes, "{law:?}: {force} {moment}");
            }
        }
    }
}
