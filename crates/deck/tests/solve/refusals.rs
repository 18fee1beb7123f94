//! What is not known is named with its line.

use crate::scene::{path, said};
use fmc_deck::{Analysis, Deck, SolveOptions};
use std::fs;

#[test]
fn what_is_not_known_is_named_by_its_line() {
    let good = fs::read_to_string(path("patch.inp")).unwrap();
    assert_eq!(said(&good, "good.inp"), "nothing");
    let rows = [
        ("*STATIC", "*DYNAMIC", "*DYNAMIC is not known"),
        (
            "*STATIC",
            "*CLEARANCE",
            "*CLEARANCE is not known: gaps and overlaps are those of the coordinates. Write ADJUST=length",
        ),
        (
            "*STATIC",
            "*CONTACT INTERFERENCE",
            "*CONTACT INTERFERENCE is not known: overlaps of the coordinates are pressed",
        ),
        ("*STEP", "*TRANSFORM, NSET=BOTTOM\n1., 0., 0., 2., 0.\n*STEP", "a coordinate is missing in field 6"),
        (
            "*STEP",
            "*TRANSFORM, NSET=BOTTOM, TYPE=S\n1., 0., 0., 2., 0., 0.\n*STEP",
            "TYPE=S is not known; known are R, C",
        ),
        ("*STEP", "*TRANSFORM, NSET=BOTTOM\n1., 0., 0., 2., 0., 0.\n*STEP", "lie on one line through the origin"),
        (
            "*STEP",
            "*TRANSFORM, NSET=BOTTOM\n1., 0., 0., 0., 1., 0.\n*TRANSFORM, NSET=BOTTOM\n1., 1., 0., 0., 1., 0.\n*STEP",
            "has other axes by line",
        ),
        ("*STATIC", "*STATIC, STABILIZE", "*STATIC, STABILIZE is not known; known are DIRECT, SOLVER"),
        ("*ELASTIC", "*ELASTIC, TYPE=ORTHO", "TYPE=ORTHO is not known; known are ISO, ISOTROPIC"),
        ("1000., 0.3", "1000., 0.5", "are not a material"),
        ("*ELASTIC\n1000., 0.3", "*PLASTIC\n1., 0.", "*PLASTIC is not known"),
        ("MATERIAL=SOFT\n*SURFACE", "MATERIAL=HARD\n*SURFACE", "there is no material 'HARD'"),
        ("SUPPER, SLOWER", "SUPPER, SNONE", "there is no surface 'SNONE'"),
        ("INTERACTION=PRESS, TYPE", "INTERACTION=PULL, TYPE", "there is no *SURFACE INTERACTION 'PULL'"),
        (
            "*CONTACT PAIR",
            "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n1e4\n*SURFACE INTERACTION, NAME=HARD\n*CONTACT PAIR, INTERACTION=HARD\nSUPPER, SLOWER\n*CONTACT PAIR",
            "LINEAR is supported for all contact pairs or for none, and line",
        ),
        (
            "*CONTACT PAIR",
            "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n1e4\n*TIE\nSUPPER, SLOWER\n*CONTACT PAIR",
            "are tied and a contact pair with LINEAR: take HARD",
        ),
        ("BOTTOM, 2, 2", "BUTTON, 2, 2", "there is no node set 'BUTTON'"),
        ("BOTTOM, 2, 2", "4711, 2, 2", "there is no node 4711"),
        ("BOTTOM, 2, 2", "BOTTOM, 4, 4, 0.1", "degree of freedom 4 is not known"),
        ("UTOP, P3, 10.", "UTOP, P5, 10.", "element 104 of type CPE4 has no face P5; its faces are P1 to P4"),
        ("UTOP, P3, 10.", "UTOP, P1, 10.", "inside of a body"),
        ("UTOP, P3, 10.", "UTOP, P3NU, 10.", "a load 'P3NU' is not known"),
        ("*DLOAD", "*DLOAD, AMPLITUDE=UP", "there is no amplitude 'UP'"),
        ("*BOUNDARY", "*EQUATION", "expected the number of terms of an equation"),
        ("*BOUNDARY", "*MPC\nSLIDER, 1, 2\n*BOUNDARY", "*MPC of type SLIDER is not known, only BEAM, PIN and TIE"),
        ("*BOUNDARY", "*MPC\nPIN, 1\n*BOUNDARY", "*MPC of type PIN needs two nodes or sets"),
        ("*BOUNDARY", "*MPC\n*BOUNDARY", "*MPC has no data line"),
        ("*BOUNDARY", "*MPC, MODE=NODE\nPIN, 1, 2\n*BOUNDARY", "*MPC, MODE is not known"),
        ("*BOUNDARY", "*MPC\nBEAM, 3, 2\n*BOUNDARY", "the reference node 2 belongs to an element"),
        ("TYPE=CPE4", "TYPE=M3D4", "membranes are not known"),
        ("SUPPER, SLOWER", "SUPPER, SUPPER2\n*SURFACE, NAME=SUPPER2\nUTOP", "are surfaces of one body"),
        // Faces that an element does not have.
        ("LTOP, S3", "LTOP, S7", "of type CPE4 has no face S7; its faces are S1 to S4"),
        ("LTOP, S3", "LTOP, S0", "has no face S0"),
        ("LTOP, S3", "LTOP, SPOS", "has no face SPOS"),
        ("LTOP, S3", "LTOP, P3", "has no face P3"),
        ("*MATERIAL", "*SURFACE, NAME=UNUSED\nUTOP, SNEG\n*MATERIAL", "has no face SNEG"),
        ("LTOP, S3", "LTOP, S3, 1", "expected a set or label and a face"),
        // Numbers that are none.
        ("UTOP, P3, 10.", "UTOP, P3, nan", "expected a finite number, found 'nan' in field 3"),
        ("UTOP, P3, 10.", "UTOP, P3, 1e999", "expected a finite number, found '1e999' in field 3"),
        ("UTOP, P3, 10.", "UTOP, P3, ten", "expected a number, found 'ten' in field 3"),
        ("UTOP, P3, 10.", "UTOP, P3", "the size of the load is missing in field 3"),
        ("UTOP, P3, 10.", "UTOP, P3, , ", "the size of the load is missing in field 3"),
        ("UTOP, P3, 10.", "UTOP, GRAV, 10., 0., inf", "found 'inf' in field 5"),
        ("UTOP, P3, 10.", "UTOP, GRAV, 10., , 1.", "the direction is missing in field 4"),
        ("*DLOAD\nUTOP, P3, 10.", "*CLOAD\nBOTTOM, 2, NaN", "expected a finite number, found 'NaN' in field 3"),
        ("*DLOAD\nUTOP, P3, 10.", "*CLOAD\nBOTTOM, 2,", "expected a set, a degree of freedom and a force"),
        ("BOTTOM, 2, 2", "BOTTOM, 2, 2, infinity", "expected a finite number, found 'infinity' in field 4"),
        ("BOTTOM, 2, 2", "BOTTOM, 2, 2, ,", "the displacement is missing in field 4"),
        ("BOTTOM, 2, 2", "BOTTOM, PINNED, 2", "PINNED has no further fields"),
        ("1000., 0.3", "1000.", "Poisson's ratio is missing in field 2"),
        ("1000., 0.3", ", 0.3", "Young's modulus is missing in field 1"),
        ("1000., 0.3", "nan, 0.3", "expected a finite number, found 'nan' in field 1"),
        ("*ELASTIC", "*DENSITY\n-1.\n*ELASTIC", "a density of -1 is not above 0"),
        ("*ELASTIC", "*DENSITY\n1.\n*DENSITY\n1.\n*ELASTIC", "has a density already"),
        ("*STEP", "*AMPLITUDE, NAME=A\n0., 0., 1., nan\n*STEP", "expected a finite number, found 'nan' in field 4"),
        ("*STEP", "*AMPLITUDE, NAME=A\n0., 0., , 1.\n*STEP", "is missing in field 3"),
        ("*STEP", "*AMPLITUDE, NAME=A\n0., 0.\n*AMPLITUDE, NAME=a\n0., 1.\n*STEP", "this amplitude is there twice"),
        ("*SURFACE INTERACTION", "*SURFACE INTERACTION, NAME=PRESS\n*SURFACE INTERACTION", "is there twice"),
        ("NAME=PRESS", "NAME=PRESS\n*FRICTION\n,1.", "the coefficient is missing in field 1"),
        ("NAME=PRESS", "NAME=PRESS\n*FRICTION\n0.1\n*FRICTION\n0.2", "has two *FRICTION"),
        ("NAME=PRESS", "NAME=PRESS\n*FRICTION, TAUMAX=1.\n0.1", "*FRICTION, TAUMAX is not known"),
        ("NAME=PRESS", "NAME=PRESS\n*FRICTION\n0.1, 0., 5.", "may not depend on anything"),
        (
            "NAME=PRESS",
            "NAME=PRESS\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR\n1., 1.",
            "known are HARD, LINEAR, EXPONENTIAL, TIED",
        ),
        (
            "NAME=PRESS",
            "NAME=PRESS\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR",
            "the slope of a linear overclosure is missing",
        ),
        ("*CONTACT PAIR,", "*CONTACT PAIR, ADJUST=NEAR,", "only a length, not a set of nodes"),
        ("*CONTACT PAIR,", "*CONTACT PAIR, ADJUST=-1.,", "ADJUST=-1. is not a length"),
        // What would change the answer, or the number of increments.
        ("*STEP", "*STEP, INC=0", "INC=0 is not a number of increments"),
        ("*STEP", "*STEP, PERTURBATION", "*STEP, PERTURBATION is not known"),
        ("*STEP\n*STATIC", "*STEP, INC=5\n*STATIC, DIRECT\n0.1, 1.", "takes 10 increments, more than INC=5"),
        ("*STATIC", "*STATIC, DIRECT=NO STOP", "DIRECT=NO STOP is not known"),
        ("*STATIC", "*STATIC\n1., -1.", "times of *STATIC are not below 0"),
        ("*STATIC", "*STATIC\n1., 1., 0., 0., 1.", "*STATIC has four numbers"),
        ("*STATIC", "*STATIC\n*STATIC", "a *STATIC already"),
        (
            "*SOLID SECTION",
            "*SOLID SECTION, ELSET=UPPER, MATERIAL=M2\n*MATERIAL, NAME=M2\n*ELASTIC\n1., 0.\n*SOLID SECTION",
            "has another material by the section of line",
        ),
        ("*CONTACT PAIR", "*CONTACT\n*CONTACT PAIR", "*CONTACT has no *CONTACT PROPERTY ASSIGNMENT"),
        (
            "*CONTACT PAIR",
            "*CONTACT\n*CONTACT PROPERTY ASSIGNMENT\n, , PRESS\n*CONTACT PAIR",
            "*CONTACT includes nothing",
        ),
        (
            "*CONTACT PAIR",
            "*CONTACT\n*CONTACT PROPERTY ASSIGNMENT\nSUPPER, SLOWER, PRESS\n*CONTACT PAIR",
            "is known with one interaction of all",
        ),
        ("*CONTACT PAIR", "*CONTACT INCLUSIONS, ALL EXTERIOR\n*CONTACT PAIR", "stands behind no *CONTACT"),
        ("*CONTACT PAIR", "*CONTACT EXCLUSIONS\n*CONTACT PAIR", "*CONTACT EXCLUSIONS is not known"),
        ("*STEP", "*RESTART, READ\n*STEP", "*RESTART, READ is not known"),
        // What would be passed over, or would count twice.
        ("*STATIC", "*STATIC\n1., 1.\n2., 2.", "*STATIC has a data line more than is known"),
        ("1000., 0.3", "1000., 0.3\n2000., 0.3, 100.", "*ELASTIC has a data line more than is known"),
        ("*END STEP", "*END STEP\n1, 2, 3", "'1, 2, 3' belongs to no keyword"),
        ("*STEP", "*NSET, NSET=NONE\n*BOUNDARY\nNONE, 1\n*STEP", "node set 'NONE' is empty"),
        ("BOTTOM, 2, 2", "BOTTOM, 2, 2\nBOTTOM, 2, 2, 0.1", "is moved elsewhere along axis 2 by line"),
    ];
    for (number, (from, to, expected)) in rows.into_iter().enumerate() {
        assert!(good.contains(from), "{from}");
        let changed = good.replacen(from, to, 1);
        let name = format!("model{number}.inp");
        let message = said(&changed, &name);
        let first = good.find(from).unwrap();
        let line = good[..first].lines().count() + usize::from(good[..first].ends_with('\n') || first == 0);
        let lines: Vec<String> = (line - 1..line + 6).map(|line| format!("{name}:{line}: ")).collect();
        assert!(lines.iter().any(|line| message.starts_with(line)), "{to}: {message}, expected {lines:?}");
        assert!(message.contains(expected), "{to}: {message}");
    }
}

