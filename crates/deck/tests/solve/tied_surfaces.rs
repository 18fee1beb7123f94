//! Ties of the surfaces that they name, beside which the same bodies touch or pass through one another.

use crate::scene::{Outcome, largest_off, said, solved_text};
use fmc_contact::contact::PairOptions;
use fmc_contact::{EnergyLaw, Options};
use fmc_deck::{Analysis, Deck, SolveOptions, step_table};
use fmc_solid::fem::{Constraints, Law, Material, Model, Part};
use fmc_solid::statics::{Equilibrium, NewtonSettings, Path, Problem};

/// Young's modulus; Poisson's number is 0, so that a column is as free beside as it is held.
const E: f64 = 1000.0;

/// A rectangle of CPE4 from `low` to `high`, whose labels begin after `first`: its nodes row by row, and so its elements.
pub(crate) fn rectangle(name: &str, first: usize, [low, high]: [[f64; 2]; 2], [n, m]: [usize; 2]) -> String {
    let mut text = format!("*NODE, NSET=N{name}\n");
    for (j, i) in (0..=m).flat_map(|j| (0..=n).map(move |i| (j, i))) {
        let [x, y] = [(0, i, n), (1, j, m)].map(|(k, at, of)| low[k] + (high[k] - low[k]) * at as f64 / of as f64);
        text += &format!("{}, {x}, {y}\n", first + 1 + j * (n + 1) + i);
    }
    text += &format!("*ELEMENT, TYPE=CPE4, ELSET={name}\n");
    for (j, i) in (0..m).flat_map(|j| (0..n).map(move |i| (j, i))) {
        let corner = first + 1 + j * (n + 1) + i;
        let label = first + 1 + j * n + i;
        text += &format!("{label}, {corner}, {}, {}, {}\n", corner + 1, corner + n + 2, corner + n + 1);
    }
    text + &format!("*SOLID SECTION, ELSET={name}, MATERIAL=M\n")
}

fn material() -> String {
    format!("*MATERIAL, NAME=M\n*ELASTIC\n{E}, 0.\n")
}

/// Two columns on one base that nothing moves: the left one, tied, is pulled by 10, the right one, in contact, is pressed by 10. Each has the stress
/// of its load and no other; the pressed one has its rims, where the pressure falls off within the penetration.
#[test]
fn one_column_is_tied_and_one_presses() {
    let bodies = rectangle("BASE", 0, [[0.0, 0.0], [3.0, 1.0]], [5, 2])
        + &rectangle("LEFT", 100, [[0.0, 1.0], [1.0, 3.0]], [3, 4])
        + &rectangle("RIGHT", 200, [[2.0, 1.0], [3.0, 3.0]], [3, 4]);
    let text = format!(
        "{bodies}{}*ELSET, ELSET=TOP, GENERATE\n6, 10\n*SURFACE, NAME=STOP\nTOP, S3\n*SURFACE, NAME=SLEFT, TYPE=NODE\n101\n102\n103\n104\n\
         *SURFACE, NAME=SRIGHT\nRIGHT, S1\n*SURFACE INTERACTION, NAME=I\n*CONTACT PAIR, INTERACTION=I\nSRIGHT, STOP\n*TIE, NAME=T\nSLEFT, STOP\n\
         *BOUNDARY\nNBASE, 1, 2\n201, 1\n*STEP\n*STATIC\n*DLOAD\n110, P3, -10.\n111, P3, -10.\n112, P3, -10.\n210, P3, 10.\n211, P3, 10.\n\
         212, P3, 10.\n*END STEP\n",
        material()
    );
    let outcome = solved_text::<2>("columns", &text);
    let [pulled, pressed] = [10..22, 22..34].map(|cells| &outcome.stresses[cells]);
    assert!(largest_off(pulled, [0.0, 10.0, 0.0, 0.0, 0.0, 0.0]) < 1e-8);
    let off = largest_off(pressed, [0.0, -10.0, 0.0, 0.0, 0.0, 0.0]);
    assert!(off < 0.1, "{off}");
    let top = |node: usize| outcome.displacement[node][1];
    // Columns of height 2.
    assert!((top(18 + 16) - 2.0 * 10.0 / E).abs() < 1e-9, "{}", top(34));
    assert!((top(18 + 20 + 16) + 2.0 * 10.0 / E).abs() < 1e-4, "{}", top(54));
    assert_eq!(outcome.steps[0].ties.len(), 1);
}

