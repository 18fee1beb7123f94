//! Points of a quadrature on the part of a facet that is nearer to a corner or an edge than a radius.
//!
//! On the plane of a facet the squared distance is w² + δ²(u), in coordinates w and u of that plane: of a corner δ² = d² + u²,
//! of an edge, w being across it, δ is linear in u. The part is divided into strips between the places along u where its
//! boundary has a kink, and each strip by Gauss' rule along u, and for each of its points along w. Parts that are wide beside their
//! distance from the corner or edge, at which the distance has a kink, are halved towards it.

use super::round_cells::{Nearest, across};
use crate::geometry::Vector;
use crate::geometry::primitives::convex_piece::place;

/// Gauss' rule of eight points on the interval from −1 to 1: half of it.
const GAUSS: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_47),
    (0.960_289_856_497_536_3, 0.101_228_536_290_376_26),
];

/// Length of an interval, by its distance from a kink, up to which the rule is right to nine digits.
const LONGEST: f64 = 1.25;

/// Parts of the radius below which nothing is halved: along a strip, and across.
const FINEST: f64 = 1e-3;
const FINEST_ACROSS: f64 = 1e-4;

/// What is looked at on a facet: what is nearest, a point of it, and how far.
pub(super) struct Round<'a, const D: usize> {
    pub(super) nearest: &'a Nearest<D>,
    pub(super) apex: &'a Vector<D>,
    pub(super) radius: f64,
}

impl<const D: usize> Round<'_, D> {
    /// Calls `visit(barycentric, part of the facet's measure)` for the points on a convex piece of a facet.
    pub(super) fn for_each_point(
        &self,
        corners: &[Vector<D>; D],
        piece: &[[f64; D]],
        visit: &mut impl FnMut(&[f64; D], f64),
    ) {
        if piece.len() < D {
            return;
        }
        if D == 2 { self.on_segment(corners, piece, visit) } else { self.on_polygon(corners, piece, visit) }
    }

    fn on_segment(&self, corners: &[Vector<D>; D], piece: &[[f64; D]], visit: &mut impl FnMut(&[f64; D], f64)) {
        let (p, q) = (&piece[0], &piece[1]);
        let [from, to] = [p, q].map(|w| place(corners, w) - self.apex);
        let length = (to - from).norm();
        let Some(direction) = (to - from).try_normalize(0.0) else { return };
        let start = from.dot(&direction);
        let distance = (from - direction * start).norm();
        let half = (self.radius * self.radius - distance * distance).max(0.0).sqrt();
        let ends = [start.max(-half), (start + length).min(half)];
        let measure = (q[1] - p[1]).abs();
        halved(ends, [0.0, distance], FINEST_ACROSS * self.radius, &mut |ends| {
            gauss(ends, |u, weight| {
                let t = (u - start) / length;
                visit(&std::array::from_fn(|c| p[c] + t * (q[c] - p[c])), weight / length * measure);
            });
        });
    }

    fn on_polygon(&self, corners: &[Vector<D>; D], piece: &[[f64; D]], visit: &mut impl FnMut(&[f64; D], f64)) {
        let Some(plane) = Plane::new(self, corners) else { return };
        let polygon: Vec<[f64; 2]> = piece.iter().map(|w| plane.coordinates(&place(corners, w))).collect();
        let squared = self.radius * self.radius;
        let mut breaks: Vec<f64> = polygon.iter().map(|x| x[0]).collect();
        let [first, last] = breaks.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], u| [a.min(*u), b.max(*u)]);
        let [zeroth, once, twice] = plane.squared;
        for (n, p) in polygon.iter().enumerate() {
            let q = &polygon[(n + 1) % polygon.len()];
            let (du, dw) = (q[0] - p[0], q[1] - p[1]);
            let half = p[1] * dw + (once + twice * p[0]) * du;
            let at_start = p[1] * p[1] + plane.across(p[0]) - squared;
            let inside =
                roots(dw * dw + twice * du * du, half, at_start).into_iter().filter(|t| (0.0..=1.0).contains(t));
            breaks.extend(inside.map(|t| p[0] + t * du));
        }
        breaks.extend(roots(twice, once, zeroth - squared));
        let kink = plane.kink();
        breaks.push(kink[0]);
        breaks.retain(|u| (first..=last).contains(u));
        breaks.sort_unstable_by(f64::total_cmp);
        for ends in breaks.windows(2) {
            let middle = plane.chord(&polygon, 0.5 * (ends[0] + ends[1]), squared);
            if ends[0] < ends[1] && middle[0] < middle[1] {
                let finest = FINEST * self.radius / twice.sqrt();
                halved([ends[0], ends[1]], kink, finest, &mut |ends| {
                    eased(ends, |u, weight| {
                        let chord = plane.chord(&polygon, u, squared);
                        let near = [0.0, plane.across(u).sqrt()];
                        halved(chord, near, FINEST_ACROSS * self.radius, &mut |chord| {
                            gauss(chord, |w, part| visit(&plane.barycentric(u, w), part * weight / plane.measure));
                        });
                    });
                });
            }
        }
    }

    /// The least distance on a convex piece of a facet, but for one inside of it that none of its corners and borders have.
    pub(super) fn least_at_border(&self, away: &[Vector<D>]) -> f64 {
        let count = if D == 2 { away.len() - 1 } else { away.len() };
        (0..count).fold(f64::INFINITY, |least, n| {
            let (p, q) = (away[n], away[(n + 1) % away.len()]);
            let step = q - p;
            let t = -p.dot(&step) / step.norm_squared();
            least.min((p + step * if t.is_finite() { t.clamp(0.0, 1.0) } else { 0.0 }).norm())
        })
    }
}

