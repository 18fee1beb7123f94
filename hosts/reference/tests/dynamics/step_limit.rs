//! The stable step, against where the scheme does become unstable.

use crate::scene::{depth, exact, material, part, run, tip_on_block};
use fmc_contact::{CellType, EnergyLaw};
use fmc_shapes::rectangle_quad4;
use fmc_solid::dynamics::{DynamicsError, Setup, Simulation, Step};
use fmc_solid::fem::{Constraints, Law, Model};

/// Two unit cells, the upper one 0.1 deep in the lower one, each moving as one along y only: lower held, upper of mass 1.
/// Material so soft that the contact decides.
fn resting(k: f64, step: Step) -> Setup<2> {
    let soft = |name: &str, y: f64| {
        let mesh = rectangle_quad4([0.0, y], [1.0, 1.0 + y], [1, 1]);
        let mut material = material(Law::LinearElastic, 0.0);
        material.young = 1e-9;
        part(name, CellType::Quad4, mesh, material)
    };
    let model = Model::new(vec![soft("lower", 0.0), soft("upper", 0.9)]).unwrap();
    let mut supports = Constraints::default();
    supports.fix(model.nodes_of(0));
    supports.prescribe(model.nodes_of(1), 0, 0.0);
    // The traction 2kV = 0.2 k is held by a dead load: equilibrium. A small velocity shows whether it is stable.
    let mut load = vec![[0.0; 2]; 8];
    let mut velocity = vec![[0.0; 2]; 8];
    for node in model.nodes_of(1) {
        velocity[node] = [0.0, 1e-6];
        if model.coords()[node][1] < 1.0 {
            load[node] = [0.0, -0.1 * k];
        }
    }
    Setup { supports, load, velocity, step, check_every: 0, ..Setup::new(model, exact(k, 2.0)) }
}

#[test]
fn contact_limit_is_where_stability_ends() {
    // V = 1 · (0.1 − y) for the two lower nodes of the upper cell, each of mass 1/4, ∂V/∂y = −½ each:
    // ω² = 2k (¼/¼ + ¼/¼) = 4k.
    let k = 50.0;
    let limit = 2.0 / (4.0f64 * k).sqrt();
    let simulation = Simulation::start(resting(k, Step::Fixed(0.5 * limit))).unwrap();
    assert!((simulation.limit().step() / limit - 1.0).abs() < 1e-6, "{}", simulation.limit());
    let growth = |part: f64| {
        let mut setup = resting(k, Step::Fixed(0.5 * limit));
        setup.step = Step::Fixed(part * limit);
        let mut simulation = Simulation::start(setup)?;
        let samples = run(&mut simulation, 400);
        Ok::<f64, DynamicsError>(samples.iter().map(|s| s.kinetic).fold(0.0, f64::max) / samples[0].kinetic)
    };
    assert!(growth(0.99).unwrap() < 100.0);
    // A step beyond it is refused, and the message names who sets the limit.
    let refused = growth(1.01).unwrap_err();
    assert!(matches!(refused, DynamicsError::StepTooLarge { .. }));
    assert!(refused.to_string().contains("contact alone: 1.4142e-1"), "{refused}");
}