/// A beam on a beam, 6 by 9 facets: their left halves are tied.
fn halves(contact: &str, load: &str) -> String {
    let bodies =
        rectangle("LOW", 0, [[0.0, 0.0], [2.0, 1.0]], [6, 2]) + &rectangle("UP", 100, [[0.0, 1.0], [2.0, 2.0]], [8, 2]);
    format!(
        "{bodies}{}*ELSET, ELSET=LOWLEFT, GENERATE\n7, 9\n*ELSET, ELSET=UPLEFT, GENERATE\n101, 104\n*SURFACE, NAME=SLOW\nLOWLEFT, S3\n\
         *SURFACE, NAME=SUP\nUPLEFT, S1\n*SURFACE, NAME=FREELOW\n12, S3\n*SURFACE, NAME=FREEUP\n108, S1\n{contact}*TIE, NAME=T, POSITION TOLERANCE=0.05\n\
         SUP, SLOW\n*BOUNDARY\n1, 1\nNBOTTOM, 2\n*NSET, NSET=NBOTTOM, GENERATE\n1, 7\n*STEP\n*STATIC\n{load}*END STEP\n",
        material()
    )
}

const CONTACT: &str = "*SURFACE INTERACTION, NAME=I\n*CONTACT PAIR, INTERACTION=I\nFREEUP, FREELOW\n";

/// The same by the library, whose named parts are those faces whose nodes lie in the left half.
fn by_library(has_contact: bool, force: f64) -> Vec<[f64; 2]> {
    let part = |name: &str, low: [f64; 2], high: [f64; 2], cells| Part {
        name: name.to_owned(),
        cell_type: fmc_contact::CellType::Quad4,
        mesh: fmc_shapes::rectangle_quad4(low, high, cells),
        material: Material { law: Law::LinearElastic, young: E, poisson: 0.0, density: 1.0 },
    };
    let parts = vec![part("low", [0.0, 0.0], [2.0, 1.0], [6, 2]), part("up", [0.0, 1.0], [2.0, 2.0], [8, 2])];
    let model = Model::new(parts).expect("a model");
    let is_left = |x: &[f64; 2]| (x[1] - 1.0).abs() < 1e-9 && x[0] < 1.0 + 1e-9;
    let surfaces: Vec<Vec<Vec<u32>>> =
        (0..2).map(|body| model.faces_where(body, is_left).into_iter().map(|face| face.nodes).collect()).collect();
    let mut supports = Constraints::default();
    let node = |at: [f64; 2]| model.coords().iter().position(|x| (0..2).all(|k| (x[k] - at[k]).abs() < 1e-9)).unwrap();
    (0..7).for_each(|i| supports.prescribe([node([2.0 * i as f64 / 6.0, 0.0])], 1, 0.0));
    supports.prescribe([node([0.0, 0.0])], 0, 0.0);
    let mut load = vec![[0.0; 2]; model.node_count()];
    load[node([2.0, 2.0])][1] = force;
    let tied = PairOptions { excluded: !has_contact, ..PairOptions::tied(0.05) }.between([1, 2]);
    let contact = Options::new(EnergyLaw::depth(0.0));
    let pairs = vec![([0, 1], tied)];
    // Its lower side is held across it.
    let symmetry_planes = vec![[[0.0, 0.0], [0.0, 1.0]]];
    let problem = Problem { supports, load, pairs, surfaces, symmetry_planes, ..Problem::new(model, contact) };
    let mut at = Equilibrium::new(problem).unwrap();
    at.settings = NewtonSettings { tolerance: 1e-9, most_iterations: 100, ..NewtonSettings::default() };
    let step = Path { steps: 1, most_halvings: 8 };
    at.follow(step, &mut |_| std::ops::ControlFlow::Continue(())).expect("an equilibrium");
    at.displacement().to_vec()
}

fn off(outcome: &Outcome<2>, other: &[[f64; 2]]) -> f64 {
    let size = other.as_flattened().iter().fold(0.0_f64, |size, u| size.max(u.abs()));
    let both = outcome.displacement.as_flattened().iter().zip(other.as_flattened());
    both.map(|(u, v)| (u - v).abs()).fold(0.0, f64::max) / size
}

