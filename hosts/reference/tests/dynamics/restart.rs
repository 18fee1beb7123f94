//! Interrupted runs.

use crate::scene::{depth, exact, run, tip_on_block};
use fmc_contact::contact::Friction;
use fmc_contact::{EnergyLaw, Estimator, FiberOptions, FiberPattern, Options};
use fmc_solid::dynamics::{CheckpointError, DynamicsError, Sample, Setup, Simulation, Step};
use std::path::PathBuf;

const STEP: Step = Step::Fixed(1.2e-3);

fn path(name: &str) -> PathBuf {
    std::env::temp_dir().join(format!("fmc-{}-{name}", std::process::id()))
}

/// Every number of a sample but its timings.
fn numbers(sample: &Sample<2>) -> String {
    format!("{:?}", Sample { contact_seconds: 0.0, seconds: 0.0, ..sample.clone() })
}

#[test]
fn interrupted_run_goes_on_bit_for_bit() {
    let new_each_step = |k: f64| {
        let pattern = FiberPattern::Isotropic { length: None };
        let fibers = Estimator::Fibers(FiberOptions { pattern, ..FiberOptions::default() });
        Options { estimator: fibers, ..Options::new(EnergyLaw::volume(k)) }
    };
    let rough = Options { friction: Friction::coulomb(0.4), ..depth(4e4) };
    let variants: [(Options, f64, bool, Step); 5] = [
        (exact(1e6, 2.0), 0.0, false, STEP),
        (exact(1e6, 2.0), 3.0, false, Step::Auto),
        (new_each_step(1000.0), 0.0, true, STEP),
        (depth(4e4), 0.0, false, STEP),
        (rough, 0.0, false, STEP),
    ];
    for (variant, (options, damping, new_fibers_every_step, step)) in variants.into_iter().enumerate() {
        let setup = || Setup {
            damping,
            new_fibers_every_step,
            check_every: 7,
            contact_substeps: variant as u32 + 1,
            ..tip_on_block(options, step)
        };
        let path = path(&format!("restart-{variant}"));
        let mut whole = Simulation::start(setup()).unwrap();
        let samples = run(&mut whole, 60);
        let mut first = Simulation::start(setup()).unwrap();
        run(&mut first, 25);
        first.save(&path).unwrap();
        let mut second = Simulation::resume(setup(), &path).unwrap();
        assert_eq!(second.state(), first.state());
        assert_eq!(second.step_size(), first.step_size());
        let rest = run(&mut second, 35);
        for (a, b) in samples[25..].iter().zip(&rest) {
            assert_eq!(numbers(a), numbers(b));
        }
        assert_eq!(second.state(), whole.state());
        std::fs::remove_file(path).unwrap();
    }
}

#[test]
fn wrong_files_are_refused() {
    let options = exact(1e6, 2.0);
    let path = path("refused");
    Simulation::start(tip_on_block(options, STEP)).unwrap().save(&path).unwrap();
    let refusal = |setup: Setup<2>| match Simulation::resume(setup, &path) {
        Err(DynamicsError::Checkpoint(error)) => error,
        _ => panic!("not refused"),
    };
    assert_eq!(refusal(tip_on_block(exact(1.1e6, 2.0), STEP)), CheckpointError::OtherModel);
    assert_eq!(refusal(Setup { damping: 0.1, ..tip_on_block(options, STEP) }), CheckpointError::OtherModel);
    let other = refusal(tip_on_block(options, Step::Fixed(1e-3)));
    assert_eq!(other, CheckpointError::OtherStep { found: 1.2e-3, asked: 1e-3 });
    // Threads decide nothing and may differ.
    assert!(Simulation::resume(tip_on_block(Options { threads: 2, ..options }, STEP), &path).is_ok());
    std::fs::write(&path, "not a checkpoint").unwrap();
    assert_eq!(refusal(tip_on_block(options, STEP)), CheckpointError::Damaged);
    std::fs::remove_file(&path).unwrap();
    assert!(matches!(refusal(tip_on_block(options, STEP)), CheckpointError::File { .. }));
}
