//! Rigid obstacles with flat sides, whose integrals are exact: closed forms, derivatives, balance, scans.

use crate::depth;
use crate::scene::{Scene, cross, norm, size_sum};
use fmc_contact::contact::TangentPart;
use fmc_contact::{Contact, ContactForces, Estimator, FiberOptions, FiberPattern, Obstacle, Options, Pose, Shape};
use fmc_shapes::{
    Diagonals, Mesh, Splitmix, cuboid_hex8, cuboid_surface, cuboid_tet4, icosphere, random_rotation, rectangle_quad4,
    rectangle_tri3, regular_polygon,
};

/// A mesh against an obstacle.
pub(crate) fn against<const D: usize>(
    mesh: &Mesh<D>,
    shape: &Shape<D>,
    pose: Pose<D>,
    k: f64,
) -> (Scene<D>, Contact<D>) {
    let scene = Scene::of(&[mesh]);
    let mut contact = scene.contact(depth(k));
    contact.add_obstacle(Obstacle { shape: shape.clone(), pose }).expect("a valid obstacle");
    (scene, contact)
}

pub(crate) fn found<const D: usize>(mesh: &Mesh<D>, shape: &Shape<D>, pose: Pose<D>) -> ContactForces<D> {
    let (scene, contact) = against(mesh, shape, pose, 1.0);
    contact.evaluate(&scene.coords).expect("valid coordinates")
}

fn close(what: &str, found: f64, expected: f64) {
    assert!((found - expected).abs() < 1e-11 * expected.abs().max(1e-3), "{what}: {found} instead of {expected}");
}

fn blocks_2d(min: [f64; 2], max: [f64; 2]) -> [Mesh<2>; 3] {
    let tri = rectangle_tri3(min, max, [4, 3], Diagonals::Alternating);
    [tri.boundary(), tri, rectangle_quad4(min, max, [5, 2])]
}

fn blocks_3d(min: [f64; 3], max: [f64; 3]) -> [Mesh<3>; 3] {
    [cuboid_surface(min, max, [3, 2, 2]), cuboid_tet4(min, max, [3, 2, 2]), cuboid_hex8(min, max, [2, 3, 2])]
}

/// δ²/2 by area, however thin; neither the scale of a half-space nor where its origin lies matters.
#[test]
fn half_spaces() {
    for delta in [1e-6, 0.03, 0.4] {
        for mesh in blocks_2d([0.0, -delta], [1.0, 1.0 - delta]) {
            let at = found(&mesh, &Shape::HalfSpace, Pose::at([7.0, 0.0]).scaled(0.1));
            close("energy", at.energy / delta.powi(2), 0.5);
            close("force", at.bodies[0].force[1] / delta, 1.0);
            close("penetration", at.penetration / delta, 1.0);
            close("volume", at.volume / delta, 1.0);
            close("sideways", at.bodies[0].force[0] / delta, 0.0);
        }
        for mesh in blocks_3d([0.0, 0.0, -delta], [1.0, 0.5, 1.0 - delta]) {
            let at = found(&mesh, &Shape::HalfSpace, Pose::at([7.0, 0.0, 0.0]));
            close("energy", at.energy / delta.powi(2), 0.25);
            close("force", at.bodies[0].force[2] / delta, 0.5);
        }
        let tip = rectangle_tri3([-0.5; 2], [0.5; 2], [5, 5], Diagonals::Same).rotated(std::f64::consts::FRAC_PI_4);
        let at = found(&tip.translated([0.0, 0.5f64.sqrt() - delta]), &Shape::HalfSpace, Pose::default());
        // The height of the lowest corner is the difference of numbers of the size of 1.
        assert!((at.energy / delta.powi(3) - 1.0 / 3.0).abs() < 1e-14 / delta, "{}", at.energy / delta.powi(3));
    }
}

