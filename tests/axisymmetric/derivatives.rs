//! Forces and tangents are the derivatives of the weighted energy, law by law.

use crate::differences::{
    axial_forces_balance, direction, force_is_the_slope_at_a_step, force_is_the_slope_of_the_energy, moved,
    obstacle_is_pushed_by_the_slope, tangent_is_the_slope_of_the_force,
};
use crate::scene::lines;
use crate::scene::table::uncorrected;
use crate::sections::{against_obstacles, flat_shapes, pairs, round_shapes};
use crate::{depth, exactly};
use fmc_contact::{EnergyLaw, Options};
use fmc_shapes::Splitmix;

fn volume() -> EnergyLaw {
    EnergyLaw::Volume { stiffness: 30.0, exponent: 2.0 }
}

/// The slope of the energy jumps where a node passes a line: steps are so short that none does.
const LINES: (f64, f64) = (1e-7, 1e-8);

/// Lines whose energy has a force that is its slope.
fn on_lines(law: EnergyLaw) -> Options {
    Options { axisymmetric: true, ..uncorrected(law, 0.02, 1) }
}

#[test]
fn volume_between_bodies() {
    pairs(exactly(volume()), |contact, coords| {
        axial_forces_balance(&contact, &coords);
        force_is_the_slope_of_the_energy(&contact, &coords, 1e-7);
        tangent_is_the_slope_of_the_force(&contact, &coords);
    });
}

#[test]
fn volume_against_obstacles() {
    against_obstacles(exactly(volume()), &flat_shapes(), |contact, coords| {
        axial_forces_balance(&contact, &coords);
        force_is_the_slope_of_the_energy(&contact, &coords, 1e-7);
        tangent_is_the_slope_of_the_force(&contact, &coords);
        obstacle_is_pushed_by_the_slope(contact, &coords, 1e-7);
    });
}

#[test]
fn fibers_between_bodies_and_against_obstacles() {
    for law in [volume(), EnergyLaw::fiber(30.0)] {
        pairs(on_lines(law), |mut contact, coords| {
            contact.keep_patches(&coords).unwrap();
            force_is_the_slope_at_a_step(&contact, &coords, LINES);
            tangent_is_the_slope_of_the_force(&contact, &coords);
        });
        let shapes: Vec<_> = flat_shapes().into_iter().chain(round_shapes()).collect();
        against_obstacles(on_lines(law), &shapes, |mut contact, coords| {
            contact.keep_patches(&coords).unwrap();
            force_is_the_slope_at_a_step(&contact, &coords, LINES);
        });
    }
}

/// The correction is one along the axis alone.
#[test]
fn corrected_fibers_balance() {
    for law in [volume(), EnergyLaw::fiber(30.0)] {
        let options = Options { law, axisymmetric: true, ..lines(0.02, 1) };
        pairs(options, |contact, coords| {
            axial_forces_balance(&contact, &coords);
            let at = contact.evaluate(&coords).unwrap();
            assert!(at.bodies.iter().all(|body| body.moment == [0.0; 3]));
        });
    }
}

#[test]
fn fiber_law_between_bodies() {
    pairs(exactly(EnergyLaw::fiber(30.0)), |mut contact, coords| {
        contact.keep_patches(&coords).unwrap();
        axial_forces_balance(&contact, &coords);
        force_is_the_slope_of_the_energy(&contact, &coords, 1e-7);
        tangent_is_the_slope_of_the_force(&contact, &coords);
    });
}

#[test]
fn fiber_law_against_planes() {
    let planes = &flat_shapes()[..3];
    against_obstacles(exactly(EnergyLaw::fiber(30.0)), planes, |mut contact, coords| {
        // Where two patches meet at a corner the energy has a step, in the plane too.
        if contact.keep_patches(&coords).unwrap() > 1 {
            return;
        }
        axial_forces_balance(&contact, &coords);
        force_is_the_slope_of_the_energy(&contact, &coords, 1e-7);
        tangent_is_the_slope_of_the_force(&contact, &coords);
        obstacle_is_pushed_by_the_slope(contact, &coords, 1e-7);
    });
}

/// The derivative of a weighted gap, by differences.
#[test]
fn gaps_are_weighted() {
    pairs(depth(1.0), |contact, coords| {
        let gaps = |coords: &[[f64; 2]]| contact.gap_constraints(coords, 0.2).expect("gaps");
        let at = gaps(&coords);
        let direction = direction(&coords, &mut Splitmix::new(5));
        let [plus, minus] = [1e-6, -1e-6].map(|h| gaps(&moved(&coords, &direction, h)));
        assert!(!at.nodes.is_empty());
        let largest = at.gaps.iter().fold(0.0f64, |m, g| m.max(g.abs()));
        let mut smooth = 0;
        for row in 0..at.nodes.len() {
            let entries = at.row_starts[row]..at.row_starts[row + 1];
            let along: f64 = entries
                .map(|k| (0..2).map(|i| at.slopes[k][i] * direction[at.columns[k] as usize][i]).sum::<f64>())
                .sum();
            let by_differences = (plus.gaps[row] - minus.gaps[row]) / 2e-6;
            smooth += usize::from((along - by_differences).abs() < 1e-6 * largest.max(along.abs()));
        }
        // A quadrature point whose nearest point changes from one facet to the next has no slope.
        assert!(smooth + 2 >= at.nodes.len(), "{smooth} of {}", at.nodes.len());
    });
}

#[test]
fn depth_between_bodies() {
    pairs(depth(30.0), |contact, coords| {
        axial_forces_balance(&contact, &coords);
        force_is_the_slope_of_the_energy(&contact, &coords, 1e-7);
        tangent_is_the_slope_of_the_force(&contact, &coords);
    });
}

#[test]
fn depth_against_obstacles() {
    against_obstacles(depth(30.0), &flat_shapes(), |contact, coords| {
        axial_forces_balance(&contact, &coords);
        force_is_the_slope_of_the_energy(&contact, &coords, 1e-7);
        tangent_is_the_slope_of_the_force(&contact, &coords);
        obstacle_is_pushed_by_the_slope(contact, &coords, 1e-7);
    });
}

/// The energy is known to 6e-5, the force to 2e-7.
#[test]
fn depth_against_round_obstacles() {
    against_obstacles(depth(30.0), &round_shapes(), |contact, coords| {
        axial_forces_balance(&contact, &coords);
        force_is_the_slope_of_the_energy(&contact, &coords, 1e-4);
    });
}
