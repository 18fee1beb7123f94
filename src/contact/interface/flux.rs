//! Scalar fields through contact.

use crate::Error;
use crate::contact::evaluation::{Contact, kernels};
use crate::contact::flux::{ContactFlux, FluxRequest};

impl<const D: usize> Contact<D> {
    /// What flows through the contact at `coords`, of heat or of charge: ∫ N h (T − T_other) dA out of every node, T being a field and T_other
    /// that on the other side, and the derivative of it by the field. With axisymmetry dA is that of rings.
    ///
    /// Both sides are taken at material points of their surfaces that face one another, along the normal of either side by turns. The pressure,
    /// of which h depends, is that of the law at the penetration there. Bodies that are tied conduct where they are tied.
    ///
    /// # Errors
    /// [`Error::Length`], [`Error::BadEntry`], [`Error::Unsupported`] for a mesh in parts, [`Error::Untied`]; else as [`Self::evaluate`], but for
    /// friction.
    pub fn flux(&self, coords: &[[f64; D]], request: &FluxRequest) -> Result<ContactFlux, Error> {
        let (nodes, obstacles) = (self.mesh.surface.unknown_count(), self.partners.obstacles.count());
        let fields = request.check(nodes, obstacles)?;
        let entries = kernels::flux(self, coords, request)?;
        let is_partition = self.mesh.surface.division().is_none_or(|division| !division.has_basis());
        ContactFlux::new(&entries, request, [nodes, obstacles, fields], is_partition)
    }
}
