//! The chord of a line in a convex shape, and the parts of which it is made.

use crate::geometry::Vector;

/// Where a line passes a boundary: `t` along it (infinite where it never does) and the unit outward normal.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hit<const D: usize> {
    pub(crate) t: f64,
    pub(crate) normal: Vector<D>,
}

/// A line whose slope against a plane is smaller is parallel to it: where it meets the plane may be no double.
const PARALLEL: f64 = 1e-290;

/// The part of a line from `enter` to `leave`; empty chords are `None`.
pub(crate) type Chord<const D: usize> = Option<[Hit<D>; 2]>;

/// The part inside both; empty where they only touch.
pub(super) fn common<const D: usize>(a: Chord<D>, b: Chord<D>) -> Chord<D> {
    let ([p, q], [r, s]) = (a?, b?);
    let (enter, leave) = (if p.t >= r.t { p } else { r }, if q.t <= s.t { q } else { s });
    (enter.t < leave.t).then_some([enter, leave])
}

/// The part inside one or the other, for parts of one convex shape.
pub(super) fn hull<const D: usize>(a: Chord<D>, b: Chord<D>) -> Chord<D> {
    match (a, b) {
        (Some([p, q]), Some([r, s])) => Some([if p.t <= r.t { p } else { r }, if q.t >= s.t { q } else { s }]),
        (one, other) => one.or(other),
    }
}

/// low ≤ x[axis] ≤ high.
pub(super) fn slab<const D: usize>(o: &Vector<D>, d: &Vector<D>, axis: usize, low: f64, high: f64) -> Chord<D> {
    let slope = d[axis];
    if slope.abs() <= PARALLEL {
        let is_inside = low <= o[axis] && o[axis] <= high;
        return is_inside.then_some([everywhere(f64::NEG_INFINITY), everywhere(f64::INFINITY)]);
    }
    let mut normal = Vector::zeros();
    normal[axis] = 1.0;
    let down = Hit { t: (low - o[axis]) / slope, normal: -normal };
    let up = Hit { t: (high - o[axis]) / slope, normal };
    Some(if slope > 0.0 { [down, up] } else { [up, down] })
}

/// An end that is never reached.
pub(super) fn everywhere<const D: usize>(t: f64) -> Hit<D> {
    Hit { t, normal: Vector::zeros() }
}

/// |radial part|² + (axial · last)² ≤ radius²: a ball (axial 1) or an endless cylinder (axial 0).
pub(super) fn quadric<const D: usize>(o: &Vector<D>, d: &Vector<D>, axial: f64, radius: f64) -> Chord<D> {
    let reduced = |mut x: Vector<D>| {
        x[D - 1] *= axial;
        x
    };
    let (p, q) = (reduced(*o), reduced(*d));
    let a = q.norm_squared();
    if a < 1e-300 {
        return (p.norm_squared() <= radius * radius)
            .then_some([everywhere(f64::NEG_INFINITY), everywhere(f64::INFINITY)]);
    }
    // Nearest point of the line first: the square root then loses no digits far from the shape.
    let t = -p.dot(&q) / a;
    let nearest = p + q * t;
    let squared = (radius * radius - nearest.norm_squared()) / a;
    (squared > 0.0).then(|| {
        let half = squared.sqrt();
        [-half, half].map(|s| Hit { t: t + s, normal: (nearest + q * s) / radius })
    })
}

#[cfg(test)]
mod tests {
    use crate::geometry::shapes::convex_shape::tests::convex;
    use crate::geometry::{Shape, Vector};

    /// Membership written down independently of the chords.
    fn inside(shape: &Shape<3>, x: &Vector<3>) -> bool {
        let radial = x[0].hypot(x[1]);
        match *shape {
            Shape::HalfSpace => x[2] <= 0.0,
            Shape::Ball { radius } => x.norm() <= radius,
            Shape::Cuboid { half_extents: h } => (0..3).all(|i| x[i].abs() <= h[i]),
            Shape::Cylinder { radius, half_height } => radial <= radius && x[2].abs() <= half_height,
            Shape::Cone { radius, half_height: h } => x[2].abs() <= h && radial <= radius * (h - x[2]) / (2.0 * h),
            Shape::Capsule { radius, half_height } => radial.hypot((x[2].abs() - half_height).max(0.0)) <= radius,
            _ => false,
        }
    }

    #[test]
    fn chords_against_point_membership() {
        let shapes = [
            Shape::HalfSpace,
            Shape::Ball { radius: 1.1 },
            Shape::Cuboid { half_extents: [0.5, 1.0, 0.7] },
            Shape::Cylinder { radius: 0.8, half_height: 0.9 },
            Shape::Cone { radius: 1.0, half_height: 0.6 },
            Shape::Capsule { radius: 0.5, half_height: 0.7 },
        ];
        let mut hits = 0;
        for shape in &shapes {
            let convex = convex(shape);
            for n in 0..400 {
                let f = |k: f64| ((n as f64 + 1.0) * k).sin();
                let o = Vector::<3>::new(f(1.3), f(2.7), f(3.9));
                let mut d = Vector::<3>::new(f(5.1), f(7.7), f(9.2));
                if n % 10 == 0 {
                    // Along an axis, or along a generator of the cone.
                    d = [Vector::x(), Vector::y(), Vector::z(), Vector::<3>::new(1.0, 0.0, 1.2)][n / 10 % 4];
                }
                let d = d.normalize();
                let chord = convex.chord(&o, &d);
                for step in -400..400 {
                    let t = step as f64 * 0.0101;
                    let expected = inside(shape, &(o + d * t));
                    let found = chord.is_some_and(|[p, q]| p.t <= t && t <= q.t);
                    let near_end = chord.is_some_and(|c| c.iter().any(|h| (h.t - t).abs() < 1e-9));
                    assert!(found == expected || near_end, "{shape:?} line {n} t {t}: {found}");
                    hits += usize::from(found);
                }
                for (hit, sign) in chord.iter().flatten().zip([-1.0, 1.0]) {
                    if hit.t.is_finite() {
                        assert!((hit.normal.norm() - 1.0).abs() < 1e-12 && sign * hit.normal.dot(&d) >= -1e-7);
                    }
                }
            }
        }
        assert!(hits > 10_000);
    }
}
