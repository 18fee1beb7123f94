//! What is not known is named with its line.

use crate::scene::path;
use fmc_deck::{Analysis, Deck, SolveOptions};
use std::fs;

/// What is said of a file: of reading it, or of what it means.
fn said(text: &str, name: &str) -> String {
    let folder = std::env::temp_dir().join(format!("fmc-deck-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    let file = folder.join(name);
    fs::write(&file, text).unwrap();
    let said = match Deck::read(&file) {
        Err(error) => error,
        Ok(deck) => match Analysis::<2>::new(&deck, SolveOptions::default()) {
            Err(fault) => deck.located(&fault),
            Ok(_) => "nothing".to_owned(),
        },
    };
    said.replace(&folder.display().to_string(), "").trim_start_matches('/').to_owned()
}

#[test]
fn what_is_not_known_is_named_by_its_line() {
    let good = fs::read_to_string(path("patch.inp")).unwrap();
    assert_eq!(said(&good, "good.inp"), "nothing");
    let rows = [
        ("*STATIC", "*DYNAMIC", "*DYNAMIC is not known"),
        ("*STATIC", "*STATIC, STABILIZE", "*STATIC, STABILIZE is not known; known are DIRECT, SOLVER"),
        ("*ELASTIC", "*ELASTIC, TYPE=ORTHO", "TYPE=ORTHO is not known; known are ISO, ISOTROPIC"),
        ("1000., 0.3", "1000., 0.5", "are not a material"),
        ("*ELASTIC\n1000., 0.3", "*PLASTIC\n1., 0.", "*PLASTIC is not known"),
        ("MATERIAL=SOFT\n*SURFACE", "MATERIAL=HARD\n*SURFACE", "there is no material 'HARD'"),
        ("SUPPER, SLOWER", "SUPPER, SNONE", "there is no surface 'SNONE'"),
        ("INTERACTION=PRESS, TYPE", "INTERACTION=PULL, TYPE", "there is no *SURFACE INTERACTION 'PULL'"),
        (
            "*CONTACT PAIR",
            "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n1e4\n*TIE\nSUPPER, SLOWER\n*CONTACT PAIR",
            "LINEAR is known for all contact pairs",
        ),
        ("BOTTOM, 2, 2", "BUTTON, 2, 2", "there is no node set 'BUTTON'"),
        ("BOTTOM, 2, 2", "4711, 2, 2", "there is no node 4711"),
        ("BOTTOM, 2, 2", "BOTTOM, 4, 4", "degree of freedom 4 is not known"),
        ("UTOP, P3, 10.", "UTOP, P5, 10.", "element 104 has no face 5"),
        ("UTOP, P3, 10.", "UTOP, P1, 10.", "inside of a body"),
        ("UTOP, P3, 10.", "UTOP, P3NU, 10.", "a load 'P3NU' is not known"),
        ("*DLOAD", "*DLOAD, AMPLITUDE=UP", "there is no amplitude 'UP'"),
        ("*BOUNDARY", "*EQUATION", "*EQUATION is not known"),
        ("TYPE=CPE4", "TYPE=CPS4", "plane stress is not known"),
        ("SUPPER, SLOWER", "SUPPER, SUPPER2\n*SURFACE, NAME=SUPPER2\nUTOP", "are surfaces of one body"),
    ];
    for (number, (from, to, expected)) in rows.into_iter().enumerate() {
        assert!(good.contains(from), "{from}");
        let changed = good.replacen(from, to, 1);
        let name = format!("model{number}.inp");
        let message = said(&changed, &name);
        let first = changed.find(to).unwrap();
        let line = changed[..first].lines().count() + usize::from(changed[..first].ends_with('\n') || first == 0);
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
    assert!(message.contains("element 101 has no *SOLID SECTION"), "{message}");
    assert!(Deck::read(&path("none.inp")).err().unwrap().contains("none.inp"));
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
    for name in ["patch.inp", "parts.inp", "steps.inp", "friction.inp"] {
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
