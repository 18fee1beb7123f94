//! One degree of freedom, where the scheme's frequency is known in closed form.

use crate::scene::{exact, material, part};
use fmc_contact::CellType;
use fmc_shapes::rectangle_quad4;
use fmc_solid::dynamics::{DynamicsError, Setup, Simulation, Step};
use fmc_solid::fem::{Constraints, Law, Model};

/// One linear elastic cell, ν = 0, held at its left, its right side moving along x only, at velocity 1 from rest: a
/// spring of stiffness E (unit height and length) and the mass ρ/2.
fn oscillator(step: f64) -> Result<Simulation<2>, DynamicsError> {
    let mesh = rectangle_quad4([0.0; 2], [1.0, 1.0], [1, 1]);
    let model = Model::new(vec![part("spring", CellType::Quad4, mesh, material(Law::LinearElastic, 0.0))]).unwrap();
    let mut supports = Constraints::default();
    supports.fix(model.nodes_where(0, |x| x[0] == 0.0));
    supports.prescribe(model.nodes_where(0, |x| x[0] == 1.0), 1, 0.0);
    // Nodes that are held do not take the velocity.
    let velocity = vec![[1.0, 1.0]; 4];
    Simulation::start(Setup {
        supports,
        velocity,
        step: Step::Fixed(step),
        check_every: 0,
        ..Setup::new(model, exact(1.0, 1.0))
    })
}

#[test]
fn period_is_that_of_the_scheme() {
    let omega = (1000.0f64 / 0.5).sqrt();
    for part in [0.1, 0.5, 0.9] {
        let step = part / omega;
        let mut simulation = oscillator(step).unwrap();
        // x(n) = A sin(n φ) with cos φ = 1 − (ωΔt)²/2, and A sin φ = Δt v0 from the first step.
        let phase = (1.0 - 0.5 * part * part).acos();
        let amplitude = step / phase.sin();
        for n in 1..=400 {
            let sample = simulation.advance().unwrap();
            let x = simulation.state().displacement[1][0];
            assert!((x - amplitude * (n as f64 * phase).sin()).abs() < 1e-12 * amplitude * n as f64, "step {n}: {x}");
            // v(n) = v0 cos(n φ), synchronous with x.
            let kinetic = 0.25 * (n as f64 * phase).cos().powi(2);
            assert!((sample.kinetic - kinetic).abs() < 1e-12 * n as f64);
        }
    }
}
