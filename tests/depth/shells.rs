//! Convex obstacles from which the contact is at a distance: closed forms, the quadrature of the same distance, derivatives.

use crate::depth;
use crate::obstacles::{Deviations, deviations_of, disturbed};
use crate::scene::Scene;
use fmc_contact::contact::PairOptions;
use fmc_contact::overlap::Partner::{Body, Obstacle as Rigid};
use fmc_contact::{Contact, ContactForces, Obstacle, Options, Pose, Shape};
use fmc_shapes::{
    Diagonals, Mesh, cuboid_hex8, cuboid_surface, cuboid_tet4, icosphere, random_rotation, rectangle_quad4,
    rectangle_tri3,
};
use std::f64::consts::PI;
use std::sync::Arc;

fn scene<const D: usize>(
    mesh: &Mesh<D>,
    shape: &Shape<D>,
    pose: Pose<D>,
    by: f64,
    options: Options,
) -> (Scene<D>, Contact<D>) {
    let scene = Scene::of(&[mesh]);
    let mut contact = scene.contact(options);
    contact.add_obstacle(Obstacle { shape: shape.clone(), pose }).unwrap();
    contact.set_pair_options([Body(0), Rigid(0)], Some(PairOptions::with_gap_offset(by))).unwrap();
    (scene, contact)
}

fn found<const D: usize>(mesh: &Mesh<D>, shape: &Shape<D>, pose: Pose<D>, by: f64) -> ContactForces<D> {
    let (scene, contact) = scene(mesh, shape, pose, by, depth(1.0));
    contact.evaluate(&scene.coords).unwrap()
}

fn close(what: &str, found: f64, expected: f64, tolerance: f64) {
    let off = (found - expected).abs();
    assert!(off <= tolerance * expected.abs().max(1e-3), "{what}: {found} instead of {expected}, off by {off:e}");
}

fn hull_of<const D: usize>(points: &[[f64; D]]) -> Shape<D> {
    Shape::ConvexHull { points: points.to_vec() }
}

/// The corners of a box about the origin.
fn corners<const D: usize>(half: [f64; D]) -> Vec<[f64; D]> {
    (0..1usize << D).map(|c| std::array::from_fn(|i| if c >> i & 1 == 1 { half[i] } else { -half[i] })).collect()
}

/// The distance from a box as a host would write it down, less an offset: by quadrature.
fn by_function<const D: usize>(half: [f64; D], by: f64) -> Shape<D> {
    Shape::SignedDistance(Arc::new(move |x: &[f64; D]| {
        let out: [f64; D] = std::array::from_fn(|i| x[i].abs() - half[i]);
        let far = out.iter().map(|o| o.max(0.0).powi(2)).sum::<f64>().sqrt();
        let nearest = (0..D).fold(0, |n, i| if out[i] > out[n] { i } else { n });
        let gradient = |i: usize| match far > 0.0 {
            true => out[i].max(0.0) / far * x[i].signum(),
            false => f64::from(u8::from(i == nearest)) * x[i].signum(),
        };
        (if far > 0.0 { far } else { out[nearest] } - by, std::array::from_fn(gradient))
    }))
}

/// Bodies that have all of a square or a cube in them, with its shell, or half of it: the measure of what is nearer than s is
/// 4 + 8 s + π s² and 8 + 24 s + 6 π s² + 4/3 π s³ by Steiner.
#[test]
fn shells_around_all_of_a_box() {
    let r = 0.3f64;
    let square = 4.0 / 3.0 + 4.0 * r + 4.0 * r * r + PI * r.powi(3) / 3.0;
    for mesh in [
        rectangle_tri3([-2.0, -3.0], [4.0, 2.0], [4, 3], Diagonals::Alternating),
        rectangle_quad4([-2.0, -3.0], [4.0, 2.0], [5, 2]),
    ] {
        let at = found(&mesh, &hull_of(&corners([1.0; 2])), Pose::default(), r);
        close("square", at.energy, square, 1e-10);
        close("area", at.volume, 4.0 + 8.0 * r + PI * r * r, 1e-10);
        let half = mesh.mapped(|x| [x[0], if x[1] > 1.9 { 0.0 } else { x[1].min(-0.01) }]);
        close(
            "half of a square",
            found(&half, &hull_of(&corners([1.0; 2])), Pose::default(), r).energy,
            0.5 * square,
            1e-10,
        );
    }
    let cube = 2.0 + 8.0 * r + 12.0 * r * r + 2.0 * PI * r.powi(3) + PI * r.powi(4) / 3.0;
    let volume = 8.0 + 24.0 * r + 6.0 * PI * r * r + 4.0 / 3.0 * PI * r.powi(3);
    for top in [2.0, 0.0] {
        let part = if top > 0.0 { 1.0 } else { 0.5 };
        for mesh in [
            cuboid_tet4([-2.0, -3.0, -2.0], [4.0, 2.0, top], [3, 2, 2]),
            cuboid_hex8([-2.0, -3.0, -2.0], [4.0, 2.0, top], [2, 3, 2]),
        ] {
            let at = found(&mesh, &hull_of(&corners([1.0; 3])), Pose::default(), r);
            close("cube", at.energy, part * cube, 1e-9);
            close("volume", at.volume, part * volume, 1e-9);
            let turned =
                found(&mesh, &hull_of(&corners([1.0; 3])), Pose::default().turned_about([1.0, 0.3, 0.2], 0.4), r);
            close("cube, turned", turned.energy, part * cube, 1e-9);
        }
    }
}

