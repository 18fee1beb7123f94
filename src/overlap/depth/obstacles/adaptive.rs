//! Integrals over the part of simplices that lies inside an obstacle which is known by its signed distance.
//!
//! A simplex is halved, again and again, until halves tell no more than the whole, or until the distance at its centre
//! proves that it lies outside: the distance changes by no more than one is apart, so that nothing is missed between
//! points. In each the distance is taken to be linear to find where it passes zero, and only for this: what is integrated
//! vanishes there itself, so that the error is the square of that of the place.

use crate::Error;
use crate::geometry::Vector;
use crate::geometry::primitives::simplex_rule::{InSimplex, degree_5};
use crate::overlap::depth::simplex_parts::{Corners, WHOLE, below, between};
use crate::overlap::pair::obstacle_distance::{Distance, ObstacleDistance};
use crate::overlap::pair::sides::Pair;
use std::ops::AddAssign;

/// Simplices that a thread takes at once.
const CHUNK: usize = 128;

/// Distances in a simplex are nearly linear if they are off their linear interpolant by no more than this part of its
/// radius: there is no room for a tip of the obstacle between the points that were seen. Where it crosses the surface
/// they have to be off by no more than this part of the depth.
const STRAIGHT: f64 = 0.1;

/// What was seen of the deviation from the linear interpolant may be this part of its largest value.
const SEEN: f64 = 0.25;

/// A simplex whose measure times the depth that it may hide is below this part of the whole sum may hide it.
const HIDDEN: f64 = 1e-7;

/// Simplices of one, two and three dimensions are small below this part of the measure of all, however little was found.
const SMALL: [f64; 3] = [1e-6, 1e-7, 1e-7];

/// Halvings after which a simplex is taken as it is: its size is then rounding.
const MOST_HALVINGS: i32 = 120;

/// The rule of corners and centre, exact for polynomials of degree 2, may be off by so many tolerances.
const UNSEEN: f64 = 10.0;

/// Divisions in a row that have to tell nothing new, on facets and in volumes: one is blind for what changes along other
/// edges than its own.
const PASSES: usize = 2;

/// Distances of points at this part of their own distance are equal but for rounding.
const ROUNDING: f64 = 1e-12;

/// A depth below this part of the coordinates is that of their rounding. Where surfaces touch and nothing lies deeper, the whole
/// sum is such noise, and cannot say what is little. The square root of it is the size of a part at which a curved surface that
/// touches is let be, and the square of that what its volume may be off.
const NOISE: f64 = 0.25 * f64::EPSILON;

/// Simplices in hand from which on they are taken as they are, so that the work and its memory have an end where surfaces touch
/// along a line in space, and for functions that have none: so many, or so many for each that was given.
const MOST_PARTS: usize = 1 << 17;
const MOST_OF_ROOT: usize = 16;

/// What is integrated.
pub(crate) trait Quantity: Copy + Default + AddAssign + Send + Sync {
    /// How much is known otherwise.
    fn difference(&self, other: &Self) -> f64;

    /// How much it is.
    fn size(&self) -> f64;
}

/// A simplex over which is integrated.
pub(crate) struct Root<const D: usize> {
    pub(crate) corners: [Vector<D>; 4],
    pub(crate) measure: f64,
}

/// An integral over the inside of an obstacle.
pub(crate) struct Adaptive<'a, const D: usize, F> {
    pub(crate) pair: &'a Pair<'a, D>,
    pub(crate) distance: &'a ObstacleDistance<'a, D>,
    /// Of the simplices.
    pub(crate) dimension: usize,
    /// Up to this part of the whole sum two halves tell nothing new.
    pub(crate) tolerance: f64,
    /// Adds a point: number of its simplex, coordinates there, part of its measure, distance.
    pub(crate) integrand: F,
}

/// All roots together.
struct Whole {
    measure: f64,
    /// Depth that is rounding.
    noise: f64,
}

/// A part of a root, of which nothing but the distances at its corners is known.
#[derive(Clone, Copy)]
struct Bare<const D: usize> {
    root: u32,
    halvings: i32,
    corners: Corners,
    points: [Vector<D>; 4],
    phi: [f64; 4],
}

/// A part of a root that reaches into the obstacle, or may.
#[derive(Clone, Copy)]
struct Part<const D: usize, Q> {
    bare: Bare<D>,
    /// Halvings in a row that told nothing new.
    passed: usize,
    center: Vector<D>,
    at_center: f64,
    /// Distance of the farthest corner from the centre.
    radius: f64,
    /// Largest deviation of the distance from its linear interpolant.
    bend: f64,
    /// How far the mean distance by its corners and centre is from that by the quadrature, which sees no kink beside a
    /// corner; where all of it is inside.
    unseen: f64,
    /// Integral over it, its root having measure 1.
    value: Q,
}

/// What has become of some parts: what is done with, by root, and what is not.
type Refined<const D: usize, Q> = Result<(Vec<(u32, Q)>, Vec<Part<D, Q>>), Error>;

