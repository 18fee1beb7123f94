//! Signed distance functions of the shapes that have a closed form: the same lines find the same crossings.

use crate::scene::{Scene, consistent_lines, distance, lines, norm};
use fmc_contact::{ContactForces, Error, Obstacle, Options, Pose, Shape};
use fmc_shapes::{Mesh, random_polygon, random_polyhedron, random_rotation};
use std::sync::Arc;

/// Distance and its gradient from a distance alone, by differences: what a host would do that knows no better.
fn with_differences<const D: usize>(phi: impl Fn(&[f64; D]) -> f64 + Send + Sync + 'static) -> Shape<D> {
    let h = 1e-6;
    Shape::SignedDistance(Arc::new(move |x: &[f64; D]| {
        let slope = |i: usize| {
            let (mut low, mut high) = (*x, *x);
            (low[i], high[i]) = (x[i] - h, x[i] + h);
            (phi(&high) - phi(&low)) / (2.0 * h)
        };
        (phi(x), std::array::from_fn(slope))
    }))
}

fn length(x: &[f64]) -> f64 {
    x.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// Distance to the box of these half sides around the origin.
fn to_box(x: &[f64], half: &[f64]) -> f64 {
    let q: Vec<f64> = x.iter().zip(half).map(|(x, h)| x.abs() - h).collect();
    let outside: Vec<f64> = q.iter().map(|q| q.max(0.0)).collect();
    length(&outside) + q.iter().fold(f64::NEG_INFINITY, |m, q| m.max(*q)).min(0.0)
}

/// Shapes in closed form beside their distances.
fn shapes<const D: usize>() -> Vec<(Shape<D>, Shape<D>)> {
    let (r, h) = (0.6, 0.5);
    let radial = |x: &[f64; D]| length(&x[..D - 1]);
    let half_extents: [f64; D] = std::array::from_fn(|i| 0.4 + 0.1 * i as f64);
    // The larger of the distances from the base and from the flank is at most the distance, and 1-Lipschitz.
    let flank = length(&[r, 2.0 * h]);
    vec![
        (Shape::HalfSpace, with_differences(|x: &[f64; D]| x[D - 1])),
        (Shape::Ball { radius: r }, with_differences(move |x: &[f64; D]| length(x) - r)),
        (Shape::Cuboid { half_extents }, with_differences(move |x: &[f64; D]| to_box(x, &half_extents))),
        (
            Shape::Cylinder { radius: r, half_height: h },
            with_differences(move |x: &[f64; D]| to_box(&[radial(x), x[D - 1]], &[r, h])),
        ),
        (
            Shape::Cone { radius: r, half_height: h },
            with_differences(move |x: &[f64; D]| {
                let flank = (2.0 * h * radial(x) + r * (x[D - 1] - h)) / flank;
                flank.max(-h - x[D - 1])
            }),
        ),
        (
            Shape::Capsule { radius: r, half_height: h },
            with_differences(move |x: &[f64; D]| length(&[radial(x), (x[D - 1].abs() - h).max(0.0)]) - r),
        ),
    ]
}

fn against<const D: usize>(scene: &Scene<D>, shape: &Shape<D>, pose: Pose<D>, options: Options) -> ContactForces<D> {
    let mut contact = scene.contact(options);
    contact.add_obstacle(Obstacle { shape: shape.clone(), pose }).unwrap();
    contact.evaluate(&scene.coords).unwrap()
}

fn like_the_shape<const D: usize>(body: &Mesh<D>, spacing: f64, seed: u64) {
    let scene = Scene::of(&[body]);
    let position = std::array::from_fn(|i| [0.5, -0.3, 0.4][i]);
    for (shape, distances) in shapes() {
        for scale in [1.0, 0.7, 1.4] {
            let pose = Pose { position, rotation: random_rotation(seed), scale };
            for options in [consistent_lines(spacing, seed), lines(spacing, seed)] {
                let closed = against(&scene, &shape, pose, options);
                let marched = against(&scene, &distances, pose, options);
                assert!(closed.volume > 1e-2);
                // Crossings are the same but for chords shorter than a part of the spacing, at corners and edges, which
                // marching may step over: they lose that part times the length of the edges, of a boundary of some 3.
                // Normals by differences are known to 1e-9, but not within a step of an edge.
                let name = format!("{shape:?}, scale {scale}");
                assert!(
                    (marched.volume / closed.volume - 1.0).abs() < 1e-4,
                    "{name}: {:e}",
                    marched.volume / closed.volume - 1.0
                );
                let size = closed.contact_area;
                let on_nodes = distance(&marched.forces, &closed.forces) / size;
                let (x, y) = (marched.obstacles[0].force, closed.obstacles[0].force);
                let (p, q) = (marched.obstacles[0].moment, closed.obstacles[0].moment);
                let errors = [on_nodes, distance(&[x], &[y]) / size, distance(&[p], &[q]) / size];
                assert!(errors.iter().all(|e| *e < 0.25 * spacing), "{name}: {errors:?}");
            }
        }
    }
}

#[test]
fn distances_are_like_their_shapes_in_2d() {
    for seed in 0..3 {
        like_the_shape(&random_polygon(9, 1.0, 0.5, seed), 0.005, seed);
    }
}

#[test]
fn distances_are_like_their_shapes_in_3d() {
    like_the_shape(&random_polyhedron(1, 1.0, 0.3, 1, 5), 0.04, 5);
}

/// A distance that grows more slowly than it might costs evaluations, not accuracy.
#[test]
fn timid_distances_find_the_same_crossings() {
    let scene = Scene::of(&[&random_polygon(9, 1.0, 0.5, 1)]);
    let pose = Pose::at([0.4, -0.5]);
    let bold = with_differences(|x: &[f64; 2]| length(x) - 0.6);
    let timid = with_differences(|x: &[f64; 2]| 0.1 * (length(x) - 0.6));
    let [bold, timid] = [bold, timid].map(|shape| against(&scene, &shape, pose, consistent_lines(0.01, 1)));
    assert!((timid.volume / bold.volume - 1.0).abs() < 1e-6);
    assert!(distance(&timid.forces, &bold.forces) < 1e-4 * norm(&bold.forces));
}

/// Where no line grazes, lines end where those of the shape do, up to rounding.
#[test]
fn crossings_are_closed_to_rounding() {
    let scene = Scene::of(&[&random_polygon(9, 1.0, 0.5, 1)]);
    // A ball so large that its rim runs through the body like a plane.
    let (radius, pose) = (20.0, Pose::at([14.0, 14.3]));
    let distances = Shape::SignedDistance(Arc::new(move |x: &[f64; 2]| {
        let length = length(x);
        (length - radius, x.map(|x| x / length))
    }));
    for seed in 0..4 {
        let [closed, marched] = [Shape::Ball { radius }, distances.clone()]
            .map(|s| against(&scene, &s, pose, consistent_lines(0.01, seed)));
        assert!(closed.volume > 0.1);
        // Coordinates of 20 are rounded to 2⁻⁴⁹, on some hundred lines.
        assert!((marched.volume / closed.volume - 1.0).abs() < 1e-12, "{:e}", marched.volume / closed.volume - 1.0);
        assert!(distance(&marched.forces, &closed.forces) < 1e-11 * norm(&closed.forces));
    }
}

/// One that hardly changes along a line allows short steps alone: its lines are followed to their ends, or refused by name.
#[test]
fn distances_that_stand_still_are_found_or_refused() {
    let scene = Scene::of(&[&random_polygon(9, 1.0, 0.5, 1)]);
    let pose = Pose::at([0.4, -0.5]);
    let shape = |slope: f64| with_differences(move |x: &[f64; 2]| slope * (length(x) - 0.6));
    let bold = against(&scene, &shape(1.0), pose, consistent_lines(1e-3, 1));
    for slope in [1e-1, 1e-5] {
        let mut contact = scene.contact(consistent_lines(1e-3, 1));
        contact.add_obstacle(Obstacle { shape: shape(slope), pose }).unwrap();
        match contact.evaluate(&scene.coords) {
            // Differences know the slope to some ten digits of its size, and the crossings lie where the distance is zero.
            Ok(still) => assert!((still.volume / bold.volume - 1.0).abs() < 1e-3, "{slope}: {}", still.volume),
            Err(error) => assert!(matches!(error, Error::UnfinishedLines { .. }), "{slope}: {error}"),
        }
    }
}

/// Bodies that no closed form describes: two balls melted into one, and a ball with another cut out of it.
#[test]
fn unions_and_differences_of_distances() {
    use crate::membership::{cover, thrown};
    let ball = |x: &[f64; 2], c: [f64; 2], r: f64| length(&[x[0] - c[0], x[1] - c[1]]) - r;
    let union = move |x: &[f64; 2]| ball(x, [0.0, 0.0], 0.5).min(ball(x, [0.6, 0.1], 0.4));
    let crescent = move |x: &[f64; 2]| ball(x, [0.0, 0.0], 0.6).max(-ball(x, [0.3, 0.1], 0.4));
    let body = random_polygon(9, 1.0, 0.5, 4);
    let scene = Scene::of(&[&body]);
    let count = |phi: &dyn Fn(&[f64; 2]) -> f64| {
        thrown([[-1.6; 2], [1.6; 2]], 300_000, 1, |x| if phi(x) < 0.0 { cover(&body, x) } else { 0 })
    };
    for (shape, [volume, error]) in
        [(with_differences(union), count(&union)), (with_differences(crescent), count(&crescent))]
    {
        let found = against(&scene, &shape, Pose::at([0.0; 2]), lines(0.003, 2));
        assert!((found.volume - volume).abs() < 4.0 * error, "{} instead of {volume} ± {error}", found.volume);
    }
}
