//! Bodies that touch or nearly touch, and are pushed sideways by less than friction holds.

use super::bodies::{Block, Host};

const WEIGHT: f64 = 1e3;
const MU: f64 = 0.5;

fn pushed(part: f64, gap: f64) -> Host {
    let mut host = Host::new(&[Block::unit(0.0, gap, 4)]);
    host.add_weight(0, [part * MU * WEIGHT, -WEIGHT]);
    host
}

fn farthest(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |most: f64, x| most.max(x.abs()))
}

/// In one step a block moves as far as one that is pressed first and then pushed, which sticks: by elastic strains, not by a part of its size.
#[test]
fn a_block_that_is_pressed_and_pushed_at_once_sticks() {
    for part in [0.02, 0.1, 0.4, 0.7, 0.9] {
        for gap in [0.0, 1e-9, 1e-6, -1e-9, -1e-6] {
            let first = pushed(0.0, gap);
            let mut contact = first.contact(Some(0.0), MU);
            contact.begin_step(&first.coords).unwrap();
            let pressed = first.solved(&mut contact, None).unwrap();
            let strained = farthest(&pressed.x) * (1.0 + 8.0 * part);
            let host = pushed(part, gap);
            let mut contact = host.contact(Some(0.0), MU);
            contact.begin_step(&host.coords).unwrap();
            let found = host.solved(&mut contact, None).unwrap();
            let far = farthest(&found.x);
            assert!(far < strained + 2.0 * gap.abs(), "{part} {gap:e}: {far} beside {strained}");
            assert!(found.warnings.is_empty(), "{part} {gap:e}: {:?}", found.warnings);
            // The floor bears all of it.
            let [along, up] = found.contact.obstacles[0].force;
            let off = (along - part * MU * WEIGHT).hypot(up + WEIGHT) / WEIGHT;
            assert!(off < 1e-7, "{part} {gap:e}: {off:e}");
        }
    }
}
