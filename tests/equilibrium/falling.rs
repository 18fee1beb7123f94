//! A load with friction that falls to a part, and one that stays.

use super::bodies::Host;
use super::unloaded::{WEIGHT, loaded, scene};
use fmc_contact::contact::Contact;
use fmc_contact::contact::equilibrium::{DriverOptions, Equilibrium, Found};

/// The largest of all entries.
fn largest(all: impl IntoIterator<Item = f64>) -> f64 {
    all.into_iter().fold(0.0, |most, one| most.max(one.abs()))
}

/// The end of a history of loads, and what friction has dissipated since the first of them.
fn through(host: &Host, parts: &[f64]) -> (Vec<Found<2>>, f64) {
    let mut contact = host.contact(Some(0.0), 0.3);
    contact.begin_step(&host.coords).unwrap();
    let mut ends: Vec<Found<2>> = Vec::new();
    for part in parts {
        let x = ends.last().map_or_else(|| vec![0.0; host.load.len()], |end| end.x.clone());
        ends.push(loaded(host, *part, &mut contact, &x));
    }
    let dissipated = ends[1..].iter().map(|end| end.contact.friction.dissipated).sum();
    (ends, dissipated)
}

/// Limits of friction fall with the load, below what facets carry: they give back what is elastic first, and few slide. In one step and in
/// many the end is the same, and so is what is dissipated.
#[test]
fn a_load_falls_to_a_part_in_few_solves() {
    let host = scene();
    for part in [0.5, 0.1] {
        let (ends, dissipated) = through(&host, &[1.0, part]);
        let end = &ends[1];
        assert!(end.solves <= 6 + 3 * end.updates, "{part}: {} solves, {} updates", end.solves, end.updates);
        let floor = end.contact.obstacles[0].force[1] / (-2.0 * part * WEIGHT);
        assert!((floor - 1.0).abs() < 1e-7, "{part}: {floor}");
        let many: Vec<f64> = (0..=10).map(|k| 1.0 - (1.0 - part) * f64::from(k) / 10.0).collect();
        let (small, of_small) = through(&host, &many);
        let (from, to) = (&ends[0].contact.forces, &small[10].contact.forces);
        let change = largest(from.iter().zip(to).flat_map(|(a, b)| [a[0] - b[0], a[1] - b[1]]));
        // A search leaves a thousandth of what bodies do by what is left of the penetration, at both ends.
        let differs = largest(end.contact.forces.iter().zip(to).flat_map(|(a, b)| [a[0] - b[0], a[1] - b[1]])) / change;
        assert!(differs < 5e-3, "{part}: forces differ by {differs:e} of their change");
        // By the work that friction could do at most.
        let most = 0.3 * 2.0 * WEIGHT * largest(end.x.iter().zip(&ends[0].x).map(|(a, b)| a - b));
        assert!((dissipated - of_small).abs() < 1e-2 * most, "{part}: {dissipated:e}, {of_small:e} of {most:e}");
    }
}

/// Without friction, and where there is no load, a step in which nothing changes is answered without a solve.
#[test]
fn a_step_in_which_nothing_changes_takes_no_solve() {
    let mut host = scene();
    host.hold(0, |_| true);
    let mut contact = host.contact(Some(0.0), 0.0);
    let first = host.solved(&mut contact, None).unwrap();
    let again = again(&host, &mut contact, &first);
    assert_eq!((again.solves, again.updates), (0, 0));
    assert_eq!(again.x, first.x);
    let host = scene();
    let (ends, _) = through(&host, &[1.0, 0.0, 0.0, 0.0]);
    assert_eq!(ends[2..].iter().map(|end| end.solves).collect::<Vec<_>>(), [0, 0]);
    assert_eq!(ends[3].x, ends[1].x);
}

/// With friction slip is counted anew from the place of now, which changes forces by the strains that a step has brought.
#[test]
fn a_step_in_which_nothing_changes_keeps_its_multipliers() {
    let host = scene();
    let (ends, _) = through(&host, &[1.0, 1.0]);
    assert!(ends[1].solves <= 2 && ends[1].updates == 0, "{} solves, {} updates", ends[1].solves, ends[1].updates);
    let moved = largest(ends[1].x.iter().zip(&ends[0].x).map(|(a, b)| a - b)) / largest(ends[0].x.iter().copied());
    assert!(moved < 1e-4, "{moved:e}");
}

fn again(host: &Host, contact: &mut Contact<2>, first: &Found<2>) -> Found<2> {
    let mut search = Equilibrium::new(contact, host.unknowns(), &first.x, None, DriverOptions::default()).unwrap();
    search.run(contact, |contact, request| host.answer(contact, request)).unwrap().unwrap().clone()
}
