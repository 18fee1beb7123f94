//! Bodies that nothing but contact holds come to rest.

use super::bodies::{Block, Host, YOUNG};

const WEIGHT: f64 = 1e3;

/// A block on a floor, a gap above it or sunk into it: the floor bears its weight, whatever the gap, in few solves.
#[test]
fn a_block_comes_to_rest_on_a_floor() {
    for gap in [0.0, 1e-9, -1e-9, 1e-6, -1e-6, 2.5e-3, 0.3, 3.0] {
        let mut host = Host::new(&[Block::unit(0.0, gap, 4)]);
        host.add_weight(0, [0.0, -WEIGHT]);
        let mut contact = host.contact(Some(0.0), 0.0);
        let found = host.solved(&mut contact, None).unwrap();
        let floor = -found.contact.obstacles[0].force[1];
        assert!((floor / WEIGHT - 1.0).abs() < 1e-9, "gap {gap}: {floor}");
        assert!(found.solves <= 6, "gap {gap}: {} solves", found.solves);
        // It is as free to slide as it was.
        assert!(found.warnings.iter().any(|text| text.starts_with("free: body 0 along")), "{:?}", found.warnings);
        // Its foot is on the floor, but for what the bodies give way.
        let foot = gap + found.x[1];
        assert!(foot.abs() < 10.0 * WEIGHT / YOUNG, "gap {gap}: {foot}");
    }
}

/// The same whatever the units: lengths in mm and forces in mN change no count and no ratio.
#[test]
fn units_change_nothing() {
    let counts: Vec<_> = [1.0, 1e3, 1e-6]
        .into_iter()
        .map(|unit| {
            let block = Block { low: [0.0, 1e-3 * unit], high: [unit, 1.001 * unit], cells: 4 };
            let mut host = Host::new(&[block]);
            host.add_weight(0, [0.0, -WEIGHT * unit]);
            let mut contact = host.contact(Some(0.0), 0.0);
            let found = host.solved(&mut contact, None).unwrap();
            let floor = -found.contact.obstacles[0].force[1] / (WEIGHT * unit);
            assert!((floor - 1.0).abs() < 1e-9);
            (found.solves, found.rigid_steps, found.updates)
        })
        .collect();
    assert!(counts.iter().all(|one| *one == counts[0]), "{counts:?}");
}

/// A stack with friction, a gap between all of them: the floor bears all, each joint what stands on it.
#[test]
fn a_stack_stands() {
    let gap = 1e-4;
    let blocks: Vec<_> = (0..3)
        .map(|k| {
            let (inset, y) = (0.05 * k as f64, (1.0 + gap) * k as f64 + gap);
            Block { low: [inset, y], high: [1.0 - inset, y + 1.0], cells: 3 + k % 2 }
        })
        .collect();
    let mut host = Host::new(&blocks);
    (0..3).for_each(|body| host.add_weight(body, [0.0, -WEIGHT]));
    let mut contact = host.contact(Some(0.0), 0.5);
    let found = host.solved(&mut contact, None).unwrap();
    assert!((found.contact.obstacles[0].force[1] / (-3.0 * WEIGHT) - 1.0).abs() < 1e-7);
    assert!(found.solves <= 12 && found.rigid_steps <= 10, "{} {}", found.solves, found.rigid_steps);
    for body in 0..2 {
        let force = found.contact.bodies[body + 1].force[1];
        assert!((force / WEIGHT - 1.0).abs() < 1e-7, "body {}: {force}", body + 1);
    }
}

/// Same input, same bits.
#[test]
fn twice_is_the_same() {
    let once = || {
        let mut host = Host::new(&[Block::unit(0.0, 1e-3, 3), Block::unit(0.1, 1.01, 4)]);
        host.add_weight(0, [0.0, -WEIGHT]);
        host.add_weight(1, [0.0, -WEIGHT]);
        let mut contact = host.contact(Some(0.0), 0.3);
        host.solved(&mut contact, None).unwrap()
    };
    assert_eq!(once(), once());
}
