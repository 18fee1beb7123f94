//! A body that touches itself.

use crate::scene::{path, solved_text};

/// The arms of a U are closed by 3 where their gap is 2, in all ways to ask for self-contact. CalculiX 2.20, with the same slope, has 235.1119 at the
/// tip; without contact it is 18.7. 2e-3: it measures penetration at points of its faces.
#[test]
fn arms_of_a_profile_press_one_another() {
    let text = std::fs::read_to_string(path("u_profile.inp")).unwrap();
    let pair = "*CONTACT PAIR,INTERACTION=I,TYPE=SURFACE TO SURFACE\nSI,SI\n";
    assert!(text.contains(pair));
    let general = "*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n*CONTACT PROPERTY ASSIGNMENT\n,, I\n";
    for (name, ways) in [("both", pair), ("one", &pair.replace("SI,SI", "SI")), ("all", general)] {
        let outcome = solved_text::<3>(&format!("u-{name}"), &text.replace(pair, ways));
        let step = &outcome.steps[0];
        let force = step.sets[0].1[2];
        assert!((force / -235.1119 - 1.0).abs() < 2e-3, "{name}: {force}");
        assert!(step.warnings.is_empty(), "{name}: {:?}", step.warnings);
    }
}
