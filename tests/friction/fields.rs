//! Friction at contact points and at nodes: against the resultants, and against what a flat face must have.

use crate::scene::{Scene, norm};
use crate::{STIFFNESS, begun, in_plane, in_space, laws, slid};
use fmc_contact::contact::NodeStatus;
use fmc_contact::{Error, Options};

const MU: f64 = 0.3;
const DELTA: f64 = 1e-3;

/// Nodes of the upper block's lower face, away from its rim.
fn inner_nodes<const D: usize>(scene: &Scene<D>) -> Vec<usize> {
    let is_inner = |x: &[f64; D]| x[D - 1] < 0.0 && (0..D - 1).all(|i| x[i].abs() < 0.3);
    let found: Vec<usize> = scene.nodes_of(1).filter(|&node| is_inner(&scene.coords[node])).collect();
    assert!(!found.is_empty());
    found
}

/// The points' tractions add up to the friction of the pair.
fn points_add_up<const D: usize>(scene: &Scene<D>, options: Options, by: f64) {
    let (contact, coords) = (begun(scene, options, &scene.coords), slid(scene, by));
    let found = contact.evaluate(&coords).expect("valid coordinates");
    let points = contact.contact_points(&coords).expect("points");
    let sum: [f64; D] = std::array::from_fn(|i| points.iter().map(|point| point.friction[i] * point.area).sum());
    let off: [f64; D] = std::array::from_fn(|i| sum[i] - found.bodies[0].friction[i]);
    assert!(norm(&[off]) < 1e-12 * norm(&[sum]), "{sum:?} {:?}", found.bodies[0].friction);
    let sliding: f64 = points.iter().map(|point| point.sliding * point.area).sum();
    let area: f64 = points.iter().map(|point| point.area).sum();
    let expected = found.friction.slip_area / (found.friction.slip_area + found.friction.stick_area);
    assert!((sliding / area - expected).abs() < 1e-9, "{} {expected}", sliding / area);
}

fn of_a_flat_face<const D: usize>(scene: &Scene<D>, options: Options) {
    let contact = begun(scene, options, &scene.coords);
    let limit = MU * DELTA;
    for by in [0.4 * limit, -6.0 * limit] {
        let coords = slid(scene, by);
        let field = contact.nodal_contact(&coords).expect("valid coordinates");
        let sticks = by.abs() < limit;
        let traction = if sticks { -STIFFNESS * by } else { -by.signum() * MU * STIFFNESS * DELTA };
        for node in inner_nodes(scene) {
            // The pressure of a point off the node's own facet differs by its slope, which a flat face does not have.
            assert!((field.friction[node][0] / traction - 1.0).abs() < 1e-2, "{:?} {traction}", field.friction[node]);
            assert!(field.friction[node][1..].iter().all(|t| t.abs() < 1e-9 * traction.abs()));
            assert_eq!(field.status[node], if sticks { NodeStatus::Sticking } else { NodeStatus::Sliding });
            assert_eq!(field.sliding[node], if sticks { 0.0 } else { 1.0 });
        }
        for (node, status) in field.status.iter().enumerate().filter(|(_, status)| **status == NodeStatus::Apart) {
            assert_eq!(field.friction[node], [0.0; D], "{status:?}");
        }
        let points = contact.contact_points(&coords).expect("points");
        let inner = points.iter().filter(|point| (0..D - 1).all(|i| point.position[i].abs() < 0.2));
        for point in inner {
            // Body 0 lies below and is the first side: it slips the other way.
            let plastic = if sticks { 0.0 } else { -by + by.signum() * limit };
            // Facets that reach the rim bear less there, as a whole.
            assert!((point.slip[0] - plastic).abs() < 0.02 * limit, "{} {plastic}", point.slip[0]);
            assert!((point.friction[0] / -traction - 1.0).abs() < 0.02, "{} {traction}", point.friction[0]);
        }
    }
}

#[test]
fn fields_on_a_flat_face() {
    in_plane(DELTA).iter().for_each(|scene| laws(MU).into_iter().for_each(|options| of_a_flat_face(scene, options)));
    in_space(DELTA).iter().for_each(|scene| laws(MU).into_iter().for_each(|options| of_a_flat_face(scene, options)));
}

#[test]
fn tractions_of_the_points_add_up() {
    for by in [0.3, -0.9, 4.0].map(|part| part * MU * DELTA) {
        in_plane(DELTA).iter().for_each(|scene| laws(MU).into_iter().for_each(|o| points_add_up(scene, o, by)));
        in_space(DELTA).iter().for_each(|scene| laws(MU).into_iter().for_each(|o| points_add_up(scene, o, by)));
    }
}

#[test]
fn fields_without_friction_or_without_a_step() {
    let scene = &in_plane(DELTA)[0];
    let none = scene.contact(Options { friction: Default::default(), ..laws(MU)[0] });
    let field = none.nodal_contact(&scene.coords).expect("valid coordinates");
    assert!(field.status.iter().all(|status| matches!(status, NodeStatus::Apart | NodeStatus::Touching)));
    assert!(
        field.friction.iter().all(|traction| *traction == [0.0; 2]) && field.sliding.iter().all(|part| *part == 0.0)
    );
    let slides = scene.contact(laws(MU)[0]);
    assert_eq!(slides.nodal_contact(&scene.coords).expect_err("no step"), Error::NoStep);
    assert_eq!(slides.contact_points(&scene.coords).expect_err("no step"), Error::NoStep);
}
