//! Penetration driven to nothing at a finite stiffness.

use super::equilibrium::Equilibrium;
use super::error::StaticsError;
use super::newton::Watch;
use super::pressure::nodal_pressures;
use fmc_contact::overlap::Partner;
use fmc_contact::{EnergyLaw, FiberProfile};

/// How an augmentation went.
#[derive(Clone, Debug, PartialEq)]
pub struct Augmentation {
    /// Largest true penetration before, and after every solve.
    pub penetrations: Vec<f64>,
    /// Whether the last one is as small as was asked for.
    pub reached: bool,
}

/// A solve that leaves more than this part of the penetration is the last one.
const STALLED: f64 = 0.95;

impl<const D: usize> Equilibrium<D> {
    /// Repeats the last equilibrium with the quadratic fiber law until the true penetration is at most `target`: the method of
    /// multipliers, by Uzawa's iteration.
    ///
    /// The law's pressure is k L. What the multiplier λ of the augmented Lagrangian adds to it, k (L + λ/k), is what the law
    /// gives for bodies whose surface is farther out by λ/k. So the contact is shown one side of every pair with its nodes
    /// moved out by their pressure by k, of the solve before. That does not change during a solve, and forces and tangent
    /// remain those of one energy. At the end ∫ N_a L dA vanishes for every node in contact: one condition per node, and no
    /// more than its displacement can fulfil. Of two bodies the side with more nodes in contact is moved.
    ///
    /// # Errors
    /// Those of [`StaticsError`]; the last equilibrium is kept.
    pub fn augment(&mut self, target: f64, most: usize, watch: Watch) -> Result<Augmentation, StaticsError> {
        let mut penetrations = vec![self.true_contact()?.penetration];
        let EnergyLaw::Fiber { stiffness: k, profile: FiberProfile::Quadratic } = self.problem.contact.law else {
            let error =
                fmc_contact::Error::Unsupported { what: "augmentation of another law than the quadratic fiber law" };
            return Err(error.into());
        };
        if self.has_friction() {
            return Err(fmc_contact::Error::Unsupported { what: "augmentation of contact with friction" }.into());
        }
        let reached = |penetrations: &[f64]| penetrations.last().is_some_and(|p| *p <= target);
        for _ in 0..most {
            if reached(&penetrations) {
                break;
            }
            let next = self.next_offset(k);
            let before = std::mem::replace(&mut self.offset, next);
            match self.newton(self.displacement.clone(), self.load, watch) {
                Ok((u, balance)) => self.accept(u, balance, self.load),
                Err(error) => {
                    self.offset = before;
                    return Err(error);
                }
            }
            penetrations.push(self.true_contact()?.penetration);
            let stalled =
                penetrations.len() > 3 && penetrations.windows(2).rev().take(3).all(|pair| pair[1] > STALLED * pair[0]);
            if stalled {
                break;
            }
        }
        Ok(Augmentation { reached: reached(&penetrations), penetrations })
    }

    /// Offset of every node for the next solve: pressure by stiffness, against the force.
    fn next_offset(&self, k: f64) -> Vec<[f64; D]> {
        let mut offset = vec![[0.0; D]; self.displacement.len()];
        let forces = &self.balance.contact.forces;
        for pair in &self.balance.contact.pairs {
            let sides = [pair.a, pair.b].into_iter().filter_map(|side| match side {
                Partner::Body(part) => Some(nodal_pressures(&self.problem.model, part, forces)),
                Partner::Obstacle(_) => None,
            });
            // Of equals the first.
            let moved = sides.reduce(|first, second| if second.len() > first.len() { second } else { first });
            for at in moved.into_iter().flatten() {
                let size = forces[at.node].iter().map(|f| f * f).sum::<f64>().sqrt();
                offset[at.node] = forces[at.node].map(|f| -f / size * at.pressure / k);
            }
        }
        offset
    }
}
