//! The last equilibrium of a path, on the contact normals that are found where it is.

use super::equilibrium::Equilibrium;
use super::error::StaticsError;
use super::newton::Watch;

/// Times that the patches are found anew at the end of a path; three or four do.
const MOST_TURNS: usize = 6;

/// Iterations of a turn, at most: it begins near its end, or never gets there.
const MOST_ITERATIONS_OF_TURN: usize = 8;

impl<const D: usize> Equilibrium<D> {
    /// From the last equilibrium to that on the patches that are found where it is. Those of a solve are found on its way,
    /// and what they leave of the way is up to 10⁻⁴ of the displacements; every turn takes that much of what is left.
    pub(super) fn turn_patches(&mut self, watch: Watch) -> Result<(), StaticsError> {
        if !self.problem.contact.law.is_fiber() {
            return Ok(());
        }
        let settings = self.settings;
        for _ in 0..MOST_TURNS {
            let u = self.displacement.clone();
            self.keep_patches(&u)?;
            let balance = self.evaluate(&u, self.load)?;
            if balance.relative() <= self.settings.tolerance {
                self.balance = balance;
                break;
            }
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
