//! Pressure at the nodes.

use crate::depth;
use crate::scene::Scene;
use fmc_contact::contact::NodeStatus;
use fmc_shapes::{Diagonals, Mesh, cuboid_hex8, cuboid_tet4, rectangle_tri3};

/// A flat block on a larger one: the pressure is k δ at every node of its face, and forces at surface nodes alone add up
/// to the resultant.
fn flat<const D: usize>(lower: &Mesh<D>, upper: &Mesh<D>) {
    let delta = 1e-4;
    let upper = upper.clone().mapped(|mut x| {
        x[D - 1] -= delta;
        x
    });
    let scene = Scene::of(&[lower, &upper]);
    let contact = scene.contact(depth(1e3));
    let (field, found) =
        (contact.nodal_contact(&scene.coords).expect("a field"), contact.evaluate(&scene.coords).expect("forces"));
    let mut sum = [0.0; D];
    for node in scene.nodes_of(1) {
        let is_below = scene.coords[node][D - 1] < 0.0;
        let touches = field.status[node] == NodeStatus::Touching;
        // Walls that are sunk in touch too.
        assert!(touches || !is_below, "{:?}: {:?}", scene.coords[node], field.status[node]);
        for i in 0..D {
            sum[i] -= field.pressure[node] * field.area[node] * field.normal[node][i];
        }
        if !is_below {
            continue;
        }
        assert!((field.pressure[node] / (1e3 * delta) - 1.0).abs() < 1e-2, "{}", field.pressure[node]);
        assert!((field.gap[node] / -delta - 1.0).abs() < 1e-2, "{}", field.gap[node]);
    }
    // What acts on nodes inside the bodies is told at their surface.
    let is_inside = |x: &[f64; D]| (0..D - 1).all(|i| x[i] > 1e-9 && x[i] < 1.0 - 1e-9) && x[D - 1] > 0.01;
    let inner = || scene.nodes_of(1).filter(|&n| is_inside(&scene.coords[n]));
    assert!(inner().any(|n| found.forces[n] != [0.0; D]), "the test sees no inner node");
    assert!(inner().all(|n| field.area[n] == 0.0 || scene.coords[n][D - 1] > 0.99));
    let total = found.bodies[1].force;
    for i in 0..D {
        assert!((sum[i] - total[i]).abs() < 1e-12 * total[D - 1], "{sum:?} {total:?}");
    }
}

#[test]
fn pressure_of_a_flat_face() {
    let below = rectangle_tri3([-1.0, -1.0], [2.0, 0.0], [11, 4], Diagonals::Same);
    flat(&below, &rectangle_tri3([0.0, 0.0], [1.0, 1.0], [4, 4], Diagonals::Alternating));
    let below = cuboid_tet4([-1.0, -1.0, -1.0], [2.0, 2.0, 0.0], [7, 7, 3]);
    flat(&below, &cuboid_tet4([0.0; 3], [1.0; 3], [3, 3, 3]));
    flat(&below, &cuboid_hex8([0.0; 3], [1.0; 3], [3, 3, 3]));
}