/// A block around one corner of a box: of each face, edge and corner it has a part in closed form.
#[test]
fn around_a_corner() {
    let ([a, b, c], r) = ([0.3f64, 0.3, 0.05], 0.2f64);
    let faces = 0.5 * r * r * (a * b + b * c + c * a);
    let edges = PI / 2.0 * r.powi(3) / 6.0 * (a + b + c);
    let corner = PI / 2.0 * r.powi(4) / 12.0;
    // ∫ (a − t) (b − t) (c − t) from 0 to c is that of the depth inside.
    let inside = a * b * c * c / 2.0 - (a + b) * c.powi(3) / 6.0 + c.powi(4) / 12.0 + r * a * b * c;
    for cells in [[2, 2, 1], [5, 4, 3]] {
        for mesh in [
            cuboid_tet4([0.2, 0.1, 0.25], [0.9, 0.8, 0.9], cells),
            cuboid_hex8([0.2, 0.1, 0.25], [0.9, 0.8, 0.9], cells),
        ] {
            let at = found(&mesh, &hull_of(&corners([0.5, 0.4, 0.3])), Pose::default(), r);
            close("energy", at.energy, faces + edges + corner + inside, 1e-9);
            // ∂/∂c, ∂/∂b and ∂/∂a of the energy, as the block's lower faces move.
            let force = r * r / 2.0 * (a + b) + PI / 12.0 * r.powi(3) + a * b * c - (a + b) * c * c / 2.0
                + c.powi(3) / 3.0
                + r * a * b;
            close("force", at.bodies[0].force[2], force, 1e-9);
        }
    }
}

/// Against the quadrature of the same distance: on a face, over edges and corners, beside and inside, flush with walls, to the
/// digits that the quadrature has. A box with more facets than it needs is the same.
#[test]
fn the_quadrature_agrees() {
    let (half, r) = ([0.5, 0.4, 0.3], 0.2);
    let many = cuboid_surface([-0.5, -0.4, -0.3], half, [3, 2, 4]);
    let many = Shape::Polytope { points: many.coords.clone(), facets: many.facets() };
    let turned = Pose { rotation: random_rotation(3), ..Pose::at([0.02, 0.03, 0.01]) }.scaled(1.1);
    for (pose, min, max) in [
        (Pose::default(), [-0.2, -0.2, 0.4], [0.3, 0.2, 0.9]),
        (Pose::default(), [-0.5, -0.4, 0.45], [0.5, 0.4, 0.9]),
        (Pose::default(), [-0.5, -0.4, 0.3], [0.5, 0.4, 0.9]),
        (Pose::default(), [0.2, 0.1, 0.25], [0.9, 0.8, 0.9]),
        (Pose::default(), [0.5, 0.4, 0.3], [0.9, 0.8, 0.9]),
        (Pose::default(), [0.6, -0.1, -0.9], [0.9, 0.2, 0.5]),
        (turned, [0.1, 0.2, 0.1], [0.9, 0.8, 0.9]),
        (turned, [-0.2, -0.3, 0.52], [0.3, 0.2, 0.9]),
    ] {
        let mesh = cuboid_tet4(min, max, [2, 2, 1]);
        let expected = found(&mesh, &by_function(half, r / pose.scale), pose, 0.0);
        assert!(expected.energy > 0.0, "{min:?}");
        let mut first = None;
        for shape in [hull_of(&corners(half)), Shape::Cuboid { half_extents: half }, many.clone()] {
            let at = found(&mesh, &shape, pose, r);
            let size = expected.bodies[0].force.iter().fold(0.0f64, |m, f| m.max(f.abs()));
            // The quadrature has fewer digits in volumes.
            close("energy", at.energy, expected.energy, 1e-4);
            for (force, expected) in at.forces.iter().flatten().zip(expected.forces.iter().flatten()) {
                assert!((force - expected).abs() < 2e-6 * size, "{min:?}: {force} instead of {expected}");
            }
            close("area", at.contact_area, expected.contact_area, 1e-3);
            // The quadrature tells that of its points.
            assert!(at.penetration > (1.0 - 1e-9) * expected.penetration, "{min:?}");
            close("penetration", at.penetration, expected.penetration, 0.1);
            let same: &mut ContactForces<3> = first.get_or_insert_with(|| at.clone());
            close("energy of another", at.energy, same.energy, 1e-9);
            for (force, expected) in at.forces.iter().flatten().zip(same.forces.iter().flatten()) {
                assert!((force - expected).abs() < 1e-9 * size, "{min:?}: {force} and {expected}");
            }
        }
    }
}

