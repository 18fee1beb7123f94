//! What cannot wear, and what is no wear.

use crate::{DELTA, STIFFNESS, WEAR, in_plane, laws, moved, on_a_plane, wearing};
use fmc_contact::contact::PairOptions;
use fmc_contact::contact::{Cohesive, Interface, WornFacet};
use fmc_contact::overlap::Partner;
use fmc_contact::{EnergyLaw, Error, Options, Warning};

#[test]
fn what_cannot_wear_is_named() {
    let scene = &in_plane()[0];
    let mut contact = on_a_plane(scene, laws(0.0)[0]);
    let (body, other, obstacle) = (Partner::Body(0), Partner::Body(1), Partner::Obstacle(0));
    let wear = PairOptions::with_wear(WEAR);
    let on_volume = PairOptions { law: Some(EnergyLaw::volume(1.0)), ..wear };
    let held = |own: PairOptions| PairOptions { wear_coefficients: WEAR, ..own };
    let by_own_law = PairOptions { interface: Interface::Law { reach: 2.0 }, ..PairOptions::default() };
    for (pair, options, wanted) in [
        ([body, obstacle], wear, "a wear coefficient of an obstacle, which does not wear"),
        ([obstacle, body], PairOptions::with_wear([1e-3, 0.0]), "of an obstacle, which does not wear"),
        ([body, body], wear, "a wear coefficient of a body with itself"),
        ([body, other], held(PairOptions::rough()), "a rough pair, which never slides"),
        ([body, other], held(PairOptions::tied(2.0)), "bodies that are tied"),
        ([body, other], held(PairOptions::no_separation(2.0)), "do not separate"),
        ([body, other], held(PairOptions::with_cohesive(Cohesive::new(1.0, 1.0))), "have a cohesive interface"),
        ([body, other], held(by_own_law), "or one by your own law"),
        ([body, other], on_volume, "the law volume, whose pressure is one for the whole pair"),
        ([body, other], PairOptions::with_wear([1.0, -1.0]), "wear_coefficient"),
        ([body, other], PairOptions::with_wear([f64::NAN, 1.0]), "wear_coefficient"),
        ([body, other], PairOptions::with_wear([f64::INFINITY, 1.0]), "wear_coefficient"),
    ] {
        let text = contact.set_pair_options(pair, Some(options)).expect_err(wanted).to_string();
        assert!(text.contains(wanted), "{text}");
    }
    // What was set before stays, in either order.
    let options = contact.pair_options([obstacle, body]).expect("a pair").expect("options");
    assert_eq!(options.wear_coefficients, [0.0, WEAR[0]]);
    let volume = Options { law: EnergyLaw::volume(1.0), ..laws(0.0)[0] };
    assert!(contact.set_options(volume).expect_err("wear").to_string().contains("law volume"));
    for cycles in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(contact.set_wear_cycles(cycles), Err(Error::NotPositive { name: "wear_cycles", .. })));
    }
}

#[test]
fn rows_that_are_no_wear_are_named() {
    let scene = &in_plane()[0];
    let mut contact = wearing(scene, laws(0.0)[0]);
    assert_eq!(contact.commit_step(&scene.coords), Err(Error::NoStep));
    contact.begin_step(&scene.coords).expect("a step");
    contact.commit_step(&moved(scene, 1, [0.3, 0.0])).expect("a step");
    let known = contact.worn_facets();
    let bad = |one: WornFacet| [known[0], one];
    let of = |row, what| Error::NoSuchRow { list: "worn facets", row, what };
    for (rows, wanted) in [
        (bad(WornFacet { facet: 10_000, ..known[1] }), of(1, "a facet that does not exist")),
        (bad(WornFacet { point: 1, ..known[1] }), of(1, "a point that does not move the facet")),
        (bad(known[0]), of(1, "a facet and a point that an earlier row names")),
    ] {
        assert_eq!(contact.set_worn_facets(&rows), Err(wanted));
    }
    for value in [-1.0, f64::NAN, f64::INFINITY] {
        for row in [WornFacet { depth: value, ..known[1] }, WornFacet { volume: value, ..known[1] }] {
            assert!(matches!(contact.set_worn_facets(&bad(row)), Err(Error::BadEntry { entry: 1, .. })));
        }
    }
    assert_eq!(contact.worn_facets(), known);
    contact.set_worn_facets(&known).expect("rows as they came");
    assert_eq!(contact.worn_facets(), known);
}

#[test]
fn a_step_that_wears_more_than_the_penetration_is_told() {
    let scene = &in_plane()[0];
    for options in laws(0.0).into_iter().chain(laws(0.3)) {
        let mut contact = wearing(scene, options);
        let coords = moved(scene, 1, [0.05, 0.0]);
        assert!(contact.evaluate(&coords).is_err() || options.friction.coefficient == 0.0);
        contact.begin_step(&scene.coords).expect("a step");
        // Both sides: K k s, the stick apart.
        let slid = 0.05 - options.friction.coefficient * DELTA;
        let each = (WEAR[0] + WEAR[1]) * STIFFNESS * slid;
        for (cycles, is_told) in [(1.0, false), (0.99 / each, false), (1.01 / each, true), (3.0 / each, true)] {
            contact.set_wear_cycles(cycles).expect("cycles");
            let warnings = contact.evaluate(&coords).expect("forces").warnings;
            let found = warnings.iter().find_map(|warning| match warning {
                Warning::LargeWear { a: Partner::Body(0), b: Partner::Body(1), ratio } => Some(*ratio),
                _ => None,
            });
            assert_eq!(found.is_some(), is_told, "{warnings:?}");
            // Facets at the rim slide by as much, but for their mean.
            assert!(found.is_none_or(|ratio| (ratio / (each * cycles) - 1.0).abs() < 2e-3), "{found:?}");
        }
    }
}

/// Cells below a surface that is worn through them are not measured, but named.
#[test]
fn cells_that_are_worn_through_are_named() {
    let scene = &in_plane()[0];
    let mut contact = wearing(scene, laws(0.0)[0]);
    contact.begin_step(&scene.coords).expect("a step");
    contact.commit_step(&moved(scene, 1, [0.3, 0.0])).expect("a step");
    // Cells are 0.3 high, and most nodes wear with two facets.
    let deep = |depth: f64| -> Vec<WornFacet> {
        contact.worn_facets().into_iter().map(|one| WornFacet { depth, ..one }).collect()
    };
    let (well, through) = (deep(0.05), deep(0.4));
    contact.set_worn_facets(&well).expect("wear");
    contact.evaluate(&scene.coords).expect("forces");
    contact.set_worn_facets(&through).expect("wear");
    let found = contact.evaluate(&scene.coords);
    assert!(matches!(found, Err(Error::InvertedCell { .. } | Error::ZeroMeasure { .. })), "{found:?}");
}