#[test]
fn fiber_law_limit_is_known_beforehand() {
    // Two squares of one soft cell each, moving along y only, pressed onto one another by dead loads. Where both faces move
    // as a whole, ω² = 2k A/m = 2k ½/¼ = 4k. The bound takes the corners, to which half of a side wall belongs too:
    // 2k (½ + ½)/¼ = 8k.
    let k = 50.0;
    let fiber = |step: f64| {
        let mut setup = resting(k, Step::Fixed(step));
        setup.contact.law = EnergyLaw::fiber(k);
        setup.supports = Constraints::default();
        setup.supports.prescribe(0..8, 0, 0.0);
        setup.load = vec![[0.0; 2]; 8];
        // 0.1 deep: the traction 0.1 k over the width of 1, on the nodes of the faces in contact.
        for (node, x) in setup.model.coords().iter().enumerate() {
            setup.load[node] = match x[1] {
                1.0 => [0.0, 0.05 * k],
                0.9 => [0.0, -0.05 * k],
                _ => [0.0; 2],
            };
        }
        Simulation::start(setup)
    };
    let bound = 2.0 / (8.0 * k).sqrt();
    let simulation = fiber(0.5 * bound).unwrap();
    assert!((simulation.limit().step() / bound - 1.0).abs() < 1e-6, "{}", simulation.limit());
    let refused = fiber(1.01 * bound).err().unwrap();
    assert!(refused.to_string().contains("contact alone: 1.0000e-1"), "{refused}");
    let mut simulation = fiber(0.99 * bound).unwrap();
    let samples = run(&mut simulation, 400);
    let largest = samples.iter().map(|s| s.kinetic).fold(0.0, f64::max);
    assert!(largest < 1e-10, "{largest}"); // it starts with 2 × ½ (1e-6)² and lines are laid to some 1e-3
}

#[test]
fn depth_law_limit_is_known_beforehand() {
    // As with the fiber law, 8k before the squares meet. Where they lie in one another the tangent may say more.
    let k = 50.0;
    let squares = |gap: f64, step: f64| {
        let mut setup = resting(k, Step::Fixed(step));
        setup.contact = depth(k);
        setup.load = vec![[0.0; 2]; 8];
        let model = setup.model;
        let mut parts = model.parts().to_vec();
        parts[1].mesh = parts[1].mesh.clone().translated([0.0, gap]);
        setup.model = Model::new(parts).unwrap();
        Simulation::start(setup)
    };
    let bound = 2.0 / (8.0 * k).sqrt();
    let apart = squares(0.2, 0.5 * bound).unwrap().limit().step();
    assert!((apart / bound - 1.0).abs() < 1e-6, "{apart} {bound}");
    let refused = squares(0.2, 1.01 * bound).err().unwrap();
    assert!(refused.to_string().contains("contact alone: 1.0000e-1"), "{refused}");
    let together = squares(0.0, 0.5 * bound).unwrap().limit().step();
    assert!(together <= apart && together > 0.5 * apart, "{together} {apart}");
}

#[test]
fn structural_limit_is_where_stability_ends() {
    let step = |step: Step| Simulation::start(tip_on_block(exact(1e-3, 2.0), step));
    let limit = step(Step::Auto).unwrap().limit();
    let stable = limit.step();
    assert!((step(Step::Auto).unwrap().step_size() / (0.9 * stable) - 1.0).abs() < 1e-12);
    let refused = step(Step::Fixed(1.01 * stable)).err().unwrap();
    assert!(refused.to_string().contains("exceeds the limit of") && refused.to_string().contains("structure alone"));
    assert!(step(Step::Fixed(0.99 * stable)).is_ok());
}

#[test]
fn jumping_force_has_no_limit_and_says_so() {
    let simulation = Simulation::start(tip_on_block(exact(1e3, 1.0), Step::Auto)).unwrap();
    assert_eq!(simulation.limit().contact, None);
    assert!(simulation.limit().to_string().contains("jumps"), "{}", simulation.limit());
}

#[test]
fn step_that_comes_to_exceed_the_limit_is_told() {
    // Before the bodies meet nothing speaks against this step; the contact is stiff.
    let quiet = Simulation::start(tip_on_block(exact(1e-3, 2.0), Step::Auto)).unwrap();
    let setup = Setup { check_every: 1, ..tip_on_block(exact(3e7, 2.0), Step::Fixed(quiet.step_size())) };
    let mut simulation = Simulation::start(setup).unwrap();
    let told = (0..100).find_map(|_| simulation.advance().ok()?.warnings.into_iter().find(|w| w.contains("exceeds")));
    assert!(told.is_some_and(|warning| warning.contains("contact alone")));
}
