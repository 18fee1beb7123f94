//! A result says what should be known about it, and says nothing when there is nothing to say.

use crate::scene::{Scene, exact, fibers, lines};
use fmc_contact::overlap::Partner;
use fmc_contact::{EnergyLaw, FiberOptions, Obstacle, Options, Pose, Shape, Warning};
use fmc_shapes::{Diagonals, cuboid_tet4, icosphere, rectangle_quad4, rectangle_tri3};

/// Unit squares of edges 1/n, one `depth` deep in the other.
fn stacked(n: usize, depth: f64) -> Scene<2> {
    let square = rectangle_tri3([0.0; 2], [1.0; 2], [n, n], Diagonals::Alternating);
    Scene::of(&[&square, &square.clone().rotated(0.01).translated([0.1, 1.0 - depth])])
}

const A: Partner = Partner::Body(0);
const B: Partner = Partner::Body(1);

#[test]
fn good_estimates_give_no_warning() {
    assert!(stacked(5, 0.1).evaluate(exact()).warnings.is_empty());
    assert!(stacked(5, 0.1).evaluate(lines(0.01, 1)).warnings.is_empty());
    // What is chosen automatically is fine enough for any mesh, and for thin overlaps.
    for (n, depth) in [(1, 0.1), (5, 0.1), (40, 0.1), (5, 1e-3), (5, 1e-6)] {
        let warnings = stacked(n, depth).evaluate(fibers(FiberOptions::default())).warnings;
        assert!(warnings.is_empty(), "{n}, {depth}: {warnings:?}");
    }
    let ball = icosphere(1.0, 2);
    let scene = Scene::of(&[&ball, &ball.clone().translated([1.9, 0.1, 0.2])]);
    assert!(scene.evaluate(fibers(FiberOptions::default())).warnings.is_empty());
}

#[test]
fn fibers_wider_apart_than_facets_are_coarse() {
    let warnings = stacked(20, 0.3).evaluate(lines(0.06, 1)).warnings;
    let coarse = warnings.iter().find_map(|w| match *w {
        Warning::CoarseFibers { a, b, spacing, facet_size } => Some((a, b, spacing, facet_size)),
        _ => None,
    });
    let (a, b, spacing, facet_size) = coarse.expect("edges of 0.05 are finer than 0.06");
    assert_eq!((a, b, spacing), (A, B, 0.06));
    assert!((facet_size - 0.05).abs() < 1e-12);
    assert!(stacked(20, 0.3).evaluate(lines(0.04, 1)).warnings.is_empty());
}

#[test]
fn few_fibers_do_not_resolve_an_overlap() {
    // Lines a tenth apart: some ten of a family cross the face of 1, of the other family hardly one a depth of 0.02.
    let seen = |spacing: f64, depth: f64| {
        let warnings = stacked(2, depth).evaluate(lines(spacing, 1)).warnings;
        warnings.iter().find_map(|w| match *w {
            Warning::UnresolvedOverlap { a, b, fibers } => Some((a, b, fibers)),
            _ => None,
        })
    };
    let (a, b, fibers) = seen(0.3, 0.02).expect("a handful of fibers");
    assert_eq!((a, b), (A, B));
    assert!((1..8).contains(&fibers));
    assert_eq!(seen(0.01, 0.02), None);
}

#[test]
fn swallowed_bodies_are_named() {
    let outer = cuboid_tet4([-1.0; 3], [1.0; 3], [2; 3]);
    let inner = cuboid_tet4([-0.2; 3], [0.3; 3], [2; 3]);
    for options in [exact(), lines(0.05, 1)] {
        let inside = vec![Warning::SwallowedBody { inner: B, outer: A }];
        assert_eq!(Scene::of(&[&outer, &inner]).evaluate(options).warnings, inside);
        let inside = vec![Warning::SwallowedBody { inner: A, outer: B }];
        assert_eq!(Scene::of(&[&inner, &outer]).evaluate(options).warnings, inside);
        // Half out is not swallowed.
        let out = inner.clone().translated([1.0, 0.0, 0.0]);
        assert!(Scene::of(&[&outer, &out]).evaluate(options).warnings.is_empty());
        // An obstacle can be swallowed, and swallow.
        for (half, inner, outer) in [(0.3, Partner::Obstacle(0), A), (3.0, A, Partner::Obstacle(0))] {
            let scene = Scene::of(&[&cuboid_tet4([-1.0; 3], [1.0; 3], [2; 3])]);
            let mut contact = scene.contact(options);
            let obstacle = Obstacle { shape: Shape::Cuboid { half_extents: [half; 3] }, pose: Pose::at([0.1; 3]) };
            contact.add_obstacle(obstacle).unwrap();
            let warnings = contact.evaluate(&scene.coords).unwrap().warnings;
            assert_eq!(warnings, [Warning::SwallowedBody { inner, outer }]);
        }
    }
}

/// A ball inside a body that touches its surface, by rounding, is swallowed as one that does not.
#[test]
fn an_obstacle_that_touches_from_inside_is_swallowed() {
    let block = rectangle_quad4([-1.0, -2.0], [1.0, 0.0], [20, 20]);
    let scene = Scene::of(&[&block]);
    for (radius, x) in [(1e-3, 0.0), (0.01, 0.0), (0.01, 0.05), (0.3, 0.05)] {
        let mut contact = scene.contact(Options::new(EnergyLaw::depth(1.0)));
        let pose = Pose::at([x, -radius]);
        contact.add_obstacle(Obstacle { shape: Shape::Ball { radius }, pose }).unwrap();
        let warnings = contact.evaluate(&scene.coords).unwrap().warnings;
        let expected = [Warning::SwallowedBody { inner: Partner::Obstacle(0), outer: A }];
        assert_eq!(warnings, expected, "{radius} {x}");
    }
}

#[test]
fn warnings_read_as_sentences() {
    let warning = Warning::SwallowedBody { inner: Partner::Obstacle(3), outer: Partner::Body(2) };
    assert_eq!(warning.to_string(), "obstacle 3 lies inside body 2 and is not pushed out");
    let warning = Warning::UnresolvedOverlap { a: A, b: B, fibers: 3 };
    assert!(warning.to_string().contains("body 0 and body 1") && warning.to_string().contains('3'));
}
