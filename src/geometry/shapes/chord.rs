//! The chord of a line in a convex rigid shape, in closed form.

use crate::geometry::{Shape, Vector};

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

/// The part of the line `o + t d` inside a shape in its own frame; `d` has unit length.
///
/// What is made of facets, and what has a signed distance only, has no chord here: it is met as a surface or by
/// marching.
pub(crate) fn chord<const D: usize>(shape: &Shape<D>, o: &Vector<D>, d: &Vector<D>) -> Chord<D> {
    match *shape {
        Shape::HalfSpace => slab(o, d, D - 1, f64::NEG_INFINITY, 0.0),
        Shape::Ball { radius } => quadric(o, d, 1.0, radius),
        Shape::Cuboid { half_extents } => {
            (0..D).map(|i| slab(o, d, i, -half_extents[i], half_extents[i])).reduce(common).flatten()
        }
        Shape::Cylinder { radius, half_height } => {
            common(quadric(o, d, 0.0, radius), slab(o, d, D - 1, -half_height, half_height))
        }
        Shape::Cone { radius, half_height } => {
            common(cone(o, d, radius, half_height), slab(o, d, D - 1, -half_height, half_height))
        }
        Shape::Capsule { radius, half_height } => {
            let mut up = Vector::zeros();
            up[D - 1] = half_height;
            let side = common(quadric(o, d, 0.0, radius), slab(o, d, D - 1, -half_height, half_height));
            [side, quadric(&(o - up), d, 1.0, radius), quadric(&(o + up), d, 1.0, radius)]
                .into_iter()
                .reduce(hull)
                .flatten()
        }
        Shape::Polytope { .. }
        | Shape::ConvexHull { .. }
        | Shape::HeightField(_)
        | Shape::Compound { .. }
        | Shape::SignedDistance(_) => None,
    }
}

/// The part inside both; empty where they only touch.
fn common<const D: usize>(a: Chord<D>, b: Chord<D>) -> Chord<D> {
    let ([p, q], [r, s]) = (a?, b?);
    let (enter, leave) = (if p.t >= r.t { p } else { r }, if q.t <= s.t { q } else { s });
    (enter.t < leave.t).then_some([enter, leave])
}

/// The part inside one or the other, for parts of one convex shape.
fn hull<const D: usize>(a: Chord<D>, b: Chord<D>) -> Chord<D> {
    match (a, b) {
        (Some([p, q]), Some([r, s])) => Some([if p.t <= r.t { p } else { r }, if q.t >= s.t { q } else { s }]),
        (one, other) => one.or(other),
    }
}

/// low ≤ x[axis] ≤ high.
fn slab<const D: usize>(o: &Vector<D>, d: &Vector<D>, axis: usize, low: f64, high: f64) -> Chord<D> {
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
fn everywhere<const D: usize>(t: f64) -> Hit<D> {
    Hit { t, normal: Vector::zeros() }
}

/// |radial part|² + (axial · last)² ≤ radius²: a ball (axial 1) or an endless cylinder (axial 0).
fn quadric<const D: usize>(o: &Vector<D>, d: &Vector<D>, axial: f64, radius: f64) -> Chord<D> {
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

/// The lower nappe of the endless cone with its apex at `half_height` and the given radius at `−half_height`.
fn cone<const D: usize>(o: &Vector<D>, d: &Vector<D>, radius: f64, half_height: f64) -> Chord<D> {
    // f(x) = |radial|² − k² (h − z)² ≤ 0, on the line A t² + 2 B t + C.
    let k2 = (radius / (2.0 * half_height)).powi(2);
    let (mut or, mut dr) = (*o, *d);
    (or[D - 1], dr[D - 1]) = (0.0, 0.0);
    let (depth, dz) = (half_height - o[D - 1], d[D - 1]);
    let mut a = dr.norm_squared() - k2 * dz * dz;
    let b = or.dot(&dr) + k2 * depth * dz;
    let c = or.norm_squared() - k2 * depth * depth;
    if a.abs() < 1e-14 * (1.0 + k2) {
        // Parallel to a generator: a line turned by less than rounding meets the same points.
        a = 1e-14 * (1.0 + k2);
    }
    let discriminant = b * b - a * c;
    if discriminant < 0.0 && a > 0.0 {
        return None;
    }
    let q = -(b + b.signum() * discriminant.max(0.0).sqrt());
    let roots = if q == 0.0 { [0.0, 0.0] } else { [q / a, c / q] };
    let at = |t: f64| {
        let x = o + d * t;
        let mut normal = x;
        normal[D - 1] = k2 * (half_height - x[D - 1]);
        Hit { t, normal: normal.try_normalize(0.0).unwrap_or_else(Vector::zeros) }
    };
    let (first, last) = (roots[0].min(roots[1]), roots[0].max(roots[1]));
    match a {
        a if a > 0.0 => Some([at(first), at(last)]),
        // Steeper than the cone: it runs in one nappe up to one root and in the other from the other root on.
        _ if dz > 0.0 => Some([everywhere(f64::NEG_INFINITY), at(first)]),
        _ => Some([at(last), everywhere(f64::INFINITY)]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
            for n in 0..400 {
                let f = |k: f64| ((n as f64 + 1.0) * k).sin();
                let o = Vector::<3>::new(f(1.3), f(2.7), f(3.9));
                let mut d = Vector::<3>::new(f(5.1), f(7.7), f(9.2));
                if n % 10 == 0 {
                    // Along an axis, or along a generator of the cone.
                    d = [Vector::x(), Vector::y(), Vector::z(), Vector::<3>::new(1.0, 0.0, 1.2)][n / 10 % 4];
                }
                let d = d.normalize();
                let chord = chord(shape, &o, &d);
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
