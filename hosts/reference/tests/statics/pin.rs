//! A pin in a hole that is larger by a thousandth, pressed aside: conforming contact that spreads.

use crate::scene::{exact, material};
use fmc_contact::{CellType, EnergyLaw};
use fmc_shapes::{Diagonals, Mesh, rectangle_tri3};
use fmc_solid::fem::{Constraints, Model, Part};
use fmc_solid::statics::{Equilibrium, Path, Problem};
use std::f64::consts::TAU;
use std::ops::ControlFlow;

/// A ring of cells that grow outwards as a power of the number of the ring.
fn ring(inner: f64, outer: f64, cells: [usize; 2], power: f64) -> Mesh<2> {
    let flat = rectangle_tri3([0.0, 0.0], [1.0, TAU], cells, Diagonals::Alternating);
    let bent = flat.mapped(|[part, angle]| {
        let r = inner + (outer - inner) * part.powf(power);
        [r * angle.sin(), -r * angle.cos()]
    });
    bent.welded(1e-9)
}

/// Four load steps at either stiffness, of which none is halved.
#[test]
fn no_load_step_fails() {
    let radius = |x: &[f64; 2]| x[0].hypot(x[1]);
    for k in [2e4, 2e5] {
        let part =
            |name: &str, mesh| Part { name: name.into(), cell_type: CellType::Tri3, mesh, material: material(200.0) };
        let plate = part("plate", ring(1.001, 3.0, [12, 90], 1.6));
        let model = Model::new(vec![plate, part("pin", ring(0.3, 1.0, [7, 64], 1.0))]).unwrap();
        let mut supports = Constraints::default();
        supports.fix(model.nodes_where(0, |x| radius(x) > 2.99));
        let bore = model.nodes_where(1, |x| radius(x) < 0.301);
        supports.prescribe(bore.clone(), 0, 0.0);
        supports.prescribe(bore, 1, -0.02);
        let problem = Problem { supports, ..Problem::new(model, exact(EnergyLaw::depth(k))) };
        let mut at = Equilibrium::new(problem).unwrap();
        let path = Path { steps: 4, ..Path::default() };
        at.follow(path, &mut |iteration| {
            println!("{iteration}");
            ControlFlow::Continue(())
        })
        .unwrap();
        println!("k = {k:e}: {} iterations, {} of the contact", at.iterations, at.contact_iterations);
        assert_eq!(at.halvings, 0);
        let force = at.balance().contact.bodies[1].force;
        assert!(force[1] > 1.0 && force[0].abs() < 1e-2 * force[1], "{force:?}");
    }
}
