//! The last equilibrium of a path, on the contact normals that are found where it is.

use super::equilibrium::Equilibrium;
use super::error::StaticsError;
use super::iteration::Iteration;
use super::report::Watch;
use super::search::Reached;
use std::ops::ControlFlow;

/// Iterations of a turn, at most: it begins near its end, or never gets there.
const MOST_ITERATIONS_OF_TURN: usize = 8;

/// Part of the residual that an iteration of a turn may leave. Where more of it stays, the energy has a kink: lines that run along an
/// edge are no smooth function of the displacement, and no step lowers it any more.
const LEFT_OVER: f64 = 0.5;

impl<const D: usize> Equilibrium<D> {
    /// Where the patches of the last equilibrium, found on its way, are not those that are found where it is: the relative
    /// residual on these, before the last turn that was tried. The turn led nowhere, or more of them would have been
    /// needed; the forces are those of an equilibrium all the same, along normals that are a little off.
    pub fn unturned(&self) -> Option<f64> {
        self.unturned
    }

    /// The relative residual at which the last turn came to a halt, if one did and was left out for that.
    pub fn stalled_turn(&self) -> Option<f64> {
        self.stalled_turn
    }

    /// From the last equilibrium to that on the patches that are found where it is. Those of a solve are found on its way,
    /// and what they leave of the way is up to 10⁻⁴ of the displacements; every turn takes that much of what is left.
    pub(super) fn turn_patches(&mut self, watch: Watch) -> Result<(), StaticsError> {
        if !self.problem.contact.law.is_fiber() {
            return Ok(());
        }
        let settings = self.settings;
        (self.unturned, self.stalled_turn) = (None, None);
        for _ in 0..settings.most_turns {
            let u = self.displacement.clone();
            self.keep_patches(&u)?;
            self.settings.most_iterations = MOST_ITERATIONS_OF_TURN.min(settings.most_iterations);
            let (mut first, mut last, mut stalled) = (None, f64::INFINITY, None);
            let mut progress = |at: &Iteration| {
                first = first.or(at.tangent.map(|_| at.residual));
                let is_slow = at.residual > LEFT_OVER * last && at.tangent.is_some();
                (last, stalled) = (at.residual, is_slow.then_some(at.residual));
                watch(at)?;
                if is_slow { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            };
            let turned = self.search(&u, self.load, false, &mut progress);
            self.settings = settings;
            self.unturned = first;
            match turned {
                Ok(Reached { displacement, balance }) => {
                    (self.displacement, self.balance) = (displacement, balance);
                    if self.unturned.is_none() {
                        break;
                    }
                }
                Err(StaticsError::Interrupted) if stalled.is_none() => return Err(StaticsError::Interrupted),
                // What was found remains an equilibrium, on patches of its way.
                Err(_) => {
                    self.stalled_turn = stalled.or(Some(last));
                    break;
                }
            }
        }
        Ok(())
    }
}
