//! The signed distance of rigid shapes of closed form.

use super::{Shape, Vector};

/// Distance of a point from the surface of a shape, negative inside, and its gradient, both in the shape's own frame;
/// where several points of the surface are nearest, the gradient is that from one of them. `None` for what is made of
/// facets or has a function of its own.
pub(crate) fn signed_distance<const D: usize>(shape: &Shape<D>, x: &Vector<D>) -> Option<(f64, Vector<D>)> {
    let mut up = Vector::zeros();
    up[D - 1] = 1.0;
    let section = match shape {
        Shape::HalfSpace => return Some((x[D - 1], up)),
        Shape::Ball { radius } => return Some((x.norm() - radius, x.try_normalize(0.0).unwrap_or(up))),
        Shape::Cuboid { half_extents } => return Some(of_box(x, &(*half_extents).into())),
        &Shape::Cylinder { radius, half_height } => Section::Rectangle { radius, half_height },
        &Shape::Cone { radius, half_height } => Section::Triangle { radius, half_height },
        &Shape::Capsule { radius, half_height } => Section::Stadium { radius, half_height },
        Shape::Polytope { .. }
        | Shape::ConvexHull { .. }
        | Shape::HeightField(_)
        | Shape::Compound { .. }
        | Shape::SignedDistance(_) => return None,
    };
    let mut outwards = *x;
    outwards[D - 1] = 0.0;
    let radial = outwards.norm();
    if radial > 0.0 {
        outwards /= radial;
    } else {
        outwards[0] = 1.0;
    }
    let (phi, gradient) = section.at(&Vector::<2>::new(radial, x[D - 1]));
    Some((phi, outwards * gradient[0] + up * gradient[1]))
}

fn of_box<const D: usize>(x: &Vector<D>, half: &Vector<D>) -> (f64, Vector<D>) {
    let beyond = x.abs() - half;
    let sign = x.map(f64::signum);
    let nearest = beyond.imax();
    if beyond[nearest] <= 0.0 {
        let mut gradient = Vector::zeros();
        gradient[nearest] = sign[nearest];
        return (beyond[nearest], gradient);
    }
    let outside = beyond.map(|b| b.max(0.0));
    let phi = outside.norm();
    (phi, outside.component_mul(&sign) / phi)
}

/// Half of the section of a body of revolution through its axis: distance from the axis, and height.
enum Section {
    Rectangle { radius: f64, half_height: f64 },
    Triangle { radius: f64, half_height: f64 },
    Stadium { radius: f64, half_height: f64 },
}

impl Section {
    fn at(&self, x: &Vector<2>) -> (f64, Vector<2>) {
        match *self {
            Section::Rectangle { radius, half_height } => of_box(x, &Vector::<2>::new(radius, half_height)),
            Section::Stadium { radius, half_height } => {
                let from = Vector::<2>::new(x[0], x[1] - x[1].clamp(-half_height, half_height));
                let distance = from.norm();
                let gradient = if distance > 0.0 { from / distance } else { Vector::<2>::new(1.0, 0.0) };
                (distance - radius, gradient)
            }
            Section::Triangle { radius, half_height } => {
                let (apex, rim) = (Vector::<2>::new(0.0, half_height), Vector::<2>::new(radius, -half_height));
                let (lateral, base) =
                    (Vector::<2>::new(2.0 * half_height, radius).normalize(), Vector::<2>::new(0.0, -1.0));
                let faces = [(lateral, lateral.dot(&(x - apex))), (base, -half_height - x[1])];
                let (normal, height) = if faces[0].1 >= faces[1].1 { faces[0] } else { faces[1] };
                if height <= 0.0 {
                    return (height, normal);
                }
                let foot = Vector::<2>::new(0.0, -half_height);
                let from = [(apex, rim), (foot, rim)].map(|(p, q)| {
                    let along = q - p;
                    x - p - along * ((x - p).dot(&along) / along.norm_squared()).clamp(0.0, 1.0)
                });
                let from = if from[0].norm_squared() <= from[1].norm_squared() { from[0] } else { from[1] };
                let phi = from.norm();
                (phi, if phi > 0.0 { from / phi } else { normal })
            }
        }
    }
}
