//! Rows of the obstacles' rotations in the tangent, against differences of forces and moments as an obstacle turns.

use crate::scene::table::exactly;
use crate::scene::{Scene, cross, norm};
use fmc_contact::contact::{Friction, TangentPart};
use fmc_contact::{Contact, EnergyLaw, Error, Obstacle, Options, Pose, Shape};
use fmc_shapes::{Mesh, Splitmix, cuboid_hex8, random_polygon, random_polyhedron, random_rotation, rectangle_quad4};

/// A pose turned about its position by a vector, in 2D by its first entry.
fn turned<const D: usize>(pose: &Pose<D>, by: &[f64; D]) -> Pose<D> {
    let turn: [[f64; D]; D] = if D == 2 {
        let (s, c) = by[0].sin_cos();
        std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                if i == j {
                    c
                } else if i < j {
                    -s
                } else {
                    s
                }
            })
        })
    } else {
        let angle = norm(&[*by]);
        let axis: [f64; 3] = std::array::from_fn(|i| by[i]);
        let turn = Pose::<3>::default().turned_about(axis, angle).rotation;
        std::array::from_fn(|i| std::array::from_fn(|j| turn[i][j]))
    };
    let apply = |x: [f64; D]| -> [f64; D] { std::array::from_fn(|i| (0..D).map(|j| turn[i][j] * x[j]).sum()) };
    let columns: [[f64; D]; D] = std::array::from_fn(|j| apply(std::array::from_fn(|i| pose.rotation[i][j])));
    let rotation = std::array::from_fn(|i| std::array::from_fn(|j| columns[j][i]));
    Pose { position: pose.position, rotation, scale: pose.scale }
}

/// Nodal forces, then those on the obstacles, then the moments about their positions.
fn all<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]]) -> Vec<[f64; D]> {
    let at = contact.evaluate(coords).unwrap();
    let mut forces = at.forces;
    forces.extend(at.obstacles.iter().map(|obstacle| obstacle.force));
    forces.extend(at.obstacles.iter().enumerate().map(|(o, obstacle)| {
        let of_force = cross(&contact.obstacle(o).unwrap().pose.position, &obstacle.force);
        let moment: [f64; 3] = std::array::from_fn(|i| obstacle.moment[i] - of_force[i]);
        std::array::from_fn(|i| if D == 3 { moment[i] } else { [moment[2], 0.0][i] })
    }));
    forces
}

fn check<const D: usize>(mesh: &Mesh<D>, shapes: [(Shape<D>, Pose<D>); 2], options: Options) {
    let scene = Scene::of(&[mesh]);
    let coords = &scene.coords;
    let mut contact = scene.contact(options);
    for (shape, pose) in &shapes {
        contact.add_obstacle(Obstacle { shape: shape.clone(), pose: *pose }).unwrap();
    }
    let without = contact.tangent(coords, TangentPart::Full).unwrap();
    contact.set_obstacle_rotations(true);
    let tangent = contact.tangent(coords, TangentPart::Full).unwrap();
    let (nodes, count) = (coords.len(), coords.len() + 4);
    // All else stays.
    assert!(without.blocks.iter().all(|block| tangent.blocks.contains(block)));
    let both = contact.evaluate_tangent(coords, TangentPart::Full).unwrap();
    assert_eq!(both, (contact.evaluate(coords).unwrap(), tangent.clone()));
    let here = all(&contact, coords);
    assert!(here[nodes..].iter().all(|f| norm(&[*f]) > 0.0), "both are met");
    let mut random = Splitmix::new(9);
    for _ in 0..3 {
        let mut direction: Vec<[f64; D]> =
            (0..count).map(|_| std::array::from_fn(|_| random.between(-1.0, 1.0))).collect();
        if D == 2 {
            direction[nodes + 2..].iter_mut().for_each(|turn| turn[1] = 0.0);
        }
        let mut at = |h: f64| {
            let along = |x: &[f64; D], d: &[f64; D]| -> [f64; D] { std::array::from_fn(|i| x[i] + h * d[i]) };
            let moved: Vec<[f64; D]> = coords.iter().zip(&direction).map(|(x, d)| along(x, d)).collect();
            for (o, (_, pose)) in shapes.iter().enumerate() {
                let mut pose = turned(pose, &direction[nodes + 2 + o].map(|turn| h * turn));
                pose.position = along(&pose.position, &direction[nodes + o]);
                contact.set_pose(o, pose).unwrap();
            }
            all(&contact, &moved)
        };
        let h = 1e-6;
        let (plus, minus) = (at(h), at(-h));
        let mut product = tangent.product(&direction);
        // The second derivative is symmetric; the moment turns along, by half.
        for o in 0..2 {
            let (moment, turn) = (here[nodes + 2 + o], direction[nodes + 2 + o]);
            if D == 3 {
                for i in 0..3 {
                    let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                    product[nodes + 2 + o][i] += 0.5 * (moment[j] * turn[k] - moment[k] * turn[j]);
                }
            }
        }
        let largest = product.iter().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
        for (n, product) in product.iter().enumerate() {
            for i in 0..D {
                let slope = (minus[n][i] - plus[n][i]) / (2.0 * h);
                assert!((slope - product[i]).abs() < 1e-6 * largest, "{n} of {nodes}, {i}: {slope} {}", product[i]);
            }
        }
    }
    shapes.iter().enumerate().for_each(|(o, (_, pose))| contact.set_pose(o, *pose).unwrap());
    let semidefinite = contact.tangent(coords, TangentPart::Semidefinite).unwrap();
    let mut matrix = nalgebra::DMatrix::<f64>::zeros(count * D, count * D);
    semidefinite.triplets().for_each(|(row, col, value)| matrix[(row, col)] += value);
    assert!((&matrix - matrix.transpose()).amax() <= 1e-12 * matrix.amax());
    let eigenvalues = matrix.symmetric_eigenvalues();
    assert!(eigenvalues.min() >= -1e-12 * eigenvalues.max().max(1e-9), "{}", eigenvalues.min());
}

