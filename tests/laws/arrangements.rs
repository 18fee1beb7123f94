//! Nested, separate, touching, identical and coplanar bodies of random shape, in random places and at any scale.

use crate::balance::balanced;
use crate::scene::{Scene, consistent_lines, exact, lines, size_sum};
use fmc_contact::{ContactForces, Warning};
use fmc_shapes::{
    Diagonals, Mesh, Splitmix, cuboid_tet4, random_polygon, random_polyhedron, random_rotation, rectangle_tri3,
};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed};

fn config() -> Config {
    Config { cases: 24, failure_persistence: None, rng_seed: RngSeed::Fixed(3), ..Config::default() }
}

/// A concave body of radii between 0.6 and 1.4, of few facets.
trait Random: Sized {
    fn random(seed: u64) -> Self;
}

impl Random for Mesh<2> {
    fn random(seed: u64) -> Self {
        random_polygon(5 + (seed % 12) as usize, 1.0, 0.4, seed)
    }
}

impl Random for Mesh<3> {
    fn random(seed: u64) -> Self {
        random_polyhedron((seed % 2) as usize, 1.0, 0.25, 1 + (seed % 3) as usize, seed)
    }
}

/// Both bodies turned, moved by a few sizes and scaled, as one.
fn scene<const D: usize>(a: &Mesh<D>, b: &Mesh<D>, seed: u64, size: f64) -> Scene<D> {
    let r = random_rotation::<D>(seed);
    let mut random = Splitmix::new(seed);
    let offset: [f64; D] = std::array::from_fn(|_| random.between(-3.0, 3.0));
    let put = |mesh: &Mesh<D>| mesh.clone().rotated_by(r).translated(offset).scaled(size);
    Scene::of(&[&put(a), &put(b)])
}

fn nothing<const D: usize>(contact: &ContactForces<D>) {
    assert_eq!((contact.volume, size_sum(&contact.forces)), (0.0, 0.0));
}

/// The small body lies within the ball of radius 0.3 about the centre, the large one contains it: a polyhedron of 20
/// triangles with corners at 0.75 or more has its faces at 0.79·0.75 or less far only where they are steep.
fn nested<const D: usize>(seed: u64, size: f64)
where
    Mesh<D>: Random,
{
    let (outer, inner) = (Mesh::<D>::random(seed), Mesh::<D>::random(seed + 1).scaled(0.15));
    let scene = scene(&outer, &inner, seed, size);
    let volume = inner.measure() * size.powi(D as i32);
    // Coordinates of 4 are rounded, the small body is 0.3 wide.
    let contact = scene.evaluate(exact());
    assert!((contact.volume / volume - 1.0).abs() < 1e-12, "{} of {volume}", contact.volume);
    balanced(&contact, &scene.coords);
    assert!(contact.warnings.iter().any(|w| matches!(w, Warning::SwallowedBody { .. })));
    assert!(scene.nodes_of(0).all(|node| contact.forces[node] == [0.0; D]));
    // Some 20 lines of a family across it, each off by half a spacing at its ends.
    let sampled = scene.evaluate(lines(0.01 * size, seed));
    assert!((sampled.volume / volume - 1.0).abs() < 0.05);
}

fn separate<const D: usize>(seed: u64, size: f64)
where
    Mesh<D>: Random,
{
    let r = random_rotation::<D>(seed + 5);
    let (a, b) = (Mesh::<D>::random(seed), Mesh::<D>::random(seed + 1));
    // Radii of at most 1.4 each.
    let scene = scene(&a, &b.translated(std::array::from_fn(|i| 2.85 * r[i][0])), seed, size);
    nothing(&scene.evaluate(exact()));
    nothing(&scene.evaluate(lines(0.05 * size, seed)));
}

/// A low pyramid on one of the facets, on corners with the same coordinates.
fn touching<const D: usize>(seed: u64, size: f64)
where
    Mesh<D>: Random,
{
    let a = Mesh::<D>::random(seed);
    let faces = a.boundary_faces();
    let base: Vec<[f64; D]> = faces[seed as usize % faces.len()].iter().map(|&n| a.coords[n as usize]).collect();
    // Bodies are star-shaped about the origin: a hundredth farther out than the middle of the facet is outside.
    let apex = std::array::from_fn(|i| 1.01 * base.iter().map(|x| x[i]).sum::<f64>() / D as f64);
    let mut coords = base;
    coords.push(apex);
    // In whichever orientation.
    let pyramid = Mesh { coords, conn: (0..=D as u32).collect(), nodes_per_cell: D + 1 };
    let scene = scene(&a, &pyramid, seed, size);
    nothing(&scene.evaluate(exact()));
    nothing(&scene.evaluate(lines(0.02 * size, seed)));
    nothing(&scene.evaluate(consistent_lines(0.02 * size, seed)));
}

