//! What an equilibrium has taken, and whether there is friction.

use super::equilibrium::Equilibrium;
use super::error::StaticsError;
use fmc_contact::contact::equilibrium::Unheld;

impl<const D: usize> Equilibrium<D> {
    /// Equations that are kept for the contact.
    pub fn kept_count(&self) -> usize {
        self.matrices.condensed.count()
    }

    /// Sparse matrices factorised.
    pub fn factorisations(&self) -> usize {
        self.matrices.system.count + self.matrices.condensed.factorisations
    }

    /// Substitutions through the whole factors of the bodies; two are a solution.
    pub fn passes(&self) -> usize {
        self.matrices.system.passes.get() + self.matrices.condensed.passes()
    }

    /// Largest mean penetration of a node at the last equilibrium.
    ///
    /// # Errors
    /// Those of [`Contact::nodal_penetration`](fmc_contact::Contact::nodal_penetration).
    pub fn nodal_penetration(&self) -> Result<f64, StaticsError> {
        Ok(self.contact.nodal_penetration(&self.coords(), 0.0)?)
    }

    /// Whether contact resists sliding.
    pub(super) fn has_friction(&self) -> bool {
        self.contact.has_friction()
    }

    /// Name of a body, and how it moves.
    pub(super) fn motion_of(&self, unheld: &Unheld) -> (String, String) {
        let along = |axis: &usize| unheld.direction[*axis].abs();
        let most = (0..D).max_by(|p, q| along(p).total_cmp(&along(q))).unwrap_or(0);
        let motion = match unheld.is_rotation {
            true => "rotation".to_owned(),
            false => format!("translation along {}", ["x", "y", "z"][most]),
        };
        (self.problem.model.parts()[unheld.body as usize].name.clone(), motion)
    }
}