fn laws() -> [Options; 2] {
    [exactly(EnergyLaw::depth(3.0)), exactly(EnergyLaw::Volume { stiffness: 3.0, exponent: 2.0 })]
}

#[test]
fn in_the_plane() {
    let mesh = random_polygon(9, 0.8, 0.3, 1).translated([0.3, 0.9]);
    for options in laws() {
        let plane = (Shape::HalfSpace, Pose::at([0.1, 0.45]).turned(0.2));
        let block = Shape::Cuboid { half_extents: [0.5, 0.4] };
        check(&mesh, [plane, (block, Pose::at([1.2, 1.2]).turned(0.4).scaled(1.1))], options);
    }
}

#[test]
fn in_space() {
    let mesh = random_polyhedron(0, 0.8, 0.3, 2, 2).translated([0.3, -0.2, 0.9]);
    for options in laws() {
        let pose = Pose { rotation: random_rotation(5), ..Pose::at([1.3, -0.1, 1.2]) };
        let plane = (Shape::HalfSpace, Pose::at([0.1, 0.0, 0.45]).turned_about([1.0, 2.0, 0.5], 0.2));
        check(&mesh, [plane, (Shape::Cuboid { half_extents: [0.6, 0.5, 0.4] }, pose)], options);
    }
}

/// The part of friction in the tangent, against differences: of a block that sticks to a plane, or slides on it, as both move and the
/// plane turns. What the tangent leaves out is of the size of the penetration by that of the facets.
fn rubs<const D: usize>(mesh: &Mesh<D>, plane: Pose<D>, along: [f64; D], depth: f64) {
    let scene = Scene::of(&[mesh]);
    let most = 0.5 * depth / 0.3 * 4.0;
    for by in [0.1 * depth, 2.0 * depth] {
        let options = exactly(EnergyLaw::depth(1e3));
        let [mut rough, mut smooth] = [Friction::coulomb(0.3), Friction::default()]
            .map(|friction| scene.contact(Options { friction, ..options }));
        let start = scene.coords.clone();
        let coords: Vec<[f64; D]> = start.iter().map(|x| std::array::from_fn(|i| x[i] + by * along[i])).collect();
        for contact in [&mut rough, &mut smooth] {
            contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose: plane }).unwrap();
            contact.begin_step(&start).unwrap();
            contact.set_obstacle_rotations(true);
        }
        let mut random = Splitmix::new(3);
        let [with, without] = [&rough, &smooth].map(|contact| contact.tangent(&coords, TangentPart::Full).unwrap());
        let symmetric = rough.tangent(&coords, TangentPart::Semidefinite).unwrap();
        let nodes = coords.len();
        let mut largest = (0.0f64, 0.0f64);
        for turns in [true, true, false] {
            let mut direction: Vec<[f64; D]> =
                (0..nodes + 2).map(|_| std::array::from_fn(|_| random.between(-1.0, 1.0))).collect();
            if turns {
                direction[..=nodes].iter_mut().for_each(|x| *x = [0.0; D]);
            }
            if D == 2 {
                direction[nodes + 1][1] = 0.0;
            }
            let mut at = |h: f64| {
                let moved = |x: &[f64; D], d: &[f64; D]| -> [f64; D] { std::array::from_fn(|i| x[i] + h * d[i]) };
                let here: Vec<[f64; D]> = coords.iter().zip(&direction).map(|(x, d)| moved(x, d)).collect();
                let mut pose = turned(&plane, &direction[nodes + 1].map(|turn| h * turn));
                pose.position = moved(&pose.position, &direction[nodes]);
                let [one, other] = [&mut rough, &mut smooth].map(|contact| {
                    contact.set_pose(0, pose).unwrap();
                    let found = all(contact, &here);
                    contact.set_pose(0, plane).unwrap();
                    found
                });
                one.into_iter().flatten().zip(other.into_iter().flatten()).map(|(f, g)| f - g).collect::<Vec<f64>>()
            };
            let h = 1e-5 * depth;
            let (plus, minus) = (at(h), at(-h));
            let (p, q) = (with.product(&direction), without.product(&direction));
            for (n, (p, q)) in p.iter().flatten().zip(q.iter().flatten()).enumerate() {
                let slope = (minus[n] - plus[n]) / (2.0 * h);
                largest = (largest.0.max((slope - (p - q)).abs()), largest.1.max((p - q).abs()));
            }
        }
        println!("{D}D by {by}: {:.2e} of {most:.2e}", largest.0 / largest.1);
        assert!(largest.0 < most * largest.1, "{D}D by {by}: {} of {}", largest.0, largest.1);
        let mut matrix = nalgebra::DMatrix::<f64>::zeros((nodes + 2) * D, (nodes + 2) * D);
        symmetric.triplets().for_each(|(row, col, value)| matrix[(row, col)] += value);
        assert!((&matrix - matrix.transpose()).amax() <= 1e-12 * matrix.amax());
        let eigenvalues = matrix.symmetric_eigenvalues();
        assert!(eigenvalues.min() >= -1e-11 * eigenvalues.max(), "{}", eigenvalues.min());
    }
}

