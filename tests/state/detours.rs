//! Any two settings, with other values before: the contact is as if it had had its last values alone.

use crate::looks::{RESULTS, glance, look, same};
use crate::problem::{Problem, moved, problems};
use crate::scene::Scene;
use crate::settings::{Setting, settings};
use fmc_contact::Contact;
use std::collections::BTreeSet;

/// Makes the last calls of settings, which succeed.
fn last<'a>(contact: &mut Contact<2>, settings: impl IntoIterator<Item = &'a Setting>) {
    settings.into_iter().for_each(|setting| {
        (setting.last)(contact).unwrap_or_else(|error| panic!("{}: {error}", setting.name));
    });
}

/// A contact that never had other values.
fn fresh(problem: Problem, scene: &Scene<2>, settings: &[Setting]) -> Contact<2> {
    let mut contact = problem.contact(scene);
    last(&mut contact, settings);
    contact
}

/// Calls `visit` with every other value of a setting twice, and with every two of those that fall to this of so many problems.
fn for_every_two(settings: &[Setting], (number, count): (usize, usize), mut visit: impl FnMut([(usize, usize); 2])) {
    let of_setting = |(s, setting): (usize, &Setting)| (0..setting.others.len()).map(move |other| (s, other)).collect();
    let values: Vec<(usize, usize)> = settings.iter().enumerate().flat_map::<Vec<_>, _>(of_setting).collect();
    for (i, &first) in values.iter().enumerate() {
        let others = values.iter().enumerate().filter(|(j, _)| *j == i || (i + j) % count == number);
        others.for_each(|(_, &second)| visit([first, second]));
    }
}

/// Looks at two contacts, at all that can be seen where there was but one other value.
fn compare(contacts: [&Contact<2>; 2], now: &[[f64; 2]], two: &[(usize, usize); 2], what: &dyn Fn() -> String) {
    let [found, expected] = contacts.map(|contact| match two[0] == two[1] {
        true => look(contact, now),
        false => glance(contact, now),
    });
    same(&found, &expected, what);
}

/// Before all last values, and in between.
#[test]
fn values_before_the_last_do_not_matter() {
    let scene = crate::problem::scene();
    let now = moved(&scene, 4e-4, -2e-4);
    let problems = problems();
    for (number, &problem) in problems.iter().enumerate() {
        let settings = settings(problem, &scene);
        let expected = fresh(problem, &scene, &settings);
        for_every_two(&settings, (number, problems.len()), |two| {
            let mut contact = problem.contact(&scene);
            for (setting, other) in two {
                // What does not go with the values at hand is refused, which changes nothing either.
                let _ = (settings[setting].others[other])(&mut contact);
                let _ = contact.evaluate(&now);
            }
            last(&mut contact, &settings);
            let names = || two.map(|(setting, other)| format!("{} {other}", settings[setting].name));
            compare([&contact, &expected], &now, &two, &|| format!("{problem:?} after {:?}", names()));
        });
    }
}

/// After all of them, and back again: but for what is released by a value in between, nothing has changed.
#[test]
fn values_that_are_given_back_do_not_matter() {
    let scene = crate::problem::scene();
    let now = moved(&scene, 4e-4, -2e-4);
    let problems = problems();
    for (number, &problem) in problems.iter().enumerate() {
        let settings = settings(problem, &scene);
        let expected = fresh(problem, &scene, &settings);
        for_every_two(&settings, (number, problems.len()), |two| {
            let mut contact = fresh(problem, &scene, &settings);
            for (setting, other) in two {
                let _ = (settings[setting].others[other])(&mut contact);
                let _ = contact.evaluate(&now);
            }
            let is_again = |setting: &&Setting| {
                let changed = two.map(|(changed, _)| &settings[changed]);
                changed.iter().any(|changed| changed.name == setting.name || changed.releases.contains(&setting.name))
            };
            last(&mut contact, settings.iter().filter(is_again));
            let names = || two.map(|(setting, other)| format!("{} {other}", settings[setting].name));
            compare([&contact, &expected], &now, &two, &|| format!("{problem:?}, {:?} and back", names()));
        });
    }
}

/// Every setting has a say in some problem, so that the tests above have something to see.
#[test]
fn other_values_matter() {
    let scene = crate::problem::scene();
    let now = moved(&scene, 4e-4, -2e-4);
    // Nothing but the time depends on these.
    let silent = BTreeSet::from(["threads", "checks", "ranks"]);
    let (mut all, mut seen) = (BTreeSet::new(), BTreeSet::new());
    for problem in problems() {
        let settings = settings(problem, &scene);
        let expected = look(&fresh(problem, &scene, &settings), &now);
        for setting in settings.iter().filter(|setting| !setting.others.is_empty()) {
            all.insert(setting.name);
            let is_seen = setting.others.iter().any(|other| {
                let mut contact = fresh(problem, &scene, &settings);
                // What does not go with all other values is refused.
                other(&mut contact).is_ok() && look(&contact, &now)[..RESULTS] != expected[..RESULTS]
            });
            if is_seen {
                seen.insert(setting.name);
            }
        }
    }
    assert_eq!(all.difference(&seen).copied().collect::<BTreeSet<_>>(), silent);
}
