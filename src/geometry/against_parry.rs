//! Chords and distances of the convex shapes against parry's ray and point queries, in 3D.

use super::shapes::{ConvexShape, convex};
use super::{Shape, Vector};
use parry3d_f64::query::{PointQuery, Ray, RayCast};
use parry3d_f64::shape::{Ball, Capsule, Cone, Cuboid, Cylinder, HalfSpace};
use std::sync::Arc;

trait Both: PointQuery + RayCast {}
impl<S: PointQuery + RayCast> Both for S {}

const RADIUS: f64 = 0.7;
const HALF: f64 = 0.6;

/// A shape, what is known of it, the same in parry, and how far apart their ends of chords may be: parry finds those of
/// cylinders and cones by iteration.
type Compared = (Shape<3>, Arc<dyn ConvexShape<3>>, Box<dyn Both>, f64);

fn shapes() -> Vec<Compared> {
    let (radius, half_height) = (RADIUS, HALF);
    let shapes: [(Shape<3>, Box<dyn Both>, f64); 6] = [
        (Shape::HalfSpace, Box::new(HalfSpace::new([0.0, 1.0, 0.0].into())), 1e-13),
        (Shape::Ball { radius }, Box::new(Ball::new(RADIUS)), 1e-13),
        (Shape::Cuboid { half_extents: [0.5, 0.7, 0.6] }, Box::new(Cuboid::new([0.5, 0.6, 0.7].into())), 1e-13),
        (Shape::Capsule { radius, half_height }, Box::new(Capsule::new_y(HALF, RADIUS)), 1e-13),
        (Shape::Cylinder { radius, half_height }, Box::new(Cylinder::new(HALF, RADIUS)), 1e-6),
        (Shape::Cone { radius, half_height }, Box::new(Cone::new(HALF, RADIUS)), 1e-6),
    ];
    shapes.into_iter().map(|(shape, other, tolerance)| (shape.clone(), convex(&shape), other, tolerance)).collect()
}

/// parry's axis of revolution is y.
fn theirs(x: &Vector<3>) -> parry3d_f64::math::Vector {
    [x[0], x[2], x[1]].into()
}

/// Points and unit vectors, 400 of each.
fn scattered() -> impl Iterator<Item = (Vector<3>, Vector<3>)> {
    (1..400).map(|n| {
        let f = |k: f64| (n as f64 * k).sin();
        (Vector::<3>::new(f(1.3), f(2.7), f(3.9)) * 0.8, Vector::<3>::new(f(5.1), f(7.7), f(9.2)).normalize())
    })
}

#[test]
fn first_ends_of_chords_are_parrys_hits() {
    for (shape, convex, other, tolerance) in shapes() {
        let mut hits = 0;
        for (x, d) in scattered() {
            // From far outside, where the half-space is not met from within.
            let origin = x - d * 10.0;
            if convex.distance_bound(&origin) <= 0.0 {
                continue;
            }
            let found = convex.chord(&origin, &d).filter(|[enter, _]| enter.t > 0.0 && enter.t.is_finite());
            let ray = Ray::new(theirs(&origin), theirs(&d));
            let expected = other.cast_local_ray_and_get_normal(&ray, 1e3, true);
            // A chord that is shorter than the tolerance may be missed.
            let Some([enter, leave]) = found else {
                assert!(expected.is_none() || tolerance > 1e-9, "{shape:?} misses what parry hits from {origin}");
                continue;
            };
            let Some(expected) = expected else {
                assert!(leave.t - enter.t < 1e-2, "{shape:?}: parry misses a chord of {}", leave.t - enter.t);
                continue;
            };
            // Where the line grazes, the end is as much less certain as the angle is small.
            let slope = -enter.normal.dot(&d);
            assert!((enter.t - expected.time_of_impact).abs() * slope < 10.0 * tolerance, "{shape:?} from {origin}");
            // Iterations that end beside an edge see the other side of it.
            let aligned = theirs(&enter.normal).dot(expected.normal);
            assert!(aligned > 1.0 - 1e-6 || tolerance > 1e-9, "{shape:?}: normals differ, {aligned}");
            hits += 1;
        }
        assert!(hits > 50, "{shape:?}: {hits}");
    }
}

#[test]
fn bounds_have_the_sign_of_parrys_distance_and_are_no_larger() {
    for (shape, convex, other, _) in shapes() {
        let mut inside = 0;
        for (x, _) in scattered() {
            let bound = convex.distance_bound(&x);
            let nearest = other.project_local_point(theirs(&x), false);
            let away = (nearest.point - theirs(&x)).length();
            let distance = if nearest.is_inside { -away } else { away };
            assert!(bound <= distance + 1e-14, "{shape:?} at {x}: {bound} beyond {distance}");
            assert_eq!(bound < 0.0, distance < 0.0, "{shape:?} at {x}");
            // Inside, the nearest point of a convex shape lies on the nearest of its faces.
            assert!(bound > 0.0 || (bound - distance).abs() < 1e-14, "{shape:?} at {x}: {bound}, not {distance}");
            inside += usize::from(bound < 0.0);
        }
        assert!(inside > 10 && inside < 390, "{shape:?}: {inside}");
    }
}

#[test]
fn signed_distances_are_parrys() {
    for (shape, convex, other, _) in shapes() {
        for (x, _) in scattered() {
            let x = x * 1.5;
            let (phi, gradient) = convex.signed_distance(&x);
            let nearest = other.project_local_point(theirs(&x), false);
            let away = (nearest.point - theirs(&x)).length();
            let distance = if nearest.is_inside { -away } else { away };
            assert!((phi - distance).abs() < 1e-13, "{shape:?} at {x}: {phi}, not {distance}");
            // To the nearest point it is as far as the distance, against the gradient.
            let end = theirs(&(x - gradient * phi));
            assert!((end - nearest.point).length() < 1e-12, "{shape:?} at {x}: nearest at {end:?}");
        }
    }
}
