//! Rigid obstacles whose integrals are taken by quadrature.

use crate::obstacles::{Deviations, against, deviations, disturbed, found};
use fmc_contact::{Error, Obstacle, Pose, Shape};
use fmc_shapes::{
    Diagonals, Mesh, cuboid_hex8, cuboid_surface, cuboid_tet4, random_rotation, rectangle_quad4, rectangle_tri3,
};
use std::f64::consts::PI;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// A block whose face at height 0 lies δ deep in a ball: a cap. With r the distance from the centre of the ball, the
/// depth R − r is summed over the cap.
#[test]
fn balls() {
    let r = 0.5f64;
    let shape = Shape::Ball { radius: r };
    for delta in [0.002f64, 0.02, 0.2] {
        // 3D: the force is ∫ (R − r) over the disc: π (R a² − ⅔ (R³ − h³)), h = R − δ; J = ∫ of it over the depth.
        let h = r - delta;
        let force = PI * (r * (r * r - h * h) - 2.0 / 3.0 * (r.powi(3) - h.powi(3)));
        // ∫_h^R of π (R³/3 − R h² + ⅔ h³) dh.
        let energy = PI * (r.powi(3) * delta / 3.0 - r * (r.powi(3) - h.powi(3)) / 3.0 + (r.powi(4) - h.powi(4)) / 6.0);
        for (name, mesh) in [
            ("tet", cuboid_tet4([-1.0, -1.1, -1.0], [1.05, 1.0, 0.0], [20, 20, 2])),
            ("facets", cuboid_surface([-1.0, -1.1, -1.0], [1.05, 1.0, 0.0], [3, 2, 2])),
        ] {
            let at = found(&mesh, &shape, Pose::at([0.0, 0.0, h]));
            let (f, e) = (-at.bodies[0].force[2] / force - 1.0, at.energy / energy - 1.0);
            println!("ball 3D {name}, {delta}: force {f:.1e}, energy {e:.1e}, pieces {}", at.crossing_count);
            // The energy is needed to fewer digits than the forces, which are no differences of it.
            assert!(f.abs() < 1e-6 && e.abs() < 5e-5, "{name}, {delta}: {f:e}, {e:e}");
            assert!((at.penetration / delta - 1.0).abs() < 0.05);
        }
        // 2D: ∫ (R − r) over the chord.
        let a = (r * r - h * h).sqrt();
        let force = 2.0 * r * a - (a * r + h * h * (a / h).asinh());
        let mesh = rectangle_tri3([-1.0, -1.0], [1.1, 0.0], [30, 4], Diagonals::Alternating);
        let at = found(&mesh, &Shape::Ball { radius: r }, Pose::at([0.0, h]));
        let f = -at.bodies[0].force[1] / force - 1.0;
        println!("ball 2D {delta}: force {f:.1e}, pieces {}", at.crossing_count);
        assert!(f.abs() < 1e-5, "{delta}: {f:e}");
    }
}

/// A face that only touches a capsule: no rounding error makes the energy negative.
#[test]
fn touching_costs_no_energy() {
    let mesh = Mesh::<2> {
        coords: vec![[1.25, -1.5625], [2.25, -1.5625], [1.25, -0.5625]],
        conn: vec![0, 1, 2],
        nodes_per_cell: 3,
    };
    let at = found(&mesh, &Shape::Capsule { radius: 1.25, half_height: 1.25 }, Pose::default());
    assert!((0.0..1e-15).contains(&at.energy) && (0.0..1e-15).contains(&at.volume), "{:e}, {:e}", at.energy, at.volume);
}

/// A ball a tenth as large as the facet it touches between all corners and points.
#[test]
fn small_balls_on_large_facets() {
    let r = 0.1f64;
    let delta = 0.2 * r;
    let h = r - delta;
    let force = PI * (r * (r * r - h * h) - 2.0 / 3.0 * (r.powi(3) - h.powi(3)));
    let mesh = cuboid_surface([0.0, 0.0, -1.0], [1.0, 1.0, 0.0], [1, 1, 1]);
    for n in 0..40 {
        let at = |k: f64| 0.15 + 0.7 * (0.5 + 0.5 * (f64::from(n) * k).sin());
        let at = found(&mesh, &Shape::Ball { radius: r }, Pose::at([at(1.3), at(2.9), h]));
        let f = -at.bodies[0].force[2] / force - 1.0;
        assert!(f.abs() < 1e-4, "{n}: {f:e}");
    }
}

