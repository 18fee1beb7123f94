//! A union of shapes as a signed distance.

use super::Part;
use super::nearest::{Nearest, nearest};
use crate::Error;
use crate::geometry::{Pose, Shape, SignedDistance, Vector};
use std::sync::Arc;

/// Up to this part of its least extent from a boundary, the gradient of a part is found by differences of its distance:
/// the direction to the nearest point is there made of rounding. On a smooth boundary their error is 1e-12 from its
/// curvature and 1e-10 from rounding; within this distance of an edge the normal is a mean of those beside it.
const BESIDE: f64 = 1e-6;

/// The union of some shapes.
struct Compound<const D: usize> {
    parts: Vec<(Distance<D>, Pose<D>)>,
}

/// How the distance from a part is found.
enum Distance<const D: usize> {
    HalfSpace,
    Ball { radius: f64 },
    Nearest { nearest: Nearest<D>, beside: f64 },
    Function(Arc<dyn SignedDistance<D>>),
}

/// The shape that stands for a compound. Its distance is the least of those from its parts, which is never more than
/// the true one and no steeper, as [`SignedDistance`] asks for.
pub(crate) fn compound<const D: usize>(parts: Vec<Part<D>>) -> Result<Shape<D>, Error> {
    if parts.is_empty() {
        return Err(Error::EmptyCompound);
    }
    let distance = |part: Part<D>| {
        let distance = match part.shape {
            Shape::HalfSpace => Distance::HalfSpace,
            &Shape::Ball { radius } => Distance::Ball { radius },
            Shape::SignedDistance(function) => Distance::Function(function.clone()),
            _ => {
                let what = "this shape as a part of a compound";
                let (nearest, least) = nearest(&part).ok_or(Error::Unsupported { what })?;
                Distance::Nearest { nearest, beside: BESIDE * least }
            }
        };
        Ok((distance, part.pose))
    };
    let parts = parts.into_iter().map(distance).collect::<Result<_, _>>()?;
    Ok(Shape::SignedDistance(Arc::new(Compound { parts })))
}

impl<const D: usize> Distance<D> {
    /// Distance and gradient in the part's own frame.
    fn at(&self, x: &Vector<D>) -> Result<(f64, Vector<D>), ()> {
        Ok(match self {
            Distance::HalfSpace => (x[D - 1], last_axis()),
            Distance::Ball { radius } => (x.norm() - radius, x.try_normalize(0.0).unwrap_or_else(last_axis)),
            Distance::Nearest { nearest, beside } => {
                let distance = |x: Vector<D>| {
                    let (inside, nearest) = nearest(&x.into());
                    let away = x - Vector::from(nearest);
                    if inside { (-away.norm(), -away) } else { (away.norm(), away) }
                };
                let (phi, away) = distance(*x);
                if phi.abs() > *beside {
                    (phi, away / phi.abs())
                } else {
                    let mut step = Vector::<D>::zeros();
                    let gradient = Vector::from_fn(|axis, _| {
                        step.fill(0.0);
                        step[axis] = *beside;
                        distance(x + step).0 - distance(x - step).0
                    });
                    (phi, gradient)
                }
            }
            Distance::Function(function) => {
                let (mut phi, mut gradient) = ([f64::NAN], [[f64::NAN; D]]);
                function.evaluate(&[(*x).into()], &mut phi, &mut gradient).map_err(|_| ())?;
                (phi[0], gradient[0].into())
            }
        })
    }
}

impl<const D: usize> SignedDistance<D> for Compound<D> {
    fn evaluate(&self, x: &[[f64; D]], phi: &mut [f64], gradient: &mut [[f64; D]]) -> Result<(), usize> {
        for (i, x) in x.iter().enumerate() {
            let mut least = (f64::INFINITY, Vector::zeros());
            for (distance, pose) in &self.parts {
                let (phi, gradient) = distance.at(&pose.unplace(&Vector::from(*x))).map_err(|()| i)?;
                // What is not finite is an error of the part, and is handed on.
                if phi.is_nan() || phi * pose.scale < least.0 {
                    least = (phi * pose.scale, pose.rotate(&gradient));
                }
                if !phi.is_finite() {
                    break;
                }
            }
            (phi[i], gradient[i]) = (least.0, least.1.into());
        }
        Ok(())
    }
}

fn last_axis<const D: usize>() -> Vector<D> {
    let mut up = Vector::zeros();
    up[D - 1] = 1.0;
    up
}
