//! Derivatives.

use super::Resident;
use crate::capi::boundary::failure::Failure;
use crate::capi::structs::gradients::{GradientLists, fmc_pair_gradient};
use crate::capi::structs::view::{check_node_count, fmc_coords};
use crate::contact::GradientRequest;

impl<const D: usize> Resident<D> {
    /// The derivatives of `energy` times the energy and `adjoint` times the forces.
    pub(crate) unsafe fn vjp(
        &mut self,
        coords: &fmc_coords,
        (energy, adjoint): (f64, Option<&fmc_coords>),
        request: &GradientRequest,
        index_base: i32,
    ) -> Result<GradientLists, Failure> {
        let mut room = Vec::new();
        let adjoint = match adjoint {
            Some(view) => {
                check_node_count(view.node_count, self.held.contact().surface().unknown_count())?;
                // SAFETY: passed on to the caller.
                Some(unsafe { view.rows::<D>("adjoint", &mut room) }?)
            }
            None => None,
        };
        // SAFETY: passed on to the caller.
        let found =
            unsafe { self.at(coords, index_base, |contact, rows| contact.vjp(rows, energy, adjoint, request)) }?;
        let flat = |rows: &[[f64; D]]| rows.as_flattened().to_vec();
        let rotations = found.rotations.as_flattened().to_vec();
        Ok(GradientLists {
            by_place: [flat(&found.coords), flat(&found.reference), flat(&found.positions), rotations],
            pairs: found.pairs.iter().map(fmc_pair_gradient::from).collect(),
        })
    }
}
