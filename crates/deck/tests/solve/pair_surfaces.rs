//! Contact pairs that name a part of the faces that meet.

use crate::scene::{said, solved_text};
use crate::tied_surfaces::rectangle;
use fmc_deck::{Analysis, Deck, SolveOptions};

/// A square of four columns on another, pressed by 10; the pair names `surface` of the lower one.
fn squares(surface: &str, pair: &str) -> String {
    let bodies = rectangle("LOWER", 0, [[0.0, 0.0], [1.0, 1.0]], [4, 2])
        + &rectangle("UPPER", 100, [[0.0, 1.0], [1.0, 2.0]], [4, 2]);
    format!(
        "{bodies}*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.\n*SURFACE, NAME=SUP\n101, S1\n102, S1\n103, S1\n104, S1\n*SURFACE, NAME=SLOW\n{surface}\
         *SURFACE INTERACTION, NAME=I\n{pair}*BOUNDARY\nNLOWER, 1\nNUPPER, 1\n1, 2\n2, 2\n3, 2\n4, 2\n5, 2\n*STEP\n*STATIC\n*DLOAD\n105, P3, 10.\n\
         106, P3, 10.\n107, P3, 10.\n108, P3, 10.\n*END STEP\n"
    )
}

const PAIR: &str = "*CONTACT PAIR, INTERACTION=I\nSUP, SLOW\n";

/// The pressure is 10 everywhere. Two of four faces of the lower square are not named: they bear half of the force by their own half of the facets
/// in contact, a quarter of all; 2 %: the pressure falls off within the penetration from the edges.
#[test]
fn faces_that_no_pair_names_are_told_with_their_force() {
    let outcome = solved_text::<2>("part-named", &squares("5, S3\n6, S3\n", PAIR));
    let [warning] = &outcome.steps[0].warnings[..] else { panic!("{:?}", outcome.steps[0].warnings) };
    assert!(
        warning.contains("'LOWER' and 'UPPER' also press one another outside the surfaces of the contact pair"),
        "{warning}"
    );
    assert!(warning.contains("7 S3") && warning.contains("8 S3") && !warning.contains("6 S3"), "{warning}");
    let number = |before: &str| -> f64 {
        let rest = warning.split(before).nth(1).unwrap();
        rest.split(|c: char| !(c.is_ascii_digit() || "e.-".contains(c)))
            .next()
            .unwrap()
            .trim_end_matches('.')
            .parse()
            .unwrap()
    };
    let (outside, total) = (number("with "), number("normal force of "));
    assert!((total - 10.0).abs() < 0.02 && (outside - 2.5).abs() < 0.05, "{warning}");
}

#[test]
fn whole_surfaces_and_general_contact_say_nothing() {
    let whole = "5, S3\n6, S3\n7, S3\n8, S3\n";
    let general = "*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n*CONTACT PROPERTY ASSIGNMENT\n,, I\n";
    for (surface, pair) in [(whole, PAIR), ("5, S3\n", general)] {
        let outcome = solved_text::<2>("named", &squares(surface, pair));
        assert!(outcome.steps[0].warnings.is_empty(), "{:?}", outcome.steps[0].warnings);
    }
}

/// Cells that are there twice have the labels of the file, and the line of the second.
#[test]
fn duplicates_have_their_labels() {
    let text = squares("5, S3\n", PAIR)
        .replace("*MATERIAL", "*ELEMENT, TYPE=CPE4, ELSET=UPPER\n4711, 101, 102, 107, 106\n*MATERIAL");
    assert_eq!(said(&text, "twice.inp"), "nothing");
    let file = std::env::temp_dir().join(format!("fmc-deck-twice-{}.inp", std::process::id()));
    std::fs::write(&file, &text).unwrap();
    let deck = Deck::read(&file).unwrap();
    let analysis = Analysis::<2>::new(&deck, SolveOptions::default()).unwrap();
    let error =
        analysis.solve(&mut |_, _| std::ops::ControlFlow::Continue(()), &mut |_, _| Ok(())).unwrap_err().to_string();
    std::fs::remove_file(file).unwrap();
    let line = text.lines().position(|line| line.starts_with("4711,")).unwrap() + 1;
    assert!(error.contains(&format!("inp:{line}: elements 101 and 4711 have the same nodes")), "{error}");
}