fn identical<const D: usize>(seed: u64, size: f64)
where
    Mesh<D>: Random,
{
    let a = Mesh::<D>::random(seed);
    let scene = scene(&a, &a, seed, size);
    let volume = a.measure() * size.powi(D as i32);
    for (options, tolerance) in [(exact(), 1e-12), (lines(0.04 * size, seed), 0.03)] {
        let contact = scene.evaluate(options);
        assert!((contact.volume / volume - 1.0).abs() < tolerance, "{} of {volume}", contact.volume);
        balanced(&contact, &scene.coords);
        // Each facet is shared half and half: both bodies feel the same.
        let n = a.coords.len();
        let sizes = size_sum(&contact.forces);
        assert!(sizes > 0.0);
        for node in 0..n {
            let (f, g) = (contact.forces[node], contact.forces[n + node]);
            assert!((0..D).all(|i| (f[i] - g[i]).abs() < 1e-12 * sizes), "node {node}: {f:?} and {g:?}");
        }
    }
}

/// Blocks whose sides lie in one plane, `depth` deep in each other along the last axis.
fn coplanar<const D: usize>(lower: &Mesh<D>, upper: &Mesh<D>, depth: f64, seed: u64, size: f64) {
    let scene = scene(
        lower,
        &upper.clone().translated(std::array::from_fn(|i| if i == D - 1 { 1.0 - depth } else { 0.0 })),
        seed,
        size,
    );
    let r = random_rotation::<D>(seed);
    let contact = scene.evaluate(exact());
    let scale = size.powi(D as i32);
    // Coordinates of 4 are rounded to 4e-16, on a face of 1.
    assert!((contact.volume / scale - depth).abs() < 1e-14, "{} of {depth}", contact.volume / scale);
    balanced(&contact, &scene.coords);
    let along: f64 = (0..D).map(|i| contact.bodies[1].force[i] * r[i][D - 1]).sum::<f64>() / scale * size;
    assert!((along - 1.0).abs() < 1e-12, "{along}");
    let sampled = scene.evaluate(lines(0.02 * size, seed));
    balanced(&sampled, &scene.coords);
    // 50 lines of a family across the face (2D). A family that runs along a thin overlap hits it seldom and then over its
    // whole length; the standard error says so.
    let tolerance = 0.05 * depth.max(0.02) + 3.0 * sampled.standard_error / scale;
    assert!((sampled.volume / scale - depth).abs() < tolerance, "{} of {depth}", sampled.volume / scale);
}

fn size() -> impl Strategy<Value = f64> {
    (-6i32..=6).prop_map(|power| 10f64.powi(power))
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn nested_bodies_keep_the_smaller_volume(seed in 0u64..1 << 40, size in size()) {
        nested::<2>(seed, size);
        nested::<3>(seed, size);
    }

    #[test]
    fn separate_bodies_feel_nothing(seed in 0u64..1 << 40, size in size()) {
        separate::<2>(seed, size);
        separate::<3>(seed, size);
    }

    #[test]
    fn touching_bodies_feel_nothing(seed in 0u64..1 << 40, size in size()) {
        touching::<2>(seed, size);
        touching::<3>(seed, size);
    }

    #[test]
    fn identical_bodies_keep_their_volume(seed in 0u64..1 << 40, size in size()) {
        identical::<2>(seed, size);
        identical::<3>(seed, size);
    }

    #[test]
    fn coplanar_blocks_push_across_their_overlap(
        seed in 0u64..1 << 40, size in size(), depth in 0.001..0.5, n in 1usize..5, m in 1usize..5
    ) {
        let square = |n| rectangle_tri3([0.0; 2], [1.0; 2], [n, n], Diagonals::Alternating);
        coplanar(&square(n), &square(m), depth, seed, size);
        let cube = |n: usize| cuboid_tet4([0.0; 3], [1.0; 3], [n; 3]);
        coplanar(&cube(n.min(3)), &cube(m.min(3)), depth, seed, size);
    }
}
