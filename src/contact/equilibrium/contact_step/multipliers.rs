//! Pressures at nodes in place of a law, for as little penetration as is wanted: an augmented Lagrangian.
//!
//! The pressure at a node is p = max(0, λ − k g) with its mean gap g and a multiplier λ, and acts with A ∂g/∂x, A being its area.
//! After each equilibrium λ becomes p, and the next one penetrates less at the same k. See Alart and Curnier, CMAME 92
//! (1991), without friction; the updates are Uzawa's.

use super::kept::Kept;
use super::touching::{Touch, Touching};
use crate::Error;
use crate::contact::evaluation::kernels;
use crate::contact::results::GapConstraints;
use crate::contact::tangents::TangentPart;
use crate::overlap::Partner;
use nalgebra::{DMatrix, DVector};
use std::collections::BTreeMap;

/// A node, its body and the partner.
type Row = (u32, [Partner; 2]);

/// A contact with multipliers.
pub(super) struct Multipliers<'k, 'a, 'p, const D: usize> {
    kept: &'k mut Kept<'a, 'p, D>,
    reach: f64,
    /// Pressure by penetration.
    pub(super) stiffness: f64,
    multipliers: BTreeMap<Row, f64>,
    /// The side of two bodies that has them: the first, or the second.
    sides: BTreeMap<[Partner; 2], bool>,
}

/// What an update of the multipliers says of the equilibrium.
#[derive(Clone, Copy)]
pub(super) struct Update {
    /// Largest mean penetration at a node.
    pub(super) penetration: f64,
    /// Largest change of a multiplier, by k: how far a node that is pressed is from the surface, inside or outside.
    pub(super) change: f64,
}

/// Gaps of one side of every pair, and the pressures there.
struct Pressed<const D: usize> {
    gaps: GapConstraints<D>,
    /// Rows, with their pressures.
    rows: Vec<(usize, f64)>,
}

impl<const D: usize> Pressed<D> {
    /// ∂g/∂x of a row by degree of freedom.
    fn slopes(&self, row: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        let entries = self.gaps.row_starts[row]..self.gaps.row_starts[row + 1];
        entries.flat_map(|entry| {
            let node = self.gaps.columns[entry] as usize;
            self.gaps.slopes[entry].iter().enumerate().map(move |(axis, slope)| (node * D + axis, *slope))
        })
    }

    /// Mean gap of a row.
    fn gap(&self, row: usize) -> f64 {
        self.gaps.gaps[row] / self.gaps.areas[row]
    }
}

impl<'k, 'a, 'p, const D: usize> Multipliers<'k, 'a, 'p, D> {
    /// Without any, with which p is k times the penetration.
    pub(super) fn new(kept: &'k mut Kept<'a, 'p, D>, reach: f64, stiffness: f64) -> Self {
        Self { kept, reach, stiffness, multipliers: BTreeMap::new(), sides: BTreeMap::new() }
    }

    fn pressed(&mut self, displacement: &DVector<f64>) -> Result<Pressed<D>, Error> {
        let coords = self.kept.placed(displacement)?;
        let gaps = kernels::gap_constraints(self.kept.contact, &coords, self.reach)?;
        self.choose_sides(&gaps);
        let is_mine = |row: &usize| gaps.areas[*row] > 0.0 && self.has_multipliers(gaps.partners[*row]);
        let pressure = |row: usize| {
            let multiplier = self.multipliers.get(&(gaps.nodes[row], gaps.partners[row])).copied().unwrap_or(0.0);
            (row, (multiplier - self.stiffness * gaps.gaps[row] / gaps.areas[row]).max(0.0))
        };
        let rows = (0..gaps.gaps.len()).filter(is_mine).map(pressure).collect();
        Ok(Pressed { gaps, rows })
    }

    /// Of two bodies the one with more nodes there when they meet, of equals the first.
    fn choose_sides(&mut self, gaps: &GapConstraints<D>) {
        let mut counts: BTreeMap<[Partner; 2], [usize; 2]> = BTreeMap::new();
        for (partners, _) in gaps.partners.iter().zip(&gaps.areas).filter(|(_, area)| **area > 0.0) {
            let is_second = partners[0] > partners[1];
            counts.entry(sorted(*partners)).or_default()[usize::from(is_second)] += 1;
        }
        for (pair, [first, second]) in counts {
            self.sides.entry(pair).or_insert(second > first);
        }
    }

    /// Whether a row of these partners counts; an obstacle has no rows.
    fn has_multipliers(&self, partners: [Partner; 2]) -> bool {
        let is_second = partners[0] > partners[1];
        let of_bodies = matches!(partners, [Partner::Body(_), Partner::Body(_)]);
        !of_bodies || self.sides.get(&sorted(partners)).is_some_and(|chosen| *chosen == is_second)
    }

    /// Pressures become multipliers.
    pub(super) fn update(&mut self, displacement: &DVector<f64>) -> Result<Update, Error> {
        let pressed = self.pressed(displacement)?;
        let gaps = &pressed.gaps;
        let key = |row: usize| (gaps.nodes[row], gaps.partners[row]);
        let before = |row: usize| self.multipliers.get(&key(row)).copied().unwrap_or(0.0);
        let changes = pressed.rows.iter().map(|&(row, pressure)| (pressure - before(row)).abs());
        let update = Update {
            penetration: pressed.rows.iter().map(|&(row, _)| -pressed.gap(row)).fold(0.0, f64::max),
            change: changes.fold(0.0, f64::max) / self.stiffness,
        };
        self.multipliers = pressed.rows.iter().map(|&(row, pressure)| (key(row), pressure)).collect();
        Ok(update)
    }
}

fn sorted([p, q]: [Partner; 2]) -> [Partner; 2] {
    if p < q { [p, q] } else { [q, p] }
}

impl<const D: usize> Touching for Multipliers<'_, '_, '_, D> {
    /// Areas are taken as they are, so that there is no energy.
    fn at(&mut self, displacement: &DVector<f64>) -> Result<Touch, Error> {
        let pressed = self.pressed(displacement)?;
        let mut forces = vec![0.0; self.kept.freedom_count()];
        for &(row, pressure) in pressed.rows.iter().filter(|(_, pressure)| *pressure > 0.0) {
            pressed.slopes(row).for_each(|(freedom, slope)| forces[freedom] += pressure * slope);
        }
        Ok(self.kept.touch(0.0, &forces))
    }

    fn tangent(&mut self, displacement: &DVector<f64>, _: TangentPart) -> Result<DMatrix<f64>, Error> {
        let pressed = self.pressed(displacement)?;
        let mut dense = DMatrix::zeros(displacement.len(), displacement.len());
        for &(row, _) in pressed.rows.iter().filter(|(_, pressure)| *pressure > 0.0) {
            let stiffness = self.stiffness / pressed.gaps.areas[row];
            let entries: Vec<(usize, f64)> =
                pressed.slopes(row).filter_map(|(freedom, slope)| Some((self.kept.local(freedom)?, slope))).collect();
            for (col, other) in &entries {
                entries.iter().for_each(|(row, slope)| dense[(*row, *col)] += stiffness * slope * other);
            }
        }
        Ok(dense)
    }

    fn freedom(&self, place: usize) -> usize {
        self.kept.freedom(place)
    }

    fn node(&self, place: usize) -> usize {
        self.kept.node(place)
    }

    fn start(&self, place: usize) -> f64 {
        self.kept.start(place)
    }
}
