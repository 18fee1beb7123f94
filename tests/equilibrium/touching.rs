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

/// A row of blocks that lie apart, dragged on a floor to a wall by a force: facets that rock off the floor do not hold what slides. The wall
/// bears the force less friction, from the closed form μ times the weight of all.
#[test]
fn a_row_is_dragged_to_a_wall() {
    const COUNT: usize = 4;
    let apart = 1.05;
    let blocks: Vec<Block> = (0..COUNT).map(|k| Block::unit(apart * k as f64, 0.0, 4)).collect();
    let wall = Block { low: [apart * COUNT as f64, 0.01], high: [apart * COUNT as f64 + 1.0, 1.5], cells: 4 };
    let mut host = Host::new(&[blocks, vec![wall]].concat());
    let mu = 0.2;
    let force = 8.0 * mu * WEIGHT;
    (0..COUNT as i64).for_each(|body| host.add_weight(body, [0.0, -WEIGHT]));
    host.add_weight(0, [force, 0.0]);
    host.hold(0, |x| x[0] > apart * COUNT as f64 + 0.99);
    host.hold(1, |x| x[0] > apart * COUNT as f64 + 0.99);
    let mut contact = host.contact(Some(0.0), mu);
    contact.begin_step(&host.coords).unwrap();
    let found = host.solved(&mut contact, None).unwrap_or_else(|refusal| panic!("{}", refusal.text));
    let borne = found.contact.bodies[COUNT].force[0];
    let expected = force - COUNT as f64 * mu * WEIGHT;
    // The wall's friction takes off some weight.
    assert!((borne / expected - 1.0).abs() < 0.1, "{borne} beside {expected}");
}
