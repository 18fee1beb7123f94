//! Bodies apart, and bodies that only touch: no overlap and no force. Where a tilt leaves it to rounding on which side a
//! face lies, the overlap is of the size of rounding, and no force is larger than a full overlap's.

use crate::balance::balanced;
use crate::scene::table::{by_laws, laws, suits};
use crate::scene::{Scene, exact, fibers, isotropic, lines, size_sum};
use fmc_contact::{FiberOptions, Options};
use fmc_shapes::{
    Diagonals, Mesh, cuboid_hex8, cuboid_tet4, icosphere, random_rotation, rectangle_quad4, rectangle_tri3,
};

fn estimators() -> Vec<Options> {
    vec![exact(), fibers(FiberOptions::default()), lines(0.013, 1), isotropic(0.3, 3_000, 1)]
}

fn nothing<const D: usize>(scene: &Scene<D>) {
    for options in by_laws(estimators(), &laws(1.0)).into_iter().filter(|options| suits(scene, options)) {
        let contact = scene.evaluate(options);
        // Clipping may leave slivers as wide as rounding at the rim of a face of size 1.
        assert!(contact.volume < 1e-15 && contact.energy < 1e-15 && contact.contact_area < 1e-15, "{options:?}");
        assert!(size_sum(&contact.forces) < 1e-15, "{options:?}");
    }
}

fn square() -> Mesh<2> {
    rectangle_tri3([0.0; 2], [1.0; 2], [4, 4], Diagonals::Alternating)
}

fn cube() -> Mesh<3> {
    cuboid_tet4([0.0; 3], [1.0; 3], [3; 3])
}

#[test]
fn bodies_apart_feel_nothing() {
    nothing(&Scene::of(&[&square(), &square().translated([1.01, 0.0])]));
    nothing(&Scene::of(&[&cube(), &cube().translated([3.0, 0.0, 0.0])]));
    // Boxes meet, bodies do not: one square in the corner left free by a turned one.
    let diamond = square().translated([-0.5; 2]).rotated(std::f64::consts::FRAC_PI_4);
    nothing(&Scene::of(&[&diamond, &square().scaled(0.3).translated([0.37, 0.37])]));
    let ball = icosphere(1.0, 2);
    nothing(&Scene::of(&[&ball, &ball.clone().translated([1.2, 1.2, 1.2])]));
    // A body in the hollow of another: between the tips of a star-shaped hole there is room.
    let ring = fmc_shapes::patch_quad4([12, 2], |u, v| {
        let (s, c) = (-std::f64::consts::TAU * u).sin_cos();
        [(1.0 + v) * c, (1.0 + v) * s]
    });
    let ring = ring.welded(1e-9);
    nothing(&Scene::of(&[&ring, &square().scaled(0.9).translated([-0.45; 2])]));
}

#[test]
fn whole_sides_and_faces_touch() {
    nothing(&Scene::of(&[&square(), &square().translated([1.0, 0.0])]));
    nothing(&Scene::of(&[&square(), &rectangle_quad4([0.25, 1.0], [2.0, 3.0], [3, 5])]));
    nothing(&Scene::of(&[&cube(), &cube().translated([0.0, 0.0, 1.0])]));
    nothing(&Scene::of(&[&cube(), &cuboid_hex8([0.3, 1.0, -0.4], [1.7, 2.0, 0.9], [2; 3])]));
}

#[test]
fn corners_and_edges_touch() {
    nothing(&Scene::of(&[&square(), &square().translated([1.0, 1.0])]));
    let diamond = Mesh { coords: vec![[1.0, 0.5], [1.5, 0.0], [1.5, 1.0]], conn: vec![0, 1, 2], nodes_per_cell: 3 };
    nothing(&Scene::of(&[&square(), &diamond]));
    nothing(&Scene::of(&[&cube(), &cube().translated([1.0, 1.0, 0.0])]));
    nothing(&Scene::of(&[&cube(), &cube().translated([1.0; 3])]));
    let x = [[1.0, 0.4, 0.5], [1.5, 0.0, 0.0], [1.5, 1.0, 0.0], [1.5, 0.5, 1.0]];
    let tip = Mesh { coords: x.to_vec(), conn: vec![0, 1, 2, 3], nodes_per_cell: 4 };
    nothing(&Scene::of(&[&cube(), &tip]));
}

/// The two turned as one, so that faces which touch do so up to rounding; `area` is that of the face they share.
fn hardly_anything<const D: usize>(a: &Mesh<D>, b: &Mesh<D>, area: f64) {
    for seed in 0..12 {
        let r = random_rotation::<D>(seed);
        let scene = Scene::of(&[&a.clone().rotated_by(r), &b.clone().rotated_by(r)]);
        for options in estimators() {
            let contact = scene.evaluate(options);
            // Rounding of coordinates of size 2, on a face of area 1, several times over.
            assert!(contact.volume < 1e-14, "seed {seed}, {options:?}: {:e}", contact.volume);
            if size_sum(&contact.forces) > 1e-12 {
                balanced(&contact, &scene.coords);
            }
            // Every nodal force is part of the push on a face; both bodies have one. Sampling sees it with an error.
            let most = 2.0 * area * if options == exact() { 1.0 + 1e-12 } else { 1.3 };
            assert!(size_sum(&contact.forces) <= most, "seed {seed}: {} of {area}", size_sum(&contact.forces));
        }
    }
}

#[test]
fn tilted_faces_touch_up_to_rounding() {
    let right = square().translated([1.0, 0.0]);
    hardly_anything(&square(), &right, 1.0);
    hardly_anything(&square(), &rectangle_quad4([1.0, 0.25], [2.0, 1.5], [3, 5]), 0.75);
    hardly_anything(&cube(), &cube().translated([0.0, 0.0, 1.0]), 1.0);
    hardly_anything(&cube(), &cuboid_hex8([0.3, 1.0, -0.4], [1.7, 2.0, 0.9], [2; 3]), 0.7 * 0.9);
}

#[test]
fn tilted_corners_touch_up_to_rounding() {
    hardly_anything(&square(), &square().translated([1.0, 1.0]), 1e-9);
    hardly_anything(&cube(), &cube().translated([1.0, 1.0, 0.0]), 1e-9);
}
