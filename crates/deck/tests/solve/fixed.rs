//! `*BOUNDARY, FIXED`: degrees of freedom held where a step finds them.

use crate::free_turns::plate;
use crate::scene::{said, solved_text};

const SQUARE: &str = "*NODE\n1, 0., 0.\n2, 1., 0.\n3, 1., 1.\n4, 0., 1.\n*ELEMENT, TYPE=CPS4, ELSET=E\n1, 1, 2, 3, 4\n*NSET, NSET=TOP\n3, 4\n\
                      *MATERIAL, NAME=M\n*ELASTIC\n1000., 0.\n*SOLID SECTION, ELSET=E, MATERIAL=M\n";

/// A square with E = 1000 is pulled by 8 and sheared by 2; then its upper nodes are fixed, and the forces go: it stays as it is, and what fixes it bears the forces. Along
/// the axes of the space, and along those of the nodes.
#[test]
fn a_fixed_node_stays_and_bears_what_held_it() {
    for axes in ["", "*TRANSFORM, NSET=TOP\n0.8, 0.6, 0., -0.6, 0.8, 0.\n"] {
        let loads = match axes.is_empty() {
            true => "TOP, 1, 1.\nTOP, 2, 4.\n",
            // (1, 4) along (0.8, 0.6) and (−0.6, 0.8).
            false => "TOP, 1, 3.2\nTOP, 2, 2.6\n",
        };
        let text = format!(
            "{SQUARE}{axes}*BOUNDARY\n1, 1, 2\n2, 1, 2\n*STEP\n*STATIC\n*CLOAD\n{loads}*END STEP\n\
             *STEP\n*STATIC\n0.5, 1.\n*BOUNDARY, FIXED\nTOP, 1, 2\n*CLOAD, OP=NEW\n*NODE PRINT, NSET=TOP\nRF\n*END STEP\n"
        );
        let [once, twice] = ["*STEP\n*STATIC\n0.5", "*END"].map(|end| {
            let cut = if end == "*END" { text.clone() } else { text[..text.find(end).unwrap()].to_owned() };
            solved_text::<2>("fixed", &cut)
        });
        let moved = twice.displacement.iter().zip(&once.displacement).flat_map(|(p, q)| [p[0] - q[0], p[1] - q[1]]);
        let off = moved.fold(0.0, |most: f64, off| most.max(off.abs()));
        let up = once.displacement[2][1] + once.displacement[3][1];
        assert!(off < 1e-12 && (up - 0.016).abs() < 1e-9, "{axes} {off:e} {up}");
        let step = &twice.steps[1];
        assert!(step.load.iter().all(|load| load.abs() < 1e-12), "{step:?}");
        let [x, y, _] = step.sets[0].1;
        assert!((x - 2.0).abs() < 1e-9 && (y - 8.0).abs() < 1e-9, "{axes} {:?}", step.sets);
    }
}

/// A node of no element that stretches a square by equations: `OP=NEW` lets it go, and FIXED holds it where it was, with the same reaction.
#[test]
fn a_fixed_node_of_no_element_keeps_what_it_stretches() {
    let text = format!(
        "{SQUARE}*NODE\n900, 5., 5.\n*EQUATION\n2\nTOP, 2, 1., 900, 2, -1.\n*BOUNDARY\n1, 1, 2\n2, 1, 2\n*STEP\n*STATIC\n*BOUNDARY\n900, 2, 2, 0.01\n*END STEP\n\
         *STEP\n*STATIC\n*BOUNDARY, OP=NEW\n1, 1, 2\n2, 1, 2\n*BOUNDARY, OP=NEW, FIXED\n900, 2\n*END STEP\n"
    );
    let solved = solved_text::<2>("fixed-loose", &text);
    let [first, second] = [0, 1].map(|step: usize| &solved.steps[step].references[0]);
    assert!((first.force[1] - 10.0).abs() < 1e-8 && (second.force[1] - 10.0).abs() < 1e-8, "{first:?} {second:?}");
    assert_eq!((first.displacement, second.displacement), ([0.0, 0.01, 0.0], [0.0, 0.01, 0.0]));
}