#[test]
fn what_is_missing_is_told() {
    let good = fs::read_to_string(path("patch.inp")).unwrap();
    let without = |from: &str| said(&good[..good.find(from).unwrap()], "cut.inp");
    assert!(without("*STEP").contains("there is no *STEP"), "{}", without("*STEP"));
    assert!(without("*NODE FILE").contains("ends within a *STEP"));
    let message = said(&good.replace("*SOLID SECTION, ELSET=UPPER, MATERIAL=SOFT\n", ""), "section.inp");
    let line = good.lines().position(|line| line.starts_with("101,") && line.matches(',').count() == 4).unwrap() + 1;
    assert!(message.contains(&format!("section.inp:{line}: element 101 has no *SOLID SECTION")), "{message}");
    assert!(Deck::read(&path("none.inp")).err().unwrap().contains("none.inp"));
}

/// Nodes and elements are named by their lines, as all else is.
#[test]
fn wrong_nodes_and_elements_are_named_by_their_lines() {
    let good = fs::read_to_string(path("steps.inp")).unwrap();
    let rows = [
        ("2, 1., 0.", "2, 1., nan", "expected a finite number, found 'nan'"),
        ("2, 1., 0.", "1, 1., 0.", "node 1 is there twice"),
        ("1, 1, 2, 3, 4", "1, 4, 3, 2, 1", "element 1 is inverted or has no volume"),
        ("1, 1, 2, 3, 4", "1, 1, 2, 3, 9", "names node 9, which does not exist"),
    ];
    for (number, (from, to, expected)) in rows.into_iter().enumerate() {
        let name = format!("nodes{number}.inp");
        let message = said(&good.replacen(from, to, 1), &name);
        let line = good.lines().position(|line| line == from).unwrap() + 1;
        assert!(message.starts_with(&format!("{name}:{line}: ")) && message.contains(expected), "{to}: {message}");
    }
}

