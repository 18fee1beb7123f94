//! Which unknown of a host moves which coordinate of the contact.

use crate::Error;
use crate::contact::ties::Supports;
use nalgebra::DVector;
use std::collections::BTreeMap;

/// The unknowns of a host, in the contact's eyes: x = base + the unknown, coordinate by coordinate.
#[derive(Clone, Debug, PartialEq)]
pub struct Unknowns<const D: usize> {
    /// Number of the host's unknowns.
    pub count: usize,
    /// Unknown of every coordinate of the contact, `row * D + axis`; `None` for one that never moves.
    pub of_coordinate: Vec<Option<usize>>,
    /// Further unknowns of coordinates that follow several, by the same numbers: each with its weight, by which it moves the coordinate, too. Linear
    /// constraints that a host eliminates are such: the unknown of the coordinate itself is then the constant of the constraint, and not free.
    pub weighted: BTreeMap<usize, Vec<(usize, f64)>>,
    /// Coordinates of the contact where all unknowns are zero.
    pub base: Vec<[f64; D]>,
    /// Whether an unknown is solved for, by unknown.
    pub free: Vec<bool>,
}

impl<const D: usize> Unknowns<D> {
    /// # Errors
    /// [`Error::Length`], [`Error::UnknownOutOfRange`], [`Error::NonFiniteCoordinate`].
    pub(in crate::contact::equilibrium) fn check(&self, row_count: usize) -> Result<(), Error> {
        let lengths = [
            ("base", row_count, self.base.len()),
            ("of_coordinate", row_count * D, self.of_coordinate.len()),
            ("free", self.count, self.free.len()),
        ];
        for (array, expected, found) in lengths {
            if expected != found {
                return Err(Error::Length { array, expected, found });
            }
        }
        for (place, unknown) in self.of_coordinate.iter().enumerate() {
            if let Some(unknown) = unknown.filter(|unknown| *unknown >= self.count) {
                return Err(Error::UnknownOutOfRange { row: place / D, unknown: unknown as i64, count: self.count });
            }
        }
        for (&place, weights) in &self.weighted {
            if place >= row_count * D {
                return Err(Error::Length { array: "weighted", expected: row_count * D, found: place + 1 });
            }
            for &(unknown, weight) in weights {
                if unknown >= self.count {
                    return Err(Error::UnknownOutOfRange {
                        row: place / D,
                        unknown: unknown as i64,
                        count: self.count,
                    });
                }
                if !weight.is_finite() {
                    return Err(Error::NonFiniteCoordinate { node: place / D, axis: place % D });
                }
            }
        }
        match self.base.as_flattened().iter().position(|x| !x.is_finite()) {
            Some(place) => Err(Error::NonFiniteCoordinate { node: place / D, axis: place % D }),
            None => Ok(()),
        }
    }

    /// Unknowns that move a coordinate, each with its weight.
    pub(crate) fn of(&self, place: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        let own = self.of_coordinate[place].map(|unknown| (unknown, 1.0));
        own.into_iter().chain(self.weighted.get(&place).into_iter().flatten().copied())
    }

    /// Whether an unknown moves several coordinates.
    pub(crate) fn are_shared(&self) -> bool {
        let mut is_taken = vec![false; self.count];
        !self.weighted.is_empty()
            || self.of_coordinate.iter().flatten().any(|&unknown| std::mem::replace(&mut is_taken[unknown], true))
    }

    /// Coordinates that nothing free moves.
    pub(crate) fn supports(&self) -> Supports {
        Supports::new((0..self.of_coordinate.len()).map(|place| self.is_held(place)))
    }

    /// Whether nothing that is solved for moves a coordinate.
    pub(crate) fn is_held(&self, place: usize) -> bool {
        self.of(place).all(|(unknown, weight)| weight == 0.0 || !self.free[unknown])
    }

    /// Coordinates of the contact.
    pub(in crate::contact::equilibrium) fn coords(&self, x: &[f64]) -> Vec<[f64; D]> {
        let mut coords = self.base.clone();
        for (coordinate, unknown) in coords.as_flattened_mut().iter_mut().zip(&self.of_coordinate) {
            *coordinate += unknown.map_or(0.0, |unknown| x[unknown]);
        }
        self.add_weighted(x, coords.as_flattened_mut());
        coords
    }

