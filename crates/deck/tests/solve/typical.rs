//! What files of other programs have, as Abaqus/CAE, PrePoMax and FreeCAD write them.

use crate::scene::{said, solved_text};
use fmc_deck::{Analysis, Deck, SolveOptions};

fn squares() -> String {
    let page = include_str!("../../../../docs/solve.md");
    page.split("```text\n").find(|block| block.starts_with("*NODE")).unwrap().split("```").next().unwrap().to_owned()
}

/// Contact of all bodies with one another is that of the only pair: the same bits, since squares do not touch themselves.
#[test]
fn general_contact_is_the_contact_of_all_pairs() {
    let pair = "*CONTACT PAIR, INTERACTION=RUB\nBOTTOM_OF_UPPER, TOP_OF_LOWER\n";
    let by_pair = solved_text::<2>("pair", &squares());
    assert!(squares().contains(pair));
    for inclusions in [", ALL EXTERIOR", "\nBOTTOM_OF_UPPER, TOP_OF_LOWER"] {
        let general = format!("*CONTACT\n*CONTACT INCLUSIONS{inclusions}\n*CONTACT PROPERTY ASSIGNMENT\n ,  , RUB\n");
        let by_all = solved_text::<2>("general", &squares().replace(pair, &general));
        assert_eq!(by_all.displacement, by_pair.displacement, "{inclusions}");
    }
    let nothing = squares().replace(pair, "");
    let said = said(&nothing, "without.inp");
    assert_eq!(said, "nothing");
}

