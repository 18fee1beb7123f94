//! A contact that is made anew where a step began, with the slip, the multipliers and the options of then, goes on as the first.

use crate::looks::{look, same};
use crate::problem::{DELTA, moved, problems};
use fmc_contact::EnergyLaw;

#[test]
fn a_restart_goes_on_as_if_nothing_had_stopped() {
    let scene = crate::problem::scene();
    let path: Vec<_> =
        (0..5).map(|step| moved(&scene, 1.5e-4 * step as f64, DELTA * (0.5 - 0.2 * step as f64))).collect();
    for problem in problems() {
        let mut contact = problem.contact(&scene);
        contact.begin_step(&path[0]).expect("a step");
        for (now, next) in path[1..].iter().zip(&path[2..]) {
            if problem.has_friction() {
                contact.commit_step(now).expect("a step");
            } else if !matches!(problem.options.law, EnergyLaw::Volume { .. }) {
                contact.augment(now, 0.02, 0.0).expect("multipliers");
            }
            let mut other = problem.contact(&scene);
            other.begin_step(if problem.has_friction() { now } else { &path[0] }).expect("a step");
            other.set_slip(&contact.slip().expect("a step")).expect("a slip");
            other.set_multipliers(&contact.multipliers()).expect("multipliers");
            same(&look(&other, next), &look(&contact, next), &|| format!("{problem:?}"));
            if problem.has_friction() {
                let slips = [&mut contact, &mut other].map(|contact| {
                    contact.freeze_friction(next).expect("a step has begun");
                    format!("{:?}", contact.evaluate(&path[4]))
                });
                assert_eq!(slips[0], slips[1], "{problem:?}");
                contact.release_friction();
            }
        }
    }
}
