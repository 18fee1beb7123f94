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

/// Loads of one step add up, wherever they are written; those of an earlier step they replace.
#[test]
fn loads_of_one_step_add_up() {
    let good = std::fs::read_to_string(path("steps.inp")).unwrap();
    let loads = |name: &str, rows: &str| {
        let last = "*DLOAD\nE, P3, 3.\n*CLOAD\nTOP, 2, -2.\n*END STEP\n";
        assert!(good.ends_with(last));
        let outcome = solved_text::<2>(name, &good.replace(last, rows));
        outcome.steps.iter().skip(3).map(|step| (step.load[1], step.displacement)).collect::<Vec<_>>()
    };
    let near = |found: &[(f64, f64)], expected: &[f64]| {
        assert_eq!(found.len(), expected.len(), "{found:?}");
        for ((load, displacement), expected) in found.iter().zip(expected) {
            // Forces of some units: rounding. E = 1000 and a square of side 1: a force moves the top by a thousandth of it.
            assert!((load + expected).abs() < 1e-12, "{load}, not {expected}");
            assert!((displacement - 1e-3 * expected).abs() < 1e-9, "{displacement}, not {expected}");
        }
    };
    // The third step has left -1 at each node of TOP.
    near(&loads("twice", "*CLOAD\nTOP, 2, -1.5\n*CLOAD\n3, 2, -0.5\n4, 2, -0.5\n*END STEP\n"), &[4.0]);
    let pushed = "*SURFACE, NAME=S\nE, S3\n*ELSET, ELSET=SAME\n1\n*STEP";
    let faces = "*DLOAD\nE, P3, 1.\nE, P3, 0.5\n*DLOAD\nSAME, P3, 0.5\n*DSLOAD\nS, P, 1.\n*CLOAD, OP=NEW\n*END STEP\n";
    let again = "*STEP\n*STATIC\n*DLOAD\nE, P3, 1.\nSAME, P3, 2.\n*DSLOAD\nS, P, 4.\n*END STEP\n";
    let text = good.replacen("*STEP", pushed, 1);
    let last = text.find("*DLOAD").unwrap();
    let outcome = solved_text::<2>("faces", &(text[..last].to_owned() + faces + again));
    let found: Vec<_> = outcome.steps.iter().skip(3).map(|step| (step.load[1], step.displacement)).collect();
    near(&found, &[3.0, 7.0]);
    // Loads of an earlier step of which some change are unclear.
    let some = text[..last].to_owned() + faces + "*STEP\n*STATIC\n*DLOAD\nE, P3, 1.\n*END STEP\n";
    let said = crate::scene::said(&some, "some.inp");
    assert!(said.contains("a load of an earlier step acts on") && said.contains("OP=NEW"), "{said}");
    let paths = text[..last].to_owned() + "*DLOAD\nE, P3, 1.\n*DLOAD, AMPLITUDE=TOTAL\nE, P3, 1.\n*END STEP\n";
    let said = crate::scene::said(&paths, "paths.inp");
    assert!(said.contains("with another AMPLITUDE: loads that add up need one"), "{said}");
}
