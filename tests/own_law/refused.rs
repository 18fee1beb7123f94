//! Laws that fail, and what a pair cannot have: nothing changes then.

use crate::laws::{One, PointByPoint, bilinear};
use crate::{held, in_the_plane, moved, options};
use fmc_contact::contact::{Cohesive, Interface, InterfaceLaw, LawFailure, LawPoints, LawResponse, PairOptions};
use fmc_contact::overlap::Partner::Body;
use fmc_contact::{Contact, EnergyLaw, Error, LawFault, Options};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// The bilinear law until it is told to do something wrong.
struct Faulty(Arc<AtomicUsize>);

const FAULTS: [&str; 6] = [
    "",
    "the law of the interface of bodies 0 and 1, at point 3: number 1 of the traction is NaN, at a jump of [",
    "the law of the interface of bodies 0 and 1, at point 0: number 2 of the tangent is inf, at a jump of [",
    "the law of the interface of bodies 0 and 1, at point 1: number 0 of the history is NaN, at a jump of [",
    "the law of the interface of bodies 0 and 1, at point 2: number 0 of the dissipated energy is NaN, at a jump of [",
    "the law of the interface of bodies 0 and 1, at point 4: it has melted",
];

impl InterfaceLaw for Faulty {
    fn history_count(&self) -> usize {
        2
    }

    fn respond(&self, points: &LawPoints<'_>, response: &mut LawResponse<'_>) -> Result<(), LawFailure> {
        PointByPoint { count: 2, law: bilinear }.respond(points, response)?;
        match self.0.load(Ordering::Relaxed) {
            1 => response.tractions[3 * points.dim + 1] = f64::NAN,
            2 => response.tangents[2] = f64::INFINITY,
            3 => response.history[2] = f64::NAN,
            4 => response.dissipated[2] = f64::NAN,
            5 => return Err(LawFailure { point: Some(4), cause: "it has melted".to_owned() }),
            _ => {}
        }
        Ok(())
    }
}

#[test]
fn a_law_that_fails_is_named_with_the_pair_and_the_point_and_changes_nothing() {
    let scene = &in_the_plane(0.0)[0];
    let fault = Arc::new(AtomicUsize::new(0));
    let mut contact = held(scene, Faulty(Arc::clone(&fault)));
    let (first, next) = (moved(scene, [0.002, 0.01]), moved(scene, [0.01, 0.03]));
    contact.begin_step(&scene.coords).expect("a step");
    contact.commit_step(&first).expect("a step");
    let (history, forces) = (contact.law_history().expect("a history"), contact.evaluate(&next));
    for (number, text) in FAULTS.iter().enumerate().skip(1) {
        fault.store(number, Ordering::Relaxed);
        let errors = [contact.evaluate(&next).unwrap_err(), contact.commit_step(&next).unwrap_err()];
        for error in errors {
            assert!(error.to_string().starts_with(text), "{error}");
        }
        assert_eq!(contact.law_history().expect("a history"), history);
    }
    fault.store(0, Ordering::Relaxed);
    assert_eq!(contact.evaluate(&next), forces);
}

/// What is left unwritten counts as not finite.
#[test]
fn a_law_that_forgets_a_number_is_refused() {
    struct Silent;
    impl InterfaceLaw for Silent {
        fn respond(&self, _: &LawPoints<'_>, _: &mut LawResponse<'_>) -> Result<(), LawFailure> {
            Ok(())
        }
    }
    let scene = &in_the_plane(0.0)[0];
    let error = held(scene, Silent).evaluate(&scene.coords).unwrap_err();
    assert!(matches!(error, Error::InterfaceLaw(LawFault { bodies: [0, 1], point: Some(0), .. })), "{error}");
}

#[test]
fn what_a_pair_with_a_law_cannot_have_is_refused_and_changes_nothing() {
    let scene = &in_the_plane(0.0)[0];
    let mut contact = held(scene, PointByPoint { count: 2, law: bilinear });
    let (pair, coords) = ([Body(0), Body(1)], moved(scene, [0.0, 0.01]));
    let before = contact.evaluate(&coords);
    let law = || Arc::new(PointByPoint { count: 0, law: |_: &[f64], _: &mut [f64]| unreachable!() as One });
    let refused: [(PairOptions, &str); 5] = [
        (PairOptions::default(), "another interface than 'law'"),
        (
            PairOptions { friction_coefficient: Some(0.3), ..options() },
            "friction of bodies with an interface by your own law",
        ),
        (PairOptions { law: Some(EnergyLaw::depth(1.0)), ..options() }, "a law of contact together with"),
        (PairOptions { excluded: true, ..options() }, "both excluded and has an interface by your own law"),
        (PairOptions { interface: Interface::Law { reach: -1.0 }, ..options() }, "reach"),
    ];
    for (options, text) in refused {
        let error = contact.set_law_pair(pair, options, law()).unwrap_err().to_string();
        assert!(error.contains(text), "{error}");
    }
    assert!(contact.set_law_pair([Body(1), Body(1)], options(), law()).is_err());
    let too_far = PairOptions { interface: Interface::Law { reach: 1e-9 }, ..options() };
    let apart = &in_the_plane(0.03)[0];
    let mut far = apart.contact(Options::new(EnergyLaw::depth(1.0)));
    assert!(matches!(far.set_law_pair(pair, too_far, law()), Err(Error::Untied { .. })));
    let without = far.set_pair_options(pair, Some(options())).unwrap_err();
    assert!(without.to_string().contains("without the law"), "{without}");
    assert_eq!(far.pair_options(pair), Ok(None));
    assert!(contact.set_law_history(&[0.0; 3]).is_err());
    let mut history = contact.law_history().expect("a history");
    history[5] = f64::INFINITY;
    let bad = contact.set_law_history(&history);
    assert_eq!(bad, Err(Error::BadEntry { array: "history", entry: 5, value: f64::INFINITY }));
    assert_eq!(contact.evaluate(&coords), before);
}

/// The same options once more keep law and history; another law begins with zeros; another interface takes its place.
#[test]
fn options_that_are_set_again_keep_the_law() {
    let scene = &in_the_plane(0.0)[0];
    let mut contact = held(scene, PointByPoint { count: 2, law: bilinear });
    let (pair, coords) = ([Body(0), Body(1)], moved(scene, [0.0, 0.01]));
    contact.begin_step(&scene.coords).expect("a step");
    contact.commit_step(&coords).expect("a step");
    let history = contact.law_history().expect("a history");
    assert!(history.iter().any(|x| *x > 0.0));
    contact.set_pair_options([Body(1), Body(0)], Some(options())).expect("options");
    assert_eq!(contact.law_history().expect("a history"), history);
    contact.set_law_pair(pair, options(), Arc::new(PointByPoint { count: 2, law: bilinear })).expect("a law");
    assert!(contact.law_history().expect("a history").iter().all(|x| *x == 0.0));
    let count = |contact: &Contact<2>| {
        (contact.law_points(&coords).expect("points").len(), contact.cohesive_points(&coords).expect("points").len())
    };
    let all = count(&contact).0;
    contact.set_pair_options(pair, Some(PairOptions::with_cohesive(Cohesive::new(2.0, 0.1)))).expect("options");
    assert_eq!(count(&contact), (0, all));
    contact.set_pair_options(pair, None).expect("options");
    assert_eq!(count(&contact), (0, 0));
}
