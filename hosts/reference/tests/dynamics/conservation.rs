//! What an impact must keep.

use crate::scene::{depth, exact, run, tip_on_block};
use fmc_contact::{EnergyLaw, Estimator, FiberOptions, Options, Resolution};
use fmc_solid::dynamics::{Sample, Setup, Simulation, Step};

const K: f64 = 1e6;
const STEP: f64 = 1.2e-3;

fn fibers(spacing: f64) -> Options {
    let fibers = FiberOptions { resolution: Resolution::Spacing(spacing), ..FiberOptions::default() };
    Options { estimator: Estimator::Fibers(fibers), ..Options::new(EnergyLaw::Volume { stiffness: K, exponent: 2.0 }) }
}

fn largest_error(samples: &[Sample<2>]) -> f64 {
    samples.iter().map(|s| (s.total / samples[0].total - 1.0).abs()).fold(0.0, f64::max)
}

#[test]
fn energy_error_falls_with_the_square_of_the_step() {
    let error = |halvings: i32| {
        let step = STEP * 0.5f64.powi(halvings);
        let mut simulation = Simulation::start(tip_on_block(exact(K, 2.0), Step::Fixed(step))).unwrap();
        let samples = run(&mut simulation, 200 << halvings);
        assert!(samples.iter().any(|s| s.contact > 0.05 * s.total), "they do not meet");
        largest_error(&samples)
    };
    let errors = [error(1), error(2), error(3)];
    let slope = (errors[0] / errors[2]).log2() / 2.0;
    assert!((slope - 2.0).abs() < 0.15, "slope {slope}, errors {errors:?}");
}

/// The force of the depth law has no step, over corners and mesh lines: what the energy swings by is the scheme's alone, here
/// at 0.97 of the stable step.
#[test]
fn the_depth_law_keeps_energy_with_one_evaluation_a_step() {
    let error = |options: Options| {
        let mut simulation = Simulation::start(tip_on_block(options, Step::Fixed(STEP))).unwrap();
        let samples = run(&mut simulation, 200);
        assert!(samples.iter().any(|s| s.contact > 0.02 * s.total), "they do not meet");
        largest_error(&samples)
    };
    let [depth, volume] = [depth(4e4), exact(K, 2.0)].map(error);
    println!("depth {depth:.1e}, volume {volume:.1e}");
    assert!(depth < 5e-4 && depth < 0.5 * volume, "depth {depth:e}, volume {volume:e}");
}

#[test]
fn momentum_is_kept_without_supports() {
    for options in [exact(K, 2.0), exact(2000.0, 1.0), fibers(1e-3), depth(4e4)] {
        let mut simulation = Simulation::start(tip_on_block(options, Step::Fixed(0.5 * STEP))).unwrap();
        let momentum = |simulation: &Simulation<2>, sample: &Sample<2>| -> [f64; 2] {
            std::array::from_fn(|axis| {
                (0..2).map(|part| simulation.part_mass(part) * sample.velocities[part][axis]).sum()
            })
        };
        let start = momentum(&simulation, &simulation.sample());
        let samples = run(&mut simulation, 400);
        let peak = samples.iter().map(|s| s.bodies[1][1]).fold(0.0, f64::max);
        assert!(peak > 1.0);
        let size = start[1].abs();
        for sample in &samples {
            let now = momentum(&simulation, sample);
            assert!((0..2).all(|axis| (now[axis] - start[axis]).abs() < 1e-12 * size), "{now:?} {start:?}");
            assert!(sample.balance < 1e-12 * peak, "{} of {peak}", sample.balance);
        }
    }
}

#[test]
fn motion_can_be_turned_round() {
    let mut simulation = Simulation::start(tip_on_block(exact(K, 2.0), Step::Fixed(STEP))).unwrap();
    let start = simulation.state().clone();
    let samples = run(&mut simulation, 100);
    assert!(samples.iter().filter(|s| s.overlap > 0.0).count() > 30, "they hardly meet");
    simulation.reverse();
    run(&mut simulation, 100);
    let error = simulation.state().displacement.iter().flatten().map(|u| u.abs()).fold(0.0, f64::max);
    assert!(error < 1e-9, "{error}");
    for (v, start) in simulation.state().velocity.iter().flatten().zip(start.velocity.iter().flatten()) {
        assert!((v + start).abs() < 1e-7 * 3.0, "{v} {start}");
    }
}

#[test]
fn contact_substeps_resolve_a_force_that_jumps() {
    let left_over = |contact_substeps: u32| {
        let setup = Setup { contact_substeps, ..tip_on_block(exact(2000.0, 1.0), Step::Fixed(STEP)) };
        let mut simulation = Simulation::start(setup).unwrap();
        let start = simulation.sample();
        let samples = run(&mut simulation, 300);
        let end = samples.last().unwrap();
        assert!(end.overlap == 0.0 && samples.iter().any(|s| s.overlap > 0.0));
        // The forces that are returned sum up to the change of momentum, as those of either scheme.
        for axis in 0..2 {
            let impulse: f64 = samples.iter().map(|s| s.bodies[1][axis] * STEP).sum();
            let change = simulation.part_mass(1) * (end.velocities[1][axis] - start.velocities[1][axis]);
            assert!((impulse - change).abs() < 1e-12 * simulation.part_mass(1) * 3.0, "{impulse} {change}");
        }
        // The way back is as exact as ever.
        simulation.reverse();
        run(&mut simulation, 300);
        let away = simulation.state().displacement.iter().flatten().map(|u| u.abs()).fold(0.0, f64::max);
        assert!(away < 1e-8, "{away}");
        (end.total / start.total - 1.0).abs()
    };
    let errors = [left_over(1), left_over(8)];
    assert!(errors[1] < 0.25 * errors[0], "{errors:?}");
}

#[test]
fn threads_change_no_bit() {
    for options in [exact(K, 2.0), fibers(5e-4), depth(4e4)] {
        let run_with = |threads: usize| {
            let mut setup = tip_on_block(Options { threads, ..options }, Step::Fixed(STEP));
            setup.model = setup.model.with_threads(threads).unwrap();
            let mut simulation = Simulation::start(setup).unwrap();
            let totals: Vec<u64> = run(&mut simulation, 80).iter().map(|s| s.total.to_bits()).collect();
            (simulation.state().clone(), totals)
        };
        assert!(run_with(1) == run_with(2));
    }
}