/// Notes stand at the lines of what they are about.
#[test]
fn notes_have_lines() {
    let good = fs::read_to_string(path("patch.inp")).unwrap();
    let text = good.replace("TYPE=CPE4", "TYPE=CPE4R").replace("*STEP\n*STATIC", "*STEP, INC=2\n*STATIC\n0.1, 1.");
    let file = std::env::temp_dir().join(format!("fmc-deck-notes-{}.inp", std::process::id()));
    fs::write(&file, &text).unwrap();
    let deck = Deck::read(&file).unwrap();
    let analysis = Analysis::<2>::new(&deck, SolveOptions::default()).unwrap();
    let line = |start: &str| text.lines().position(|line| line.starts_with(start)).unwrap() + 1;
    for (start, words) in [
        ("*ELEMENT", "CPE4R is integrated in full, as CPE4, and LOCKS"),
        ("*NODE FILE", "*NODE FILE: files and tables"),
        ("*EL FILE", "*EL FILE: files and tables"),
        ("*STEP", "INC=2: the step begins with as many load steps, not 10"),
    ] {
        let found = analysis.notes.iter().any(|note| note.line == line(start) && note.message.starts_with(words));
        assert!(found, "{start}: {:?}", analysis.notes);
    }
    fs::remove_file(file).unwrap();
}

