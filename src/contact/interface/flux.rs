//! Scalar fields through contact, and the heat of friction.

use crate::Error;
use crate::contact::evaluation::{Contact, kernels};
use crate::contact::flux::{ContactFlux, FluxRequest};
use crate::contact::results::FrictionHeat;

impl<const D: usize> Contact<D> {
    /// What flows through the contact at `coords`, of heat or of charge: ∫ N h (T − T_other) dA out of every node, T being a field and T_other
    /// that on the other side, and the derivative of it by the field. With axisymmetry dA is that of rings.
    ///
    /// Both sides are taken at material points of their surfaces that face one another, along the normal of either side by turns. The pressure,
    /// of which h depends, is that of the law at the penetration there. Bodies that are tied, glued or do not separate conduct
    /// where they are held.
    ///
    /// # Errors
    /// [`Error::Length`], [`Error::BadEntry`], [`Error::Unsupported`] for a mesh in parts, [`Error::Untied`]; else as [`Self::evaluate`], but for
    /// friction.
    #[inline(never)]
    pub fn flux(&self, coords: &[[f64; D]], request: &FluxRequest) -> Result<ContactFlux, Error> {
        let (nodes, obstacles) = (self.mesh.surface.unknown_count(), self.partners.obstacles.count());
        let fields = request.check(nodes, obstacles)?;
        let entries = kernels::flux(self, coords, request)?;
        let is_partition = self.mesh.surface.division().is_none_or(|division| !division.has_basis());
        ContactFlux::new(&entries, request, [nodes, obstacles, fields], is_partition)
    }

    /// The energy that friction has dissipated since the step began, as heat at the nodes and obstacles; its sum is that of the pairs. Divided by
    /// the time of the step it is a power. Of what a facet dissipates each side takes a part by its effusivity √(k ρ c), or half.
    ///
    /// `effusivities` are those of all bodies, then of all obstacles, removed ones included; 0: the side takes nothing.
    ///
    /// # Errors
    /// [`Error::Length`], [`Error::BadEntry`], [`Error::NoStep`], [`Error::Unsupported`] for a mesh in parts; else as [`Self::evaluate`].
    #[inline(never)]
    pub fn friction_heat(&self, coords: &[[f64; D]], effusivities: Option<&[f64]>) -> Result<FrictionHeat, Error> {
        self.mesh.surface.refuse_submesh("the heat of friction of a mesh in parts")?;
        if let Some(given) = effusivities {
            let (array, expected) = ("effusivities", self.mesh.surface.body_count() + self.partners.obstacles.count());
            if given.len() != expected {
                return Err(Error::Length { array, expected, found: given.len() });
            }
            if let Some(entry) = given.iter().position(|value| !(value.is_finite() && *value >= 0.0)) {
                return Err(Error::BadEntry { array, entry, value: given[entry] });
            }
        }
        kernels::friction_heat(self, coords, effusivities)
    }
}
