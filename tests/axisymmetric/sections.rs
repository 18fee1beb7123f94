//! Sections to be measured: two bodies, and one against obstacles.

use crate::scene::Scene;
use fmc_contact::{Contact, Obstacle, Options, Pose, Shape};
use fmc_shapes::{Diagonals, Mesh, Splitmix, rectangle_quad4, rectangle_tri3};

/// Two sections at these radii, one above the other, disturbed; nodes on the axis stay there.
fn scene(meshes: [&Mesh<2>; 2], seed: u64) -> (Scene<2>, Vec<[f64; 2]>) {
    let scene = Scene::of(&meshes);
    let mut random = Splitmix::new(seed);
    let mut coords = scene.coords.clone();
    for node in scene.nodes_of(1) {
        let x = &mut coords[node];
        let turn = if x[0] > 0.0 { 0.2 * (x[0] - 0.3) } else { 0.0 };
        x[1] += turn - 0.3;
    }
    for x in coords.iter_mut() {
        let on_axis = x[0] == 0.0;
        x.iter_mut().for_each(|x| *x += random.between(-0.02, 0.02));
        if on_axis {
            x[0] = 0.0;
        }
    }
    (scene, coords)
}

/// Bodies with and without a part of the axis.
pub(crate) fn pairs(options: Options, mut visit: impl FnMut(Contact<2>, Vec<[f64; 2]>)) {
    let lower = [
        rectangle_tri3([0.0, -1.0], [1.5, 0.0], [5, 3], Diagonals::Alternating),
        rectangle_quad4([0.5, -1.0], [2.0, 0.0], [4, 3]),
        rectangle_tri3([0.1, -1.0], [1.6, 0.0], [3, 3], Diagonals::Same),
    ];
    let upper = [
        rectangle_tri3([0.0, 0.0], [1.0, 0.8], [3, 3], Diagonals::Same),
        rectangle_quad4([0.8, 0.0], [1.8, 0.8], [2, 2]),
        rectangle_quad4([0.3, 0.0], [1.3, 0.8], [3, 2]),
    ];
    for (seed, (lower, upper)) in lower.iter().zip(&upper).enumerate() {
        let (scene, coords) = scene([lower, upper], seed as u64);
        visit(scene.contact(options), coords);
    }
}

/// A body against obstacles of all kinds, the plane inclined and not.
pub(crate) fn against_obstacles(
    options: Options,
    shapes: &[(Shape<2>, [f64; 2], f64)],
    mut visit: impl FnMut(Contact<2>, Vec<[f64; 2]>),
) {
    let body = rectangle_tri3([0.0, 0.0], [1.0, 0.8], [3, 3], Diagonals::Alternating);
    for (seed, (shape, position, turn)) in shapes.iter().enumerate() {
        let (scene, mut coords) = scene([&body, &rectangle_quad4([3.0, 5.0], [3.5, 6.0], [1, 1])], seed as u64);
        let mut contact = scene.contact(options);
        let pose = Pose::at(*position).turned(*turn);
        contact.add_obstacle(Obstacle { shape: shape.clone(), pose }).unwrap();
        coords.iter_mut().for_each(|x| x[1] += 0.01);
        visit(contact, coords);
    }
}

pub(crate) fn flat_shapes() -> Vec<(Shape<2>, [f64; 2], f64)> {
    vec![
        (Shape::HalfSpace, [0.0, 0.15], 0.0),
        (Shape::HalfSpace, [0.0, 0.1], 0.2),
        (Shape::HalfSpace, [0.8, 0.1], -1.4),
        (Shape::Cuboid { half_extents: [0.5, 0.3] }, [0.6, -0.1], 0.1),
    ]
}

pub(crate) fn round_shapes() -> Vec<(Shape<2>, [f64; 2], f64)> {
    vec![(Shape::Ball { radius: 0.7 }, [0.5, -0.5], 0.0), (Shape::Ball { radius: 0.5 }, [0.0, -0.3], 0.0)]
}