/// Lines of included files are those of these files.
#[test]
fn included_files_have_lines_of_their_own() {
    let folder = std::env::temp_dir().join(format!("fmc-deck-included-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join("step.inp"), "*STEP\n*STATIC\n*WAVE\n*END STEP\n").unwrap();
    let good = fs::read_to_string(path("patch.inp")).unwrap();
    let start = &good[..good.find("*STEP").unwrap()];
    fs::write(folder.join("model.inp"), format!("{start}*INCLUDE, INPUT=step.inp\n")).unwrap();
    let message = Deck::read(&folder.join("model.inp")).err().unwrap();
    assert!(message.ends_with("step.inp:3: *WAVE is not known"), "{message}");
}

/// Whatever stands in a file, there is an answer.
#[test]
fn damaged_files_do_not_panic() {
    let folder = std::env::temp_dir().join(format!("fmc-deck-damaged-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    let file = folder.join("damaged.inp");
    let mut random = fmc_shapes::Splitmix::new(1);
    for name in ["patch.inp", "parts.inp", "steps.inp", "friction.inp", "rigid_faces.inp", "segments.inp"] {
        let text = fs::read_to_string(path(name)).unwrap();
        let lines: Vec<&str> = text.lines().collect();
        for round in 0..150 {
            let mut damaged = text.clone().into_bytes();
            if round % 3 == 0 {
                // Without a line, or with one of another place.
                let at = |random: &mut fmc_shapes::Splitmix| random.bits() as usize % lines.len();
                let (gone, from, to) = (at(&mut random), at(&mut random), at(&mut random));
                let mut changed: Vec<&str> = lines.clone();
                changed[to] = lines[from];
                changed.remove(gone);
                damaged = changed.join("\n").into_bytes();
            } else {
                for _ in 0..3 {
                    let at = random.bits() as usize % damaged.len();
                    damaged[at] = b"0123456789,.-*=\nABCDEFabcdef "[random.bits() as usize % 29];
                }
            }
            fs::write(&file, &damaged).unwrap();
            let Ok(deck) = Deck::read(&file) else { continue };
            match deck.dimension() {
                Ok(2) => drop(Analysis::<2>::new(&deck, SolveOptions::default())),
                Ok(_) => drop(Analysis::<3>::new(&deck, SolveOptions::default())),
                Err(_) => {}
            }
        }
    }
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn gravity_that_turns_says_whether_it_replaces_the_old() {
    let good = fs::read_to_string(path("patch.inp")).unwrap();
    let turned = |op: &str| {
        let steps =
            format!("UPPER, GRAV, 1., 0., -1.\n*END STEP\n*STEP\n*STATIC\n*DLOAD{op}\nUPPER, GRAV, 1., 0.1, -1.");
        let text = good.replacen("UTOP, P3, 10.", &steps, 1).replacen("*ELASTIC", "*DENSITY\n1.\n*ELASTIC", 1);
        said(&text, "gravity.inp")
    };
    assert!(turned("").contains("gravity of another direction acts since an earlier step"), "{}", turned(""));
    assert_eq!(turned(", OP=NEW"), "nothing");
}
