//! What has no equilibrium ends with a message that says why.

use crate::scene::{exact, hertz};
use fmc_contact::{EnergyLaw, EnergyProfile, PenetrationLaw};
use fmc_solid::fem::Constraints;
use fmc_solid::statics::{Equilibrium, Iteration, Problem, StaticsError};
use std::ops::ControlFlow;

fn failure(problem: Problem<2>, most_iterations: usize) -> (StaticsError, Equilibrium<2>) {
    let mut equilibrium = Equilibrium::new(problem).unwrap();
    equilibrium.settings.most_iterations = most_iterations;
    let error = equilibrium.follow(Default::default(), &mut |_: &Iteration| ControlFlow::Continue(())).unwrap_err();
    println!("{error}");
    (error, equilibrium)
}

fn disc() -> Problem<2> {
    hertz(4.0, exact(EnergyLaw::fiber(2e4)))
}

#[test]
fn a_disc_that_may_slide_is_not_supported() {
    let (error, at) = failure(Problem { supports: Constraints::default(), ..disc() }, 60);
    assert!(matches!(&error, StaticsError::Unsupported { body, .. } if body == "disc"), "{error}");
    assert!(error.to_string().contains("not supported"));
    assert_eq!(at.load(), 0.0);
}

#[test]
fn a_disc_that_is_lifted_is_adrift() {
    let mut problem = disc();
    problem.load.iter_mut().flatten().for_each(|f| *f = -*f);
    let (error, _) = failure(problem, 60);
    let motion = "translation along y".to_owned();
    assert_eq!(error, StaticsError::Adrift { body: "disc".into(), motion, has_friction: false });
}

#[test]
fn pressure_above_the_stiffness_goes_through() {
    let law =
        EnergyLaw::Fiber(PenetrationLaw { stiffness: 5.0, profile: EnergyProfile::Linear { smoothing_length: 8e-3 } });
    let mut equilibrium = Equilibrium::new(hertz(4.0, exact(law))).unwrap();
    let mut watch = |_: &Iteration| ControlFlow::Continue(());
    // At this ε the disc sinks in until its contact is wide enough; it stays there however small ε becomes.
    let error = equilibrium.follow(Default::default(), &mut watch);
    let error = error.and_then(|()| equilibrium.continue_smoothing(8e-6, &mut watch)).unwrap_err();
    assert!(matches!(error, StaticsError::PeakPressureAboveStiffness { stiffness: 5.0, .. }), "{error}");
    assert!(error.to_string().contains("raise k above the peak pressure"));
}

#[test]
fn too_few_iterations_leave_the_last_equilibrium() {
    let (error, at) = failure(disc(), 0);
    assert!(matches!(error, StaticsError::NotConverged { .. }), "{error}");
    assert_eq!(at.load(), 0.0);
    assert!(at.displacement().iter().flatten().all(|u| *u == 0.0));
}

#[test]
fn whoever_watches_may_break_off() {
    let mut equilibrium = Equilibrium::new(disc()).unwrap();
    let end = equilibrium.follow(Default::default(), &mut |_: &Iteration| ControlFlow::Break(()));
    assert_eq!(end, Err(StaticsError::Interrupted));
}