/// A block on the edge of a box: near the edge the depth is that below the side wall.
#[test]
fn boxes() {
    let delta = 0.1f64;
    let (energy, force) = (0.5 * delta * delta * (0.5 - delta) + delta.powi(3) / 3.0, 0.5 * (delta - delta * delta));
    let turn = Pose::at([3.0, 2.0]).turned(0.7).scaled(2.0);
    let into = |x: [f64; 2]| {
        let x = [2.0 * x[0], 2.0 * x[1]];
        let (s, c) = 0.7f64.sin_cos();
        [3.0 + c * x[0] - s * x[1], 2.0 + s * x[0] + c * x[1]]
    };
    let square = Shape::Cuboid { half_extents: [1.0, 1.0] };
    let hull = Shape::ConvexHull { points: vec![[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [0.2, 0.3], [1.0, -1.0]] };
    for shape in [&square, &hull] {
        for mesh in blocks_2d([0.5, 1.0 - delta], [1.5, 2.0]) {
            let at = found(&mesh, shape, Pose::default());
            close("energy", at.energy, energy);
            close("force", at.bodies[0].force[1], force);
            close("sideways", at.bodies[0].force[0], 0.5 * delta * delta);
            close("volume", at.volume, 0.5 * delta);
            let at = found(&mesh.clone().mapped(into), shape, turn);
            close("energy, scaled", at.energy, 8.0 * energy);
            close(
                "force, scaled",
                at.bodies[0].force[0].hypot(at.bodies[0].force[1]),
                4.0 * force.hypot(0.5 * delta * delta),
            );
        }
        // The box inside the body: a pyramid.
        for mesh in blocks_2d([-2.0, -3.0], [4.0, 2.0]) {
            let at = found(&mesh, shape, Pose::default());
            close("box in body", at.energy, 4.0 / 3.0);
            assert!(at.bodies[0].force.iter().all(|f| f.abs() < 1e-12));
        }
        // Through the box from below, up to half of the depth of its upper face: 1 − max(|x|, |y|) is summed.
        for mesh in blocks_2d([-0.3, -5.0], [0.3, 0.5]) {
            let at = found(&mesh, shape, Pose::default());
            close("from below", at.energy, 0.507);
            close("force from below", at.bodies[0].force[1], -0.3);
        }
        for mesh in blocks_2d([-2.0, -3.0], [0.0, 2.0]) {
            close("half of the box in the body", found(&mesh, shape, Pose::default()).energy, 2.0 / 3.0);
        }
    }
    let cube = Shape::Cuboid { half_extents: [1.0, 1.0, 1.0] };
    for mesh in blocks_3d([0.5, -0.3, 1.0 - delta], [1.5, 0.4, 2.0]) {
        let at = found(&mesh, &cube, Pose::default());
        close("energy", at.energy, 0.7 * energy);
        close("force", at.bodies[0].force[2], 0.7 * force);
    }
    for mesh in blocks_3d([-2.0, -3.0, -2.0], [4.0, 2.0, 2.0]) {
        close("box in body", found(&mesh, &cube, Pose::default()).energy, 2.0);
    }
    for mesh in blocks_3d([-2.0, -3.0, -2.0], [4.0, 2.0, 0.0]) {
        close("half of the box in the body", found(&mesh, &cube, Pose::default()).energy, 1.0);
    }
}

/// Differences of the energy against the force, and of the force against the tangent, each in parts of its size.
pub(crate) struct Deviations {
    pub(crate) force: f64,
    pub(crate) tangent: f64,
    pub(crate) balance: f64,
}

/// Differences of fourth order with these steps, the obstacle's translation among the unknowns.
pub(crate) fn deviations<const D: usize>(
    mesh: &Mesh<D>,
    shape: &Shape<D>,
    pose: Pose<D>,
    steps: [f64; 2],
) -> Deviations {
    let (scene, contact) = against(mesh, shape, pose, 30.0);
    deviations_of(&scene, contact, pose, steps)
}

/// The same of a contact with one obstacle, which stands there.
pub(crate) fn deviations_of<const D: usize>(
    scene: &Scene<D>,
    mut contact: Contact<D>,
    pose: Pose<D>,
    steps: [f64; 2],
) -> Deviations {
    let coords = &scene.coords;
    let mut random = Splitmix::new(5);
    let tangent = contact.tangent(coords, TangentPart::Full).expect("valid coordinates");
    let at = contact.evaluate(coords).expect("valid coordinates");
    assert!(at.energy > 0.0 && !at.obstacles.is_empty());
    let mut all = at.forces.clone();
    all.push(at.obstacles[0].force);
    let sizes = size_sum(&at.forces);
    let sum: [f64; D] = std::array::from_fn(|i| all.iter().map(|f| f[i]).sum());
    let moment: [f64; 3] = std::array::from_fn(|i| {
        coords.iter().zip(&at.forces).map(|(x, f)| cross(x, f)[i]).sum::<f64>() + at.obstacles[0].moment[i]
    });
    let mut found = Deviations { force: 0.0, tangent: 0.0, balance: norm(&[sum]).max(norm(&[moment])) / sizes };
    for _ in 0..3 {
        let direction: Vec<[f64; D]> =
            (0..=coords.len()).map(|_| std::array::from_fn(|_| random.between(-1.0, 1.0))).collect();
        let mut forces_at = |h: f64| {
            let moved: Vec<[f64; D]> =
                coords.iter().zip(&direction).map(|(x, d)| std::array::from_fn(|i| x[i] + h * d[i])).collect();
            let mut there = pose;
            (0..D).for_each(|i| there.position[i] += h * direction[coords.len()][i]);
            contact.set_pose(0, there).expect("a valid pose");
            let at = contact.evaluate(&moved).expect("valid coordinates");
            let mut all = at.forces;
            all.push(at.obstacles[0].force);
            (at.energy, all)
        };
        let product = tangent.product(&direction);
        let largest = product.iter().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
        let along: f64 = all.iter().flatten().zip(direction.iter().flatten()).map(|(f, d)| f * d).sum();
        let (mut force, mut stiffness) = (f64::INFINITY, f64::INFINITY);
        for h in steps {
            let at = [2.0 * h, h, -h, -2.0 * h].map(&mut forces_at);
            let slope = |f: [f64; 4]| (8.0 * (f[1] - f[2]) - (f[0] - f[3])) / (12.0 * h);
            force = force.min((slope(at.each_ref().map(|a| a.0)) + along).abs() / sizes);
            let error = (0..all.len()).flat_map(|n| (0..D).map(move |i| (n, i)));
            let error = error.map(|(n, i)| (slope(at.each_ref().map(|a| a.1[n][i])) + product[n][i]).abs());
            stiffness = stiffness.min(error.fold(0.0, f64::max) / largest);
        }
        found.force = found.force.max(force);
        found.tangent = found.tangent.max(stiffness);
    }
    contact.set_pose(0, pose).expect("a valid pose");
    let semidefinite = contact.tangent(coords, TangentPart::Semidefinite).expect("valid coordinates");
    let size = (coords.len() + 1) * D;
    let mut matrix = nalgebra::DMatrix::<f64>::zeros(size, size);
    semidefinite.triplets().for_each(|(row, col, value)| matrix[(row, col)] += value);
    assert!((&matrix - matrix.transpose()).amax() <= 1e-12 * matrix.amax());
    let eigenvalues = matrix.symmetric_eigenvalues();
    let (least, largest) = (eigenvalues.min(), eigenvalues.max());
    // It is none where all facets that move outwards rise from the depth.
    assert!(least >= -1e-12 * largest.max(1e-9), "{least:e} and {largest:e}");
    let both = contact.evaluate_tangent(coords, TangentPart::Full).expect("valid coordinates");
    assert_eq!(both, (contact.evaluate(coords).expect("valid coordinates"), tangent));
    found
}

/// Coordinates disturbed, so that no face is flush.
pub(crate) fn disturbed<const D: usize>(mesh: Mesh<D>, seed: u64) -> Mesh<D> {
    let mut random = Splitmix::new(seed);
    let mut mesh = mesh;
    mesh.coords.iter_mut().flatten().for_each(|x| *x += random.between(-0.02, 0.02));
    mesh
}

fn exact_derivatives<const D: usize>(meshes: impl IntoIterator<Item = Mesh<D>>, shapes: &[(Shape<D>, Pose<D>)]) {
    for (seed, mesh) in meshes.into_iter().enumerate() {
        let mesh = disturbed(mesh, seed as u64);
        for (shape, pose) in shapes {
            let found = deviations(&mesh, shape, *pose, [1e-5, 1e-6]);
            let Deviations { force, tangent, balance } = found;
            assert!(force < 1e-9 && tangent < 1e-6, "{shape:?}: {force:e}, {tangent:e}");
            assert!(balance < 1e-12, "{shape:?}: {balance:e}");
        }
    }
}

#[test]
fn derivatives_in_the_plane() {
    let polygon = regular_polygon(7, 0.5);
    let polytope = Shape::Polytope { points: polygon.coords.clone(), facets: polygon.facets() };
    let turned = |x: f64, z: f64, s: f64| Pose { position: [x, z], rotation: random_rotation(3), scale: s };
    let shapes = [
        (Shape::HalfSpace, turned(0.4, 0.3, 1.0)),
        (Shape::Cuboid { half_extents: [0.4, 0.3] }, turned(0.5, 0.1, 1.3)),
        (Shape::Cuboid { half_extents: [0.4, 0.3] }, turned(0.9, 0.6, 0.8)),
        (polytope, turned(0.9, 0.9, 1.1)),
    ];
    exact_derivatives(blocks_2d([0.0; 2], [1.0; 2]), &shapes);
}

#[test]
fn derivatives_in_space() {
    let ball = icosphere(0.5, 1);
    let polytope = Shape::Polytope { points: ball.coords.clone(), facets: ball.facets() };
    let turned = |x: f64, z: f64, s: f64| Pose { position: [x, 0.4, z], rotation: random_rotation(4), scale: s };
    let shapes = [
        (Shape::HalfSpace, turned(0.4, 0.3, 1.0)),
        (Shape::Cuboid { half_extents: [0.4, 0.3, 0.5] }, turned(0.5, 0.1, 1.3)),
        (Shape::Cuboid { half_extents: [0.4, 0.3, 0.3] }, turned(0.9, 0.6, 0.8)),
        (polytope, turned(0.9, 0.9, 1.1)),
    ];
    exact_derivatives(blocks_3d([0.0; 3], [1.0; 3]), &shapes);
}

/// A block led down past the side wall of a box, half sunk in it, and over its edge: the energy has no step.
#[test]
fn past_a_wall() {
    let cuboid = Shape::Cuboid { half_extents: [1.0, 1.0] };
    for mesh in blocks_2d([0.0; 2], [0.5; 2]) {
        let (scene, contact) = against(&mesh, &cuboid, Pose::default(), 1e3);
        let step = |positions: usize, place: &dyn Fn(f64) -> [f64; 2]| {
            let all: Vec<_> = (0..=positions)
                .map(|n| {
                    let shift = place(n as f64 / positions as f64);
                    let coords: Vec<[f64; 2]> =
                        scene.coords.iter().map(|x| [x[0] + shift[0], x[1] + shift[1]]).collect();
                    let at = contact.evaluate(&coords).expect("valid coordinates");
                    (at.energy, at.bodies[0].force, shift)
                })
                .collect();
            let largest = all.iter().fold(0.0f64, |m, a| m.max(a.0));
            let steps = all.windows(2).map(|pair| {
                let [(e, f, x), (e1, f1, x1)] = pair else { return 0.0 };
                (e1 - e + (0..2).map(|i| 0.5 * (f[i] + f1[i]) * (x1[i] - x[i])).sum::<f64>()).abs()
            });
            steps.fold(0.0, f64::max) / largest
        };
        let down: &dyn Fn(f64) -> [f64; 2] = &|s| [0.8, 1.1 - 1.8 * s];
        let over: &dyn Fn(f64) -> [f64; 2] = &|s| [0.3 + 0.9 * s, 0.9];
        for path in [down, over] {
            let (fine, coarse) = (step(400, path), step(100, path));
            assert!(fine < 5e-4 && fine <= 0.25 * coarse + 1e-10, "{fine:e} against {coarse:e}");
        }
    }
}

/// The law asks no estimator: the same bits between bodies and against an obstacle, on lines and isotropic segments too.
#[test]
fn estimators_have_no_part_in_it() {
    let blocks = [
        rectangle_tri3([0.0, 0.0], [1.0, 1.0], [4, 4], Diagonals::Same),
        rectangle_tri3([0.2, 0.95], [0.8, 1.5], [3, 3], Diagonals::Same),
    ];
    let scene = Scene::of(&[&blocks[0], &blocks[1]]);
    let of = |estimator: Estimator| {
        let mut contact = scene.contact(Options { estimator, ..depth(3.0) });
        let shape = Shape::Ball { radius: 0.5 };
        contact.add_obstacle(Obstacle { shape, pose: Pose::at([0.5, -0.4]) }).expect("an obstacle");
        contact.evaluate(&scene.coords).expect("valid coordinates")
    };
    let exact = of(Estimator::Exact);
    assert_eq!(exact.pairs.len(), 2);
    for pattern in [FiberPattern::Lines, FiberPattern::Isotropic { length: None }] {
        assert_eq!(of(Estimator::Fibers(FiberOptions { pattern, ..FiberOptions::default() })), exact);
    }
    assert_eq!(of(Estimator::default()), exact);
}
