//! Forces and moments sum to zero: exact overlap does not change when everything moves as one, and sampled forces are
//! corrected so that theirs does not either.

use crate::pairs::{plane_scene, solid_scene};
use crate::scene::table::{by_laws, is_depth, laws};
use crate::scene::{Scene, cross, exact, fibers, isotropic, lines, size_sum};
use fmc_contact::{
    Contact, ContactForces, Estimator, FiberOptions, LineWeights, Obstacle, Options, Pose, Resolution, Shape,
};
use fmc_shapes::{Diagonals, icosphere, rectangle_tri3, regular_polygon};

/// Of the sum of the sizes of all forces, and for moments times the size of the bodies.
const ROUNDING: f64 = 1e-12;

/// Balanced estimates of every kind, at this size of the bodies.
fn estimators(size: f64) -> Vec<Options> {
    let consistent = FiberOptions {
        weights: LineWeights::Consistent,
        resolution: Resolution::Spacing(0.04 * size),
        ..FiberOptions::default()
    };
    let sampled = [fibers(FiberOptions::default()), lines(0.05 * size, 3), lines(0.31 * size, 6)];
    let by_all = by_laws(sampled, &laws(size));
    by_all.into_iter().chain([exact(), fibers(consistent), isotropic(0.2 * size, 3_000, 5)]).collect()
}

/// Nodes, bodies and obstacles: every sum there is.
pub(crate) fn balanced<const D: usize>(contact: &ContactForces<D>, coords: &[[f64; D]]) {
    let reactions: Vec<[f64; D]> = contact.obstacles.iter().map(|o| o.force).collect();
    let sizes = size_sum(&contact.forces) + size_sum(&reactions);
    // The centre of the nodes' box and the length of its diagonal.
    let range = |i: usize| {
        coords.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x[i]), high.max(x[i])))
    };
    let centre: [f64; D] = std::array::from_fn(|i| 0.5 * (range(i).0 + range(i).1));
    let size = (0..D).map(|i| (range(i).1 - range(i).0).powi(2)).sum::<f64>().sqrt();
    let (mut force, mut moment) = ([0.0; D], [0.0; 3]);
    let mut add = |f: &[f64; D], m: [f64; 3]| {
        (0..D).for_each(|i| force[i] += f[i]);
        (0..3).for_each(|i| moment[i] += m[i]);
    };
    for (x, f) in coords.iter().zip(&contact.forces) {
        add(f, cross(&std::array::from_fn(|i| x[i] - centre[i]), f));
    }
    for obstacle in &contact.obstacles {
        let about_centre = cross(&centre, &obstacle.force);
        add(&obstacle.force, std::array::from_fn(|i| obstacle.moment[i] - about_centre[i]));
    }
    assert!(force.iter().all(|f| f.abs() <= ROUNDING * sizes), "{force:?} of {sizes}");
    assert!(moment.iter().all(|m| m.abs() <= ROUNDING * sizes * size), "{moment:?} of {sizes} at {size}");
    // The resultants are the sums over the nodes.
    let of_bodies = |i: usize| contact.bodies.iter().map(|b| b.force[i]).sum::<f64>();
    let of_nodes = |i: usize| contact.forces.iter().map(|f| f[i]).sum::<f64>();
    assert!((0..D).all(|i| (of_bodies(i) - of_nodes(i)).abs() <= ROUNDING * sizes));
}

fn pairs_balance<const D: usize>(scene: impl Fn(u64) -> Scene<D>, seeds: u64) {
    for seed in 0..seeds {
        let size = [1.0, 1e-3, 1e3, 1e-6, 1e6][seed as usize % 5];
        let scene = scene(seed).mapped(|x| x.map(|x| x * size));
        for options in estimators(size) {
            let contact = scene.evaluate(options);
            assert!(contact.volume > 0.0 && size_sum(&contact.forces) > 0.0);
            balanced(&contact, &scene.coords);
        }
    }
}

#[test]
fn forces_and_moments_balance_in_2d() {
    pairs_balance(plane_scene, 20);
}

