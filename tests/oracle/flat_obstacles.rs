//! Obstacles with flat sides: the half-space against clipping written here, cuboid and polytope against the same shape as
//! a body of the mesh.

use crate::halfspaces::Convex;
use crate::scene::{Scene, consistent_lines, distance, exact, lines, norm};
use fmc_contact::{Contact, ContactForces, Obstacle, Options, Pose, Shape};
use fmc_shapes::{
    Diagonals, Mesh, cuboid_tet4, random_polygon, random_polyhedron, random_rotation, rectangle_tri3, regular_polygon,
};

fn against<const D: usize>(body: &Mesh<D>, shape: Shape<D>, pose: Pose<D>, options: Options) -> ContactForces<D> {
    let scene = Scene::of(&[body]);
    let mut contact: Contact<D> = scene.contact(options);
    contact.add_obstacle(Obstacle { shape, pose }).unwrap();
    contact.evaluate(&scene.coords).unwrap()
}

fn pose<const D: usize>(position: [f64; D], seed: u64, scale: f64) -> Pose<D> {
    Pose { position, rotation: random_rotation(seed), scale }
}

/// Random bodies over a tilted plane. Neither the scale nor where on the plane the origin lies matters.
fn half_space<const D: usize>(body: &Mesh<D>, seed: u64, spacing: f64, sampling: f64) {
    let r = random_rotation::<D>(seed);
    let n: [f64; D] = std::array::from_fn(|i| r[i][D - 1]);
    let level = 0.2;
    let position = std::array::from_fn(|i| level * n[i] + 5.0 * r[i][0]);
    let (volume, gradient) = Convex::half_space(n, level).bounded(body);
    for scale in [1.0, 0.01] {
        let pose = Pose { position, rotation: r, scale };
        let contact = against(body, Shape::HalfSpace, pose, exact());
        assert!((contact.volume / volume - 1.0).abs() < 1e-12, "{} instead of {volume}", contact.volume);
        let forces: Vec<[f64; D]> = contact.forces.iter().map(|f| f.map(|f| -f)).collect();
        assert!(distance(&forces, &gradient) < 1e-12 * norm(&gradient));
        let sampled = against(body, Shape::HalfSpace, pose, lines(spacing, seed));
        assert!((sampled.volume / volume - 1.0).abs() < sampling, "{} instead of {volume}", sampled.volume);
        assert!(distance(&sampled.forces, &contact.forces) < 5.0 * sampling * norm(&gradient));
        // It is pushed along its outward normal backwards.
        let along: f64 = (0..D).map(|i| contact.obstacles[0].force[i] * n[i]).sum();
        assert!((along + norm(&[contact.obstacles[0].force])).abs() < 1e-12 * along.abs());
    }
}

#[test]
fn half_space_under_random_bodies() {
    for seed in 0..6 {
        half_space(&random_polygon(9, 1.0, 0.5, seed), seed, 1e-3, 1e-3);
        half_space(&random_polyhedron(1, 1.0, 0.3, 1, seed), seed, 2e-2, 3e-3);
    }
}

#[test]
fn square_on_its_tip_in_a_half_space() {
    // Depth h of a right angle, its sides at 45°: h². Lines y = 0.
    let square = rectangle_tri3([-0.5; 2], [0.5; 2], [5, 5], Diagonals::Same).rotated(std::f64::consts::FRAC_PI_4);
    for h in [1e-6, 0.01, 0.3] {
        let body = square.clone().translated([0.7, 0.5f64.sqrt() - h]);
        let contact = against(&body, Shape::HalfSpace, Pose::at([3.0, 0.0]), exact());
        // h is the difference of coordinates of 1.
        assert!((contact.volume / (h * h) - 1.0).abs() < 1e-15 / h);
        assert!((contact.bodies[0].force[1] - 2.0 * h).abs() < 1e-14);
        assert!((contact.penetration - h).abs() < 1e-14);
        // The reaction acts at the middle of the line of intersection, at x = 0.7 (moment x·F_y).
        assert!((contact.obstacles[0].moment[2] + 0.7 * 2.0 * h).abs() < 1e-14);
    }
}

