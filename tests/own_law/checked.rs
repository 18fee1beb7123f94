//! A law is checked by differences, and what is wrong is said in words.

use crate::laws::{One, PointByPoint, bilinear, unsymmetric};
use fmc_contact::contact::{InterfaceLaw, LawCheck, LawFailure, LawPoints, LawReport, LawResponse, check_law};
use fmc_contact::{Error, LawFault};
use std::sync::atomic::{AtomicUsize, Ordering};

fn checked(law: impl Fn(&[f64], &mut [f64]) -> One + Send + Sync, count: usize, dim: usize, scale: f64) -> LawReport {
    check_law(&PointByPoint { count, law }, &LawCheck::new(dim, scale)).expect("an answer")
}

/// The bilinear law has corners where damage begins and ends, and in compression; an opening of 0.05 is fifty times that where it begins, so that
/// differences with a step of 5e-8 have 1e-8 or so.
#[test]
fn laws_that_are_right_are_found_right() {
    for dim in [2, 3] {
        for scale in [1e-3, 0.05, 0.2] {
            let report = checked(bilinear, 2, dim, scale);
            assert!(report.is_right() && report.largest_error < 1e-6, "{report:?}");
        }
        let report = checked(unsymmetric, 2, dim, 0.1);
        assert!(report.is_right() && report.largest_error < 1e-7 && report.asymmetry > 0.1 && report.corners == 0);
        assert!(report.sentences.iter().any(|text| text.starts_with("symmetry: the tangent is not symmetric")));
    }
    let at_rest = LawCheck { jumps: vec![0.0, 0.0, 0.03, 0.01], ..LawCheck::new(2, 0.05) };
    let report = check_law(&PointByPoint { count: 2, law: bilinear }, &at_rest).expect("an answer");
    assert!(report.is_right(), "{report:?}");
}

#[test]
fn what_is_wrong_is_said_in_words() {
    let wrong = |change: fn(&mut One), text: &str| {
        let law = move |jump: &[f64], history: &mut [f64]| {
            let mut one = unsymmetric(jump, history);
            change(&mut one);
            one
        };
        let report = checked(law, 2, 2, 0.1);
        assert!(report.faults().count() == 1 && report.largest_error > 1e-5, "{report:?}");
        let fault = report.faults().next().expect("a fault");
        assert!(fault.contains(text), "{fault}");
    };
    wrong(|one| one.tangent.swap(1, 2), "rows and columns are exchanged");
    wrong(|one| one.tangent.iter_mut().for_each(|x| *x = -*x), "its sign is reversed");
    wrong(|one| one.tangent[1] = 0.0, "derivative of traction 0 by jump 1 is given as 0");
    wrong(|one| one.tangent[1] = 0.0, "the entry is missing");
    wrong(|one| one.tangent[3] *= 1.0001, "derivative of traction 1 by jump 1");
    // The secant of a softening law.
    let secant = |jump: &[f64], history: &mut [f64]| {
        let mut one = bilinear(jump, history);
        let dim = jump.len();
        one.tangent.fill(0.0);
        (0..dim).for_each(|i| one.tangent[i * dim + i] = one.traction[i] / jump[i]);
        one
    };
    assert!(!checked(secant, 2, 3, 0.05).is_right());
}

#[test]
fn a_law_that_keeps_something_itself_or_mixes_points_is_found_out() {
    let calls = AtomicUsize::new(0);
    let counting = |jump: &[f64], _: &mut [f64]| One {
        traction: jump.iter().map(|x| x * calls.fetch_add(1, Ordering::Relaxed) as f64).collect(),
        tangent: vec![1.0, 0.0, 0.0, 1.0],
        energies: [0.0; 2],
    };
    let report = checked(counting, 0, 2, 0.1);
    assert!(report.faults().next().is_some_and(|text| text.contains("not keep a state")), "{report:?}");
    struct Mixed;
    impl InterfaceLaw for Mixed {
        fn respond(&self, points: &LawPoints<'_>, response: &mut LawResponse<'_>) -> Result<(), LawFailure> {
            let mean = points.jumps.iter().sum::<f64>() / points.jumps.len() as f64;
            response.tractions.iter_mut().zip(points.jumps).for_each(|(t, x)| *t = x - mean);
            response.tangents.chunks_mut(4).for_each(|k| k.copy_from_slice(&[1.0, 0.0, 0.0, 1.0]));
            Ok(())
        }
    }
    let report = check_law(&Mixed, &LawCheck::new(2, 0.1)).expect("an answer");
    assert!(report.faults().any(|text| text.contains("points must not depend on one another")), "{report:?}");
    // A product of matrices may be summed in another order for one point.
    struct Rounded;
    impl InterfaceLaw for Rounded {
        fn respond(&self, points: &LawPoints<'_>, response: &mut LawResponse<'_>) -> Result<(), LawFailure> {
            let factor = if points.count == 1 { 1.0 + f64::EPSILON } else { 1.0 };
            response.tractions.iter_mut().zip(points.jumps).for_each(|(t, x)| *t = factor * points.fields[1] * x);
            response.tangents.chunks_mut(4).for_each(|k| k.copy_from_slice(&[3.0, 0.0, 0.0, 3.0]));
            Ok(())
        }
    }
    let report = check_law(&Rounded, &LawCheck { fields: vec![7.0, 3.0], ..LawCheck::new(2, 0.1) }).expect("an answer");
    assert!(
        report.is_right() && report.sentences[0].ends_with("other numbers of ranks may change results by as much"),
        "{report:?}"
    );
}

#[test]
fn what_cannot_be_checked_is_refused() {
    let law = PointByPoint { count: 2, law: bilinear };
    let refused = |check: LawCheck| check_law(&law, &check).unwrap_err();
    let wide = LawCheck::new(4, 0.1);
    assert!(matches!(refused(wide), Error::Dimension { .. }));
    for scale in [0.0, -1.0, f64::NAN] {
        assert!(matches!(refused(LawCheck::new(2, scale)), Error::NotPositive { name: "scale", .. }));
    }
    let jumps = |jumps: Vec<f64>| LawCheck { jumps, ..LawCheck::new(2, 0.1) };
    assert_eq!(refused(jumps(vec![0.1; 3])), Error::Length { array: "jumps", expected: 2, found: 3 });
    assert!(matches!(refused(jumps(vec![0.1, f64::INFINITY])), Error::BadEntry { array: "jumps", entry: 1, .. }));
    let history = LawCheck { history: vec![0.0; 3], ..jumps(vec![0.1; 4]) };
    assert_eq!(refused(history), Error::Length { array: "history", expected: 4, found: 3 });
    let nowhere = PointByPoint {
        count: 0,
        law: |_: &[f64], _: &mut [f64]| One { traction: vec![f64::NAN; 2], tangent: vec![0.0; 4], energies: [0.0; 2] },
    };
    assert!(matches!(
        check_law(&nowhere, &LawCheck::new(2, 0.1)),
        Err(Error::InterfaceLaw(LawFault { point: Some(0), .. }))
    ));
}
