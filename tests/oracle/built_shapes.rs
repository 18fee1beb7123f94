//! Convex hulls, height fields and compounds: against closed forms, and against the same body as another shape.

use crate::scene::{Scene, distance, exact, lines, norm};
use fmc_contact::overlap::Overlap;
use fmc_contact::{Contact, ContactForces, Error, HeightField, Obstacle, Options, Pose, Shape};
use fmc_shapes::{Diagonals, Mesh, cuboid_tet4, random_polygon, random_polyhedron, random_rotation, rectangle_tri3};
use std::f64::consts::PI;

fn contact<const D: usize>(
    body: &Mesh<D>,
    shape: &Shape<D>,
    pose: Pose<D>,
    options: Options,
) -> (Contact<D>, Vec<[f64; D]>) {
    let scene = Scene::of(&[body]);
    let mut contact: Contact<D> = scene.contact(options);
    contact.add_obstacle(Obstacle { shape: shape.clone(), pose }).unwrap();
    (contact, scene.coords)
}

fn forces<const D: usize>(body: &Mesh<D>, shape: &Shape<D>, pose: Pose<D>, options: Options) -> ContactForces<D> {
    let (contact, coords) = contact(body, shape, pose, options);
    contact.evaluate(&coords).unwrap()
}

fn overlap<const D: usize>(body: &Mesh<D>, shape: &Shape<D>, pose: Pose<D>, options: Options) -> Overlap<D> {
    let (contact, coords) = contact(body, shape, pose, options);
    contact.overlaps(&coords).unwrap().remove(0)
}

fn pose<const D: usize>(seed: u64, scale: f64) -> Pose<D> {
    Pose { position: std::array::from_fn(|i| 0.3 - 0.2 * i as f64), rotation: random_rotation(seed), scale }
}

/// The same body as two shapes that are met as facets, or in closed form: volume, forces and the reaction.
fn alike<const D: usize>(body: &Mesh<D>, shapes: [&Shape<D>; 2], pose: Pose<D>, options: Options, tolerance: f64) {
    nearly_alike(body, shapes, pose, options, [tolerance; 2]);
}

/// The same with tolerances of the volume and of the forces.
fn nearly_alike<const D: usize>(
    body: &Mesh<D>,
    shapes: [&Shape<D>; 2],
    pose: Pose<D>,
    options: Options,
    [tolerance, of_forces]: [f64; 2],
) {
    let [found, expected] = shapes.map(|shape| forces(body, shape, pose, options));
    assert!(expected.volume > 1e-3);
    assert!((found.volume / expected.volume - 1.0).abs() < tolerance, "{shapes:?}: {} volume", found.volume);
    // Where one body holds the other, the forces cancel.
    let size = norm(&expected.forces).max(expected.contact_area);
    let off = distance(&found.forces, &expected.forces) / size;
    assert!(off < of_forces, "{shapes:?}: forces off by {off:e}");
    let [x, y] = [&found, &expected].map(|contact| [contact.obstacles[0].force]);
    assert!(distance(&x, &y) < 10.0 * of_forces * size, "{shapes:?}: reaction {x:?}, not {y:?}");
}

/// Points of a grid in a box: corners, some on its edges and faces, some inside.
fn points_of_box<const D: usize>(half: &[f64; D]) -> Vec<[f64; D]> {
    (0..5usize.pow(D as u32))
        .map(|n| std::array::from_fn(|i| half[i] * ((n / 5usize.pow(i as u32)) % 5) as f64 / 2.0 - half[i]))
        .collect()
}

#[test]
fn hull_of_a_box_is_the_box() {
    for seed in 0..3 {
        let half_extents = [0.5, 0.8];
        let hull = Shape::ConvexHull { points: points_of_box(&half_extents) };
        let body = random_polygon(9, 1.0, 0.5, seed);
        alike(&body, [&hull, &Shape::Cuboid { half_extents }], pose(seed, 0.8), exact(), 1e-12);
        alike(&body, [&hull, &Shape::Cuboid { half_extents }], pose(seed, 0.8), lines(0.01, seed), 1e-9);
        let half_extents = [0.5, 0.8, 0.4];
        let hull = Shape::ConvexHull { points: points_of_box(&half_extents) };
        let body = random_polyhedron(1, 1.0, 0.3, 1, seed);
        alike(&body, [&hull, &Shape::Cuboid { half_extents }], pose(seed, 1.2), exact(), 1e-11);
        alike(&body, [&hull, &Shape::Cuboid { half_extents }], pose(seed, 1.2), lines(0.05, seed), 1e-9);
    }
}

