//! A pin that is pulled along its hole's radius while it turns: it bears on the other side too, and has no torque.

use crate::scene::Scene;
use crate::{K, sliding};
use fmc_shapes::Mesh;
use std::f64::consts::TAU;

/// A ring of one layer of quadrilaterals.
fn ring(radii: [f64; 2], count: usize) -> Mesh<2> {
    let at = |radius: f64, k: usize| {
        let angle = TAU * k as f64 / count as f64;
        [radius * angle.cos(), radius * angle.sin()]
    };
    let coords = radii.iter().flat_map(|&radius| (0..count).map(move |k| at(radius, k))).collect();
    let around = |layer: usize, k: usize| (layer * count + k % count) as u32;
    let conn = (0..count).flat_map(|k| [around(0, k), around(1, k), around(1, k + 1), around(0, k + 1)]);
    Mesh { coords, conn: conn.collect(), nodes_per_cell: 4 }
}

/// Torque by force and radius, and the force by that of a circle, K π R d: the largest of each over a turn by 61° in steps of 6.1°, with
/// and without a new step.
fn turned(counts: [usize; 2]) -> [f64; 2] {
    let scene = Scene::of(&[&ring([0.5, 1.0], counts[0]), &ring([1.0, 1.5], counts[1])]);
    let mut contact = sliding(&scene, 0.0);
    let (pulled, mut found) = (1e-2, [0.0f64; 2]);
    for step in 0..=10 {
        let (s, c) = (6.1 * f64::from(step)).to_radians().sin_cos();
        let at = |by: f64| {
            let mut coords = scene.coords.clone();
            coords[..scene.first_node[1]].iter_mut().for_each(|x| *x = [c * x[0] - s * x[1] + by, s * x[0] + c * x[1]]);
            coords
        };
        contact.begin_step(&at(0.0)).expect("a step");
        let bodies = contact.evaluate(&at(pulled)).expect("an evaluation").bodies;
        let [force, across] = bodies[0].force;
        let torque = bodies[0].moment[2] - pulled * across;
        found[0] = found[0].max(torque.abs() / force.abs());
        found[1] = found[1].max((force / (-K * 0.5 * TAU * pulled) - 1.0).abs().max(across.abs() / force.abs()));
    }
    found
}

/// A facet of length h stands off its circle by h²/8, 3e-3 of the radius at 40 facets, by which lengths and normals are wrong, and forces by some
/// times as much. Means over hat functions see the same standing off wherever the pin has turned to, but for terms of h⁴, 1e-5: the torque is of
/// these. Half as large facets have a quarter of the one, and less of the other.
#[test]
fn a_pin_turns_in_its_hole_without_torque() {
    for counts in [[40, 56], [40, 40], [56, 40]] {
        let [torque, force] = turned(counts);
        let [finer, force_finer] = turned(counts.map(|count| 2 * count));
        assert!(torque < 2e-5 && force < 1e-2, "{counts:?}: {torque:e} {force:e}");
        assert!(finer < 0.2 * torque + 1e-12 && force_finer < 0.4 * force, "{counts:?}: {finer:e} {force_finer:e}");
    }
}
