//! Axis-aligned boxes.

use crate::geometry::Vector;

/// Axis-aligned box; empty where `min > max` on some axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Aabb<const D: usize> {
    pub(crate) min: Vector<D>,
    pub(crate) max: Vector<D>,
}

impl<const D: usize> Aabb<D> {
    pub(crate) fn empty() -> Self {
        Self { min: Vector::repeat(f64::INFINITY), max: Vector::repeat(f64::NEG_INFINITY) }
    }

    #[inline]
    pub(crate) fn of<'a>(points: impl IntoIterator<Item = &'a Vector<D>>) -> Self {
        let mut aabb = Self::empty();
        points.into_iter().for_each(|x| aabb.include(x));
        aabb
    }

    /// Widens it to a point.
    #[inline]
    pub(crate) fn include(&mut self, x: &Vector<D>) {
        // Comparisons that are one instruction each; `f64::min` would look for what is no number.
        for i in 0..D {
            self.min[i] = if x[i] < self.min[i] { x[i] } else { self.min[i] };
            self.max[i] = if x[i] > self.max[i] { x[i] } else { self.max[i] };
        }
    }

    /// All sums of a point of one and a point of the other.
    pub(crate) fn sum(&self, other: &Self) -> Self {
        Self { min: self.min + other.min, max: self.max + other.max }
    }

    pub(crate) fn is_empty(&self) -> bool {
        (0..D).any(|i| self.min[i] > self.max[i])
    }

    pub(crate) fn intersection(&self, other: &Self) -> Self {
        Self { min: self.min.sup(&other.min), max: self.max.inf(&other.max) }
    }

    pub(crate) fn union(&self, other: &Self) -> Self {
        Self { min: self.min.inf(&other.min), max: self.max.sup(&other.max) }
    }

    pub(crate) fn meets(&self, other: &Self) -> bool {
        // Without branches: the axis that decides cannot be predicted, and boxes are compared by the thousand.
        (0..D).fold(true, |meets, i| meets & (self.min[i] <= other.max[i]) & (other.min[i] <= self.max[i]))
    }

    pub(crate) fn contains(&self, other: &Self) -> bool {
        (0..D).all(|i| self.min[i] <= other.min[i] && other.max[i] <= self.max[i])
    }

    pub(crate) fn inflated(&self, by: f64) -> Self {
        Self { min: self.min.add_scalar(-by), max: self.max.add_scalar(by) }
    }

    pub(crate) fn extent(&self) -> Vector<D> {
        self.max - self.min
    }

    pub(crate) fn center(&self) -> Vector<D> {
        self.min + self.extent() * 0.5
    }

    /// Distance that rounding can put between two computed points of `self` that are meant to be one: some last bits of
    /// the largest coordinate. Rotations and interpolations of coordinates lose a few; features are far above.
    pub(crate) fn rounding(&self) -> f64 {
        128.0 * f64::EPSILON * self.min.amax().max(self.max.amax())
    }

    /// Squared distance of a point from the box, 0 inside.
    pub(crate) fn squared_distance(&self, x: &Vector<D>) -> f64 {
        (0..D).map(|i| (self.min[i] - x[i]).max(x[i] - self.max[i]).max(0.0)).map(|d| d * d).sum()
    }

    pub(crate) fn volume(&self) -> f64 {
        self.extent().iter().map(|e| e.max(0.0)).product()
    }

    /// Whether the line `origin + t direction` with `t ≤ t_max` meets the box, widened by a little against rounding.
    pub(crate) fn meets_ray(&self, origin: &Vector<D>, direction: &Vector<D>, t_max: f64) -> bool {
        let (mut enter, mut leave) = (f64::NEG_INFINITY, t_max);
        let slack = 1e-12 * (self.extent().amax() + (origin - self.min).amax());
        for i in 0..D {
            let (low, high) = (self.min[i] - slack - origin[i], self.max[i] + slack - origin[i]);
            if direction[i] == 0.0 {
                if low > 0.0 || high < 0.0 {
                    return false;
                }
            } else {
                let (s, t) = (low / direction[i], high / direction[i]);
                enter = enter.max(s.min(t));
                leave = leave.min(s.max(t));
            }
        }
        enter <= leave
    }
}
