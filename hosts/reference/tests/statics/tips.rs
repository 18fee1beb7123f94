//! Pointed elastic bodies, ten times as stiff as the block into which they are pressed.

use crate::scene::exact;
use fmc_contact::{CellType, EnergyLaw};
use fmc_shapes::{Diagonals, Mesh, geometric, grid_tri3};
use fmc_solid::fem::{Constraints, Law, Material, Model, Part};
use fmc_solid::statics::{Equilibrium, Iteration, Problem};
use std::ops::ControlFlow;

/// Height of the tip.
const HEIGHT: f64 = 0.8;

/// A triangle on its corner, its cells a hundredth as large there as at its upper side.
fn tip(half_angle: f64) -> Mesh<2> {
    let rows = 18u32;
    let slope = half_angle.to_radians().tan();
    let (mut coords, mut conn) = (Vec::new(), Vec::new());
    for row in 0..=rows {
        let y = HEIGHT * (f64::from(row) / f64::from(rows)).powf(1.5);
        let x = |k: u32| slope * y * if row == 0 { 0.0 } else { 2.0 * f64::from(k) / f64::from(row) - 1.0 };
        coords.extend((0..=row).map(|k| [x(k), y]));
    }
    for row in 0..rows {
        let first = row * (row + 1) / 2;
        let above = first + row + 1;
        conn.extend((0..=row).flat_map(|k| [first + k, above + k + 1, above + k]));
        conn.extend((0..row).flat_map(|k| [first + k, first + k + 1, above + k + 1]));
    }
    Mesh { coords, conn, nodes_per_cell: 3 }
}

/// A block 2 wide and 1 high under the tip, whose corner meets the face between two nodes.
fn block() -> Mesh<2> {
    let aside = |to: f64| geometric(0.0137, to, 14, 20.0);
    let mut x: Vec<f64> = aside(-1.0).into_iter().skip(1).rev().collect();
    x.extend(aside(1.0));
    let y: Vec<f64> = geometric(0.0, -1.0, 14, 20.0).into_iter().rev().collect();
    grid_tri3([&x, &y], Diagonals::Alternating)
}

/// Stages from a depth of 0.03 to 0.1 with k = 1e5 = 200 E / m, then to k = 1e7. The force at the end of each of the last
/// three, as far as they have been reached.
fn pressed(half_angle: f64, law: Law) -> Vec<f64> {
    let part = |name: &str, mesh: Mesh<2>, young: f64| {
        let material = Material { law, young, poisson: 0.3, density: 1.0 };
        Part { name: name.into(), cell_type: CellType::Tri3, mesh, material }
    };
    let model = Model::new(vec![part("block", block(), 500.0), part("tip", tip(half_angle), 5000.0)]).unwrap();
    let foot = model.nodes_where(0, |x| x[1] < -1.0 + 1e-9);
    let head = model.nodes_where(1, |x| x[1] > HEIGHT - 1e-9);
    let supports = |down: f64| {
        let mut supports = Constraints::default();
        supports.fix(foot.clone());
        supports.prescribe(head.clone(), 0, 0.0);
        supports.prescribe(head.clone(), 1, -down);
        supports
    };
    let start = Problem { supports: supports(0.03), ..Problem::new(model, exact(EnergyLaw::depth(1e5))) };
    let mut at = Equilibrium::new(start).unwrap();
    let mut forces = Vec::new();
    for (stage, (down, k)) in [(0.03, 1e5), (0.06, 1e5), (0.1, 1e5), (0.1, 1e6), (0.1, 1e7)].into_iter().enumerate() {
        at.set_law(EnergyLaw::depth(k)).unwrap();
        at.next_stage(supports(down)).unwrap();
        let before = at.iterations;
        let end = at.follow(Default::default(), &mut |_: &Iteration| ControlFlow::Continue(()));
        let force = at.balance().contact.bodies[1].force[1];
        println!(
            "{half_angle} {law:?} k {k:.0e} {down}: {} iterations, F = {force:.4} {end:?}",
            at.iterations - before
        );
        if end.is_err() {
            break;
        }
        if stage >= 2 {
            forces.push(force);
        }
    }
    forces
}

#[test]
fn a_right_angled_tip_is_pressed_to_hard_contact() {
    for law in [Law::LinearElastic, Law::NeoHookean] {
        let forces = pressed(45.0, law);
        assert_eq!(forces.len(), 3, "stages reached");
        // That of hard contact.
        assert!((forces[1] / forces[2] - 1.0).abs() < 0.01, "{forces:?}");
    }
}