/// What changes no result here is told once, at its line.
#[test]
fn keywords_that_change_nothing_are_told() {
    let text = squares()
        .replace("*ELASTIC\n", "*EXPANSION, ZERO=20.\n1.2e-5\n*CONDUCTIVITY\n14.\n*SPECIFIC HEAT\n440.\n*ELASTIC\n")
        .replace("*FRICTION", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=EXPONENTIAL\n1e-3, 1.\n*FRICTION")
        .replace("INTERACTION=RUB\n", "INTERACTION=RUB, TYPE=MORTAR\n")
        .replace("*STEP\n", "*TIME POINTS, NAME=T\n0.5, 1.\n*STEP\n")
        .replace("*DLOAD", "*CONTROLS, PARAMETERS=FIELD\n0.01, 0.02\n*DLOAD");
    let file = std::env::temp_dir().join(format!("fmc-deck-typical-{}.inp", std::process::id()));
    std::fs::write(&file, text).unwrap();
    let deck = Deck::read(&file).unwrap();
    std::fs::remove_file(file).unwrap();
    let notes = Analysis::<2>::new(&deck, SolveOptions::default()).unwrap().notes;
    let messages: Vec<&str> = notes.iter().map(|note| note.message.as_str()).collect();
    for expected in [
        "*EXPANSION of material RUBBER is not used: there are no temperatures",
        "*CONDUCTIVITY of material RUBBER is not used: there are no temperatures",
        "*SPECIFIC HEAT of material RUBBER is not used: there are no temperatures",
        "EXPONENTIAL is taken as HARD: surfaces press when they touch, and not before",
        "*TIME POINTS: results are written at the ends of steps",
        "*CONTROLS: the search uses none of its numbers",
    ] {
        assert!(messages.contains(&expected), "{expected}: {messages:?}");
    }
}

/// What is said of the squares with a change.
fn notes_of(name: &str, text: &str) -> Vec<String> {
    let file = std::env::temp_dir().join(format!("fmc-deck-{name}-{}.inp", std::process::id()));
    std::fs::write(&file, text).unwrap();
    let deck = Deck::read(&file).unwrap();
    std::fs::remove_file(file).unwrap();
    let notes = Analysis::<2>::new(&deck, SolveOptions::default()).unwrap().notes;
    notes.into_iter().map(|note| note.message).collect()
}

/// PrePoMax and FreeCAD hold solids by `1, 6`, or by 1 to 3 and 4 to 6: the latter hold nothing there.
#[test]
fn turns_of_solids_are_left_out() {
    let plain = solved_text::<2>("held", &squares());
    for held in ["1, 1, 6\n2, 1, 6\n", "1, 1, 2\n2, 1, 2\n1, 4, 6, 0.\n2, 4\n"] {
        let text = squares().replace("1, 1, 2\n2, 1, 2\n", held);
        assert_ne!(text, squares());
        assert_eq!(solved_text::<2>("held", &text).displacement, plain.displacement, "{held}");
        let said = notes_of("held-notes", &text);
        let about = said.iter().filter(|note| note.contains("nodes of solids, as 1, are left out")).count();
        assert_eq!(about, 1, "{said:?}");
    }
    let turned = said(&squares().replace("1, 1, 2\n", "1, 1, 2\n1, 6, 6, 0.1\n"), "turned.inp");
    assert!(turned.contains("node 1 belongs to a solid and does not turn"), "{turned}");
}

/// Parameters that change nothing here, and sets of the nodes of elements.
#[test]
fn harmless_parameters_change_nothing() {
    let plain = solved_text::<2>("plain", &squares());
    let text = squares()
        .replace("*MATERIAL", "*SECTION CONTROLS, NAME=C, HOURGLASS=ENHANCED\n*ORIENTATION, NAME=O\n1., 0., 0., 0., 1., 0.\n3, 0.\n*MATERIAL")
        .replace("ELSET=LOWER, MATERIAL=RUBBER", "ELSET=LOWER, MATERIAL=RUBBER, CONTROLS=C, ORIENTATION=O")
        .replace("1000., 0.3", "1000., 0.3, 20.")
        .replace("*CONTACT PAIR,", "*CONTACT PAIR, NO THICKNESS,")
        .replace("*STEP", "*NSET, NSET=N, ELSET=UPPER\n*STEP, AMPLITUDE=STEP")
        .replace("*END STEP", "*NODE PRINT, NSET=N, FREQUENCY=1\nRF\n*END STEP");
    let outcome = solved_text::<2>("harmless", &text);
    assert_eq!(outcome.displacement, plain.displacement);
    // The nodes of UPPER are 5 to 8, two of which are held along x.
    let by_label = squares().replace("*END STEP", "*NSET, NSET=N\n5, 6, 7, 8\n*NODE PRINT, NSET=N\nRF\n*END STEP");
    assert_eq!(outcome.steps[0].sets, solved_text::<2>("labels", &by_label).steps[0].sets);
    let notes = notes_of("harmless-notes", &text);
    for expected in [
        "*SECTION CONTROLS: elements are integrated in full",
        "*ORIENTATION: materials have no directions",
        "CONTROLS of *SOLID SECTION is not used: elements are integrated in full",
        "ORIENTATION of *SOLID SECTION is not used: materials have no directions",
        "the temperature of *ELASTIC is not used: its one line holds at all",
        "AMPLITUDE=STEP is taken as RAMP: loads grow evenly to the end of the step",
        "*NODE PRINT, FREQUENCY: results are written at the ends of steps",
    ] {
        assert!(notes.iter().any(|note| note == expected), "{expected}: {notes:?}");
    }
    let tied = squares().replace("*CONTACT PAIR, INTERACTION=RUB\n", "*TIE, NAME=T, NO ROTATION\n");
    assert_eq!(said(&tied, "tied.inp"), "nothing");
}

/// A peak within a step is solved, and not written.
#[test]
fn peaks_within_steps_are_told() {
    let with = |points: &str| {
        let amplitude = format!("*AMPLITUDE, NAME=A\n{points}\n*STEP");
        notes_of("peak", &squares().replace("*STEP", &amplitude).replace("*DLOAD", "*DLOAD, AMPLITUDE=A"))
    };
    let told = |notes: &[String]| notes.iter().filter(|note| note.starts_with("AMPLITUDE=A is")).count();
    let notes = with("0., 0., 0.5, 1., 1., 0.25");
    assert_eq!(told(&notes), 1, "{notes:?}");
    assert!(notes.iter().any(|note| note.contains("is 1 at time 0.5, and 0.25 at the end of step 1")), "{notes:?}");
    for even in ["0., 0., 1., 1.", "0., 0., 0.5, 0.7, 1., 1.", "0., 0., 1., 1., 2., 9."] {
        assert_eq!(told(&with(even)), 0, "{even}");
    }
}
