//! Families of parallel lines.

use super::stream::uniforms;
use crate::geometry::Vector;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::crossing::{Projected, Window};

/// Angle by which directions leave the coordinate axes: the golden angle's complement, an irrational part of a turn.
/// Meshes are often aligned with the axes; a pattern aligned with the mesh is exact or poor by luck.
const TILT: f64 = 0.381_966_011_250_105;

/// Stream numbers from here on belong to the families of patches; lower ones to the standard families and to segments.
const OF_PATCHES: u64 = 64;

/// A family of parallel lines on a regular grid: where it runs, not how dense it is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Family<const D: usize> {
    /// Right-handed, orthonormal; the last is the direction of the lines.
    axes: [Vector<D>; D],
    /// Random shift of the grid, in units of the spacing.
    shift: [f64; 2],
}

impl<const D: usize> Family<D> {
    /// D families at right angles.
    pub(crate) fn all(seed: u64) -> Vec<Self> {
        let frame = tilted_frame::<D>();
        (0..D)
            .map(|k| {
                let mut axes: [Vector<D>; D] = std::array::from_fn(|i| frame[(k + 1 + i) % D]);
                if D == 2 {
                    // A cyclic shift of two vectors changes handedness.
                    axes[0] *= if k == 0 { -1.0 } else { 1.0 };
                } else {
                    // The grid itself is turned as well.
                    let (s, c) = (1.0 + TILT).sin_cos();
                    (axes[0], axes[1]) = (axes[0] * c + axes[1] * s, axes[1] * c - axes[0] * s);
                }
                Self { axes, shift: uniforms(seed, k as u64, 0) }
            })
            .collect()
    }

    /// A family along a unit vector; `stream` tells families of one seed apart.
    ///
    /// The grid is turned off the coordinate axes in 3D; in 2D it has no direction of its own.
    pub(crate) fn along(direction: Vector<D>, seed: u64, stream: u64) -> Self {
        let d = direction;
        let mut axes = [Vector::zeros(); D];
        if D == 2 {
            (axes[0][0], axes[0][1]) = (d[1], -d[0]);
        } else {
            // The axis after the one along which the direction runs most: the least of its components would be another
            // after a small turn, as of a direction near an axis, and all lines would jump.
            let mut aside = Vector::<D>::zeros();
            aside[(d.iamax() + 1) % D] = 1.0;
            let p = (aside - d * d.dot(&aside)).normalize();
            let mut q = Vector::<D>::zeros();
            (q[0], q[1]) = (d[1] * p[2] - d[2] * p[1], d[2] * p[0] - d[0] * p[2]);
            q[D - 1] = d[0] * p[1] - d[1] * p[0];
            let (s, c) = (1.0 + TILT).sin_cos();
            (axes[0], axes[1]) = (p * c + q * s, q * c - p * s);
        }
        axes[D - 1] = d;
        Self { axes, shift: uniforms(seed, OF_PATCHES + stream, 0) }
    }

    /// Direction of the lines.
    pub(crate) fn direction(&self) -> &Vector<D> {
        &self.axes[D - 1]
    }

    /// The vector across the lines with these components.
    pub(crate) fn across(&self, [u, v]: [f64; 2]) -> Vector<D> {
        if D == 2 { self.axes[0] * u } else { self.axes[0] * u + self.axes[1] * v }
    }

    /// A point across and along the lines, in units of length.
    pub(crate) fn view(&self, x: &Vector<D>) -> Projected {
        let v = if D == 2 { 0.0 } else { x.dot(&self.axes[1]) };
        [x.dot(&self.axes[0]), v, x.dot(self.direction())]
    }

    /// Box, across and along the lines, around what is seen of a box; widened a little against rounding.
    pub(crate) fn view_box(&self, aabb: &Aabb<D>) -> [Projected; 2] {
        let center = self.view(&aabb.center());
        let axes = if D == 2 { [0, 0, 1] } else { [0, 1, 2] };
        let half = axes.map(|axis| 0.5 * self.width(aabb, axis % D) + 1e-12 * (aabb.min.amax().max(aabb.max.amax())));
        [std::array::from_fn(|k| center[k] - half[k]), std::array::from_fn(|k| center[k] + half[k])]
    }

    /// A point as seen, in units of the grid, so that lines stand at whole numbers.
    pub(crate) fn on_grid(&self, viewed: &Projected, per_length: f64) -> Projected {
        let v = if D == 2 { 0.0 } else { viewed[1] * per_length - self.shift[1] };
        [viewed[0] * per_length - self.shift[0], v, viewed[2]]
    }

