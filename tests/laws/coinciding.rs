//! Bodies whose facets coincide: one inside another, identical, and side by side with faces in one plane.

use crate::balance::balanced;
use crate::scene::{Scene, exact, fibers, isotropic, lines, size_sum};
use fmc_contact::{ContactForces, FiberOptions, Options, Warning};
use fmc_shapes::{
    Diagonals, Mesh, ball_tet4, cuboid_hex8, cuboid_tet4, disc_tri3, random_rotation, rectangle_quad4, rectangle_tri3,
};

/// With the relative error of a volume of size 1: rounding, and the sampling error of some hundred lines per family or
/// of 20 000 segments that are as long as the body.
fn estimators() -> [(Options, f64); 4] {
    let isotropic = isotropic(1.0, 20_000, 1);
    [(exact(), 1e-13), (fibers(FiberOptions::default()), 5e-3), (lines(0.01, 1), 2e-3), (isotropic, 0.1)]
}

fn square() -> Mesh<2> {
    rectangle_tri3([0.0; 2], [1.0; 2], [4, 4], Diagonals::Alternating)
}

fn cube() -> Mesh<3> {
    cuboid_tet4([0.0; 3], [1.0; 3], [3; 3])
}

fn finite<const D: usize>(contact: &ContactForces<D>) {
    assert!(contact.forces.iter().flatten().all(|f| f.is_finite()));
    assert!(contact.volume.is_finite() && contact.contact_area.is_finite() && contact.penetration.is_finite());
}

/// Turned as one by several rotations, the identity first.
fn turned<const D: usize>(a: &Mesh<D>, b: &Mesh<D>, check: impl Fn(&Scene<D>, [[f64; D]; D])) {
    let identity = std::array::from_fn(|i| std::array::from_fn(|j| f64::from(u8::from(i == j))));
    for r in std::iter::once(identity).chain((0..6).map(random_rotation)) {
        check(&Scene::of(&[&a.clone().rotated_by(r), &b.clone().rotated_by(r)]), r);
    }
}

/// Its overlap is its volume, and nothing pushes it anywhere.
fn whole_volume<const D: usize>(a: &Mesh<D>, b: &Mesh<D>, volume: f64) {
    turned(a, b, |scene, _| {
        for (options, tolerance) in estimators() {
            let contact = scene.evaluate(options);
            finite(&contact);
            assert!((contact.volume / volume - 1.0).abs() < tolerance, "{options:?}: {} of {volume}", contact.volume);
            balanced(&contact, &scene.coords);
            let push: f64 = contact.bodies[0].force.iter().map(|f| f.abs()).sum();
            assert!(push <= tolerance.max(1e-12) * size_sum(&contact.forces), "{options:?}: {push}");
        }
    });
}

#[test]
fn identical_bodies_share_their_volume() {
    whole_volume(&square(), &square(), 1.0);
    whole_volume(&disc_tri3(1.0, 20), &disc_tri3(1.0, 20), disc_tri3(1.0, 20).measure());
    whole_volume(&cube(), &cube(), 1.0);
    whole_volume(&ball_tet4(1.0, 1, 1), &ball_tet4(1.0, 1, 1), ball_tet4(1.0, 1, 1).measure());
}

/// The same block in other cells: its faces coincide up to rounding.
#[test]
fn identical_blocks_of_other_cells_share_their_volume() {
    whole_volume(&square(), &rectangle_quad4([0.0; 2], [1.0; 2], [5, 3]), 1.0);
    whole_volume(&cube(), &cuboid_hex8([0.0; 3], [1.0; 3], [2; 3]), 1.0);
}

#[test]
fn identical_squares_push_alike() {
    let scene = Scene::of(&[&square(), &square()]);
    let contact = scene.evaluate(exact());
    // Each carries half: a corner of the square has the halves of two edges of 1/4 around it, half of that each.
    let n = square().coords.len();
    assert_eq!(contact.forces[0], [1.0 / 16.0; 2]);
    assert_eq!(contact.forces[n], [1.0 / 16.0; 2]);
    assert!((0..n).all(|node| contact.forces[node] == contact.forces[n + node]));
}

#[test]
fn nested_bodies_push_only_the_inner_one() {
    let disc = disc_tri3(0.3, 24).translated([0.45, 0.55]);
    let ball = ball_tet4(0.3, 2, 1).translated([0.45, 0.55, 0.5]);
    nested(&square(), &disc);
    nested(&cube(), &ball);
}

fn nested<const D: usize>(outer: &Mesh<D>, inner: &Mesh<D>) {
    whole_volume(outer, inner, inner.measure());
    let scene = Scene::of(&[outer, inner]);
    for (options, tolerance) in estimators() {
        let contact = scene.evaluate(options);
        assert!(scene.nodes_of(0).all(|node| contact.forces[node] == [0.0; D]));
        // Scaled about any point, the inner body's volume goes with the D-th power: Σ x·∂V/∂x = D V.
        let virial: f64 = (scene.nodes_of(1))
            .map(|node| -(0..D).map(|i| scene.coords[node][i] * contact.forces[node][i]).sum::<f64>())
            .sum();
        assert!((virial / (D as f64 * inner.measure()) - 1.0).abs() < 2.0 * tolerance, "{options:?}: {virial}");
        let swallowed = |w: &Warning| matches!(w, Warning::SwallowedBody { .. });
        assert_eq!(contact.warnings.iter().filter(|w| swallowed(w)).count(), 1);
    }
}

/// Blocks with sides in one plane, 0.1 deep in each other: they push apart across the overlap, and along the common
/// plane the overlap shrinks whichever way they move, so that no more than half of its side pushes there.
#[test]
fn blocks_with_sides_in_one_plane() {
    let upper = square().translated([0.0, 0.9]);
    let coarse = rectangle_quad4([0.0, 0.9], [1.0, 2.0], [3, 3]);
    for upper in [upper, coarse] {
        turned(&square(), &upper, |scene, r| coplanar(scene, 0.1, r.map(|row| row[1]), 0.1));
    }
    let upper = cube().translated([0.0, 0.0, 0.9]);
    let coarse = cuboid_hex8([0.0, 0.0, 0.9], [1.0, 1.0, 2.0], [2; 3]);
    for upper in [upper, coarse] {
        turned(&cube(), &upper, |scene, r| coplanar(scene, 0.1, r.map(|row| row[2]), 0.2));
    }
}

/// Volume, force 1 on the upper block along `up`, and at most `side` across.
fn coplanar<const D: usize>(scene: &Scene<D>, volume: f64, up: [f64; D], side: f64) {
    for (options, tolerance) in estimators() {
        let contact = scene.evaluate(options);
        finite(&contact);
        balanced(&contact, &scene.coords);
        assert!((contact.volume - volume).abs() < tolerance, "{options:?}: {}", contact.volume);
        let force = contact.bodies[1].force;
        let along: f64 = (0..D).map(|i| force[i] * up[i]).sum();
        let across = (0..D).map(|i| (force[i] - along * up[i]).powi(2)).sum::<f64>().sqrt();
        assert!((along - 1.0).abs() < tolerance.max(1e-12) * 10.0, "{options:?}: {along}");
        assert!(across <= side * (1.0 + 10.0 * tolerance), "{options:?}: {across}");
    }
}