#[test]
fn with_friction() {
    let depth = 1e-3;
    let plane = Pose::at([0.3, 0.1]).turned(0.2);
    let (s, c) = 0.2f64.sin_cos();
    let block = rectangle_quad4([0.0, 0.0], [0.9, 0.6], [3, 2]);
    let place = |[x, y]: [f64; 2]| [0.1 + c * x - s * (y - depth), c * (y - depth) + s * x + 0.1 - 0.2 * s / c];
    let block = Mesh { coords: block.coords.iter().map(|x| place(*x)).collect(), ..block };
    rubs(&block, plane, [c, s], depth);
    let plane = Pose::at([0.4, 0.3, 0.0]);
    rubs(&cuboid_hex8([0.0, 0.0, -depth], [0.9, 0.6, 0.6], [3, 2, 1]), plane, [0.8, 0.6, 0.0], depth);
}

#[test]
fn not_with_lines_nor_on_rings() {
    let mesh = rectangle_quad4([1.0, -0.1], [2.0, 1.0], [2, 2]);
    let plane = || Obstacle { shape: Shape::HalfSpace, pose: Pose::default() };
    let law = exactly(EnergyLaw::depth(1.0));
    let scene = Scene::of(&[&mesh]);
    let mut rings = scene.contact(Options { axisymmetric: true, ..law });
    rings.add_obstacle(plane()).unwrap();
    let without = rings.tangent(&scene.coords, TangentPart::Full).unwrap();
    rings.set_obstacle_rotations(true);
    assert_eq!(rings.tangent(&scene.coords, TangentPart::Full).unwrap(), without);
    let mut rubbed = scene.contact(Options { friction: Friction::coulomb(0.3), ..law });
    rubbed.add_obstacle(plane()).unwrap();
    rubbed.begin_step(&scene.coords).unwrap();
    rubbed.set_obstacle_rotations(true);
    assert!(rubbed.tangent(&scene.coords, TangentPart::Full).is_ok());
    let mut by_lines = scene.contact(exactly(EnergyLaw::fiber(1.0)));
    by_lines.add_obstacle(plane()).unwrap();
    by_lines.set_obstacle_rotations(true);
    let refused = by_lines.evaluate_tangent(&scene.coords, TangentPart::Full);
    assert!(matches!(refused, Err(Error::Unsupported { what }) if what.contains("with the law fiber")));
    let masses = vec![1.0; scene.coords.len()];
    assert!(rubbed.stable_step(&scene.coords, &masses).unwrap() > 0.0);
    let cube = cuboid_hex8([0.0; 3], [1.0; 3], [1; 3]);
    let mut free = Scene::of(&[&cube]).contact(law);
    free.set_obstacle_rotations(true);
    assert!(free.tangent(&cube.coords, TangentPart::Full).unwrap().blocks.is_empty());
}