/// The plane of a facet, with its coordinates u and w.
struct Plane<const D: usize> {
    apex: Vector<D>,
    axes: [Vector<D>; 2],
    /// δ² = squared[0] + 2 squared[1] u + squared[2] u².
    squared: [f64; 3],
    /// Of the facet's corners.
    corners: [[f64; 2]; D],
    /// Its area, and twice that with the sign of its coordinates.
    measure: f64,
    determinant: f64,
}

impl<const D: usize> Plane<D> {
    fn new(round: &Round<D>, corners: &[Vector<D>; D]) -> Option<Self> {
        let edges = [corners[1] - corners[0], corners[D - 1] - corners[0]];
        let normal = across(&edges[0], &edges[1]).try_normalize(0.0)?;
        let longest = if edges[0].norm() > edges[1].norm() { edges[0] } else { edges[1] }.try_normalize(0.0)?;
        let height = normal.dot(&(corners[0] - round.apex));
        let (axis, squared) = match round.nearest {
            Nearest::Edge(direction) => {
                // Where the edge is upright on the facet, any direction will do.
                let axis = across(&normal, direction).try_normalize(1e-8).unwrap_or(longest);
                let other = across(direction, &axis);
                let (slope, constant) = (across(&axis, &normal).dot(&other), height * normal.dot(&other));
                (axis, [constant * constant, slope * constant, slope * slope])
            }
            _ => (longest, [height * height, 0.0, 1.0]),
        };
        let axes = [across(&axis, &normal), axis];
        let mut plane =
            Self { apex: *round.apex, axes, squared, corners: [[0.0; 2]; D], measure: 0.0, determinant: 0.0 };
        plane.corners = corners.each_ref().map(|x| plane.coordinates(x));
        let [p, q] = [1, D - 1].map(|c| [0, 1].map(|i| plane.corners[c][i] - plane.corners[0][i]));
        plane.determinant = p[0] * q[1] - p[1] * q[0];
        plane.measure = 0.5 * plane.determinant.abs();
        (plane.measure > 0.0).then_some(plane)
    }

