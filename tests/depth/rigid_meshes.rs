//! Rigid meshes of many faces: in closed form where they are convex, or as far as a body reaches.

use crate::obstacles::{Deviations, deviations, disturbed, found};
use fmc_contact::{ContactForces, Pose, Shape};
use fmc_shapes::{Mesh, cuboid_hex8, cuboid_surface, cuboid_tet4, icosphere, random_rotation};
use std::f64::consts::PI;

fn polytope(mesh: &Mesh<3>) -> Shape<3> {
    Shape::Polytope { points: mesh.coords.clone(), facets: mesh.facets() }
}

/// A ball's node that lies farthest along x, pushed in.
fn dented(level: usize) -> Mesh<3> {
    let mut ball = icosphere(0.5, level);
    let farthest = (0..ball.coords.len()).max_by(|p, q| ball.coords[*p][0].total_cmp(&ball.coords[*q][0]));
    ball.coords[farthest.expect("nodes")].iter_mut().for_each(|x| *x *= 0.9);
    ball
}

fn assert_same(what: &str, a: &ContactForces<3>, b: &ContactForces<3>, tolerance: f64) {
    let size: f64 = b.forces.iter().flatten().map(|f| f.abs()).sum();
    assert!(size > 0.0 && b.energy > 0.0, "{what}: no contact");
    for (p, q) in a.forces.iter().flatten().zip(b.forces.iter().flatten()) {
        assert!((p - q).abs() <= tolerance * size, "{what}: {p} and {q} of {size}");
    }
    assert!((a.energy - b.energy).abs() <= tolerance * b.energy, "{what}: energies {} and {}", a.energy, b.energy);
    assert!((a.volume - b.volume).abs() <= tolerance * b.volume, "{what}: volumes {} and {}", a.volume, b.volume);
}

/// Facets in one plane are one face, however many there are.
#[test]
fn a_finer_mesh_of_a_cube_is_the_same_cube() {
    let cubes = [[1, 1, 1], [8, 8, 8]].map(|count| polytope(&cuboid_surface([-0.5; 3], [0.5; 3], count)));
    let turned = Pose { position: [0.4, 0.3, 1.2], rotation: random_rotation(7), scale: 0.9 };
    for mesh in [cuboid_tet4([0.0; 3], [1.0; 3], [4, 3, 5]), cuboid_hex8([0.0; 3], [1.0; 3], [3, 4, 3])] {
        for pose in [Pose::at([0.1, 0.2, 1.45]), Pose::at([1.2, 1.1, 1.3]), turned] {
            let [coarse, fine] = cubes.each_ref().map(|cube| found(&mesh, cube, pose));
            assert_same("cube", &fine, &coarse, 1e-9);
        }
    }
}

/// A ball of flat facets comes near to the ball as the square of their size.
#[test]
fn balls_of_facets() {
    let (r, delta) = (0.5f64, 0.05f64);
    let h = r - delta;
    let force = PI * (r * (r * r - h * h) - 2.0 / 3.0 * (r.powi(3) - h.powi(3)));
    let energy = PI * (r.powi(3) * delta / 3.0 - r * (r.powi(3) - h.powi(3)) / 3.0 + (r.powi(4) - h.powi(4)) / 6.0);
    let block = cuboid_tet4([-1.0, -1.1, -1.0], [1.05, 1.0, 0.0], [6, 6, 2]);
    let errors = [3, 4].map(|level| {
        let at = found(&block, &polytope(&icosphere(r, level)), Pose::at([0.0, 0.0, h]));
        [-at.bodies[0].force[2] / force - 1.0, at.energy / energy - 1.0].map(f64::abs)
    });
    for (coarse, fine) in errors[0].into_iter().zip(errors[1]) {
        assert!(fine < 0.03 && (3.3..5.0).contains(&(coarse / fine)), "{coarse:e}, {fine:e}");
    }
}

/// More faces than are worth looking at one by one, by bodies of both kinds of cells.
#[test]
fn forces_of_many_faces_are_the_gradient_of_the_energy() {
    let turned = |x: f64, z: f64, s: f64| Pose { position: [x, 0.4, z], rotation: random_rotation(4), scale: s };
    let shape = polytope(&icosphere(0.5, 2));
    for (mesh, pose) in [
        (cuboid_tet4([0.0; 3], [1.0; 3], [3, 2, 2]), turned(0.45, 1.4, 1.1)),
        (cuboid_hex8([0.0; 3], [1.0; 3], [2, 2, 2]), turned(0.45, 1.42, 1.0)),
    ] {
        let Deviations { force, tangent, balance } = deviations(&disturbed(mesh, 3), &shape, pose, [1e-5, 1e-6]);
        assert!(force < 1e-9 && tangent < 1e-6 && balance < 1e-12, "{force:e}, {tangent:e}, {balance:e}");
    }
}

/// The depth that a body finds beside a dent is that of the ball without it, to rounding.
#[test]
fn a_dent_elsewhere_changes_nothing() {
    let (whole, dented) = (polytope(&icosphere(0.5, 2)), polytope(&dented(2)));
    let block = cuboid_tet4([-1.0, -1.1, -1.0], [1.05, 1.0, 0.0], [8, 8, 2]);
    for delta in [0.003, 0.02, 0.06] {
        let pose = Pose::at([0.03, 0.02, 0.5 - delta]);
        assert_same("dented", &found(&block, &dented, pose), &found(&block, &whole, pose), 1e-11);
    }
    let pose = Pose::at([0.03, 0.02, 0.46]);
    let Deviations { force, tangent, balance } = deviations(&disturbed(block, 5), &dented, pose, [1e-5, 1e-6]);
    assert!(force < 1e-9 && tangent < 1e-6 && balance < 1e-12, "{force:e}, {tangent:e}, {balance:e}");
}