/// Points on a sphere of radius 1, by the golden angle: all are corners of their hull.
fn on_sphere(count: usize) -> Vec<[f64; 3]> {
    let at = |n: usize| {
        let z = 1.0 - (2 * n + 1) as f64 / count as f64;
        let (s, c) = (2.399_963_229_728_653 * n as f64).sin_cos();
        let r = (1.0 - z * z).sqrt();
        [r * c, r * s, z]
    };
    (0..count).map(at).collect()
}

#[test]
fn hull_of_a_sphere_of_points_nears_the_ball() {
    let block = cuboid_tet4([-2.0; 3], [2.0; 3], [1; 3]);
    let mut last = 1.0;
    for count in [100, 400, 1600] {
        let hull = Shape::ConvexHull { points: on_sphere(count) };
        // Far from the origin the hull is found on fewer digits.
        for scale in [1.0f64, 1e-6] {
            let volume = overlap(&block, &hull, Pose::at([0.1; 3]).scaled(scale), exact()).volume / scale.powi(3);
            let missing = 1.0 - volume / (4.0 / 3.0 * PI);
            assert!(missing > 0.0 && missing < last / 3.0, "{count} points: {missing}");
            last = if scale < 1.0 { missing } else { last };
        }
    }
    assert!(last < 0.01);
}

#[test]
fn flat_height_field_is_a_slab() {
    for seed in 0..3 {
        let (counts, lengths) = (vec![6], vec![1.6]);
        let field = HeightField { counts, lengths, heights: vec![0.4; 6], thickness: 0.8 };
        let body = random_polygon(9, 1.0, 0.5, seed);
        let slab = Shape::Cuboid { half_extents: [0.8, 0.4] };
        alike(&body, [&Shape::HeightField(field), &slab], pose(seed, 0.8), exact(), 1e-12);
        let (counts, lengths) = (vec![4, 3], vec![1.0, 1.6]);
        let field = Shape::HeightField(HeightField { counts, lengths, heights: vec![0.4; 12], thickness: 0.8 });
        let body = random_polyhedron(1, 1.0, 0.3, 1, seed);
        let slab = Shape::Cuboid { half_extents: [0.5, 0.8, 0.4] };
        alike(&body, [&field, &slab], pose(seed, 1.2), exact(), 1e-11);
        alike(&body, [&field, &slab], pose(seed, 1.2), lines(0.05, seed), 1e-9);
    }
}