/// Body and obstacle, and body against the obstacle's shape as a mesh: the same forces on the body, and the reaction is
/// the resultant on that mesh.
fn like_a_body<const D: usize>(body: &Mesh<D>, shape: &Shape<D>, as_mesh: &Mesh<D>, pose: Pose<D>, spacing: f64) {
    let placed = as_mesh.clone().scaled(pose.scale).rotated_by(pose.rotation).translated(pose.position);
    // Balanced lines would see one node or many in the obstacle's place.
    for (options, tolerance) in [(exact(), 1e-12), (consistent_lines(spacing, 3), 1e-9)] {
        let mesh = Scene::of(&[body, &placed]).evaluate(options);
        let rigid = against(body, shape.clone(), pose, options);
        assert!(mesh.volume > 1e-3);
        assert!((rigid.volume / mesh.volume - 1.0).abs() < tolerance, "{} against {}", rigid.volume, mesh.volume);
        assert!((rigid.contact_area / mesh.contact_area - 1.0).abs() < tolerance);
        let (x, y) = (&rigid.forces[..], &mesh.forces[..body.coords.len()]);
        assert!(distance(x, y) < tolerance * norm(y), "{:e}", distance(x, y) / norm(y));
        let (reaction, resultant) = (&rigid.obstacles[0], &mesh.bodies[1]);
        assert!(distance(&[reaction.force], &[resultant.force]) < 10.0 * tolerance * norm(y));
        assert!(distance(&[reaction.moment], &[resultant.moment]) < 10.0 * tolerance * norm(y));
    }
}

#[test]
fn cuboids_are_like_bodies() {
    for seed in 0..4 {
        let scale = 0.7 + 0.2 * seed as f64;
        let body = random_polygon(9, 1.0, 0.5, seed);
        let square = rectangle_tri3([-0.5, -0.8], [0.5, 0.8], [3, 4], Diagonals::Same);
        let shape = Shape::Cuboid { half_extents: [0.5, 0.8] };
        like_a_body(&body, &shape, &square, pose([0.6, -0.3], seed, scale), 0.01);
        let body = random_polyhedron(1, 1.0, 0.3, 1, seed);
        let cube = cuboid_tet4([-0.5, -0.8, -0.4], [0.5, 0.8, 0.4], [2, 3, 1]);
        let shape = Shape::Cuboid { half_extents: [0.5, 0.8, 0.4] };
        like_a_body(&body, &shape, &cube, pose([0.6, -0.3, 0.4], seed, scale), 0.05);
    }
}

#[test]
fn polytopes_are_like_bodies() {
    for seed in 0..4 {
        let scale = 0.7 + 0.2 * seed as f64;
        let body = random_polygon(9, 1.0, 0.5, seed);
        let other = random_polygon(7, 0.8, 0.5, seed + 9);
        let surface = other.boundary();
        let shape = Shape::Polytope { facets: surface.facets(), points: surface.coords };
        like_a_body(&body, &shape, &other, pose([0.6, -0.3], seed, scale), 0.01);
        let body = random_polyhedron(1, 1.0, 0.3, 1, seed);
        let other = random_polyhedron(0, 0.8, 0.4, 1, seed + 9);
        let surface = other.boundary();
        let shape = Shape::Polytope { facets: surface.facets(), points: surface.coords };
        like_a_body(&body, &shape, &other, pose([0.6, -0.3, 0.4], seed, scale), 0.05);
    }
}

/// An obstacle around the body, with a hole in which the body sits.
#[test]
fn body_in_the_hole_of_a_polytope() {
    let (outer, hole) = (regular_polygon(24, 3.0), regular_polygon(24, 1.0));
    let first = outer.coords.len() as u32;
    let mut facets = outer.facets();
    facets.extend(hole.facets().iter().map(|f| [f[1] + first, f[0] + first]));
    let shape = Shape::Polytope { points: [outer.coords, hole.coords].concat(), facets };
    let square = |half: f64| rectangle_tri3([-half; 2], [half; 2], [4, 4], Diagonals::Same);
    for options in [exact(), lines(0.002, 1)] {
        assert_eq!(against(&square(0.69), shape.clone(), Pose::at([0.0; 2]), options).volume, 0.0);
        // A corner of the square at √2·0.8 = 1.131 pokes through a corner of the 24-gon at (1, 0): a kite with that corner's
        // right angle and the 165° of the polygon, 0.131 long. Its half: sides meet at 45° and 82.5° from the axis.
        let turned = square(0.8).rotated(std::f64::consts::FRAC_PI_4);
        let length = 0.8 * 2f64.sqrt() - 1.0;
        let (a, b) = (45f64.to_radians(), 97.5f64.to_radians());
        // Triangle with base `length` and angles a at the tip and π − 82.5° = b at the polygon's corner, twice, four times.
        let half = 0.5 * length * length * a.sin() * b.sin() / (a + b).sin();
        let contact = against(&turned, shape.clone(), Pose::at([0.0; 2]), options);
        let tolerance = if options == exact() { 1e-13 } else { 5e-3 };
        assert!((contact.volume / (8.0 * half) - 1.0).abs() < tolerance, "{} of {}", contact.volume, 8.0 * half);
    }
}