/// Lateral and flat faces of bodies of revolution and of a polytope that is not convex, by their sections.
#[test]
fn other_shapes() {
    let block = cuboid_tet4([-1.0, -1.1, -1.0], [1.05, 1.0, 0.0], [8, 8, 2]);
    let (radius, half_height) = (0.5f64, 0.6f64);
    let delta = 0.05f64;
    // Axis upright, the flat end δ deep: the depth is δ but near the rim, where it is that below the lateral face.
    let force =
        PI * (radius - delta).powi(2) * delta + PI * delta * delta * (radius - delta) + PI * delta.powi(3) / 3.0;
    let at = found(&block, &Shape::Cylinder { radius, half_height }, Pose::at([0.0, 0.0, half_height - delta]));
    let f = -at.bodies[0].force[2] / force - 1.0;
    println!("cylinder: {f:.1e}, {} pieces", at.crossing_count);
    assert!(f.abs() < 1e-6, "cylinder: {f:e}");
    // Tip down: on the face the radius is t tan α at height t above the tip, and the depth (t tan α − ρ) cos α.
    let slope = radius / (2.0 * half_height);
    let force = PI * (delta * slope).powi(3) / 3.0 / (1.0 + slope * slope).sqrt();
    let energy = force * delta / 4.0;
    let down = Pose::at([0.013, 0.021, half_height - delta]).turned_about([1.0, 0.0, 0.0], PI);
    let at = found(&block, &Shape::Cone { radius, half_height }, down);
    let (f, e) = (-at.bodies[0].force[2] / force - 1.0, at.energy / energy - 1.0);
    println!("cone: {f:.1e}, {e:.1e}, pieces {}", at.crossing_count);
    assert!(f.abs() < 1e-6 && e.abs() < 2e-4, "cone: {f:e}, {e:e}");
    // On its side: by length the force of a disc, and half a ball at each end.
    let lying = Pose::at([0.03, 0.02, radius - delta]).turned_about([1.0, 0.0, 0.0], 0.5 * PI);
    let h = radius - delta;
    let a = (radius * radius - h * h).sqrt();
    let ball = PI * (radius * (radius * radius - h * h) - 2.0 / 3.0 * (radius.powi(3) - h.powi(3)));
    let force = 2.0 * 0.3 * (2.0 * radius * a - (a * radius + h * h * (a / h).asinh())) + ball;
    let at = found(&block, &Shape::Capsule { radius, half_height: 0.3 }, lying);
    let f = -at.bodies[0].force[2] / force - 1.0;
    println!("capsule: {f:.1e}, pieces {}", at.crossing_count);
    assert!(f.abs() < 1e-6, "capsule: {f:e}");
}

/// An angle of two bars, of which the block meets one as if it were a box, from above.
fn angle() -> Shape<3> {
    let section = [[0.0, 0.0], [1.0, 0.0], [1.0, 0.5], [0.5, 0.5], [0.5, 1.0], [0.0, 1.0]];
    let points: Vec<[f64; 3]> =
        [-0.7, 0.7].iter().flat_map(|&y| section.iter().map(move |p| [p[0], y, p[1]])).collect();
    let mut facets: Vec<[u32; 3]> = Vec::new();
    for k in 0..6u32 {
        let (p, q) = (k, (k + 1) % 6);
        facets.extend([[p, q + 6, q], [p, p + 6, q + 6]]);
    }
    for [p, q, r] in [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]] {
        facets.extend([[p, q, r], [p + 6, r + 6, q + 6]]);
    }
    Shape::Polytope { points, facets }
}

#[test]
fn a_polytope_that_is_not_convex() {
    let delta = 0.05f64;
    let block = cuboid_surface([0.7, -0.2, -1.0], [0.9, 0.2, delta], [2, 2, 2]);
    let at = found(&block, &angle(), Pose::default());
    // The lower face of the angle is at 0, and the block's wall at 0.9 is 0.1 from its side.
    let (f, e) = (-at.bodies[0].force[2] / (0.08 * delta) - 1.0, at.energy / (0.04 * delta * delta) - 1.0);
    println!("angle: {f:.1e}, {e:.1e}, pieces {}", at.crossing_count);
    assert!(f.abs() < 1e-6 && e.abs() < 1e-5, "{f:e}, {e:e}");
}

fn check<const D: usize>(mesh: Mesh<D>, seed: u64, shapes: &[(Shape<D>, Pose<D>)], tolerances: [f64; 2]) {
    let mesh = disturbed(mesh, seed);
    for (shape, pose) in shapes {
        let Deviations { force, tangent, balance } =
            deviations(&mesh, shape, *pose, if D == 2 { [1e-3, 1e-4] } else { [1e-2, 1e-3] });
        println!("force {force:.1e}, tangent {tangent:.1e}, balance {balance:.1e}");
        assert!(force < tolerances[0] && tangent < tolerances[1], "{shape:?}: {force:e}, {tangent:e}");
        assert!(balance < 1e-12, "{shape:?}: {balance:e}");
    }
}

