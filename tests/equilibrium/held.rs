//! Bodies that their supports hold: the stiffness that is found, and what is prescribed.

use super::bodies::{Block, Host, POISSON, YOUNG};
use fmc_contact::overlap::Partner;

fn confined(gap: f64, cells: usize) -> Host {
    let mut host = Host::new(&[Block::unit(0.0, gap, cells)]);
    host.hold(0, |_| true);
    host
}

/// M, the stiffness of a confined column.
fn oedometer() -> f64 {
    YOUNG * (1.0 - POISSON) / ((1.0 + POISSON) * (1.0 - 2.0 * POISSON))
}

/// The layer of a confined body is its compression modulus by the height of its cells, and the pair has 7.5 times that.
#[test]
fn the_stiffness_is_that_of_the_layer_of_cells() {
    let mut host = confined(0.0, 4);
    host.hold(1, |x| x[1] > 0.99);
    let mut contact = host.contact(Some(0.0), 0.0);
    host.solved(&mut contact, None).unwrap();
    let layers = contact.layer_stiffness().unwrap();
    let layer = layers.near[&(0, Partner::Obstacle(0))];
    // The rims of the layer shear, since nothing is held sideways in K: by a tenth with 4 cells.
    assert!((layer / (4.0 * oedometer()) - 1.0).abs() < 0.15, "{layer}");
    let k = layers.of_pair([Partner::Body(0), Partner::Obstacle(0)]);
    assert!((k / (7.5 * layer) - 1.0).abs() < 1e-12);
}

/// A confined column pressed by 1e-2: M times the strain, to a part in a thousand, without a number that was chosen.
#[test]
fn a_confined_column_has_its_closed_form() {
    let mut host = confined(0.0, 4);
    host.hold(1, |x| x[1] > 0.99);
    let mut contact = host.contact(Some(0.0), 0.0);
    let pressed: Vec<f64> = host.coords.iter().flat_map(|x| [0.0, if x[1] > 0.99 { -0.01 } else { 0.0 }]).collect();
    let found = host.solved(&mut contact, Some(&pressed)).unwrap();
    let force = -found.contact.obstacles[0].force[1];
    assert!((force / (0.01 * oedometer()) - 1.0).abs() < 1e-3, "{force}");
    assert!(found.solves <= 6 && found.rigid_steps == 0, "{} solves", found.solves);
    // What holds the top is what the floor bears.
    let held: f64 =
        (0..host.coords.len()).filter(|&n| host.coords[n][1] > 0.99).map(|n| found.reactions[2 * n + 1]).sum();
    assert!((held + force).abs() < 1e-8 * force, "{held} {force}");
}

/// A block carried down by several of its own heights in one step is stopped by a plate that is held, as by many small steps.
#[test]
fn nothing_passes_through_anything() {
    let plate = Block { low: [-0.5, -0.3], high: [1.5, -0.1], cells: 4 };
    for way in [0.15, 0.5, 1.2, 2.5] {
        let mut host = Host::new(&[Block::unit(0.0, 0.0, 4), plate]);
        host.hold(1, |x| x[1] > 0.99 || x[1] < -0.29);
        host.hold(0, |x| x[1] > 0.99 || x[1] < -0.29);
        let mut contact = host.contact(None, 0.0);
        let target: Vec<f64> = host.coords.iter().flat_map(|x| [0.0, if x[1] > 0.99 { -way } else { 0.0 }]).collect();
        match host.solved(&mut contact, Some(&target)) {
            Ok(found) => {
                let force = found.contact.bodies[0].force[1];
                assert!(force > 0.0, "carried by {way}: pushed the wrong way by {force}");
            }
            // Linear bodies pressed by more than their height turn inside out.
            Err(refusal) => assert!(way > 0.9, "carried by {way}: {}", refusal.text),
        }
    }
}

/// Without a load and without a motion nothing is solved.
#[test]
fn rest_stays_rest() {
    let mut host = Host::new(&[Block::unit(0.0, 0.5, 3)]);
    host.hold(0, |x| x[1] > 1.4);
    host.hold(1, |x| x[1] > 1.4);
    let mut contact = host.contact(Some(0.0), 0.0);
    let found = host.solved(&mut contact, None).unwrap();
    assert_eq!((found.solves, found.rigid_steps), (0, 0));
    assert!(found.x.iter().all(|x| *x == 0.0));
}

/// Surfaces that overlap where all their nodes are held bear the stiffness times the overlap: told with both names and the depth. Where either
/// of them is free, what presses is an equilibrium.
#[test]
fn overlaps_of_held_surfaces_are_told() {
    for (is_upper_held, has_floor) in [(true, false), (false, false), (true, true), (false, true)] {
        let upper = Block::unit(0.0, if has_floor { 0.0 } else { 1.0 }, 3);
        let mut host = if has_floor { Host::new(&[upper]) } else { Host::new(&[Block::unit(0.0, 0.0, 3), upper]) };
        let (bottom, top) = if has_floor { (0.0, 1.0) } else { (1.0, 2.0) };
        for axis in 0..2 {
            // Of the lower one all; of the upper one the top, and the surface in contact where it says so.
            host.hold(axis, |x| x[1] < bottom - 1e-9 || x[1] > top - 1e-9 || (is_upper_held && x[1] < bottom + 1e-9));
        }
        let lower_nodes = if has_floor { 0 } else { 16 };
        host.free[..2 * lower_nodes].fill(false);
        let mut contact = host.contact(has_floor.then_some(0.0), 0.0);
        let pressed: Vec<f64> =
            (0..host.coords.len()).flat_map(|node| [0.0, if node >= lower_nodes { -0.01 } else { 0.0 }]).collect();
        let found = host.solved(&mut contact, Some(&pressed)).unwrap();
        let told: Vec<_> = found.warnings.iter().filter(|text| text.contains("no node of either is free")).collect();
        assert_eq!(told.len(), usize::from(is_upper_held), "{:?}", found.warnings);
        assert!(told.iter().all(|text| text.contains("overlap by 1.0e-2") && text.contains("body 0")), "{told:?}");
    }
}
