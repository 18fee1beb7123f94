//! A ring that turns in another: friction all round, for a whole turn, and back.

use crate::scene::{Scene, norm, size_sum};
use crate::{begun, laws};
use fmc_contact::Options;
use fmc_contact::contact::Friction;
use fmc_shapes::Mesh;
use std::f64::consts::TAU;

/// A ring of two layers of quadrilaterals.
fn ring(radii: [f64; 2], count: usize, start: f64) -> Mesh<2> {
    let mut coords = Vec::new();
    for layer in 0..3 {
        let radius = radii[0] + (radii[1] - radii[0]) * layer as f64 / 2.0;
        let angles = (0..count).map(|k| start + TAU * k as f64 / count as f64);
        coords.extend(angles.map(|angle| [radius * angle.cos(), radius * angle.sin()]));
    }
    let mut conn = Vec::new();
    for (layer, k) in (0..2).flat_map(|layer| (0..count).map(move |k| (layer, k))) {
        let at = |layer: usize, k: usize| (layer * count + k % count) as u32;
        conn.extend([at(layer, k), at(layer + 1, k), at(layer + 1, k + 1), at(layer, k + 1)]);
    }
    Mesh { coords, conn, nodes_per_cell: 4 }
}

/// Polygons of 70 and 96 edges, 2e-3 deep in one another: a facet of either crosses those of the other by up to 1e-3 of the
/// radius, which is the error of the radius at which the torque is taken.
#[test]
fn the_torque_is_that_of_all_pressure() {
    let inner = ring([0.6, 1.001], 70, 0.0);
    let outer = ring([0.999 / (TAU / 192.0).cos(), 1.5], 96, 0.013);
    let scene = Scene::of(&[&inner, &outer]);
    let options = laws(0.3)[0];
    let mut contact = begun(&scene, options, &scene.coords);
    let smooth = scene.contact(Options { friction: Friction::default(), ..options });
    let degrees = (1..=90).map(|step| 4.0 * f64::from(step)).chain((1..=45).map(|step| 360.0 - 4.0 * f64::from(step)));
    let (mut last, mut torques) = (0.0, Vec::new());
    for angle in degrees {
        let (s, c) = angle.to_radians().sin_cos();
        let mut coords = scene.coords.clone();
        coords[..inner.coords.len()].iter_mut().for_each(|x| *x = [c * x[0] - s * x[1], s * x[0] + c * x[1]]);
        let found = contact.evaluate(&coords).expect("forces");
        let sum: [f64; 2] = std::array::from_fn(|i| found.forces.iter().map(|f| f[i]).sum());
        let turning = found.bodies[0].moment[2] + found.bodies[1].moment[2];
        assert!(norm(&[sum]) < 1e-13 * size_sum(&found.forces) && turning.abs() < 1e-13 * size_sum(&found.forces));
        let points = smooth.contact_points(&coords).expect("points");
        let limit: f64 = points.iter().map(|p| 0.3 * p.pressure * p.area * norm(&[p.position])).sum();
        assert!(found.friction.dissipated > 0.0 && found.friction.stick_area == 0.0);
        let torque = found.bodies[0].moment[2];
        let way = if angle > last { -1.0 } else { 1.0 };
        assert!((torque / (way * limit) - 1.0).abs() < 1e-3, "{angle}: {torque} of {limit}");
        torques.push(torque.abs());
        last = angle;
        contact.commit_step(&coords).expect("a step");
    }
    let [least, most] = torques.iter().fold([f64::INFINITY, 0.0f64], |[least, most], t| [least.min(*t), most.max(*t)]);
    assert!(most / least - 1.0 < 1e-5, "{least} {most}");
}
