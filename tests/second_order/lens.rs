//! Discs with all nodes on the circle in partial overlap, against closed forms.

use crate::scene::{Scene, exact};
use fmc_contact::{Contact, Obstacle, Pose, Shape};
use fmc_shapes::{Mesh, Splitmix, disc_tri3, second_order};
use std::f64::consts::TAU;

/// Area and chord of the segment of the unit circle that is so deep.
fn segment(depth: f64) -> [f64; 2] {
    let half = (1.0 - depth).acos();
    [half - half.sin() * half.cos(), 2.0 * half.sin()]
}

fn disc(edges: usize, nodes: usize, angle: f64) -> Mesh<2> {
    let straight = disc_tri3(1.0, edges);
    let mesh = if nodes == 3 { straight } else { second_order(&straight, nodes).rounded([0.0; 2], 1.0) };
    mesh.rotated(angle)
}

/// Area, and resultant of pressure 1, of a disc in a plane.
fn in_a_plane(edges: usize, nodes: usize, depth: f64, angle: f64) -> [f64; 2] {
    let scene = Scene::of(&[&disc(edges, nodes, angle)]);
    let mut contact: Contact<2> = scene.contact(exact());
    contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0, depth - 1.0]) }).expect("a plane");
    let found = contact.evaluate(&scene.coords).expect("forces");
    [found.volume, found.bodies[0].force[1]]
}

/// The same of half the lens of two discs.
fn in_a_disc(edges: usize, nodes: usize, depth: f64, angle: f64) -> [f64; 2] {
    let other = disc(edges, nodes, 2.7 * angle).translated([0.0, 2.0 - 2.0 * depth]);
    let found = Scene::of(&[&disc(edges, nodes, angle), &other]).evaluate(exact());
    [0.5 * found.volume, found.bodies[1].force[1]]
}

/// Root mean squares of the relative errors of both, over depths about 0.3 and over turned discs: where in an edge the overlap
/// ends decides what its error is.
fn errors(of: impl Fn(usize, usize, f64, f64) -> [f64; 2], edges: usize, nodes: usize) -> [f64; 2] {
    let (mut random, count) = (Splitmix::new(11), 48);
    let mut sums = [0.0; 2];
    for _ in 0..count {
        let (depth, angle) = (random.between(0.2, 0.4), random.between(0.0, TAU));
        let found = of(edges, nodes, depth, angle);
        for (sum, (found, expected)) in sums.iter_mut().zip(found.into_iter().zip(segment(depth))) {
            *sum += (found / expected - 1.0).powi(2);
        }
    }
    sums.map(|sum| (sum / f64::from(count)).sqrt())
}

/// Where the overlap ends within an edge, the wave of the gap (h²/24R) is cut: what it encloses to there is of third order, the
/// place of the end of second. With straight cells both are of second order, and much larger.
#[test]
fn area_is_of_third_order_and_its_gradient_of_second() {
    for of in [in_a_plane as fn(usize, usize, f64, f64) -> [f64; 2], in_a_disc] {
        let all = [16, 32, 64, 128].map(|edges| errors(of, edges, 6));
        let order = |k: usize| (all[0][k] / all[3][k]).log2() / 3.0;
        assert!(order(0) > 2.8 && order(1) > 1.8, "{all:?}: {} {}", order(0), order(1));
        assert!(all[3][0] < 2e-6 && all[3][1] < 6e-5, "{all:?}");
        let straight = errors(of, 64, 3);
        assert!(all[2][0] < straight[0] / 400.0 && all[2][1] < straight[1] / 6.0, "{all:?} {straight:?}");
    }
}
