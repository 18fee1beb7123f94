//! Means of a tie, or of what does not separate, where supports hold both sides: at planes of symmetry, at clamped ends.
//!
//! There the jump is what the supports say, whatever the traction. A traction that alternates from node to node, and dies out away from the supports, moves
//! hardly anything then: every update of the multipliers would add to it. Mortar methods have no multipliers of such nodes for that reason. Here
//! their multipliers follow those beside them, turned with the normal: a uniform traction stays uniform.

use super::glide::Glide;
use super::glide_energy::GlideAt;
use super::place::Weights;
use super::tie::{Tie, TieRow};
use crate::geometry::Vector;
use std::collections::BTreeMap;

/// Cosine of half the largest angle by which a traction is turned along, 120°.
const HALFWAY: f64 = 0.5;

/// Part of a normal along an axis that is not held, at most, where it is held along the normal.
const ASKEW: f64 = 1e-3;

/// Rows by the points that they are means at, with ∫ψ jump dA by the nodes.
struct Rows<'a> {
    nodes: &'a [u32],
    /// Whether a node is of the side of the hat functions.
    is_own: Vec<bool>,
    of_point: BTreeMap<u32, usize>,
    /// Point, ∫ψ dA and weights.
    rows: Vec<(u32, f64, Weights)>,
}

impl<'a> Rows<'a> {
    fn new(nodes: &'a [u32], (of_b, is_second): (&[bool], bool), rows: Vec<(u32, f64, Weights)>) -> Self {
        let is_own = of_b.iter().map(|of_b| *of_b == is_second).collect();
        let of_point = rows.iter().map(|(point, ..)| *point).zip(0..).collect();
        Self { nodes, is_own, of_point, rows }
    }

    /// By row, whether supports hold its point and what lies opposite, by axis; `is_held`: of a row, a point and an axis. Nothing where they do so nowhere.
    fn supported<const A: usize>(&self, is_held: impl Fn(usize, u32, usize) -> bool) -> Vec<[bool; A]> {
        // A point of the other side lies opposite to the row in whose mean it takes part most.
        let mut opposite = vec![(0.0, 0); self.nodes.len()];
        for (number, (_, measure, weights)) in self.rows.iter().enumerate() {
            for &(node, weight) in weights {
                let part = weight.abs() / measure;
                if part > opposite[node as usize].0 {
                    opposite[node as usize] = (part, number);
                }
            }
        }
        let mut found = vec![[false; A]; self.rows.len()];
        let others = (0..self.nodes.len()).filter(|&node| !self.is_own[node] && opposite[node].0 > 0.0);
        for (node, row) in others.map(|node| (self.nodes[node], opposite[node].1)) {
            let is_held = |axis| is_held(row, node, axis) && is_held(row, self.rows[row].0, axis);
            (0..A).for_each(|axis| found[row][axis] |= is_held(axis));
        }
        if found.as_flattened().contains(&true) { found } else { Vec::new() }
    }

    /// The mean of a value of the rows beside one that are not supported along an axis; `None` where there are none.
    fn beside<const A: usize>(
        &self,
        (number, axis): (usize, usize),
        supported: &[[bool; A]],
        value: impl Fn(usize) -> f64,
    ) -> Option<f64> {
        let (mut sum, mut whole) = (0.0, 0.0);
        for &(node, weight) in self.rows[number].2.iter().filter(|(node, _)| self.is_own[*node as usize]) {
            let other = self.of_point.get(&self.nodes[node as usize]);
            if let Some(&other) = other.filter(|&&other| weight > 0.0 && !supported[other][axis]) {
                (sum, whole) = (sum + weight * value(other), whole + weight);
            }
        }
        (whole > 0.0).then(|| sum / whole)
    }
}

impl<const D: usize> Tie<D> {
    /// Has multipliers where supports hold both sides follow those beside them; where nothing is beside them, they stay what they were before.
    /// Returns by row along which axes that is so, and nothing where it is so nowhere. `is_held`: of a point and an axis.
    pub(crate) fn follow(
        &self,
        is_held: impl Fn(u32, usize) -> bool,
        before: &[Vector<D>],
        multipliers: &mut [Vector<D>],
    ) -> Vec<[bool; D]> {
        let of_row = |row: &TieRow<D>| (row.point, row.measure, row.jump.clone());
        let rows = Rows::new(&self.nodes, (&self.of_b, self.is_second), self.rows.iter().map(of_row).collect());
        let supported = rows.supported(|_, point, axis| is_held(point, axis));
        let all = multipliers.to_vec();
        for (number, axes) in supported.iter().enumerate() {
            for axis in (0..D).filter(|&axis| axes[axis]) {
                let value = |other: usize| self.turned(all[other], [other, number])[axis];
                let stays = || before.get(number).map_or(0.0, |traction| traction[axis]);
                multipliers[number][axis] = rows.beside((number, axis), &supported, value).unwrap_or_else(stays);
            }
        }
        supported
    }

    /// A vector of one row, turned to another as on a circle through both, which the line between them meets at the same angle at either end.
    fn turned(&self, vector: Vector<D>, rows: [usize; 2]) -> Vector<D> {
        let [from, to] = rows.map(|row| &self.rows[row]);
        let halfway = (to.place - from.place).try_normalize(0.0).and_then(|line| {
            let across = from.normal - line * from.normal.dot(&line);
            (across.norm() > HALFWAY).then(|| across.normalize())
        });
        let Some(halfway) = halfway else { return vector };
        // Two reflections are a rotation by twice the angle between their normals.
        let reflected = |v: Vector<D>, n: &Vector<D>| v - n * (2.0 * v.dot(n));
        reflected(reflected(vector, &from.normal), &halfway)
    }
}

impl<const D: usize> GlideAt<'_, D> {
    /// As of a tie, with multipliers along the normal, by row.
    pub(crate) fn follow(
        &self,
        glide: &Glide<D>,
        is_held: impl Fn(u32, usize) -> bool,
        before: &BTreeMap<u32, f64>,
        multipliers: &mut [f64],
    ) -> Vec<[bool; 1]> {
        let weights = |row: usize| glide.rows[row].parts.iter().flat_map(|part| &part.apart).copied().collect();
        let of_row = |row: usize| (glide.rows[row].point, glide.rows[row].measure, weights(row));
        let sides = (&glide.of_b[..], glide.first.is_second);
        let rows = Rows::new(&glide.nodes, sides, (0..glide.rows.len()).map(of_row).collect());
        let along_normal = |row: usize, point: u32, _: usize| {
            let normal = self.normal(row);
            (0..D).all(|axis| normal[axis].abs() <= ASKEW || is_held(point, axis))
        };
        let supported = rows.supported(along_normal);
        let all = multipliers.to_vec();
        for number in (0..supported.len()).filter(|&number| supported[number][0]) {
            let stays = || before.get(&glide.rows[number].point).copied().unwrap_or(0.0);
            multipliers[number] = rows.beside((number, 0), &supported, |other| all[other]).unwrap_or_else(stays);
        }
        supported
    }
}