/// A plate that has tilted freely under forces and moments is fixed, and these go: its reference node stays where it is and bears them. The residual is 1e-9 of
/// forces that are 1e2 at single nodes.
#[test]
fn a_fixed_reference_node_bears_forces_and_moments() {
    let free = "*BOUNDARY\n900, 1, 2\n900, 6, 6, 0.001\n*CLOAD\n900, 3, -20.\n900, 4, -36.\n900, 5, -21.\n*END STEP\n\
                *STEP\n*STATIC\n*BOUNDARY, FIXED\n900, 3, 5\n*CLOAD, OP=NEW";
    let solved = solved_text::<3>("fixed-plate", &plate(free));
    let [loaded, fixed] = [0, 1].map(|step: usize| &solved.steps[step].references[0]);
    let off = |p: [f64; 3], q: [f64; 3]| (0..3).map(|k| (p[k] - q[k]).abs()).fold(0.0, f64::max);
    assert!(off(fixed.displacement, loaded.displacement) < 1e-12 && off(fixed.rotation, loaded.rotation) < 1e-12);
    assert!(fixed.rotation[0].abs() > 1e-4 && fixed.displacement[2] < -0.01, "{fixed:?}");
    let found = [fixed.force[2] + 20.0, fixed.moment[0] + 36.0, fixed.moment[1] + 21.0];
    assert!(found.iter().all(|off| off.abs() < 1e-5), "{fixed:?}");
}

/// The same of a guided plate with finite displacements, which turns first.
#[test]
fn a_fixed_reference_node_keeps_a_finite_rotation() {
    let free = "*BOUNDARY\n900, 1, 2\n900, 4, 5\n900, 6, 6, 0.4\n*CLOAD\n900, 3, -20.\n*END STEP\n\
                *STEP, NLGEOM\n*STATIC\n*BOUNDARY, FIXED\n900, 3, 3\n900, 6, 6\n*CLOAD, OP=NEW";
    let solved = solved_text::<3>(
        "fixed-finite",
        &plate(free)
            .replacen("*STEP\n*STATIC", "*STEP, NLGEOM\n*STATIC\n0.25, 1.", 1)
            .replace("900, 6, 6, 0.4\n*CLOAD\n900, 3, -20.", "900, 3, 3, -0.02\n900, 6, 6, 0.4"),
    );
    let [turned, fixed] = [0, 1].map(|step: usize| &solved.steps[step].references[0]);
    for k in 0..3 {
        assert!((fixed.displacement[k] - turned.displacement[k]).abs() < 1e-12, "{fixed:?} {turned:?}");
        assert!((fixed.force[k] - turned.force[k]).abs() < 1e-6, "{fixed:?} {turned:?}");
    }
    assert!(fixed.rotation[2] == 0.4 && fixed.force[2] < -1.0, "{fixed:?}");
}

#[test]
fn what_cannot_be_fixed_is_refused() {
    let good = format!("{SQUARE}*BOUNDARY\n1, 1, 2\n2, 1, 2\n*STEP\n*STATIC\n*BOUNDARY, FIXED\nTOP, 1\n*END STEP\n");
    assert_eq!(said(&good, "fixed.inp"), "nothing");
    for (from, to, expected) in [
        ("*BOUNDARY\n1,", "*BOUNDARY, FIXED\n1,", "stands within a *STEP: it holds nodes where the step finds them"),
        ("TOP, 1\n", "TOP, 1, 1, 0.5\n", "*BOUNDARY, FIXED holds nodes where they are, and not at 0.5"),
        ("FIXED\nTOP", "FIXED, AMPLITUDE=A\nTOP", "takes no AMPLITUDE"),
        ("FIXED\nTOP", "FIXED=YES\nTOP", "FIXED=YES is not known"),
    ] {
        let message = said(&good.replacen(from, to, 1), "fixed.inp");
        assert!(message.contains(expected) && message.starts_with("fixed.inp:"), "{to}: {message}");
    }
}