#[test]
fn derivatives_in_the_plane() {
    let turned = |x: f64, z: f64, s: f64| Pose { position: [x, z], rotation: random_rotation(3), scale: s };
    let disc = |x: &[f64; 2]| {
        let r = x[0].hypot(x[1]);
        (r - 0.4, [x[0] / r, x[1] / r])
    };
    let parts = vec![
        Obstacle { shape: Shape::Ball { radius: 0.3 }, pose: Pose::at([0.1, 0.1]) },
        Obstacle { shape: Shape::Cuboid { half_extents: [0.4, 0.2] }, pose: Pose::at([-0.1, 0.1]) },
    ];
    let shapes = [
        (Shape::Ball { radius: 0.4 }, turned(0.4, 1.2, 1.1)),
        (Shape::Cylinder { radius: 0.3, half_height: 0.4 }, turned(0.5, 1.2, 1.1)),
        (Shape::Cone { radius: 0.3, half_height: 0.4 }, turned(0.5, 1.2, 1.1)),
        (Shape::Capsule { radius: 0.3, half_height: 0.4 }, turned(0.5, 1.2, 1.1)),
        (Shape::SignedDistance(Arc::new(disc)), turned(0.5, 1.2, 1.1)),
        (Shape::Compound { parts }, turned(0.5, 1.2, 1.1)),
    ];
    // Measured: up to 5e-6 and 2e-5, the integrals being known to some 1e-9 and steps down to 1e-4.
    let tolerances = [2e-5, 1e-4];
    check(rectangle_tri3([0.0; 2], [1.0; 2], [4, 3], Diagonals::Alternating), 1, &shapes, tolerances);
    check(rectangle_quad4([0.0; 2], [1.0; 2], [4, 3]), 2, &shapes, tolerances);
    check(rectangle_quad4([0.0; 2], [1.0; 2], [4, 3]).boundary(), 3, &shapes, tolerances);
}

#[test]
fn derivatives_in_space() {
    let turned = |x: f64, z: f64, s: f64| Pose { position: [x, 0.4, z], rotation: random_rotation(4), scale: s };
    let shapes = [
        (Shape::Ball { radius: 0.4 }, turned(0.4, 1.2, 1.1)),
        (Shape::Capsule { radius: 0.3, half_height: 0.2 }, turned(0.5, 1.2, 1.1)),
    ];
    // Measured: up to 3e-5 and 8e-5. The energy is known to some 1e-6, which differences with a step of 1e-2 magnify.
    check(cuboid_hex8([0.0; 3], [1.0; 3], [3, 2, 2]), 1, &shapes, [1e-4, 3e-4]);
    check(cuboid_surface([0.0; 3], [1.0; 3], [3, 2, 2]), 2, &shapes, [1e-4, 3e-4]);
}

/// A function that grows twice as fast as a distance is refused where it is seen.
#[test]
fn functions_that_are_no_distances() {
    let steep = |x: &[f64; 2]| {
        let r = x[0].hypot(x[1]);
        (2.0 * (r - 0.4), [2.0 * x[0] / r, 2.0 * x[1] / r])
    };
    let mesh = rectangle_tri3([0.0; 2], [1.0; 2], [4, 3], Diagonals::Alternating);
    let shape = Shape::SignedDistance(Arc::new(steep));
    let (scene, contact) = against(&mesh, &shape, Pose::at([0.4, 1.2]), 1.0);
    let found = contact.evaluate(&scene.coords);
    assert!(matches!(found, Err(Error::SteepDistance { obstacle: 0, .. })), "{found:?}");
}

/// A wall that lies along a capsule and goes on where that turns away from it touches it to rounding: nothing is found, and looking
/// for it is no more work than the depth of a real overlap.
#[test]
fn touching_is_no_more_work_than_overlapping() {
    let asked = Arc::new(AtomicUsize::new(0));
    let count = Arc::clone(&asked);
    let capsule = move |x: &[f64; 2]| {
        count.fetch_add(1, Ordering::Relaxed);
        let along = x[1] - x[1].clamp(-1.25, 1.25);
        let r = x[0].hypot(along);
        (r - 1.25, [x[0] / r, along / r])
    };
    let shape = Shape::SignedDistance(Arc::new(capsule));
    let work = |left: f64| {
        let mesh = rectangle_quad4([left, -2.1875], [left + 1.0, -1.1875], [1, 1]);
        let (scene, contact) = against(&mesh, &shape, Pose::at([0.0; 2]), 1.0);
        asked.store(0, Ordering::Relaxed);
        let found = contact.evaluate(&scene.coords).expect("valid coordinates");
        (found.energy, asked.load(Ordering::Relaxed))
    };
    let (deep, points) = work(1.2);
    assert!(deep > 1e-6 && points > 1_000, "{deep:e}, {points}");
    for left in [1.25, 1.25 - f64::EPSILON, 1.25 + f64::EPSILON] {
        let (touching, at_touch) = work(left);
        assert!(touching < 1e-30 && at_touch < 2 * points, "{touching:e}: {at_touch} points, {points} at an overlap");
    }
}
