//! Contact points: their pressures, areas and normals are the force and the moment of the pair.

use crate::depth;
use crate::derivatives::{in_plane, in_space};
use crate::scene::{Scene, cross};
use fmc_contact::overlap::Partner;
use fmc_contact::{Contact, Obstacle, Pose, Shape};
use fmc_shapes::{Diagonals, cuboid_hex8, rectangle_tri3};

/// Σ −p A n and its moment on body 0 of what the points say, against the resultant.
fn adds_up<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]], tolerance: f64) {
    let points = contact.contact_points(coords).expect("points");
    let found = contact.evaluate(coords).expect("forces");
    assert!(!points.is_empty(), "nothing is met");
    let (mut force, mut turning, mut size) = ([0.0; D], [0.0; 3], 0.0);
    for point in &points {
        let part = point.normal.map(|n| -point.pressure * point.area * n);
        force.iter_mut().zip(part).for_each(|(sum, f)| *sum += f);
        turning.iter_mut().zip(cross(&point.position, &part)).for_each(|(sum, m)| *sum += m);
        size += point.pressure * point.area;
        assert!(point.gap < 0.0 && point.area > 0.0 && point.pressure > 0.0);
        for (side, partner) in point.sides.iter().zip(point.partners) {
            let sum: f64 = side.weights[..side.node_count].iter().sum();
            let place: [f64; D] = std::array::from_fn(|i| {
                (0..side.node_count).map(|k| side.weights[k] * coords[side.nodes[k] as usize][i]).sum()
            });
            match partner {
                Partner::Obstacle(_) => assert!(side.node_count == 0),
                // The centre may lie outside what a hollow of the other body leaves.
                Partner::Body(_) if side.node_count == 0 => {}
                Partner::Body(_) => {
                    assert!((sum - 1.0).abs() < 1e-12);
                    assert!((0..D).all(|i| (place[i] - point.position[i]).abs() < 1e-12), "{place:?} {point:?}");
                }
            }
        }
    }
    let body = &found.bodies[0];
    for i in 0..D {
        assert!((force[i] - body.force[i]).abs() < tolerance * size, "{force:?} {:?}", body.force);
    }
    let is_near = turning.iter().zip(&body.moment).all(|(sum, m)| (sum - m).abs() < tolerance * size);
    assert!(is_near, "{turning:?} {:?}", body.moment);
}

#[test]
fn of_bodies() {
    in_plane(|contact, coords| adds_up(&contact, &coords, 1e-12));
    in_space(|contact, coords| adds_up(&contact, &coords, 1e-12));
}

#[test]
fn of_obstacles() {
    let scene = Scene::of(&[&cuboid_hex8([-0.5; 3], [0.5; 3], [3; 3])]);
    for (shape, pose) in [
        (Shape::HalfSpace, Pose::at([0.0, 0.0, -0.4])),
        (Shape::Ball { radius: 0.4 }, Pose::at([0.05, 0.02, -0.8])),
        (Shape::Cuboid { half_extents: [0.2, 0.3, 0.2] }, Pose::at([0.05, 0.02, -0.6])),
    ] {
        let mut contact = scene.contact(depth(1e3));
        contact.add_obstacle(Obstacle { shape, pose }).expect("an obstacle");
        adds_up(&contact, &scene.coords, 1e-11);
    }
}

/// One point for every facet that is pressed and every cell it meets, which knows the cell behind the place in the other body.
#[test]
fn of_a_flat_face() {
    let delta = 1e-3;
    let lower = rectangle_tri3([-1.0, -1.0], [2.0, 0.0], [6, 2], Diagonals::Same);
    let upper = rectangle_tri3([0.0, -delta], [1.0, 1.0], [2, 2], Diagonals::Same);
    let scene = Scene::of(&[&lower, &upper]);
    let points = scene.contact(depth(1e3)).contact_points(&scene.coords).expect("points");
    assert!(points.iter().all(|p| p.sides.iter().all(|side| side.cell.is_some() && side.node_count > 0)));
    // Walls that are sunk in are pressed too; what lies flat has the pressure of its depth.
    let flat: Vec<_> = points.iter().filter(|p| p.normal[1].abs() > 0.5).collect();
    let area: f64 = flat.iter().map(|p| p.area).sum();
    assert!((area - 1.0).abs() < 1e-9, "{area}");
    let force: f64 = flat.iter().map(|p| p.area * p.pressure).sum();
    assert!((force / (1e3 * delta) - 1.0).abs() < 5e-3, "{force}");
}
