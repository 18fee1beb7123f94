//! Steps: amplitudes, what is let go, and what stays.

use crate::scene::{path, solved, solved_text};
use fmc_deck::SolveOptions;

/// A square of side 1 with E = 1000 and ν = 0: stresses do not feel one another.
#[test]
fn what_a_step_does_not_mention_stays() {
    let outcome = solved::<2>("steps.inp", SolveOptions::default());
    let [pulled, let_go, pressed, last] = &outcome.steps[..] else { panic!("four steps") };
    let near = |found: f64, expected: f64| assert!((found - expected).abs() < 1e-9, "{found}, not {expected}");
    // Half of 8 along x at the end of the fourth step's time: a quarter now. The top is pulled by 0.01.
    near(pulled.load[0], 2.0);
    near(pulled.sets[0].1[1], 10.0);
    // The top is held no longer; the amplitude over all steps goes on.
    near(let_go.load[0], 4.0);
    near(let_go.displacement, 0.004);
    // New forces take the place of all forces.
    near(pressed.load[0], 0.0);
    near(pressed.load[1], -2.0);
    near(pressed.displacement, 0.002);
    // Forces of a set change, and a pressure comes to it.
    near(last.load[1], -4.0 - 3.0);
    near(last.displacement, 0.007);
    assert_eq!(outcome.steps.iter().map(|step| step.time).collect::<Vec<_>>(), [1.0, 2.0, 3.0, 4.0]);
}

#[test]
fn a_face_that_a_surface_names_twice_is_loaded_once() {
    let good = std::fs::read_to_string(path("patch.inp")).unwrap();
    let once = solved_text::<2>("once", &good);
    let surface = "*SURFACE, NAME=PUSHED\nUTOP, S3\nUTOP, S3\n*MATERIAL";
    let text = good.replacen("*DLOAD\nUTOP, P3, 10.", "*DSLOAD\nPUSHED, P, 10.", 1).replacen("*MATERIAL", surface, 1);
    let twice = solved_text::<2>("twice", &text);
    let [once, twice] = [&once, &twice].map(|outcome| outcome.steps[0].load[1]);
    assert!(once != 0.0 && (once - twice).abs() < 1e-12 * once.abs(), "{once} {twice}");
}
