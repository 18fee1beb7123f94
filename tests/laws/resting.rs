//! Bodies that rest on rigid shapes, without or with coinciding faces, tilted or not.

use crate::balance::balanced;
use crate::scene::{Scene, exact, fibers, isotropic, lines, size_sum};
use fmc_contact::{ContactForces, FiberOptions, Obstacle, Options, Pose, Shape};
use fmc_shapes::{Diagonals, Mesh, cuboid_hex8, cuboid_surface, cuboid_tet4, polygon, random_rotation, rectangle_tri3};

fn estimators() -> [Options; 4] {
    [exact(), fibers(FiberOptions::default()), lines(0.013, 1), isotropic(0.3, 3_000, 1)]
}

fn against<const D: usize>(
    body: &Mesh<D>,
    shape: &Shape<D>,
    pose: Pose<D>,
    options: Options,
) -> (ContactForces<D>, Scene<D>) {
    let scene = Scene::of(&[body]);
    let mut contact = scene.contact(options);
    contact.add_obstacle(Obstacle { shape: shape.clone(), pose }).unwrap();
    (contact.evaluate(&scene.coords).unwrap(), scene)
}

/// Half-space, cuboid, cylinder and polytope whose upper face is the plane where the last coordinate is 0.
fn tables<const D: usize>(polytope: Shape<D>) -> [(Shape<D>, [f64; D]); 4] {
    let down = |depth: f64| std::array::from_fn(|i| if i == D - 1 { -depth } else { 0.5 });
    [
        (Shape::HalfSpace, [0.0; D]),
        (Shape::Cuboid { half_extents: [1.5; D] }, down(1.5)),
        (Shape::Cylinder { radius: 2.0, half_height: 0.5 }, down(0.5)),
        (polytope, down(1.0)),
    ]
}

/// A body that stands on a table, `depth` deep in it, all turned as one.
fn stands<const D: usize>(body: &Mesh<D>, polytope: Shape<D>, depth: f64) {
    let identity: [[f64; D]; D] = std::array::from_fn(|i| std::array::from_fn(|j| f64::from(u8::from(i == j))));
    for (shape, position) in tables(polytope) {
        for r in std::iter::once(identity).chain((0..6).map(random_rotation)) {
            let turn = |x: [f64; D]| std::array::from_fn(|i| (0..D).map(|j| r[i][j] * x[j]).sum());
            let lowered = body.clone().translated(std::array::from_fn(|i| if i == D - 1 { -depth } else { 0.0 }));
            let pose = Pose { position: turn(position), rotation: r, scale: 1.0 };
            for options in estimators() {
                if options == exact() && matches!(shape, Shape::Cylinder { .. }) {
                    continue;
                }
                let (contact, scene) = against(&lowered.clone().rotated_by(r), &shape, pose, options);
                let sampling =
                    if options == exact() { 1e-12 } else { 0.1 + 4.0 * contact.standard_error / depth.max(1e-9) };
                // The foot has measure 1. Where it only touches, nothing remains but rounding of coordinates of 2.
                assert!(
                    (contact.volume - depth).abs() < 1e-14 + sampling * depth,
                    "{shape:?}, {options:?}: {:e} {:e}",
                    contact.volume,
                    contact.standard_error
                );
                if depth > 0.0 {
                    balanced(&contact, &scene.coords);
                    let up = turn(std::array::from_fn(|i| f64::from(u8::from(i == D - 1))));
                    let push: f64 = (0..D).map(|i| up[i] * contact.bodies[0].force[i]).sum();
                    assert!((push - 1.0).abs() < sampling, "{shape:?}, {options:?}: {push}");
                } else {
                    assert!(
                        size_sum(&contact.forces) < 1e-12,
                        "{shape:?}, {options:?}: {:e}",
                        size_sum(&contact.forces)
                    );
                }
            }
        }
    }
}

#[test]
fn blocks_stand_on_tables() {
    let square = rectangle_tri3([0.0; 2], [1.0; 2], [4, 4], Diagonals::Alternating);
    let table = polygon(&[[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]], 3);
    let cube = cuboid_tet4([0.0; 3], [1.0; 3], [2; 3]);
    let table_3d = cuboid_surface([-1.0; 3], [1.0; 3], [3; 3]);
    for depth in [0.0, 0.02] {
        let polytope = Shape::Polytope { facets: table.facets(), points: table.coords.clone() };
        stands(&square, polytope, depth);
        let polytope = Shape::Polytope { facets: table_3d.facets(), points: table_3d.coords.clone() };
        stands(&cube, polytope.clone(), depth);
        stands(&cuboid_hex8([0.0; 3], [1.0; 3], [3; 3]), polytope, depth);
    }
}

/// A body that fills a cuboid exactly shares its faces with it.
#[test]
fn blocks_fill_cuboids() {
    let cube = cuboid_tet4([-0.5; 3], [0.5; 3], [2; 3]);
    for seed in 0..6 {
        let pose = Pose { position: [0.3, -0.2, 0.1], rotation: random_rotation(seed), scale: 1.0 };
        let body = cube.clone().rotated_by(pose.rotation).translated(pose.position);
        for options in estimators() {
            let (contact, scene) = against(&body, &Shape::Cuboid { half_extents: [0.5; 3] }, pose, options);
            // Three thousand segments of which a third meets the cube's faces; lines are better.
            let tolerance = if options == exact() { 1e-12 } else { 0.2 };
            assert!((contact.volume - 1.0).abs() < tolerance, "{options:?}: {}", contact.volume);
            balanced(&contact, &scene.coords);
            // Half of every face belongs to the body, as if the cuboid were another, and neither wins.
            let (push, sizes) = (size_sum(&[contact.bodies[0].force]), size_sum(&contact.forces));
            assert!(push < tolerance * sizes, "{options:?}: {push} of {sizes}");
            let both = size_sum(&Scene::of(&[&body, &body]).evaluate(exact()).forces);
            assert!((2.0 * sizes / both - 1.0).abs() < tolerance, "{options:?}: {sizes} of {both}");
        }
    }
}

/// A ball that touches the block's face in one point.
#[test]
fn balls_touch_in_a_point() {
    let cube = cuboid_tet4([-1.0; 3], [1.0, 1.0, 0.0], [2; 3]);
    for seed in 0..6 {
        let r = random_rotation::<3>(seed);
        let turn = |x: [f64; 3]| r.map(|row| row[0] * x[0] + row[1] * x[1] + row[2] * x[2]);
        let pose = Pose { position: turn([0.1, 0.2, 0.7]), rotation: r, scale: 1.0 };
        for options in &estimators()[1..] {
            let (contact, _) = against(&cube.clone().rotated_by(r), &Shape::Ball { radius: 0.7 }, pose, *options);
            assert!(contact.volume < 1e-14 && size_sum(&contact.forces) < 1e-12);
        }
    }
}
