//! The sides of an obstacle that a point passes on its way.

use super::rigid::{Placed, Rigid};
use crate::configuration::FacetSide;
use crate::geometry::shapes::{ConvexShape, Extent, ImplicitShape};
use crate::geometry::{Pose, SignedDistance, Vector};

/// Part of an obstacle's size that is rounding of coordinates.
const ROUNDING: f64 = 1e-12;

/// An obstacle as what is passed: no half-space, of which nobody comes out behind. Of a function of the host only the middle is known: it would
/// be asked for every facet.
pub(crate) struct Sides<'a, const D: usize> {
    kind: Kind<'a, D>,
    /// A point in its middle, in its own frame.
    pub(crate) middle: Option<Vector<D>>,
    /// Radius of a ball about the origin of its frame that holds it; infinite where that is not known.
    pub(crate) radius: f64,
}

enum Kind<'a, const D: usize> {
    Convex(&'a dyn ConvexShape<D>),
    Faceted(FacetSide<'a, D>, Pose<D>),
    Function,
}

impl<'a, const D: usize> Sides<'a, D> {
    pub(crate) fn new(rigid: &'a Rigid<D>, placed: Option<&'a Placed<D>>) -> Option<Self> {
        let middle = Vector::zeros();
        match (rigid.solid().implicit(), placed) {
            (Some(ImplicitShape::Convex(shape)), _) => match shape.extent() {
                Extent::HalfSpace => None,
                Extent::Bounded { radius, .. } => {
                    Some(Self { kind: Kind::Convex(&**shape), middle: Some(middle), radius })
                }
            },
            (Some(shape @ ImplicitShape::Function(_)), _) => {
                let (mut phi, mut gradient) = ([0.0], [[0.0; D]]);
                let is_known = shape.evaluate(&[middle.into()], &mut phi, &mut gradient).is_ok() && phi[0] < 0.0;
                Some(Self { kind: Kind::Function, middle: is_known.then_some(middle), radius: f64::INFINITY })
            }
            (None, Some(placed)) => {
                let (pose, side) = (rigid.obstacle.pose, rigid.side(placed));
                let points = &rigid.solid().faces()?.points;
                let middle = points.iter().sum::<Vector<D>>() / points.len() as f64;
                let is_inside = side.winding_number(&pose.place(&middle)) > 0;
                let radius = points.iter().map(|x| x.norm()).fold(0.0, f64::max);
                Some(Self { kind: Kind::Faceted(side, pose), middle: is_inside.then_some(middle), radius })
            }
            (None, None) => None,
        }
    }

    /// How a point that stays where it is passes the obstacle, which goes through these poses; `None` where it never comes in.
    pub(crate) fn of_way(&self, point: &Vector<D>, poses: &[Pose<D>]) -> Option<Through<D>> {
        let (first, last) = (poses.first()?, poses.last()?);
        let way: Vec<Vector<D>> = poses.iter().map(|pose| pose.unplace(point)).collect();
        let (start, end) = (self.nearest(way.first()?), self.nearest(way.last()?));
        let rounding = ROUNDING * self.radius;
        // What lies on a side comes in by that, whatever rounding says.
        let mut sides = (start.0 < rounding).then_some([first.rotate(&start.1); 2]);
        for (piece, pose) in way.windows(2).zip(&poses[1..]) {
            for normal in self.passed(&piece[0], &piece[1]) {
                let normal = pose.rotate(&normal);
                sides = Some([sides.map_or(normal, |[first, _]| first), normal]);
            }
        }
        let [entered, left] = sides?;
        let left = if end.0 < 0.0 { last.rotate(&end.1) } else { left };
        Some(Through { starts_inside: start.0 < -rounding, sides: [entered, left] })
    }

    /// Normals where a straight piece passes the surface, in this order.
    fn passed(&self, from: &Vector<D>, to: &Vector<D>) -> Vec<Vector<D>> {
        match &self.kind {
            Kind::Convex(shape) => {
                let (way, length) = (to - from, (to - from).norm());
                let hits = if length > 0.0 { shape.chord(from, &(way / length)) } else { None };
                let hits = hits.into_iter().flatten().filter(|hit| (0.0..length).contains(&hit.t));
                hits.map(|hit| hit.normal).collect()
            }
            Kind::Faceted(side, pose) => {
                let found = side.passages(&pose.place(from), &pose.place(to));
                found.iter().map(|one| unit(pose.unrotate(&one.normal))).collect()
            }
            Kind::Function => Vec::new(),
        }
    }

    /// Distance of a point from the surface, negative inside, and the outward unit normal where that is nearest.
    fn nearest(&self, x: &Vector<D>) -> (f64, Vector<D>) {
        match &self.kind {
            Kind::Convex(shape) => {
                let (distance, slope) = shape.signed_distance(x);
                (distance, unit(slope))
            }
            Kind::Faceted(side, pose) => {
                let place = pose.place(x);
                let (normal, squared) = side.nearest_normal(&place);
                let distance = squared.sqrt() / pose.scale;
                let is_inside = side.winding_number(&place) > 0;
                (if is_inside { -distance } else { distance }, unit(pose.unrotate(&normal)))
            }
            Kind::Function => (f64::INFINITY, Vector::zeros()),
        }
    }
}

/// How a point came in and where it is, or went out.
pub(crate) struct Through<const D: usize> {
    pub(crate) starts_inside: bool,
    /// Outward unit normals, in space, of the side by which it came in, or that was nearest where it started inside; and of that by which it
    /// went out, or that is nearest at the end. A ball that spins in place has one side there, whichever part of it that is.
    pub(crate) sides: [Vector<D>; 2],
}

fn unit<const D: usize>(normal: Vector<D>) -> Vector<D> {
    normal.try_normalize(0.0).unwrap_or(normal)
}
