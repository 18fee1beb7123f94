//! Friction without memory: smooth at rest, full from a slip on, and nothing is carried into the next step.

use crate::{STIFFNESS, begun, in_plane, in_space, slid};
use fmc_contact::contact::{Friction, TangentPart};
use fmc_contact::{EnergyLaw, Error, Options};

const MU: f64 = 0.3;
const DELTA: f64 = 1e-3;
const SLIP: f64 = 1e-4;

fn options() -> [Options; 2] {
    let friction = Friction { memoryless_slip: Some(SLIP), ..Friction::coulomb(MU) };
    [EnergyLaw::depth(STIFFNESS), EnergyLaw::fiber(STIFFNESS)]
        .map(|law| Options { friction, ..crate::scene::table::exactly(law) })
}

/// By the published form τ (2 y − y²), y = s/ε, as Incremental Potential Contact has it (Li and others, 2020).
fn pushed<const D: usize>(scene: &crate::Scene<D>, area: f64) {
    for options in options() {
        let mut contact = begun(scene, options, &scene.coords);
        let most = MU * STIFFNESS * DELTA * area;
        for y in [0.01, 0.5, 1.0, -3.0f64] {
            let found = contact.evaluate(&slid(scene, y * SLIP)).expect("valid coordinates");
            let part = y.signum() * if y.abs() < 1.0 { 2.0 * y.abs() - y * y } else { 1.0 };
            // Rims bear less.
            let force = -found.bodies[1].friction[0] / (most * part);
            assert!((force - 1.0).abs() < 0.02, "{y}: {force}");
            assert_eq!(found.friction.stored, 0.0);
            let lost = found.friction.dissipated / (most * part * y * SLIP);
            assert!((lost - 1.0).abs() < 0.02, "{y}: {lost}");
        }
        // The next step starts at rest.
        let end = slid(scene, 0.5 * SLIP);
        contact.commit_step(&end).expect("a step");
        assert!(contact.slip().expect("a step").is_empty());
        // The tangent plane of a point is not that of its neighbours to the last digit.
        let at_rest = contact.evaluate(&end).expect("valid coordinates").bodies[1].friction[0];
        assert!(at_rest.abs() < 1e-12 * most, "{at_rest}");
    }
}

#[test]
fn grows_to_the_limit_and_is_forgotten() {
    in_plane(DELTA).iter().for_each(|scene| pushed(scene, 1.0));
    in_space(DELTA).iter().for_each(|scene| pushed(scene, 0.8));
}

/// The way of the block is that of the differences, in the part of the tangent that the friction adds along it.
#[test]
fn tangent_along_the_way() {
    for scene in in_plane(DELTA) {
        for options in options() {
            let contact = begun(&scene, options, &scene.coords);
            for y in [0.2, 0.7, 2.0] {
                let (at, h) = (y * SLIP, 1e-9);
                let force = |by: f64| contact.evaluate(&slid(&scene, by)).expect("forces").bodies[1].friction[0];
                let expected = -(force(at + h) - force(at - h)) / (2.0 * h);
                let tangent = contact.tangent(&slid(&scene, at), TangentPart::Full).expect("a tangent");
                let nodes: Vec<u32> = scene.nodes_of(1).map(|node| node as u32).collect();
                let inside = |node: u32| nodes.contains(&node);
                let blocks = tangent.blocks.iter().filter(|block| inside(block.row) && inside(block.col));
                let found: f64 = blocks.map(|block| block.value[0][0]).sum();
                // Walls of the upper block press along the way by their depth, which friction alone does not.
                let walls = contact.evaluate(&slid(&scene, at + h)).expect("forces").bodies[1].force[0]
                    - contact.evaluate(&slid(&scene, at - h)).expect("forces").bodies[1].force[0];
                let normal = -walls / (2.0 * h) - expected;
                let size = MU * STIFFNESS * DELTA / SLIP;
                assert!((found - normal - expected).abs() < 1e-2 * size, "{y}: {found} {normal} {expected} of {size}");
            }
        }
    }
}

#[test]
fn a_spring_without_memory_is_refused() {
    let scene = &in_plane(DELTA)[0];
    let friction = Friction { stiffness: Some(1.0), ..options()[0].friction };
    let refused = scene.contact(options()[0]).set_options(Options { friction, ..options()[0] });
    assert!(matches!(refused, Err(Error::Unsupported { .. })), "{refused:?}");
    let friction = Friction { memoryless_slip: Some(0.0), ..options()[0].friction };
    let refused = scene.contact(options()[0]).set_options(Options { friction, ..options()[0] });
    assert!(matches!(refused, Err(Error::NotPositive { name: "memoryless_slip", .. })), "{refused:?}");
}
