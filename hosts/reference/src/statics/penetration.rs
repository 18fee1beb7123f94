//! As little penetration as is wanted, at a finite stiffness.

use super::equilibrium::Equilibrium;
use super::error::StaticsError;

/// Residual by the forces below which surfaces are moved out: an equilibrium is not waited for, since the next one is another.
const NEAR: f64 = 1e-2;

/// Part of a change that an update may leave; where it leaves more, the stiffness is raised by the factor that follows.
const SLOW: f64 = 0.25;
const RAISE: f64 = 4.0;

/// Factor, at most, by which it is raised over all load steps: where a node or two come and go, a stiffer law makes no update better.
const MOST_RAISED: f64 = 16.0;

/// The updates of a load step.
pub(super) struct Updates {
    count: usize,
    last: f64,
}

impl Default for Updates {
    fn default() -> Self {
        Self { count: 0, last: f64::INFINITY }
    }
}

impl<const D: usize> Equilibrium<D> {
    /// Largest mean penetration of a node at the last equilibrium.
    ///
    /// # Errors
    /// Those of [`Contact::nodal_penetration`](fmc_contact::Contact::nodal_penetration).
    pub fn nodal_penetration(&self) -> Result<f64, StaticsError> {
        Ok(self.contact.nodal_penetration(&self.coords(), 0.0)?)
    }

    /// Where the bodies are near an equilibrium and penetrate by more than is wanted, moves surfaces out by that; whether it did.
    pub(super) fn moves_out(
        &mut self,
        u: &[[f64; D]],
        residual: f64,
        updates: &mut Updates,
        load: f64,
    ) -> Result<bool, StaticsError> {
        let wanted = self.settings.penetration;
        if wanted == 0.0 || residual > NEAR.max(self.settings.tolerance) {
            return Ok(false);
        }
        let coords = self.placed(u);
        let found = self.contact.augment(&coords, 0.0, wanted)?;
        if found.is_enough {
            return Ok(false);
        }
        if updates.count == self.settings.most_updates {
            let penetration = found.penetration.max(found.change);
            return Err(StaticsError::Penetrates { load, penetration, updates: updates.count });
        }
        updates.count += 1;
        self.updates += 1;
        updates.last = if found.change > SLOW * updates.last && self.raised < MOST_RAISED {
            self.raised *= RAISE;
            self.contact.stiffen(RAISE)?;
            self.problem.contact.law = self.contact.options().law;
            f64::INFINITY
        } else {
            found.change
        };
        Ok(true)
    }
}