    fn coordinates(&self, x: &Vector<D>) -> [f64; 2] {
        let from = x - self.apex;
        self.axes.each_ref().map(|axis| axis.dot(&from))
    }

    fn barycentric(&self, u: f64, w: f64) -> [f64; D] {
        let [x, p, q] =
            [[u, w], self.corners[1], self.corners[D - 1]].map(|x| [0, 1].map(|i| x[i] - self.corners[0][i]));
        let first = (x[0] * q[1] - x[1] * q[0]) / self.determinant;
        let second = (p[0] * x[1] - p[1] * x[0]) / self.determinant;
        std::array::from_fn(|c| [1.0 - first - second, first, second][c])
    }

    /// δ².
    fn across(&self, u: f64) -> f64 {
        let [zeroth, once, twice] = self.squared;
        (zeroth + u * (2.0 * once + u * twice)).max(0.0)
    }

    /// Where δ is least, and how far from there it is twice as large or so.
    fn kink(&self) -> [f64; 2] {
        let [zeroth, once, twice] = self.squared;
        let place = -once / twice;
        if place.is_finite() {
            [place, ((zeroth + place * once).max(0.0) / twice).sqrt()]
        } else {
            [0.0, f64::INFINITY]
        }
    }

    /// The part of a line across a convex polygon that is near enough; empty where the second is not above the first.
    fn chord(&self, polygon: &[[f64; 2]], u: f64, squared: f64) -> [f64; 2] {
        let mut ends = [f64::INFINITY, f64::NEG_INFINITY];
        for (n, p) in polygon.iter().enumerate() {
            let q = &polygon[(n + 1) % polygon.len()];
            if p[0] != q[0] && (p[0] - u) * (q[0] - u) <= 0.0 {
                let w = p[1] + (u - p[0]) / (q[0] - p[0]) * (q[1] - p[1]);
                ends = [ends[0].min(w), ends[1].max(w)];
            }
        }
        let half = (squared - self.across(u)).max(0.0).sqrt();
        [ends[0].max(-half), ends[1].min(half)]
    }
}

/// Roots of a x² + 2 b x + c.
fn roots(a: f64, b: f64, c: f64) -> Vec<f64> {
    let discriminant = b * b - a * c;
    if discriminant < 0.0 {
        return Vec::new();
    }
    let sum = -(b + b.signum() * discriminant.sqrt());
    [sum / a, c / sum].into_iter().filter(|root| root.is_finite()).collect()
}

/// Halves an interval until none is much longer than the distance from a place beside it, which lies `near[1]` away from the line.
fn halved(ends: [f64; 2], near: [f64; 2], finest: f64, visit: &mut impl FnMut([f64; 2])) {
    let [low, high] = ends;
    if low >= high || !(high - low).is_finite() {
        return;
    }
    let beside = (low - near[0]).max(near[0] - high).max(0.0);
    let length = high - low;
    if length <= finest || length <= LONGEST * beside.hypot(near[1]) {
        visit(ends);
        return;
    }
    // At the place itself, if it lies inside.
    let middle = if low < near[0] && near[0] < high { near[0] } else { 0.5 * (low + high) };
    halved([low, middle], near, finest, visit);
    halved([middle, high], near, finest, visit);
}

/// Calls `visit(place, weight)` for the points of Gauss' rule on an interval.
pub(super) fn gauss([low, high]: [f64; 2], mut visit: impl FnMut(f64, f64)) {
    let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
    for (place, weight) in GAUSS {
        visit(middle - half * place, half * weight);
        visit(middle + half * place, half * weight);
    }
}

/// The same for what begins and ends as the root of the distance from the ends: places are denser there.
fn eased([low, high]: [f64; 2], mut visit: impl FnMut(f64, f64)) {
    let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
    gauss([-1.0, 1.0], |t, weight| {
        visit(middle + half * 0.5 * t * (3.0 - t * t), half * weight * 1.5 * (1.0 - t * t));
    });
}
