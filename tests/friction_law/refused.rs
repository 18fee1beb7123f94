//! Laws that fail, and what a pair cannot have beside one: nothing changes then.

use crate::laws::{Facet, One, coulomb};
use crate::{BODIES, DELTA, ON_PLANE, along, depth, flat_block, in_plane, in_space, on_plane, rub};
use fmc_contact::contact::{
    FrictionFacets, FrictionLaw, FrictionResponse, GradientRequest, LawFailure, OrthotropicFriction, PairOptions,
    StaticFriction,
};
use fmc_contact::overlap::Partner;
use fmc_contact::{Error, FrictionFault};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Coulomb's law until it is told to do something wrong.
struct Faulty(Arc<AtomicUsize>);

const FAULTS: [&str; 7] = [
    "",
    ": number 0 of the limit is NaN, at a pressure of ",
    ": number 0 of the limit is -0.1, at a pressure of",
    ": number 0 of the derivative by the pressure is NaN, at a pressure of",
    ": number 0 of the derivative by the slip is inf, at a pressure of",
    ": number 1 of the history is NaN, at a pressure of",
    ": it has melted",
];

impl FrictionLaw for Faulty {
    fn history_count(&self) -> usize {
        2
    }

    fn respond(&self, facets: &FrictionFacets<'_>, response: &mut FrictionResponse<'_>) -> Result<(), LawFailure> {
        One(2, |facet: &Facet| (0.3 * facet.pressure, 0.3, 0.0, vec![1.0, 2.0])).respond(facets, response)?;
        match self.0.load(Ordering::Relaxed) {
            1 => response.limits[2] = f64::NAN,
            2 => response.limits[2] = -0.1,
            3 => response.by_pressure[2] = f64::NAN,
            4 => response.by_slip[2] = f64::INFINITY,
            5 => response.history[5] = f64::NAN,
            6 => return Err(LawFailure { point: Some(2), cause: "it has melted".to_owned() }),
            _ => {}
        }
        Ok(())
    }
}

#[test]
fn a_law_that_fails_is_named_with_the_pair_and_the_facet_and_changes_nothing() {
    let fault = Arc::new(AtomicUsize::new(0));
    let (scene, mut contact) = on_plane(&flat_block(), depth());
    rub(&mut contact, ON_PLANE, Faulty(Arc::clone(&fault)));
    contact.begin_step(&scene.coords).expect("a step");
    let (first, next) = (scene.coords.clone(), along(&scene, 5.0 * DELTA));
    contact.commit_step(&first).expect("a step");
    let (history, forces) = (contact.friction_history().expect("a history"), contact.evaluate(&next));
    for (number, text) in FAULTS.iter().enumerate().skip(1) {
        fault.store(number, Ordering::Relaxed);
        let errors = [
            contact.evaluate(&next).unwrap_err(),
            contact.commit_step(&next).unwrap_err(),
            contact.freeze_friction(&next).unwrap_err(),
        ];
        for error in errors {
            let Error::FrictionLaw(FrictionFault { sides, facet: Some(facet), .. }) = &error else { panic!("{error}") };
            assert_eq!(*sides, [("body", 0), ("obstacle", 0)]);
            let start = format!("the law of friction of body 0 and obstacle 0, at facet {facet}{text}");
            assert!(error.to_string().starts_with(&start), "{error}, {start}");
        }
        assert_eq!(contact.friction_history().expect("a history"), history);
    }
    fault.store(0, Ordering::Relaxed);
    assert_eq!(contact.evaluate(&next), forces);
}

#[test]
fn what_a_pair_cannot_have_beside_a_law() {
    let scene = in_space();
    let mut contact = scene.contact(depth());
    contact.begin_step(&scene.coords).expect("a step");
    let before = contact.evaluate(&scene.coords);
    let plain = PairOptions::default();
    let at_rest = Some(StaticFriction { coefficient: 0.5, weakening_slip: 1.0 });
    let across = OrthotropicFriction::new(0.1, [1.0, 0.0, 0.0]);
    for (options, text) in [
        (PairOptions::with_friction(0.2), "a coefficient of friction together with your own law of friction"),
        (
            PairOptions { static_friction: at_rest, ..plain },
            "a coefficient of friction together with your own law of friction",
        ),
        (
            PairOptions::with_orthotropic_friction(0.3, across),
            "a coefficient of friction together with your own law of friction",
        ),
        (PairOptions::rough(), "your own law of friction of a pair that is rough, tied,"),
        (PairOptions::tied(0.1), "your own law of friction of a pair that is rough, tied,"),
        (PairOptions::with_wear([0.1, 0.0]), "a wear coefficient together with your own law of friction"),
    ] {
        let error = contact.set_friction_law_pair(BODIES, options, Arc::new(coulomb(0.3))).unwrap_err();
        assert!(error.to_string().contains(text), "{error}");
        assert_eq!(contact.evaluate(&scene.coords), before);
    }
    let without = PairOptions { friction_law: true, ..plain };
    let error = contact.set_pair_options(BODIES, Some(without)).unwrap_err();
    assert!(error.to_string().contains("friction by your own law without the law"), "{error}");
    let nobody = [Partner::Body(0), Partner::Body(7)];
    let error = contact.set_friction_law_pair(nobody, plain, Arc::new(coulomb(0.3))).unwrap_err();
    assert!(matches!(error, Error::BodyOutOfRange { body: 7, .. }));
    assert_eq!(contact.evaluate(&scene.coords), before);
}

#[test]
fn it_needs_a_step_and_has_no_derivative_by_a_coefficient() {
    let scene = in_plane();
    let mut contact = scene.contact(depth());
    rub(&mut contact, BODIES, coulomb(0.3));
    assert_eq!(contact.evaluate(&scene.coords), Err(Error::NoStep));
    contact.begin_step(&scene.coords).expect("a step");
    let coords = along(&scene, 5.0 * DELTA);
    let seeds = vec![[1.0, 0.0]; coords.len()];
    let request = GradientRequest { friction: true, ..GradientRequest::default() };
    let error = contact.vjp(&coords, 0.0, Some(&seeds), &request).unwrap_err();
    assert!(error.to_string().contains("of your own law of friction"), "{error}");
    let request = GradientRequest { stiffness: true, ..GradientRequest::default() };
    let error = contact.vjp(&coords, 0.0, Some(&seeds), &request).unwrap_err();
    assert!(error.to_string().contains("with your own law of friction"), "{error}");
}

/// An obstacle that is removed takes its law along.
#[test]
fn a_law_goes_with_its_obstacle() {
    let (scene, mut contact) = on_plane(&flat_block(), depth());
    rub(&mut contact, ON_PLANE, coulomb(0.3));
    contact.remove_obstacle(0).expect("an obstacle");
    assert_eq!(contact.evaluate(&scene.coords).map(|found| found.energy), Ok(0.0));
}