#[test]
fn forces_and_moments_balance_in_3d() {
    pairs_balance(solid_scene, 5);
}

/// A body in every gap of a row: each has two neighbours, and each pair is balanced by itself.
#[test]
fn forces_and_moments_balance_among_several_bodies() {
    let block = |k: usize| {
        rectangle_tri3([0.0; 2], [1.0, 0.6], [4, 3], Diagonals::Alternating)
            .rotated(0.1 * k as f64)
            .translated([0.9 * k as f64, 0.05 * (k * k) as f64])
    };
    let blocks: Vec<_> = (0..5).map(block).collect();
    let scene = Scene::of(&blocks.iter().collect::<Vec<_>>());
    for options in estimators(1.0) {
        let contact = scene.evaluate(options);
        assert_eq!(contact.pairs.len(), 4, "{options:?}");
        balanced(&contact, &scene.coords);
    }
}

fn with_obstacles<const D: usize>(scene: &Scene<D>, options: Options, obstacles: &[Obstacle<D>]) -> Contact<D> {
    let mut contact = scene.contact(options);
    obstacles.iter().for_each(|o| {
        contact.add_obstacle(o.clone()).unwrap();
    });
    contact
}

/// Every shape that the estimator takes; the reaction on the obstacle balances the force on the nodes.
fn obstacles_balance<const D: usize>(scene: &Scene<D>, polytope: Shape<D>, poses: &[Pose<D>], volume: f64) {
    let half_extents = std::array::from_fn(|i| 0.5 + 0.1 * i as f64);
    let flat = [Shape::HalfSpace, Shape::Cuboid { half_extents }, polytope];
    let round = vec![
        Shape::Ball { radius: 0.6 },
        Shape::Cylinder { radius: 0.5, half_height: 0.6 },
        Shape::Cone { radius: 0.6, half_height: 0.7 },
        Shape::Capsule { radius: 0.4, half_height: 0.5 },
    ];
    for options in estimators(1.0) {
        let takes_round = options.estimator != Estimator::Exact || is_depth(&options.law);
        let shapes = flat.iter().chain(if takes_round { round.as_slice() } else { &[] });
        let obstacles: Vec<Obstacle<D>> =
            shapes.zip(poses.iter().cycle()).map(|(s, &pose)| Obstacle { shape: s.clone(), pose }).collect();
        // One by one, so that no obstacle hides another's imbalance, and all together.
        for obstacle in &obstacles {
            let contact =
                with_obstacles(scene, options, std::slice::from_ref(obstacle)).evaluate(&scene.coords).unwrap();
            assert!(contact.obstacles[0].force.iter().any(|f| *f != 0.0), "{:?} is not met", obstacle.shape);
            assert!(contact.volume > volume);
            balanced(&contact, &scene.coords);
        }
        let contact = with_obstacles(scene, options, &obstacles).evaluate(&scene.coords).unwrap();
        balanced(&contact, &scene.coords);
    }
}

#[test]
fn obstacles_take_up_the_forces_in_2d() {
    let scene = plane_scene(3);
    let polygon = regular_polygon(7, 0.6);
    let polytope = Shape::Polytope { facets: polygon.facets(), points: polygon.coords };
    let poses = [Pose::at([0.2, -0.9]).turned(0.3), Pose::at([-0.7, 0.5]).turned(-2.0).scaled(1.2)];
    obstacles_balance(&scene, polytope, &poses, 1e-3);
}

#[test]
fn obstacles_take_up_the_forces_in_3d() {
    let scene = solid_scene(3);
    let sphere = icosphere(0.7, 1);
    let polytope = Shape::Polytope { facets: sphere.facets(), points: sphere.coords };
    let poses = [
        Pose::at([0.2, -0.6, -0.5]).turned_about([1.0, 0.3, 0.2], 0.4),
        Pose::at([-0.6, 0.4, 0.3]).turned_about([0.2, 1.0, -0.5], -2.0).scaled(1.2),
    ];
    obstacles_balance(&scene, polytope, &poses, 1e-3);
}
