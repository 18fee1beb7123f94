//! Bodies that nothing touches.

use crate::scene::{exact, material, part, run};
use fmc_contact::CellType;
use fmc_shapes::{cuboid_tet4, rectangle_quad4};
use fmc_solid::dynamics::{Sample, Setup, Simulation, Step};
use fmc_solid::fem::{Law, Model};

fn block(law: Law) -> Model<3> {
    let mesh = cuboid_tet4([0.0; 3], [1.0, 2.0, 3.0], [2, 2, 3]);
    Model::new(vec![part("block", CellType::Tet4, mesh, material(law, 0.3))]).unwrap()
}

#[test]
fn free_flight_is_uniform() {
    for law in [Law::LinearElastic, Law::NeoHookean] {
        let model = block(law);
        let v = [1.0, -2.0, 0.5];
        let velocity = vec![v; model.node_count()];
        let mut simulation = Simulation::start(Setup { velocity, ..Setup::new(model, exact(1.0, 1.0)) }).unwrap();
        let sample = run(&mut simulation, 50).pop().unwrap();
        let t = sample.time;
        assert_eq!(t, 50.0 * simulation.step_size());
        // 50 additions of Δt v round to 50 × 1e-16 of the way at most, and what that strains is rounding too.
        for u in &simulation.state().displacement {
            assert!((0..3).all(|axis| (u[axis] - v[axis] * t).abs() < 1e-13), "{u:?}");
        }
        assert!((sample.kinetic - 0.5 * 6.0 * 5.25).abs() < 1e-11);
        assert!(sample.strain.abs() < 1e-20 && sample.contact == 0.0 && sample.balance == 0.0);
    }
}

#[test]
fn weight_makes_a_parabola() {
    let model = block(Law::NeoHookean);
    let g = [0.0, 0.0, -9.81];
    let load = model.body_load(0, g); // ρ = 1
    let mut simulation = Simulation::start(Setup { load, ..Setup::new(model, exact(1.0, 1.0)) }).unwrap();
    let samples = run(&mut simulation, 40);
    // u = g t²/2 exactly: the scheme is exact for constant acceleration.
    let last = samples.last().unwrap();
    let fall = 0.5 * g[2] * last.time * last.time;
    assert!(simulation.state().displacement.iter().all(|u| (u[2] - fall).abs() < 1e-12 * fall.abs()));
    // What is gained in kinetic energy is lost in the potential of the load.
    assert!((last.external - 6.0 * g[2].abs() * fall).abs() < 1e-12 * last.kinetic);
    assert!(samples.iter().all(|s| s.total.abs() < 1e-11 * last.kinetic));
}

#[test]
fn damping_takes_energy_only_when_asked() {
    let moving = |damping: f64, step: Step| {
        let mesh = rectangle_quad4([0.0; 2], [1.0, 1.0], [3, 3]);
        let model = Model::new(vec![part("square", CellType::Quad4, mesh, material(Law::NeoHookean, 0.3))]).unwrap();
        // Flies and breathes.
        let velocity = model.coords().iter().map(|x| [1.0 + 0.5 * (x[0] - 0.5), 0.0]).collect();
        Simulation::start(Setup { velocity, damping, step, ..Setup::new(model, exact(1.0, 1.0)) }).unwrap()
    };
    let mut free = moving(0.0, Step::Auto);
    let start = free.sample().total;
    let sample = run(&mut free, 300).pop().unwrap();
    assert_eq!(sample.dissipated, 0.0);
    // The scheme keeps an energy that differs from this one by (ωΔt/2)² of what breathes, some 2 % of the whole.
    assert!((sample.total / start - 1.0).abs() < 0.5 * 0.02, "{}", sample.total / start);

    let rate = 2.0;
    let mut errors = Vec::new();
    for part in [1.0, 0.5] {
        let mut damped = moving(rate, Step::Fixed(part * free.step_size()));
        let samples = run(&mut damped, (300.0 / part) as usize);
        let sample = samples.last().unwrap();
        // The centre of mass feels nothing but −α M v, whose flow is exact.
        let decay = (-rate * sample.time).exp();
        assert!((sample.velocities[0][0] - decay).abs() < 1e-12);
        // Flight loses energy at the rate 2α; what breathes, being kinetic half of the time, at α.
        assert!(sample.total < decay * start && sample.dissipated > 0.5 * start);
        let missing = |s: &Sample<2>| (s.total + s.dissipated - start).abs() / start;
        errors.push(samples.iter().map(missing).fold(0.0, f64::max));
    }
    // What is missing has been dissipated, up to the square of the step.
    assert!(errors[0] < 0.5 * 0.02 && errors[1] < 0.3 * errors[0], "{errors:?}");
}
