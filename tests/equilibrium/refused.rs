//! What nothing stops is refused, with the body and its direction.

use super::bodies::{Block, Host};
use fmc_contact::Error;
use fmc_contact::contact::Options;
use fmc_contact::contact::equilibrium::DriverOptions;

/// A block that is pulled off its floor.
#[test]
fn lift_off_is_refused() {
    for gap in [0.0, 1e-6, -1e-6] {
        let mut host = Host::new(&[Block::unit(0.0, gap, 3)]);
        host.add_weight(0, [0.0, 10.0]);
        let mut contact = host.contact(Some(0.0), 0.0);
        let refusal = host.solved(&mut contact, None).unwrap_err();
        let unheld = refusal.unheld.expect(&refusal.text);
        assert_eq!((unheld.body, unheld.is_rotation), (0, false));
        assert!((unheld.direction[1] - 1.0).abs() < 1e-2, "{:?}", unheld.direction);
        assert!(refusal.text.contains("body 0 along (0.00, 1.00)"), "{}", refusal.text);
    }
}

/// A block beside another one falls past it.
#[test]
fn a_body_beside_the_other_is_refused() {
    let mut host = Host::new(&[Block::unit(0.0, 0.0, 3), Block::unit(1.5, 0.2, 3)]);
    host.hold(0, |x| x[0] < 1.2);
    host.hold(1, |x| x[0] < 1.2 && x[1] < 0.01);
    host.add_weight(1, [0.0, -10.0]);
    let mut contact = host.contact(None, 0.0);
    let refusal = host.solved(&mut contact, None).unwrap_err();
    let unheld = refusal.unheld.expect(&refusal.text);
    assert_eq!(unheld.body, 1);
    assert!(unheld.direction[1] < -0.9, "{:?}", unheld.direction);
}

/// On a slope steeper than friction bears, and on one that it bears.
#[test]
fn a_slope_beyond_friction_is_refused() {
    for (friction, stands) in [(0.0, false), (0.3, false), (0.5, true)] {
        let mut host = Host::new(&[Block::unit(0.0, 0.0, 4)]);
        let angle = 20f64.to_radians();
        host.add_weight(0, [-1e3 * angle.sin(), -1e3 * angle.cos()]);
        let mut contact = host.contact(Some(0.0), friction);
        match host.solved(&mut contact, None) {
            Ok(found) => {
                assert!(stands, "friction {friction}");
                let force = found.contact.obstacles[0].force;
                assert!((force[1] / (-1e3 * angle.cos()) - 1.0).abs() < 1e-7, "{force:?}");
                assert!((force[0] / (-1e3 * angle.sin()) - 1.0).abs() < 1e-7, "{force:?}");
            }
            Err(refusal) => {
                assert!(!stands, "friction {friction}: {}", refusal.text);
                let unheld = refusal.unheld.expect(&refusal.text);
                assert!(unheld.direction[0] < -0.9, "friction {friction}: {:?}", unheld.direction);
            }
        }
    }
}

/// After a refusal the contact has what it had: no multipliers, and it evaluates.
#[test]
fn a_refusal_leaves_the_contact_as_it_was() {
    let mut host = Host::new(&[Block::unit(0.0, 1e-3, 3)]);
    host.add_weight(0, [5.0, 10.0]);
    let mut contact = host.contact(Some(0.0), 0.2);
    host.solved(&mut contact, None).unwrap_err();
    assert!(contact.multipliers().is_empty());
    assert_eq!(contact.evaluate(&host.coords).unwrap().obstacles[0].force, [0.0, 0.0]);
}

/// A block whose top is pushed through its foot: what is in the way is named.
#[test]
fn a_body_pushed_through_itself_is_told_with_a_cell() {
    let mut host = Host::new(&[Block::unit(0.0, 0.0, 2)]);
    host.hold(0, |x| x[1] < 0.01 || x[1] > 0.99);
    host.hold(1, |x| x[1] < 0.01 || x[1] > 0.99);
    let mut contact = host.contact(Some(-5.0), 0.0);
    let target: Vec<f64> = host.coords.iter().flat_map(|x| [0.0, if x[1] > 0.99 { -3.0 } else { 0.0 }]).collect();
    let refusal = host.solved(&mut contact, Some(&target)).unwrap_err();
    assert!(refusal.text.contains("cell "), "{}", refusal.text);
}

/// A penetration that is asked for where none can be had is refused before anything is solved.
#[test]
fn a_penetration_with_self_contact_is_refused_at_once() {
    let mut host = Host::new(&[Block::unit(0.0, 1e-3, 2)]);
    host.add_weight(0, [0.0, -10.0]);
    let mut contact = host.contact(Some(0.0), 0.0);
    contact.set_options(Options { self_contact: true, ..*contact.options() }).unwrap();
    let options = DriverOptions { penetration: 1e-6, ..DriverOptions::default() };
    let refusal = host.solved_with(&mut contact, None, options).unwrap_err();
    assert!(
        matches!(refusal.error, Some(Error::Unsupported { what }) if what.contains("self-contact")),
        "{}",
        refusal.text
    );
    assert_eq!((refusal.solves, refusal.residuals.len()), (0, 0));
    assert!(contact.layer_stiffness().is_none());
}
