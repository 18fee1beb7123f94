//! The check of a law without a contact.

use crate::laws::{Answer, Facet, One, capped, coulomb, norm, stribeck, weakening};
use fmc_contact::Error;
use fmc_contact::contact::{FrictionLaw, FrictionLawCheck, check_friction_law};
use std::sync::atomic::{AtomicUsize, Ordering};

fn check(law: &dyn FrictionLaw, dim: usize) -> fmc_contact::contact::FrictionLawReport {
    check_friction_law(law, &FrictionLawCheck { time_step: 0.1, ..FrictionLawCheck::new(dim, 2.0, 0.3) })
        .expect("a report")
}

#[test]
fn laws_that_are_right_pass() {
    for dim in [2, 3] {
        let laws: [Box<dyn FrictionLaw>; 4] = [
            Box::new(coulomb(0.3)),
            Box::new(capped(0.3, 0.4)),
            Box::new(stribeck([0.1, 0.2, 0.05, 0.5])),
            Box::new(weakening([0.6, 0.2, 0.1])),
        ];
        for law in laws {
            let report = check(&*law, dim);
            assert!(report.is_right() && report.largest_error < 1e-6, "{report:?}");
        }
    }
}

/// μ(v) p with v by the size of the slip, and one thing wrong.
fn wrong(what: usize) -> impl FrictionLaw {
    One(1, move |facet: &Facet| -> Answer {
        let v = norm(facet.slip);
        let (limit, by_p, by_v) = ((0.3 + v * v) * facet.pressure, 0.3 + v * v, 2.0 * v * facet.pressure);
        let late = if facet.history[0] > 0.0 && what == 4 { 1.001 } else { 1.0 };
        match what {
            1 => (limit, 0.3, by_v, vec![1.0]),
            2 => (limit, by_p, -by_v, vec![1.0]),
            3 => (limit, by_p, 0.0, vec![1.0]),
            _ => (limit, late * by_p, by_v, vec![1.0]),
        }
    })
}

#[test]
fn what_is_wrong_is_found_with_place_and_sizes() {
    assert!(check(&wrong(0), 3).is_right());
    for (what, texts) in [
        (1, ["the derivative of the limit by the pressure is given as 3.000000e-1", "differences of the limit have "]),
        (2, ["the derivative of the limit by slip ", "its sign is reversed"]),
        (3, ["the derivative of the limit by slip ", "the entry is missing"]),
        (4, ["the derivative of the limit by the pressure is given as ", "off by "]),
    ] {
        for dim in [2, 3] {
            let report = check(&wrong(what), dim);
            let fault = report.faults().next().expect("a fault");
            assert!(fault.starts_with("derivatives: WRONG: at a pressure of "), "{fault}");
            assert!(texts.iter().all(|text| fault.contains(text)), "{what}: {fault}");
        }
    }
}

#[test]
fn laws_that_keep_something_or_mix_facets_are_found() {
    let calls = AtomicUsize::new(0);
    let keeps = One(0, move |facet: &Facet| {
        let more = 1e-9 * calls.fetch_add(1, Ordering::Relaxed) as f64;
        (0.3 * facet.pressure + more, 0.3, 0.0, Vec::new())
    });
    assert!(check(&keeps, 2).faults().any(|text| text.starts_with("answers: WRONG")));
}

#[test]
fn what_cannot_be_asked_is_refused() {
    let ask = |check: FrictionLawCheck| check_friction_law(&coulomb(0.3), &check).unwrap_err();
    let good = FrictionLawCheck::new(2, 1.0, 1.0);
    assert!(matches!(ask(FrictionLawCheck { dim: 4, ..good.clone() }), Error::Dimension { found: 4, .. }));
    assert!(matches!(
        ask(FrictionLawCheck { pressure: 0.0, ..good.clone() }),
        Error::NotPositive { name: "pressure", .. }
    ));
    assert!(matches!(
        ask(FrictionLawCheck { slip: f64::NAN, ..good.clone() }),
        Error::NotPositive { name: "slip", .. }
    ));
    assert!(matches!(
        ask(FrictionLawCheck { time_step: -1.0, ..good.clone() }),
        Error::NotPositive { name: "time_step", .. }
    ));
    assert!(matches!(ask(FrictionLawCheck { fields: vec![1.0, f64::NAN], ..good }), Error::BadEntry { entry: 1, .. }));
}
