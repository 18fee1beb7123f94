//! Slender bodies of first-order elements bend as beams, or a note says that they do not.

use crate::scene::solved_text;
use fmc_deck::{Analysis, Deck, SolveOptions};
use std::fmt::Write;

/// A cantilever of ten elements along x, one through its thickness of 1: length 10, E = 1000, ν = 0.3; a force of 0.1 along z on its end.
fn cantilever(kind: &str, count: usize) -> String {
    let mut text = "*NODE\n".to_owned();
    for i in 0..=count {
        for (corner, [y, z]) in [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].into_iter().enumerate() {
            writeln!(text, "{}, {}, {y}, {z}", 4 * i + corner + 1, 10.0 * i as f64 / count as f64).unwrap();
        }
    }
    writeln!(text, "*ELEMENT, TYPE={kind}, ELSET=ALL").unwrap();
    for i in 0..count {
        // Faces across x, seen along it.
        let nodes: Vec<String> = [1, 2, 3, 4, 5, 6, 7, 8].iter().map(|k| (4 * i + k).to_string()).collect();
        writeln!(text, "{}, {}", i + 1, nodes.join(", ")).unwrap();
    }
    let end = 4 * count;
    text + "*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n*SOLID SECTION, ELSET=ALL, MATERIAL=M\n*NSET, NSET=ROOT, GENERATE\n1, 4\n"
        + &format!("*NSET, NSET=END, GENERATE\n{}, {}\n*BOUNDARY\nROOT, 1\n1, 2, 3\n2, 3\n", end + 1, end + 4)
        + "*STEP\n*STATIC\n*CLOAD\nEND, 3, 0.025\n*END STEP\n"
}

/// F L³/3EI + F L/GA_s: 0.4 and, with Poisson's ratio and rectangles' shear areas of 5/6, 0.00312.
#[test]
fn incompatible_modes_bend_as_beams() {
    let beam = 0.1 * 1000.0 * 12.0 / 3.0 / 1000.0 + 0.1 * 10.0 * 1.2 * 2.6 / 1000.0;
    let tip = |kind: &str| {
        let outcome = solved_text::<3>(&format!("beam-{kind}"), &cantilever(kind, 10));
        outcome.displacement.iter().map(|u| u[2]).fold(0.0, f64::max)
    };
    // The curvature of a cell is constant, that of the beam linear: by the midpoint rule 1 − 1/4 · 1/10² of it.
    let [modes, full] = [tip("C3D8I"), tip("C3D8")];
    assert!((modes / beam - 1.0).abs() < 0.005, "{modes} {beam}");
    assert!(full < 0.75 * beam, "{full} {beam}");
    assert_eq!(tip("C3D8R"), full);
}

#[test]
fn elements_that_lock_say_so() {
    let notes = |text: &str| {
        let file = std::env::temp_dir().join(format!("fmc-deck-locks-{}.inp", std::process::id()));
        std::fs::write(&file, text).unwrap();
        let deck = Deck::read(&file).unwrap();
        std::fs::remove_file(file).unwrap();
        let notes = Analysis::<3>::new(&deck, SolveOptions::default()).unwrap().notes;
        notes.into_iter().map(|note| note.message).collect::<Vec<_>>().join("\n")
    };
    assert_eq!(notes(&cantilever("C3D8I", 2)), "");
    assert_eq!(notes(&cantilever("C3D8", 2)), "");
    let reduced = notes(&cantilever("C3D8R", 2));
    assert!(
        reduced.contains("LOCKS in bending") && reduced.ends_with("Take C3D20R, or, without NLGEOM, C3D8I"),
        "{reduced}"
    );
    let finite = notes(&cantilever("C3D8I", 2).replace("*STEP", "*STEP, NLGEOM"));
    assert!(finite.contains("here it is solved as C3D8 and LOCKS in bending"), "{finite}");
}
