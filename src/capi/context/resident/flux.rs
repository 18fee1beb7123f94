//! Scalar fields through contact.

use super::Resident;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::pointer::slice;
use crate::capi::structs::view::{check_node_count, fmc_coords};
use crate::contact::{Conductance, ContactFlux, FluxRequest, FrictionHeat};

impl<const D: usize> Resident<D> {
    /// The flux of fields, which come as their number, their values at the nodes, and those at the obstacles or NULL.
    pub(crate) unsafe fn flux(
        &mut self,
        coords: &fmc_coords,
        conductance: &Conductance,
        (count, fields, of_obstacles): (usize, *const f64, *const f64),
        index_base: i32,
    ) -> Result<ContactFlux, Failure> {
        let (nodes, obstacles) = (self.held.contact().surface().unknown_count(), self.held.contact().obstacle_count());
        check_node_count(coords.node_count, nodes)?;
        // SAFETY: passed on to the caller.
        unsafe {
            let fields = slice("fields", fields, nodes, count)?;
            let of_obstacles = match of_obstacles.is_null() {
                true => None,
                false => Some(slice("of_obstacles", of_obstacles, obstacles, count)?),
            };
            let request = FluxRequest { fields, of_obstacles, conductance };
            self.at(coords, index_base, |contact, rows| contact.flux(rows, &request))
        }
    }

    /// The heat of friction; effusivities may be NULL.
    pub(crate) unsafe fn friction_heat(
        &mut self,
        coords: &fmc_coords,
        effusivities: *const f64,
        index_base: i32,
    ) -> Result<FrictionHeat, Failure> {
        let contact = self.held.contact();
        let count = contact.surface().body_count() + contact.obstacle_count();
        // SAFETY: passed on to the caller.
        unsafe {
            let given = match effusivities.is_null() {
                true => None,
                false => Some(slice("effusivities", effusivities, count, 1)?),
            };
            self.at(coords, index_base, |contact, rows| contact.friction_heat(rows, given))
        }
    }
}
