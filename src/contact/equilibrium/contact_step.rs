//! Equilibrium of the contact with bodies that are linear, condensed on the degrees of freedom on which contact acts.
//!
//! Contact acts on few nodes, and opens and closes; the bodies are many equations, and nearly linear. So a host factorises
//! its bodies once, down to these degrees of freedom, and what is iterated here is dense and small, with the contact as it is.

mod bodies;
mod dense;
mod iterate;
mod kept;
#[cfg(feature = "solver")]
mod large;
mod newton;
mod options;
#[cfg(feature = "solver")]
mod reduced;
mod soft_start;
mod solve;
mod touching;

pub use bodies::CondensedBodies;
pub use options::{ContactStep, ContactStepOptions, ContactStepState};

use crate::Error;
use crate::contact::evaluation::Contact;
use bodies::Checked;
use kept::Kept;

/// Puts the nodes where they are at a displacement of the degrees of freedom on the list: it is given the displacement, and
/// the coordinates with it added, and moves the nodes that follow.
pub type Place<'a, const D: usize> = &'a mut dyn FnMut(&[f64], &mut [[f64; D]]) -> Result<(), Error>;

impl<const D: usize> Contact<D> {
    /// The displacement d of some degrees of freedom for which `S d + r − f(x + d) = 0`: equilibrium of the contact forces f with
    /// bodies whose stiffness S and residual r without contact have been condensed on these degrees of freedom.
    ///
    /// By Newton's method for the energy `r·d + ½ d·S d + w(x + d)`, along whose directions it is lowered: with the semidefinite
    /// tangent as long as the residual is large, with the full one then. Frozen friction has an energy, too. Friction with
    /// the current pressure has none: the matrix is then unsymmetric, and what is lowered is the residual.
    ///
    /// `place` moves the nodes that follow those on the list; without it they stay. It must not move what is on the list. Where bodies
    /// move by more than a part of a cell it is needed, since cells whose other nodes stay would be inverted, and depth is
    /// that of cells. Results that a law or an estimator does not have the gradient of an energy for (sampled lines with the
    /// momentum correction, patches that are not kept) may end the iterations early; the state then says so.
    ///
    /// For less penetration than the law leaves, call [`Self::augment`] where the step has led, and take the step again.
    ///
    /// # Errors
    /// Those of [`Self::tangent`] at `coords`. [`Error::Length`], [`Error::DofOutOfRange`], [`Error::RepeatedDof`],
    /// [`Error::NonFiniteStiffness`], [`Error::NotPositive`] for what is given; [`Error::IndefiniteStiffness`] and
    /// [`Error::SingularStiffness`] where the bodies together with the contact hold nothing; [`Error::Unsupported`] for a penetration asked for with
    /// friction, self-contact, or a law without a stiffness by penetration; those of `place`.
    #[inline(never)]
    pub fn contact_step(
        &self,
        coords: &[[f64; D]],
        bodies: &CondensedBodies,
        options: &ContactStepOptions,
        place: Option<Place<D>>,
    ) -> Result<ContactStep, Error> {
        options.check()?;
        let expected = self.mesh.surface.unknown_count();
        if coords.len() != expected {
            return Err(Error::Length { array: "coords", expected, found: coords.len() });
        }
        let checked = Checked::new(bodies, expected * D)?;
        let is_without = self.history.sticking == 0.0 || !self.partners.has_friction(self.method.options());
        let has_energy = self.history.frozen.is_some() || is_without;
        // The tangent of an interface that breaks, or of one by a law of the host, is not symmetric.
        let has_energy = has_energy && !self.has_history();
        let mut contact = Kept::new(self, coords, bodies, place);
        solve::solve(&checked, &mut contact, options, has_energy)
    }
}
