//! Which equations are kept for the contact, and in which order.

use super::equilibrium::Equilibrium;
use super::kept_equations::{Kept, rounding};
use fmc_contact::sparse::{Entries, Lower};

/// Equations on which contact acts, at most.
const MOST_KEPT: usize = 6000;

/// Part of all equations up to which those are kept as well that contact touches without stiffness. What touches at its side alone,
/// as a plane of symmetry does below another body, may get some later, or never.
const IDLE: f64 = 0.05;

impl<const D: usize> Equilibrium<D> {
    /// Equations that are kept for the contact, of the last factors.
    pub fn kept_count(&self) -> usize {
        self.kept.equations().len()
    }

    /// Sparse matrices factorised.
    pub fn factorisations(&self) -> usize {
        self.system.count + self.bulk.count
    }

    /// Substitutions through the whole factors of the bodies; two are a solution.
    pub fn passes(&self) -> usize {
        self.system.passes.get() + self.bulk.passes.get()
    }

    /// Factorises the bodies down to the equations on which contact acts by some entries and forces, if that is of use.
    ///
    /// What contact acts on in a deep overlap is more than what it will act on in the end: bodies give way. So equations come in
    /// the order of how far their nodes are from being free: those that will be so first.
    pub(super) fn condense(&mut self, u: &[[f64; D]], elastic: &Lower, entries: &Entries, forces: &[[f64; D]]) -> bool {
        let mut found = Kept::new(self.by_depth(entries, forces), self.equation_count);
        if found.equations().len() > MOST_KEPT {
            return false;
        }
        // Factors of linear bodies hold wherever contact acts on what they have kept, and keep more and more as it moves.
        let known = &self.kept;
        if self.is_linear() && self.ground.is_empty() && self.bulk.is_factorised() {
            if found.equations().iter().all(|equation| known.place(*equation).is_some()) {
                return true;
            }
            let others = known.equations().iter().filter(|equation| found.place(**equation).is_none());
            let all: Vec<usize> = others.chain(found.equations()).copied().collect();
            if all.len() <= MOST_KEPT {
                found = Kept::new(all, self.equation_count);
            }
        }
        // Bodies that only contact holds stand on that of now.
        self.ground = if self.free_motions(u).is_empty() { Vec::new() } else { entries.clone() };
        self.kept = found;
        if self.ground.is_empty() {
            self.bulk.factorise(elastic, self.kept.equations())
        } else {
            let whole = elastic.entries().chain(self.ground.iter().copied());
            self.bulk.factorise(&Lower::new(self.equation_count, whole), self.kept.equations())
        }
    }

    /// Equations of some entries, those of the nodes that are nearest to being free first: by their force over the stiffness of
    /// the contact along it.
    fn by_depth(&self, entries: &Entries, forces: &[[f64; D]]) -> Vec<usize> {
        let mut stiffness = vec![[[0.0; D]; D]; forces.len()];
        let (mut is_there, mut is_stiff) = (vec![false; self.equation_count], vec![false; self.equation_count]);
        let least = rounding(entries);
        for &(row, column, value) in entries {
            (is_there[row], is_there[column]) = (true, true);
            if value.abs() > least {
                (is_stiff[row], is_stiff[column]) = (true, true);
            }
            let [(node, i), (other, j)] = [row, column].map(|equation| self.freedom(equation));
            if node == other {
                stiffness[node][i][j] += value;
                if i != j {
                    stiffness[node][j][i] += value;
                }
            }
        }
        let depth = |node: usize| {
            let (force, stiffness) = (&forces[node], &stiffness[node]);
            let square: f64 = force.iter().map(|f| f * f).sum();
            let along: f64 = (0..D).map(|k| (0..D).map(|l| force[k] * stiffness[k][l] * force[l]).sum::<f64>()).sum();
            if along > 0.0 { square.sqrt() * square / along } else { 0.0 }
        };
        let depths: Vec<f64> = (0..forces.len()).map(depth).collect();
        let few = (IDLE * self.equation_count as f64) as usize;
        let is_wanted = if is_there.iter().filter(|is| **is).count() <= few { is_there } else { is_stiff };
        let mut equations: Vec<usize> = (0..self.equation_count).filter(|equation| is_wanted[*equation]).collect();
        equations.sort_by(|a, b| depths[self.freedom(*a).0].total_cmp(&depths[self.freedom(*b).0]));
        equations
    }

    /// Node and axis of an equation.
    fn freedom(&self, equation: usize) -> (usize, usize) {
        (self.freedoms[equation] as usize / D, self.freedoms[equation] as usize % D)
    }
}
