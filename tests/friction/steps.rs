//! Steps that are accepted, rejected, and taken up again.

use crate::{begun, in_plane, in_space, laws, slid};
use fmc_contact::contact::{FacetSlip, FrictionStep, contact_force_step};
use fmc_contact::{Bodies, CellBlock, Options};

/// Where the block is at the end of every step: to and fro, some of it sliding.
const WAY: [f64; 6] = [2e-4, 6e-4, 5e-4, -1e-4, 3e-4, 3.5e-4];

/// Forces at the end of every step, and the slip that is carried on.
type Run<const D: usize> = Vec<(Vec<[f64; D]>, Vec<FacetSlip<D>>)>;

fn run<const D: usize>(scene: &crate::Scene<D>, options: Options, attempts: usize) -> Run<D> {
    let mut contact = begun(scene, options, &scene.coords);
    let mut found = Vec::new();
    for by in WAY {
        for attempt in 0..attempts {
            // Too far, in steps that are not accepted.
            let tried = slid(scene, by * (3.0 + attempt as f64));
            contact.evaluate(&tried).expect("forces");
        }
        let coords = slid(scene, by);
        let forces = contact.evaluate(&coords).expect("forces").forces;
        contact.commit_step(&coords).expect("a step");
        found.push((forces, contact.slip().expect("a step")));
    }
    found
}

#[test]
fn rejected_steps_leave_nothing_behind() {
    for options in laws(0.4) {
        let scene = &in_plane(1e-3)[0];
        assert_eq!(run(scene, options, 3), run(scene, options, 0));
    }
}

#[test]
fn threads_change_no_bit() {
    for options in laws(0.4) {
        let scene = &in_space(1e-3)[0];
        assert_eq!(run(scene, Options { threads: 4, ..options }, 0), run(scene, options, 0));
    }
}

#[test]
fn a_restart_goes_on_with_the_same_bits() {
    for options in laws(0.4) {
        for scene in in_plane(1e-3) {
            let whole = run(&scene, options, 0);
            // In mid-slip, from coordinates and slip alone.
            let mut contact = scene.contact(options);
            contact.begin_step(&slid(&scene, WAY[1])).expect("valid coordinates");
            contact.set_slip(&whole[1].1).expect("a slip");
            for (step, by) in WAY.into_iter().enumerate().skip(2) {
                let coords = slid(&scene, by);
                assert_eq!(contact.evaluate(&coords).expect("forces").forces, whole[step].0);
                contact.commit_step(&coords).expect("a step");
                assert_eq!(contact.slip().expect("a step"), whole[step].1);
            }
        }
    }
}

/// What is lost on the way is never negative, and all work is stored or lost.
#[test]
fn energy_is_accounted_for() {
    for options in laws(0.4) {
        let scene = &in_plane(1e-3)[0];
        let mut contact = begun(scene, options, &scene.coords);
        let (mut work, mut lost, mut stored, mut last) = (0.0, 0.0, 0.0, (0.0, 0.0));
        for step in 1..=400 {
            let by = 1e-3 * (step as f64 * 0.05).sin();
            let coords = slid(scene, by);
            let found = contact.evaluate(&coords).expect("forces");
            let force = -found.bodies[1].friction[0];
            work += 0.5 * (force + last.0) * (by - last.1);
            assert!(found.friction.dissipated >= 0.0);
            lost += found.friction.dissipated;
            stored = found.friction.stored;
            last = (force, by);
            contact.commit_step(&coords).expect("a step");
        }
        // The trapezoidal rule over the corners between stick and slip.
        assert!((work - lost - stored).abs() < 5e-3 * work, "{work} {lost} {stored}");
    }
}

/// A block that is held near its limit does not creep: what is carried keeps its bits.
#[test]
fn what_sticks_does_not_creep() {
    for options in laws(0.4) {
        let scene = &in_plane(1e-3)[1];
        let coords = slid(scene, 0.96 * 0.4e-3);
        let mut contact = begun(scene, options, &scene.coords);
        contact.commit_step(&coords).expect("a step");
        let carried = contact.slip().expect("a step");
        let force = contact.evaluate(&coords).expect("forces").bodies[1].friction[0];
        for _ in 0..1000 {
            contact.commit_step(&coords).expect("a step");
        }
        let close = |x: &[FacetSlip<2>], y: &[FacetSlip<2>]| {
            let all = |list: &[FacetSlip<2>]| list.iter().flat_map(|one| one.slip).collect::<Vec<f64>>();
            x.len() == y.len() && all(x).iter().zip(all(y)).all(|(x, y)| (x - y).abs() <= 1e-12 * 0.4e-3)
        };
        assert!(close(&contact.slip().expect("a step"), &carried));
        let later = contact.evaluate(&coords).expect("forces").bodies[1].friction[0];
        assert!((later / force - 1.0).abs() < 1e-12, "{later} {force}");
    }
}

#[test]
fn a_call_that_keeps_nothing_gives_the_same_bits() {
    for options in laws(0.4) {
        let scene = &in_plane(1e-3)[1];
        let kept = run(scene, options, 0);
        let blocks: Vec<CellBlock> =
            scene.blocks.iter().map(|(cell_type, conn)| CellBlock { cell_type: *cell_type, conn }).collect();
        let (mut start, mut slip) = (scene.coords.clone(), Vec::new());
        for (step, by) in WAY.into_iter().enumerate() {
            let coords = slid(scene, by);
            let begun = FrictionStep { reference: &scene.coords, start: &start, slip: &slip };
            let found = contact_force_step(begun, &coords, &blocks, Bodies::Ids(&scene.ids), &options);
            let (forces, next) = found.expect("forces");
            assert_eq!((&forces.forces, &next), (&kept[step].0, &kept[step].1));
            (start, slip) = (coords, next);
        }
    }
}