    /// Lines that meet `region`, widened a little against rounding, and the least and largest `t` in it; `None` if
    /// there are more than can be numbered.
    pub(crate) fn window(&self, region: &Aabb<D>, per_length: f64) -> Option<(Window, [f64; 2])> {
        let center = self.view(&region.center());
        let rounding = region.rounding();
        let ends = |middle: f64, width: f64| {
            let half = 0.5 * width + 1e-9 * width + rounding;
            [middle - half, middle + half]
        };
        let range = |axis: usize| {
            let [low, high] = ends(center[axis], self.width(region, axis)).map(|u| u * per_length - self.shift[axis]);
            (low.abs().max(high.abs()) < 1e15).then_some(low.ceil() as i64..high.floor() as i64 + 1)
        };
        let window = Window { i: range(0)?, j: if D == 2 { 0..1 } else { range(1)? } };
        Some((window, ends(center[2], self.width(region, D - 1))))
    }

    /// Corners of a window in units of length, as in [`Self::view`], one line wider on each side.
    pub(crate) fn window_in_length(&self, window: &Window, spacing: f64) -> ([f64; 2], [f64; 2]) {
        let at = |line: i64, axis: usize| (line as f64 + self.shift[axis]) * spacing;
        ([at(window.i.start - 1, 0), at(window.j.start - 1, 1)], [at(window.i.end, 0), at(window.j.end, 1)])
    }

    /// Sides of the bounding rectangle of the projection of `region` across the lines (2D: the first alone).
    pub(crate) fn widths(&self, region: &Aabb<D>) -> [f64; 2] {
        std::array::from_fn(|axis| if axis + 1 < D { self.width(region, axis) } else { 0.0 })
    }

    /// Extent of `region` along one of the axes.
    fn width(&self, region: &Aabb<D>, axis: usize) -> f64 {
        region.extent().dot(&self.axes[axis].abs())
    }

    /// The point of line (i, j) at t = 0.
    pub(crate) fn origin(&self, i: i64, j: i64, spacing: f64) -> Vector<D> {
        let across = self.axes[0] * ((i as f64 + self.shift[0]) * spacing);
        if D == 2 { across } else { across + self.axes[1] * ((j as f64 + self.shift[1]) * spacing) }
    }
}

/// An orthonormal, right-handed frame, turned off the coordinate axes.
fn tilted_frame<const D: usize>() -> [Vector<D>; D] {
    let mut frame: [Vector<D>; D] = std::array::from_fn(|i| Vector::from_fn(|j, _| if i == j { 1.0 } else { 0.0 }));
    let mut turn = |p: usize, q: usize, angle: f64| {
        let (s, c) = angle.sin_cos();
        (frame[p], frame[q]) = (frame[p] * c + frame[q] * s, frame[q] * c - frame[p] * s);
    };
    turn(0, 1, TILT);
    if D == 3 {
        turn(1, 2, TILT * 1.3);
        turn(2, 0, TILT * 0.7);
    }
    frame
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::primitives::facet::determinant;

    fn frames_are_right_handed<const D: usize>() {
        let mut tilted = Vector::<D>::repeat(0.3);
        tilted[1] = -0.7;
        for family in Family::<D>::all(3).into_iter().chain([Family::along(tilted.normalize(), 3, 0)]) {
            assert!((determinant(&family.axes) - 1.0).abs() < 1e-14);
            let spacing = 0.25;
            let x = family.origin(3, if D == 2 { 0 } else { -2 }, spacing) + family.direction() * 0.7;
            let p = family.on_grid(&family.view(&x), 1.0 / spacing);
            assert!((p[0] - 3.0).abs() < 1e-12 && (p[2] - 0.7).abs() < 1e-14);
            assert!(D == 2 || (p[1] + 2.0).abs() < 1e-12);
        }
    }

    #[test]
    fn lines_turn_with_their_direction() {
        let near = |x: f64, y: f64| Family::along(Vector::<3>::new(x, y, 1.0).normalize(), 3, 0);
        let (one, other) = (near(1e-9, 2e-9), near(2e-9, 1e-9));
        assert!((0..3).all(|k| (one.axes[k] - other.axes[k]).amax() < 1e-8));
    }

    #[test]
    fn frames_are_right_handed_in_2d_and_3d() {
        frames_are_right_handed::<2>();
        frames_are_right_handed::<3>();
    }
}