/// Columns under the surface: trapezia in 2D; in 3D two prisms a cell, each as high as its three corners on average.
#[test]
fn volume_below_hills() {
    let height = |n: usize| 0.3 + 0.2 * (1.7 * n as f64).sin();
    let block = rectangle_tri3([-2.0; 2], [2.0; 2], [3, 3], Diagonals::Same);
    let heights: Vec<f64> = (0..5).map(height).collect();
    let lowest = heights.iter().copied().fold(f64::INFINITY, f64::min);
    let columns: f64 = heights.windows(2).map(|h| 0.5 * (h[0] + h[1]) - lowest + 0.1).sum();
    let field = HeightField { counts: vec![5], lengths: vec![2.0], heights, thickness: 0.1 };
    let found = overlap(&block, &Shape::HeightField(field), pose(1, 0.9), exact()).volume;
    assert!((found / (0.5 * columns * 0.81) - 1.0).abs() < 1e-12);

    let block = cuboid_tet4([-2.0; 3], [2.0; 3], [1; 3]);
    let heights: Vec<f64> = (0..12).map(height).collect();
    let lowest = heights.iter().copied().fold(f64::INFINITY, f64::min);
    let at = |i: usize, j: usize| heights[4 * i + j] - lowest + 0.1;
    let prism = |a: f64, b: f64, c: f64| (a + b + c) / 6.0;
    let cells = (0..2).flat_map(|i| (0..3).map(move |j| (i, j)));
    let columns: f64 = cells
        .map(|(i, j)| {
            let (p, q, r, s) = (at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
            prism(p, q, r) + prism(p, r, s)
        })
        .sum();
    let field = HeightField { counts: vec![3, 4], lengths: vec![1.0, 2.1], heights, thickness: 0.1 };
    let found = overlap(&block, &Shape::HeightField(field), pose(1, 0.9), exact()).volume;
    let expected = columns * 0.5 * 0.7 * 0.9f64.powi(3);
    assert!((found / expected - 1.0).abs() < 1e-11, "{found} instead of {expected}");
}

/// One part is the part: parry's point queries against chords in closed form, and against facets.
fn one_part<const D: usize>(body: &Mesh<D>, shapes: &[Shape<D>], spacing: f64) {
    for (seed, shape) in shapes.iter().enumerate() {
        let part = Obstacle { shape: shape.clone(), pose: Pose::default() };
        let nested = Obstacle { shape: Shape::Compound { parts: vec![part] }, pose: Pose::default() };
        let compound = Shape::Compound { parts: vec![nested] };
        // Marching may step over chords shorter than a part of the spacing, at corners and edges, as for every distance.
        let tolerances = [1e-4, 0.025 * spacing];
        nearly_alike(body, [&compound, shape], pose(seed as u64, 0.8), lines(spacing, seed as u64), tolerances);
    }
}

#[test]
fn compound_of_one_part_is_the_part() {
    let (radius, half_height) = (0.5, 0.6);
    let field = |counts: Vec<usize>, lengths: Vec<f64>| {
        let heights = (0..counts.iter().product()).map(|n: usize| 0.2 * (1.7 * n as f64).sin()).collect();
        HeightField { counts, lengths, heights, thickness: 0.3 }
    };
    let shapes = [
        Shape::HalfSpace,
        Shape::Ball { radius },
        Shape::Cuboid { half_extents: [0.5, 0.7] },
        Shape::Cylinder { radius, half_height },
        Shape::Cone { radius, half_height },
        Shape::Capsule { radius, half_height },
        Shape::ConvexHull { points: vec![[-0.5, -0.4], [0.7, -0.3], [0.1, 0.6]] },
        Shape::HeightField(field(vec![5], vec![1.4])),
    ];
    one_part(&random_polygon(9, 1.0, 0.5, 3), &shapes, 0.01);
    let shapes = [
        Shape::HalfSpace,
        Shape::Ball { radius },
        Shape::Cuboid { half_extents: [0.5, 0.7, 0.6] },
        Shape::Cylinder { radius, half_height },
        Shape::Cone { radius, half_height },
        Shape::Capsule { radius, half_height },
        Shape::ConvexHull { points: on_sphere(30) },
        Shape::HeightField(field(vec![4, 3], vec![1.1, 1.4])),
    ];
    one_part(&random_polyhedron(1, 1.0, 0.3, 1, 3), &shapes, 0.05);
}

/// Two balls of radius R whose centres are 2c apart: the volume of both less the lens that they share, which is two caps of
/// height h = R − c. A plane through both centres halves it, and the force is the section: two discs less their lens.
#[test]
fn compound_of_two_balls() {
    let (radius, c) = (0.7f64, 0.4f64);
    let parts = |axis: usize| -> Shape<3> {
        let at = |sign: f64| {
            let mut position = [0.0; 3];
            position[axis] = sign * c;
            Obstacle { shape: Shape::Ball { radius }, pose: Pose::at(position) }
        };
        Shape::Compound { parts: vec![at(-1.0), at(1.0)] }
    };
    let h = radius - c;
    let cap = PI * h * h * (3.0 * radius - h) / 3.0;
    let volume = 8.0 / 3.0 * PI * radius.powi(3) - 2.0 * cap;
    let segment = radius * radius * (c / radius).acos() - c * (radius * radius - c * c).sqrt();
    let section = 2.0 * PI * radius * radius - 2.0 * segment;
    let block = cuboid_tet4([-2.0, -2.0, -3.0], [2.0, 2.0, 0.0], [3; 3]);
    for (seed, depth, part) in [(1, -1.5, 1.0), (2, -1.5, 1.0), (1, 0.0, 0.5), (2, 0.0, 0.5)] {
        let found = overlap(&block, &parts(seed as usize % 2), Pose::at([0.2, -0.1, depth]), lines(0.03, seed));
        // As for a ball alone: lines some 40² per family, an end off by half a spacing at random.
        assert!((found.volume / (part * volume) - 1.0).abs() < 4e-3, "{} of {}", found.volume, part * volume);
        let force = found.pose_gradient.unwrap().position;
        let expected = if part < 1.0 { section } else { 0.0 };
        assert!((-force[2] - expected).abs() < 1.5e-2 * section, "{force} instead of {expected}");
    }
}

#[test]
fn what_cannot_be_built_says_why() {
    let add = |shape: Shape<3>| {
        let scene = Scene::of(&[&cuboid_tet4([0.0; 3], [1.0; 3], [1; 3])]);
        let mut contact: Contact<3> = scene.contact(exact());
        contact.add_obstacle(Obstacle { shape, pose: Pose::default() }).err()
    };
    let hull = |points: Vec<[f64; 3]>| add(Shape::ConvexHull { points });
    assert_eq!(hull(vec![]), Some(Error::DegenerateHull { point_count: 0 }));
    assert_eq!(hull(vec![[1.0; 3]; 9]), Some(Error::DegenerateHull { point_count: 9 }));
    let flat: Vec<[f64; 3]> = (0..20).map(|n| [n as f64, (n * n % 7) as f64, n as f64 * 0.3]).collect();
    assert_eq!(hull(flat), Some(Error::DegenerateHull { point_count: 20 }));
    assert_eq!(hull(vec![[0.0, f64::NAN, 0.0]]), Some(Error::NonFiniteCoordinate { node: 0, axis: 1 }));

    let field = HeightField { counts: vec![2, 2], lengths: vec![1.0; 2], heights: vec![0.0; 4], thickness: 1.0 };
    let with = |change: &dyn Fn(&mut HeightField)| {
        let mut changed = field.clone();
        change(&mut changed);
        add(Shape::HeightField(changed))
    };
    assert_eq!(with(&|_| ()), None);
    let few = Error::TooFewHeights { axis: 1, count: 1 };
    assert_eq!(with(&|f| (f.counts, f.heights) = (vec![2, 1], vec![0.0; 2])), Some(few));
    assert_eq!(with(&|f| f.heights[3] = f64::NAN), Some(Error::NonFiniteHeight { point: 3 }));
    assert_eq!(with(&|f| f.thickness = 0.0), Some(Error::NotPositive { name: "thickness", value: 0.0 }));
    assert_eq!(with(&|f| f.lengths[0] = -1.0), Some(Error::NotPositive { name: "length", value: -1.0 }));
    let length = |array, found| Error::Length { array, expected: if array == "heights" { 4 } else { 2 }, found };
    assert_eq!(with(&|f| f.heights.push(0.0)), Some(length("heights", 5)));
    assert_eq!(with(&|f| f.counts = vec![4]), Some(length("counts", 1)));

    assert_eq!(add(Shape::Compound { parts: vec![] }), Some(Error::EmptyCompound));
    let part = |shape, pose| add(Shape::Compound { parts: vec![Obstacle { shape, pose }] });
    let bad = Pose::default().scaled(0.0);
    assert_eq!(part(Shape::HalfSpace, bad), Some(Error::BadPose { obstacle: 0 }));
    let ball = Shape::Ball { radius: -1.0 };
    assert_eq!(part(ball, Pose::default()), Some(Error::NotPositive { name: "radius", value: -1.0 }));
}