/// No face is missed by rounding: contacts that are thin, far away from the origin.
#[test]
fn thin_contacts_far_away() {
    let block = cuboid_tet4([0.0; 3], [1.0; 3], [3, 3, 2]);
    for (shape, tilt) in
        [(polytope(&cuboid_surface([-0.5; 3], [0.5; 3], [4, 4, 4])), 0.0), (polytope(&icosphere(0.5, 2)), 0.3)]
    {
        let delta = 1e-4;
        let [near, far] = [0.0, 1000.0].map(|by| {
            let lowest = match &shape {
                Shape::Polytope { points, .. } => {
                    points.iter().map(|x| x[2] + tilt * x[0]).fold(f64::INFINITY, f64::min)
                }
                _ => 0.0,
            };
            // The face of the block is tilted instead of the shape.
            let mesh = block.clone().mapped(|x| [x[0] + by, x[1] + by, x[2] - tilt * x[0] + by]);
            let pose = Pose::at([0.48 + by, 0.51 + by, 1.0 - tilt * 0.48 - lowest - delta + by]);
            found(&mesh, &shape, pose)
        });
        // Rounding of the coordinates in parts of the depth.
        assert_same("far away", &far, &near, 1e-7);
    }
}

/// Distance of a point from a triangle, by the place where the function that it minimises has no slope.
fn distance(x: [f64; 3], triangle: [[f64; 3]; 3]) -> f64 {
    let minus = |p: [f64; 3], q: [f64; 3]| [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
    let dot = |p: [f64; 3], q: [f64; 3]| p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    let to_edge = |p: [f64; 3], q: [f64; 3]| {
        let (along, from) = (minus(q, p), minus(x, p));
        let t = (dot(from, along) / dot(along, along)).clamp(0.0, 1.0);
        let rest = [0, 1, 2].map(|i| from[i] - t * along[i]);
        dot(rest, rest).sqrt()
    };
    let [p, q, r] = triangle;
    let (e, f, from) = (minus(q, p), minus(r, p), minus(x, p));
    let (ee, ef, ff, xe, xf) = (dot(e, e), dot(e, f), dot(f, f), dot(from, e), dot(from, f));
    let determinant = ee * ff - ef * ef;
    let (s, t) = ((xe * ff - xf * ef) / determinant, (xf * ee - xe * ef) / determinant);
    if s >= 0.0 && t >= 0.0 && s + t <= 1.0 {
        let rest = [0, 1, 2].map(|i| from[i] - s * e[i] - t * f[i]);
        return dot(rest, rest).sqrt();
    }
    to_edge(p, q).min(to_edge(q, r)).min(to_edge(r, p))
}

/// The force on a flat face beside the dent and through it: the depths of many points, each below the nearest facet of all.
#[test]
fn a_dented_ball_against_brute_force() {
    let ball = dented(2);
    let block = cuboid_tet4([-1.0, -1.1, -1.0], [1.05, 1.0, 0.0], [4, 4, 2]);
    let delta = 0.04;
    // The dent looks along x: turned down it is met, else not.
    let down = [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]];
    for rotation in [random_rotation(2), down] {
        let turn = |x: &[f64; 3]| [0, 1, 2].map(|i| (0..3).map(|j| rotation[i][j] * x[j]).sum::<f64>());
        let corners: Vec<[f64; 3]> = ball.coords.iter().map(turn).collect();
        let lowest = corners.iter().map(|x| x[2]).fold(f64::INFINITY, f64::min);
        let triangles: Vec<[[f64; 3]; 3]> = ball.facets().iter().map(|f| f.map(|c| corners[c as usize])).collect();
        let position = [0.01, 0.02, -lowest - delta];
        let at = found(&block, &polytope(&ball), Pose { position, rotation, scale: 1.0 });
        // Points of the face within the facets above it: below the surface where a way up passes no facet below.
        let (count, half) = (120, 0.3);
        let step = 2.0 * half / f64::from(count);
        let mut sum = 0.0;
        for (i, j) in (0..count).flat_map(|i| (0..count).map(move |j| (i, j))) {
            let middle = |k: i32| -half + (f64::from(k) + 0.5) * step;
            let x = [middle(i), middle(j), -position[2]];
            let winding: i32 = triangles.iter().map(|t| below(x, t)).sum();
            if winding > 0 {
                sum += triangles.iter().map(|t| distance(x, *t)).fold(f64::INFINITY, f64::min) * step * step;
            }
        }
        let force = -at.bodies[0].force[2];
        // The grid misses the rim, where the depth vanishes, by the square of its spacing.
        assert!((force / sum - 1.0).abs() < 2e-3, "{force} and {sum}");
    }
}

/// How often a triangle is passed on the way down from a point: +1 where it looks down.
fn below(x: [f64; 3], t: &[[f64; 3]; 3]) -> i32 {
    let side = |p: [f64; 3], q: [f64; 3]| (q[0] - p[0]) * (x[1] - p[1]) - (q[1] - p[1]) * (x[0] - p[0]);
    let s = [side(t[1], t[2]), side(t[2], t[0]), side(t[0], t[1])];
    let area: f64 = s.iter().sum();
    if !(s.iter().all(|s| *s > 0.0) || s.iter().all(|s| *s < 0.0)) {
        return 0;
    }
    let height = (0..3).map(|k| s[k] / area * t[k][2]).sum::<f64>();
    if height > x[2] {
        0
    } else if area < 0.0 {
        1
    } else {
        -1
    }
}