/// Pressed evenly, both halves bear the same. Where the right end is lifted the tie bears all, and where it is pressed the contact bears most of it;
/// without a pair it goes through.
#[test]
fn half_of_a_face_is_tied_and_the_rest_touches() {
    let all: String = (109..117).map(|element| format!("{element}, P3, 10.\n")).collect();
    let even = solved_text::<2>("even", &halves(CONTACT, &format!("*DLOAD\n{all}")));
    let found = largest_off(&even.stresses, [0.0, -10.0, 0.0, 0.0, 0.0, 0.0]);
    // The pressure falls off within the penetration at the right end and beside the tie.
    assert!(found < 0.1, "{found}");
    let rows = &even.steps[0].pairs;
    assert_eq!(rows.iter().map(|row| row.is_tied).collect::<Vec<_>>(), [false, true]);
    // The contact yields by its penetration, the tie does not.
    assert!(rows.iter().all(|row| (row.force[1] - 10.0).abs() < 0.2), "{rows:?}");
    assert!((even.steps[0].ties[0].area - 1.0).abs() < 1e-12);
    let table = step_table(&even.steps[0]);
    assert!(table.contains("contact, area") && table.contains("tied, area"), "{table}");

    for (contact, force) in [(CONTACT, 1.0), (CONTACT, -1.0), ("", 1.0), ("", -1.0)] {
        let outcome = solved_text::<2>("end", &halves(contact, &format!("*CLOAD\n127, 2, {force}\n")));
        let other = by_library(!contact.is_empty(), force);
        let off = off(&outcome, &other);
        assert!(off < 1e-10, "{contact} {force}: {off:e}");
        let pressing: f64 = outcome.steps[0].pairs.iter().filter(|row| !row.is_tied).map(|row| row.force[1]).sum();
        let all: f64 = outcome.steps[0].pairs.iter().map(|row| row.force[1]).sum();
        assert!((all + force).abs() < 1e-8, "{all}");
        match (contact.is_empty(), force > 0.0) {
            (false, false) => assert!(pressing > 0.9, "{pressing}"),
            _ => assert_eq!(pressing, 0.0, "{contact} {force}"),
        }
        let least = other[21 + 8][1] - other[6 + 14][1];
        assert_eq!(least < -1e-3, contact.is_empty() && force < 0.0, "{least}");
    }
}

/// The same faces named by nodes, or as free faces of their elements, or by an interaction that is TIED.
#[test]
fn faces_have_many_names() {
    let text = halves(CONTACT, "*CLOAD\n127, 2, -1.\n");
    let expected = solved_text::<2>("faces", &text).displacement;
    let nodes = text.replace("NAME=SLOW\nLOWLEFT, S3", "NAME=SLOW, TYPE=NODE\n15\n16\n17, 1.\n18");
    let free = text.replace("LOWLEFT, S3", "LOWLEFT");
    let tied =
        "*SURFACE INTERACTION, NAME=J\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TIED\n*CONTACT PAIR, INTERACTION=J\n";
    let by_pair = text.replace("*TIE, NAME=T, POSITION TOLERANCE=0.05\n", tied);
    for (name, other) in [("nodes", nodes), ("free", free), ("by pair", by_pair)] {
        assert_ne!(other, text);
        assert_eq!(solved_text::<2>("names", &other).displacement, expected, "{name}");
    }
}

/// What cannot be tied so is named by its line, and what is not tied is noted.
#[test]
fn what_is_not_tied_is_told() {
    let good = halves(CONTACT, "*CLOAD\n127, 2, -1.\n");
    let after_tie = good[..good.find("SUP, SLOW\n*BOUNDARY").unwrap()].lines().count() + 1;
    let twice = "SUP, SLOW\n*TIE, NAME=U\nSUP, SLOW\n*BOUNDARY";
    for (to, line, expected) in [
        (
            "SUP, FREEUP\n*BOUNDARY",
            after_tie,
            "SUP and FREEUP are surfaces of one body, UP, which is not tied to itself",
        ),
        ("SUP, SUP\n*BOUNDARY", after_tie, "SUP and SUP are surfaces of one body"),
        ("SUP, BOTH\n*SURFACE, NAME=BOTH\nLOWLEFT, S3\n108, S1\n*BOUNDARY", after_tie, "are surfaces of one body, UP"),
        ("SUP, SNONE\n*BOUNDARY", after_tie, "there is no surface 'SNONE'"),
        (
            "SUP, INNER\n*SURFACE, NAME=INNER\nLOWLEFT, S1\n*BOUNDARY",
            after_tie,
            "'INNER' ties nothing: 3 of its faces lie",
        ),
        (
            "SUP, ONE\n*SURFACE, NAME=ONE, TYPE=NODE\n16\n*BOUNDARY",
            after_tie,
            "'ONE' ties nothing: no face with node 16 has",
        ),
        (twice, after_tie + 2, "LOW and UP are tied by line"),
    ] {
        let message = said(&good.replace("SUP, SLOW\n*BOUNDARY", to), "tied.inp");
        assert!(message.starts_with(&format!("tied.inp:{line}: ")) && message.contains(expected), "{to}: {message}");
    }
    let text = good.replace("NAME=SLOW\nLOWLEFT, S3", "NAME=SLOW, TYPE=NODE\n15\n16\n17\n18\n20");
    let file = std::env::temp_dir().join(format!("fmc-deck-not-tied-{}.inp", std::process::id()));
    std::fs::write(&file, &text).unwrap();
    let deck = Deck::read(&file).unwrap();
    let notes = Analysis::<2>::new(&deck, SolveOptions::default()).unwrap().notes;
    let told = notes.iter().find(|note| note.message.starts_with("not all of 'SLOW' is tied: no face with node 20"));
    assert!(told.is_some_and(|note| text.lines().nth(note.line - 1) == Some("SUP, SLOW")), "{notes:?}");
    std::fs::remove_file(file).unwrap();
}
