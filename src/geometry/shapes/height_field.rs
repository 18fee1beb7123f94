//! The solid below a height field, as a closed surface.

use super::faces::{Faceted, positive};
use super::solid::Solid;
use crate::Error;

/// Heights over a rectangular grid (2D: over a segment), and the solid below them.
///
/// The grid is centred on the origin and lies across the last axis, along which heights are measured. Between the
/// points of the grid the surface is linear in 2D; in 3D every cell is cut along the diagonal from its corner of least
/// x and y. The solid ends in a flat bottom, `thickness` below the lowest height, and in vertical walls.
#[derive(Clone, Debug)]
pub struct HeightField {
    /// Number of points along each axis of the grid: one number in 2D, two in 3D; each at least 2.
    pub counts: Vec<usize>,
    /// Length of the grid along each of its axes, positive.
    pub lengths: Vec<f64>,
    /// Heights; those along the last axis of the grid follow one another.
    pub heights: Vec<f64>,
    /// Depth of the solid below the lowest height, positive.
    pub thickness: f64,
}

impl HeightField {
    /// The solid as a closed surface.
    pub(super) fn solid<const D: usize>(&self) -> Result<Solid<D>, Error> {
        let (points, facets) = self.surface()?;
        Solid::faceted(&points, &facets)
    }

    /// Its corners, the heights in their order, then those of the bottom, and its facets.
    fn surface<const D: usize>(&self) -> Result<Faceted<D>, Error> {
        let lowest = self.check(D - 1)?;
        let at = |point: [usize; 2], height: f64| -> [f64; D] {
            let mut x = [height; D];
            for axis in 0..D - 1 {
                x[axis] = self.lengths[axis] * (point[axis] as f64 / (self.counts[axis] - 1) as f64 - 0.5);
            }
            x
        };
        // In 2D the grid is one row.
        let [rows, columns] = if D == 2 { [self.counts[0], 1] } else { [self.counts[0], self.counts[1]] };
        let number = |[i, j]: [usize; 2]| (i * columns + j) as u32;
        let grid = (0..rows).flat_map(|i| (0..columns).map(move |j| [i, j]));
        let mut points: Vec<[f64; D]> = grid.zip(&self.heights).map(|(point, &height)| at(point, height)).collect();
        let bottom = lowest - self.thickness;
        let mut facets: Vec<[u32; D]> = Vec::new();
        let mut facet = |corners: &[u32]| facets.push(std::array::from_fn(|k| corners[k]));
        if D == 2 {
            // From right to left, so that the solid lies on the left of every edge.
            let last = rows as u32 - 1;
            points.extend([at([0, 0], bottom), at([rows - 1, 0], bottom)]);
            (0..last).for_each(|i| facet(&[i + 1, i]));
            [[0, last + 1], [last + 1, last + 2], [last + 2, last]].iter().for_each(|edge| facet(edge));
            return Ok((points, facets));
        }
        for [i, j] in (0..rows - 1).flat_map(|i| (0..columns - 1).map(move |j| [i, j])) {
            let [p, q, r, s] = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]].map(number);
            facet(&[p, q, r]);
            facet(&[p, r, s]);
        }
        // Once around the grid, counter-clockwise from above.
        let around: Vec<[usize; 2]> = ((0..rows - 1).map(|i| [i, 0]))
            .chain((0..columns - 1).map(|j| [rows - 1, j]))
            .chain((1..rows).rev().map(|i| [i, columns - 1]))
            .chain((1..columns).rev().map(|j| [0, j]))
            .collect();
        let first = points.len() as u32;
        let below = |k: usize| first + (k % around.len()) as u32;
        points.extend(around.iter().map(|&point| at(point, bottom)));
        let middle = points.len() as u32;
        let mut center = [0.0; D];
        center[D - 1] = bottom;
        points.push(center);
        for (k, &point) in around.iter().enumerate() {
            let (here, next) = (number(point), number(around[(k + 1) % around.len()]));
            facet(&[here, below(k), below(k + 1)]);
            facet(&[here, below(k + 1), next]);
            facet(&[middle, below(k + 1), below(k)]);
        }
        Ok((points, facets))
    }

    /// The lowest height of a field whose values are fit for use.
    fn check(&self, axes: usize) -> Result<f64, Error> {
        let length = |array, found, expected| {
            if found == expected { Ok(()) } else { Err(Error::Length { array, expected, found }) }
        };
        length("counts", self.counts.len(), axes)?;
        length("lengths", self.lengths.len(), axes)?;
        if let Some(axis) = self.counts.iter().position(|&count| count < 2) {
            return Err(Error::TooFewHeights { axis, count: self.counts[axis] });
        }
        let count = self.counts.iter().try_fold(1usize, |all, &count| all.checked_mul(count)).unwrap_or(usize::MAX);
        length("heights", self.heights.len(), count)?;
        for (name, value) in self.lengths.iter().map(|&l| ("length", l)).chain([("thickness", self.thickness)]) {
            positive(name, value)?;
        }
        match self.heights.iter().position(|height| !height.is_finite()) {
            Some(point) => Err(Error::NonFiniteHeight { point }),
            None => Ok(self.heights.iter().copied().fold(f64::INFINITY, f64::min)),
        }
    }
}