impl<const D: usize, F> Adaptive<'_, D, F> {
    /// The integral over every root, its measure being 1.
    pub(crate) fn integrals<Q: Quantity>(&self, roots: &[Root<D>]) -> Result<Vec<Q>, Error>
    where
        F: Fn(u32, &InSimplex, f64, &Distance<D>, &mut Q) + Send + Sync,
    {
        let rule = degree_5(self.dimension);
        let mut sums = vec![Q::default(); roots.len()];
        let coordinates = roots.iter().flat_map(|root| &root.corners[..=self.dimension]);
        let whole = Whole {
            measure: roots.iter().map(|root| root.measure).sum(),
            noise: NOISE * coordinates.map(|x| x.amax()).fold(0.0, f64::max),
        };
        let mut active = self.first(roots, &rule)?;
        while !active.is_empty() {
            let of_sums: f64 = sums.iter().zip(roots).map(|(q, root)| q.size() * root.measure).sum();
            let of_active: f64 =
                active.iter().map(|part| part.value.size() * roots[part.bare.root as usize].measure).sum();
            let scale = of_sums + of_active;
            let is_last = active.len() > MOST_PARTS.max(MOST_OF_ROOT * roots.len());
            let refine = |parts: &[Part<D, Q>]| self.refined(parts, roots, scale, &whole, is_last, &rule);
            let refined = self.pair.on_threads(&active, CHUNK, refine);
            active.clear();
            for part in refined {
                let (done, left) = part?;
                done.into_iter().for_each(|(root, value)| sums[root as usize] += value);
                active.extend(left);
            }
        }
        Ok(sums)
    }

    /// The roots themselves.
    fn first<Q: Quantity>(&self, roots: &[Root<D>], rule: &[(InSimplex, f64)]) -> Result<Vec<Part<D, Q>>, Error>
    where
        F: Fn(u32, &InSimplex, f64, &Distance<D>, &mut Q),
    {
        let points: Vec<Vector<D>> = roots.iter().flat_map(|root| root.corners[..=self.dimension].to_vec()).collect();
        let found = self.distance.at(&points)?;
        let bare = roots.iter().zip(found.chunks_exact(self.dimension + 1)).zip(0..).map(|((root, at), number)| {
            let mut phi = [0.0; 4];
            phi.iter_mut().zip(at).for_each(|(phi, at)| *phi = at.phi);
            Bare { root: number, halvings: 0, corners: WHOLE, points: root.corners, phi }
        });
        Ok(self.measured(bare.collect(), rule)?.into_iter().flatten().collect())
    }

    fn refined<Q: Quantity>(
        &self,
        parts: &[Part<D, Q>],
        roots: &[Root<D>],
        scale: f64,
        whole: &Whole,
        is_last: bool,
        rule: &[(InSimplex, f64)],
    ) -> Refined<D, Q>
    where
        F: Fn(u32, &InSimplex, f64, &Distance<D>, &mut Q),
    {
        let edges: Vec<[usize; 2]> = parts.iter().map(|part| self.longest_edge(&part.bare.points)).collect();
        let middles: Vec<Vector<D>> = parts
            .iter()
            .zip(&edges)
            .map(|(part, [p, q])| (part.bare.points[*p] + part.bare.points[*q]) * 0.5)
            .collect();
        let found = self.distance.at(&middles)?;
        let mut halves = Vec::with_capacity(2 * parts.len());
        for (n, (part, &[p, q])) in parts.iter().zip(&edges).enumerate() {
            self.distance.check(&middles[n], found[n].phi, &part.center, part.at_center)?;
            for replaced in [q, p] {
                let mut half = part.bare;
                half.halvings += 1;
                (half.points[replaced], half.phi[replaced]) = (middles[n], found[n].phi);
                half.corners[replaced] =
                    std::array::from_fn(|i| 0.5 * (part.bare.corners[p][i] + part.bare.corners[q][i]));
                halves.push(half);
            }
        }
        let halves = self.measured(halves, rule)?;
        let (mut done, mut left) = (Vec::new(), Vec::new());
        for (n, (part, halves)) in parts.iter().zip(halves.chunks_exact(2)).enumerate() {
            let [p, q] = edges[n];
            let bend = part.bend.max((found[n].phi - 0.5 * (part.bare.phi[p] + part.bare.phi[q])).abs());
            let mut sum = Q::default();
            halves.iter().flatten().for_each(|half| sum += half.value);
            let of_root = roots[part.bare.root as usize].measure;
            let measure = of_root * 0.5f64.powi(part.bare.halvings);
            let phi = part.bare.phi[..=self.dimension].iter().chain([&part.at_center, &found[n].phi]);
            let lowest = phi.copied().fold(f64::INFINITY, f64::min);
            let is_straight = bend <= STRAIGHT * part.radius;
            let is_clear = lowest > bend / SEEN || bend <= STRAIGHT * -lowest + ROUNDING * part.radius;
            let is_resolved = part.at_center <= -part.radius || is_straight && is_clear;
            let hidden = if is_straight { bend / SEEN } else { part.radius };
            let is_small = part.bare.halvings >= MOST_HALVINGS
                || measure * hidden <= HIDDEN * scale
                || hidden <= whole.noise
                || measure <= SMALL[self.dimension - 1] * whole.measure;
            let unseen = halves.iter().flatten().fold(part.unseen, |most, half| most.max(half.unseen));
            let little = (self.tolerance * scale).max(whole.noise * measure);
            let tells_nothing = part.value.difference(&sum) * of_root <= little && unseen * measure <= UNSEEN * little;
            let passed = if tells_nothing && (is_resolved || is_small) { part.passed + 1 } else { 0 };
            if passed >= self.dimension.min(PASSES) || part.bare.halvings >= MOST_HALVINGS || is_last {
                done.push((part.bare.root, sum));
            } else {
                left.extend(halves.iter().flatten().map(|half| Part { passed, ..*half }));
            }
        }
        Ok((done, left))
    }

    /// The integrals over some parts; `None` for those that are outside.
    fn measured<Q: Quantity>(
        &self,
        bare: Vec<Bare<D>>,
        rule: &[(InSimplex, f64)],
    ) -> Result<Vec<Option<Part<D, Q>>>, Error>
    where
        F: Fn(u32, &InSimplex, f64, &Distance<D>, &mut Q),
    {
        let n = self.dimension;
        let centers: Vec<Vector<D>> = bare
            .iter()
            .map(|part| part.points[..=n].iter().fold(Vector::zeros(), |sum, x| sum + x) / (n + 1) as f64)
            .collect();
        let found = self.distance.at(&centers)?;
        let (mut parts, mut points, mut at) = (Vec::with_capacity(bare.len()), Vec::new(), Vec::new());
        // Mean distance by corners and centre, where it is that over all of the simplex.
        let mut of_corners: Vec<f64> = Vec::with_capacity(bare.len());
        for (k, bare) in bare.into_iter().enumerate() {
            let (center, at_center) = (centers[k], found[k].phi);
            let mut radius = 0.0f64;
            for (x, phi) in bare.points[..=n].iter().zip(&bare.phi) {
                self.distance.check(&center, at_center, x, *phi)?;
                radius = radius.max((x - center).norm());
            }
            if at_center >= radius {
                parts.push(None);
                of_corners.push(f64::NAN);
                continue;
            }
            let off = at_center - bare.phi[..=n].iter().sum::<f64>() / (n + 1) as f64;
            // The mean over the simplex of what is quadratic and vanishes at its corners: the place at which the distance
            // passes zero is then right in the mean, which takes five sixths from the square of its error.
            let mean = off * (n + 1) as f64 / (n + 2) as f64;
            let bend = off.abs();
            below(n, &bare.phi.map(|phi| phi + mean), |corners, share| {
                for (w, weight) in rule {
                    let w = between(corners, w);
                    points.push((0..=n).fold(Vector::zeros(), |x, c| x + bare.points[c] * w[c]));
                    at.push((k, w, weight * share * 0.5f64.powi(bare.halvings)));
                }
            });
            let is_inside = bare.phi[..=n].iter().all(|phi| phi + mean < 0.0);
            of_corners.push(if is_inside { at_center - off + mean } else { f64::NAN });
            let unseen = 0.0;
            parts.push(Some(Part { bare, passed: 0, center, at_center, radius, bend, unseen, value: Q::default() }));
        }
        let found = self.distance.at(&points)?;
        for (n, ((k, w, weight), found)) in at.iter().zip(&found).enumerate() {
            let Some(part) = &mut parts[*k] else { continue };
            self.distance.check(&points[n], found.phi, &part.center, part.at_center)?;
            let linear: f64 = w.iter().zip(&part.bare.phi).map(|(w, phi)| w * phi).sum();
            part.bend = part.bend.max((found.phi - linear).abs());
            let in_root = between(&part.bare.corners, w);
            (self.integrand)(part.bare.root, &in_root, *weight, found, &mut part.value);
            of_corners[*k] -= weight * 2f64.powi(part.bare.halvings) * found.phi;
        }
        for (part, off) in parts.iter_mut().zip(&of_corners) {
            if let Some(part) = part.as_mut().filter(|_| off.is_finite()) {
                part.unseen = off.abs();
            }
        }
        Ok(parts)
    }

    fn longest_edge(&self, points: &[Vector<D>; 4]) -> [usize; 2] {
        let edges = (0..=self.dimension).flat_map(|p| (p + 1..=self.dimension).map(move |q| [p, q]));
        let length = |[p, q]: [usize; 2]| (points[p] - points[q]).norm_squared();
        edges.fold([0, 1], |longest, edge| if length(edge) > length(longest) { edge } else { longest })
    }
}
