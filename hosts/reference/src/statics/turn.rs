//! The last equilibrium of a path, on the contact normals that are found where it is.

use super::equilibrium::Equilibrium;
use super::error::StaticsError;
use super::newton::Watch;

/// Iterations of a turn, at most: it begins near its end, or never gets there.
const MOST_ITERATIONS_OF_TURN: usize = 8;

impl<const D: usize> Equilibrium<D> {
    /// Where the patches of the last equilibrium, found on its way, are not those that are found where it is: the relative
    /// residual on these, before the last turn that was tried. The turn led nowhere, or more of them would have been
    /// needed; the forces are those of an equilibrium all the same, along normals that are a little off.
    pub fn unturned(&self) -> Option<f64> {
        self.unturned
    }

    /// From the last equilibrium to that on the patches that are found where it is. Those of a solve are found on its way,
    /// and what they leave of the way is up to 10⁻⁴ of the displacements; every turn takes that much of what is left.
    pub(super) fn turn_patches(&mut self, watch: Watch) -> Result<(), StaticsError> {
        if !self.problem.contact.law.is_fiber() {
            return Ok(());
        }
        let settings = self.settings;
        self.unturned = None;
        for _ in 0..settings.most_turns {
            let u = self.displacement.clone();
            self.keep_patches(&u)?;
            let balance = self.evaluate(&u, self.load)?;
            if balance.relative() <= self.settings.tolerance {
                (self.balance, self.unturned) = (balance, None);
                break;
            }
            self.unturned = Some(balance.relative());
            self.settings.most_iterations = MOST_ITERATIONS_OF_TURN.min(settings.most_iterations);
            let turned = self.newton(u, self.load, watch);
            self.settings = settings;
            match turned {
                Ok(found) => (self.displacement, self.balance) = found,
                Err(StaticsError::Interrupted) => return Err(StaticsError::Interrupted),
                // What was found remains an equilibrium, on patches of its way.
                Err(_) => break,
            }
        }
        Ok(())
    }
}
