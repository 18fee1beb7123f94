//! Cases with friction: every check of their files holds.

use super::driven::run;
use super::{Folder, document, finish};

/// The push up a slope by the load: NAFEMS' formula, and the tilt of the slope where it is soft.
#[test]
fn a_slider_is_pushed_up_a_slope() {
    for variant in [None, Some("tenth"), Some("fifth"), Some("frictionless"), Some("published")] {
        assert!(run("cgs4", variant).checks.len() >= 2, "{variant:?}");
    }
}

/// Cattaneo's and Mindlin's middle, which sticks.
#[test]
fn the_middle_of_a_line_contact_sticks() {
    assert_eq!(run("cattaneo", Some("coarse")).checks.len(), 2);
}

#[test]
fn a_block_slides_until_friction_has_stopped_it() {
    let folder = Folder::new("stop");
    let summary = finish(&document("stop", &["output.frames=0"]), &folder.0);
    assert_eq!(summary.checks.len(), 4);
    assert!(summary.is_ok(), "{:#?}", summary.checks);
}

/// By the law volume it leans forward, as one pressure for the whole contact bears no moment, and stops 1.2 % later.
#[test]
fn a_block_of_one_pressure_is_stopped_too() {
    let law = ["contact.law=\"volume\"", "contact.exponent=2.0", "contact.friction_stiffness=4e7"];
    // 2 k V is the pressure of its weight.
    let changes = [&["output.frames=0", "contact.stiffness=1e8"][..], &law].concat();
    let folder = Folder::new("stop-volume");
    let summary = finish(&document("stop", &changes), &folder.0);
    assert!((summary.figure("way").unwrap() / 0.169895 - 1.0).abs() < 0.02);
    assert!(summary.figure("energy_error_max").unwrap() < 0.01 && summary.figure("dissipated_least").unwrap() >= 0.0);
}