/// Above the middle of a face there is nothing but a plane.
#[test]
fn over_a_face_as_over_a_half_space() {
    let tip = [[0.0, 0.0, -2.0], [2.0, 0.0, 0.0], [-1.0, 2.0, 0.0], [-1.0, -2.0, 0.0]];
    let rotation = random_rotation(7);
    let turn = Pose { rotation, ..Pose::at([0.3, -0.2, 0.1]) };
    for by in [0.1, -0.1] {
        for delta in [1e-6, 0.05] {
            let block = cuboid_tet4([-0.1, -0.1, by - delta], [0.1, 0.1, by + 0.3], [3, 3, 2]);
            for pose in [Pose::default(), turn] {
                let mesh = if pose == turn {
                    block.clone().rotated_by(rotation).translated(pose.position)
                } else {
                    block.clone()
                };
                let [at, plane] = [hull_of(&tip), Shape::HalfSpace].map(|shape| found(&mesh, &shape, pose, by));
                let same = |found: f64, expected: f64| (found - expected).abs() < 1e-12 * expected + 1e-17;
                assert!(same(at.energy, plane.energy), "{by} {delta}: {} {}", at.energy, plane.energy);
                assert!(same(at.volume, plane.volume), "{by} {delta}: {} {}", at.volume, plane.volume);
                assert!((at.penetration - plane.penetration).abs() < 1e-15);
                for (force, expected) in at.forces.iter().flatten().zip(plane.forces.iter().flatten()) {
                    assert!((force - expected).abs() < 1e-16, "{force} instead of {expected}");
                }
            }
        }
    }
}

/// Inwards the planes move in: what is left of a box is a smaller one, and nothing in the end.
#[test]
fn inwards() {
    let mesh = cuboid_tet4([-0.1, -0.1, -0.02], [0.9, 0.8, 0.9], [3, 2, 2]);
    let pose = Pose { rotation: random_rotation(3), ..Pose::at([0.02, 0.03, 0.01]) };
    for by in [0.05, 0.2] {
        let at = found(&mesh, &hull_of(&corners([0.5, 0.4, 0.3])), pose, -by);
        let other = found(&mesh, &Shape::Cuboid { half_extents: [0.5 - by, 0.4 - by, 0.3 - by] }, pose, 0.0);
        assert!(other.energy > 0.0);
        close("energy", at.energy, other.energy, 1e-12);
        for (force, expected) in at.forces.iter().flatten().zip(other.forces.iter().flatten()) {
            assert!((force - expected).abs() < 1e-14, "{force} instead of {expected}");
        }
    }
    for by in [0.31, 2.0] {
        let at = found(&mesh, &hull_of(&corners([0.5, 0.4, 0.3])), pose, -by);
        assert!(at.energy == 0.0 && at.forces.iter().flatten().all(|force| *force == 0.0));
    }
}

/// Force against differences of the energy, tangent against differences of the force, ΣF, ΣM.
#[test]
fn derivatives() {
    let mesh = disturbed(rectangle_tri3([0.0; 2], [1.0; 2], [4, 3], Diagonals::Alternating), 1);
    let pose = Pose { position: [0.5, 1.2], rotation: random_rotation(3), scale: 1.1 };
    for by in [0.1, -0.02] {
        let hull = hull_of(&[[-0.3, -0.2], [0.3, -0.25], [0.2, 0.3]]);
        let (scene, contact) = scene(&mesh, &hull, pose, by, depth(30.0));
        check(deviations_of(&scene, contact, pose, [1e-3, 1e-4]), [1e-7, 1e-5]);
    }
    let ball = icosphere(0.4, 1).coords;
    let tip = vec![[0.0, 0.0, -0.5], [0.6, 0.0, 0.1], [-0.3, 0.5, 0.1], [-0.3, -0.5, 0.1]];
    let pose = Pose { rotation: random_rotation(4), ..Pose::at([0.5, 0.4, -0.3]) }.scaled(1.1);
    let [hexahedra, tetrahedra] =
        [cuboid_hex8([0.0; 3], [1.0; 3], [2, 2, 2]), cuboid_tet4([0.0; 3], [1.0; 3], [2, 2, 2])]
            .map(|mesh| disturbed(mesh, 1));
    for (mesh, points, by) in [
        (&hexahedra, &tip, 0.15),
        (&tetrahedra, &corners([0.3, 0.2, 0.35]), 0.15),
        (&tetrahedra, &tip, -0.03),
        (&hexahedra, &ball, -0.03),
        (&tetrahedra, &ball, 0.15),
    ] {
        let (scene, contact) = scene(mesh, &hull_of(points), pose, by, depth(30.0));
        check(deviations_of(&scene, contact, pose, [1e-3, 1e-4]), [1e-7, 1e-5]);
    }
}

fn check(found: Deviations, [force, tangent]: [f64; 2]) {
    println!("force {:.1e}, tangent {:.1e}, balance {:.1e}", found.force, found.tangent, found.balance);
    assert!(found.force < force && found.tangent < tangent && found.balance < 1e-12);
}