    /// Motion of the coordinates.
    pub(in crate::contact::equilibrium) fn spread(&self, step: &[f64]) -> Vec<[f64; D]> {
        let mut motion = vec![[0.0; D]; self.base.len()];
        for (entry, unknown) in motion.as_flattened_mut().iter_mut().zip(&self.of_coordinate) {
            *entry = unknown.map_or(0.0, |unknown| step[unknown]);
        }
        self.add_weighted(step, motion.as_flattened_mut());
        motion
    }

    /// What coordinates move by their further unknowns.
    fn add_weighted(&self, x: &[f64], coordinates: &mut [f64]) {
        for (&place, weights) in &self.weighted {
            coordinates[place] += weights.iter().map(|&(unknown, weight)| weight * x[unknown]).sum::<f64>();
        }
    }

    /// From unknowns that have the motion of their own coordinates, what the further ones of these move.
    pub(crate) fn subtract_weighted(&self, x: &mut [f64]) {
        let moved = |(&place, weights): (&usize, &Vec<(usize, f64)>)| {
            Some((
                self.of_coordinate[place]?,
                weights.iter().map(|&(unknown, weight)| weight * x[unknown]).sum::<f64>(),
            ))
        };
        let all: Vec<(usize, f64)> = self.weighted.iter().filter_map(moved).collect();
        all.into_iter().for_each(|(unknown, motion)| x[unknown] -= motion);
    }

    /// Displacements of the coordinates as those of the unknowns.
    pub(crate) fn gathered(&self, rows: &[[f64; D]]) -> Vec<f64> {
        let mut all = vec![0.0; self.count];
        for (entry, unknown) in rows.as_flattened().iter().zip(&self.of_coordinate) {
            if let Some(unknown) = unknown {
                all[*unknown] = *entry;
            }
        }
        self.subtract_weighted(&mut all);
        all
    }

    /// Forces on the coordinates, or what else is a derivative, on the unknowns.
    pub(in crate::contact::equilibrium) fn gather(&self, rows: &[[f64; D]]) -> Vec<f64> {
        let mut all = vec![0.0; self.count];
        for (entry, unknown) in rows.as_flattened().iter().zip(&self.of_coordinate) {
            if let Some(unknown) = unknown {
                all[*unknown] += entry;
            }
        }
        for (&place, weights) in &self.weighted {
            let entry = rows[place / D][place % D];
            weights.iter().for_each(|&(unknown, weight)| all[unknown] += weight * entry);
        }
        all
    }

    /// A vector with zeros at unknowns that are not free.
    pub(in crate::contact::equilibrium) fn freed(&self, mut vector: Vec<f64>) -> Vec<f64> {
        vector.iter_mut().zip(&self.free).for_each(|(entry, free)| *entry = if *free { *entry } else { 0.0 });
        vector
    }

    /// Euclidean norm over the free unknowns.
    pub(crate) fn free_norm(&self, vector: &[f64]) -> f64 {
        vector.iter().zip(&self.free).map(|(entry, free)| if *free { entry * entry } else { 0.0 }).sum::<f64>().sqrt()
    }
}

pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

pub(crate) fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}

pub(crate) fn largest(a: &[f64]) -> f64 {
    a.iter().fold(0.0, |most: f64, entry| most.max(entry.abs()))
}

/// a + t b.
pub(crate) fn moved(a: &[f64], t: f64, b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a + t * b).collect()
}

/// Σ q v.
pub(crate) fn combined(fields: &[Vec<f64>], q: &DVector<f64>) -> Vec<f64> {
    let mut sum = vec![0.0; fields.first().map_or(0, Vec::len)];
    for (field, part) in fields.iter().zip(q.iter()).filter(|(_, part)| **part != 0.0) {
        sum.iter_mut().zip(field).for_each(|(entry, value)| *entry += part * value);
    }
    sum
}
