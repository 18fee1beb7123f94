//! A union of shapes as a signed distance.

use super::implicit_shape::ImplicitShape;
use super::nearest::{Nearest, of_faces};
use super::obstacle::Obstacle;
use super::signed_distance::SignedDistance;
use super::solid::Solid;
use crate::Error;
use crate::geometry::{Pose, Vector};
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
    Own(ImplicitShape<D>),
    Nearest(Nearest<D>),
}

/// The solid that stands for a compound. Its distance is the least of those from its parts, which is never more than
/// the true one and no steeper, as [`SignedDistance`] asks for. What holds for an obstacle holds for a part; errors name
/// the obstacle.
pub(super) fn solid<const D: usize>(parts: &[Obstacle<D>], obstacle: usize) -> Result<Solid<D>, Error> {
    let checked = |part: &Obstacle<D>| Ok((part.solid(obstacle)?, part.pose));
    let solids = parts.iter().map(checked).collect::<Result<Vec<_>, Error>>()?;
    if solids.is_empty() {
        return Err(Error::EmptyCompound);
    }
    let parts = solids.iter().map(|(solid, pose)| Ok((Distance::new(solid)?, *pose))).collect::<Result<_, Error>>()?;
    Ok(Solid::function(Arc::new(Compound { parts })))
}

impl<const D: usize> Distance<D> {
    fn new(solid: &Solid<D>) -> Result<Self, Error> {
        let nearest = match solid.implicit() {
            Some(ImplicitShape::Convex(shape)) => shape.nearest(),
            _ => None,
        };
        Ok(match (nearest, solid) {
            (Some(nearest), _) => Distance::Nearest(nearest),
            (None, Solid::Implicit { shape, faces: None }) => Distance::Own(shape.clone()),
            (None, Solid::Implicit { faces: Some(faces), .. } | Solid::Faceted(faces)) => {
                let what = "this shape as a part of a compound";
                Distance::Nearest(of_faces(faces).ok_or(Error::Unsupported { what })?)
            }
        })
    }

    /// Distance and gradient in the part's own frame.
    fn at(&self, x: &Vector<D>) -> Result<(f64, Vector<D>), ()> {
        Ok(match self {
            Distance::Own(shape) => {
                let (mut phi, mut gradient) = ([f64::NAN], [[f64::NAN; D]]);
                shape.evaluate(&[(*x).into()], &mut phi, &mut gradient).map_err(|_| ())?;
                (phi[0], gradient[0].into())
            }
            Distance::Nearest(Nearest { point, least }) => {
                let distance = |x: Vector<D>| {
                    let (inside, nearest) = point(&x.into());
                    let away = x - Vector::from(nearest);
                    if inside { (-away.norm(), -away) } else { (away.norm(), away) }
                };
                let (beside, (phi, away)) = (BESIDE * least, distance(*x));
                if phi.abs() > beside {
                    (phi, away / phi.abs())
                } else {
                    let mut step = Vector::<D>::zeros();
                    let gradient = Vector::from_fn(|axis, _| {
                        step.fill(0.0);
                        step[axis] = beside;
                        distance(x + step).0 - distance(x - step).0
                    });
                    (phi, gradient)
                }
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
