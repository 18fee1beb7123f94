//! All that a host can see of a contact.

use fmc_contact::Contact;
use fmc_contact::contact::TangentPart;
use fmc_contact::overlap::Partner::{Body, Obstacle};

/// A debug print tells every bit of every number, and 0 from −0.
pub(crate) type Look = Vec<(&'static str, String)>;

/// How many of a look are results; all others were set.
pub(crate) const RESULTS: usize = 9;

/// Results at these coordinates, and what was set.
pub(crate) fn look(contact: &Contact<2>, coords: &[[f64; 2]]) -> Look {
    let masses = vec![1.0; coords.len()];
    let pairs = [[Body(0), Body(1)], [Body(1), Body(1)], [Body(0), Obstacle(0)], [Body(1), Obstacle(1)]];
    let mut seen = vec![
        ("forces", format!("{:?}", contact.evaluate(coords))),
        ("forces of the true surfaces", format!("{:?}", contact.evaluate_true(coords))),
        ("tangent", format!("{:?}", contact.tangent(coords, TangentPart::Full))),
        ("nodal contact", format!("{:?}", contact.nodal_contact(coords))),
        ("contact points", format!("{:?}", contact.contact_points(coords))),
        ("gap constraints", format!("{:?}", contact.gap_constraints(coords, 0.02))),
        ("overlaps", format!("{:?}", contact.overlaps(coords))),
        ("penetration", format!("{:?}", contact.nodal_penetration(coords, 0.02))),
        ("stable step", format!("{:?}", contact.stable_step(coords, &masses))),
        ("slip", format!("{:?}", contact.slip())),
        ("multipliers", format!("{:?}", contact.multipliers())),
        ("options", format!("{:?} {}", contact.options(), contact.obstacle_rotations())),
        ("options of pairs", format!("{:?}", pairs.map(|pair| contact.pair_options(pair)))),
    ];
    let poses = (0..contact.obstacle_count()).map(|o| contact.obstacle(o).map(|obstacle| obstacle.pose));
    seen.push(("poses", format!("{:?}", poses.collect::<Vec<_>>())));
    seen
}

/// The forces and what was set, for many contacts.
pub(crate) fn glance(contact: &Contact<2>, coords: &[[f64; 2]]) -> Look {
    vec![
        ("forces", format!("{:?}", contact.evaluate(coords))),
        ("contact points", format!("{:?}", contact.contact_points(coords))),
        ("slip", format!("{:?}", contact.slip())),
        ("multipliers", format!("{:?}", contact.multipliers())),
        ("options", format!("{:?} {}", contact.options(), contact.obstacle_rotations())),
    ]
}

/// Asserts that two looks are one.
pub(crate) fn same(found: &Look, expected: &Look, what: &dyn Fn() -> String) {
    for ((name, found), (_, expected)) in found.iter().zip(expected) {
        assert!(found == expected, "{}: other {name}\n{}", what(), difference(found, expected));
    }
}

/// Where two prints part.
fn difference(found: &str, expected: &str) -> String {
    let at = found.bytes().zip(expected.bytes()).take_while(|(x, y)| x == y).count().saturating_sub(60);
    let part = |text: &str| text.chars().skip(at).take(160).collect::<String>();
    format!("found    …{}\nexpected …{}", part(found), part(expected))
}
