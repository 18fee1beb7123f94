//! What is evaluated.

use super::Resident;
use crate::capi::boundary::failure::Failure;
use crate::capi::structs::contact_point::fmc_contact_point;
use crate::capi::structs::evaluation::Evaluation;
use crate::capi::structs::gap_constraint::KeptGaps;
use crate::capi::structs::kept_tangent::Kept;
use crate::capi::structs::nodal_lists::NodalLists;
use crate::capi::structs::placement::Placement;
use crate::capi::structs::view::{fmc_coords, fmc_forces};
use crate::contact::{CondensedBodies, ContactStep, ContactStepOptions, Place, TangentPart};

impl<const D: usize> Resident<D> {
    /// Evaluates, and writes the forces, if wanted, on success.
    pub(crate) unsafe fn evaluate(
        &mut self,
        coords: &fmc_coords,
        forces: Option<&fmc_forces>,
        add: bool,
        index_base: i32,
    ) -> Result<Evaluation, Failure> {
        // SAFETY: passed on to the caller.
        let found = unsafe {
            self.evaluated(coords, forces, add, index_base, |contact, rows| Ok((contact.evaluate(rows)?, ())))
        }?;
        Ok(found.0)
    }

    /// [`Self::evaluate`] and [`Self::tangent`] in one.
    pub(crate) unsafe fn evaluate_tangent(
        &mut self,
        coords: &fmc_coords,
        part: TangentPart,
        forces: Option<&fmc_forces>,
        add: bool,
        index_base: i32,
    ) -> Result<(Evaluation, Kept), Failure> {
        let [nodes, obstacles] = [self.held.contact().surface().unknown_count(), self.obstacle_nodes()];
        // SAFETY: passed on to the caller.
        unsafe {
            self.evaluated(coords, forces, add, index_base, |contact, rows| {
                let (found, tangent) = contact.evaluate_tangent(rows, part)?;
                Ok((found, Kept::new(&tangent, nodes, obstacles)))
            })
        }
    }

    /// Second derivative of the energy.
    pub(crate) unsafe fn tangent(
        &mut self,
        coords: &fmc_coords,
        part: TangentPart,
        index_base: i32,
    ) -> Result<Kept, Failure> {
        // SAFETY: passed on to the caller.
        let tangent = unsafe { self.at(coords, index_base, |contact, rows| contact.tangent(rows, part)) }?;
        Ok(Kept::new(&tangent, coords.node_count, self.obstacle_nodes()))
    }

    /// The contact at the nodes.
    pub(crate) unsafe fn nodal_contact(&mut self, coords: &fmc_coords, index_base: i32) -> Result<NodalLists, Failure> {
        // SAFETY: passed on to the caller.
        Ok(unsafe { self.at(coords, index_base, |contact, rows| contact.nodal_contact(rows)) }?.into())
    }

    /// The contact points.
    pub(crate) unsafe fn contact_points(
        &mut self,
        coords: &fmc_coords,
        index_base: i32,
    ) -> Result<Vec<fmc_contact_point>, Failure> {
        // SAFETY: passed on to the caller.
        let points = unsafe { self.at(coords, index_base, |contact, rows| contact.contact_points(rows)) }?;
        Ok(points.iter().map(|point| fmc_contact_point::new(point, index_base)).collect())
    }

    /// Weighted gaps.
    pub(crate) unsafe fn gap_constraints(
        &mut self,
        coords: &fmc_coords,
        reach: f64,
        index_base: i32,
    ) -> Result<KeptGaps, Failure> {
        // SAFETY: passed on to the caller.
        let found = unsafe { self.at(coords, index_base, |contact, rows| contact.gap_constraints(rows, reach)) }?;
        Ok(KeptGaps::new(&found, index_base))
    }

    /// Equilibrium with condensed bodies.
    pub(crate) unsafe fn contact_step(
        &mut self,
        coords: &fmc_coords,
        bodies: &CondensedBodies,
        options: &ContactStepOptions,
        placement: Option<Placement>,
        index_base: i32,
    ) -> Result<ContactStep, Failure> {
        let mut place = placement.map(|placement| {
            move |displacement: &[f64], coords: &mut [[f64; D]]| {
                // SAFETY: the host guarantees the function.
                unsafe { placement.call(displacement, coords.as_flattened_mut()) }
            }
        });
        let place: Option<Place<D>> = place.as_mut().map(|place| place as Place<D>);
        // SAFETY: passed on to the caller.
        unsafe { self.at(coords, index_base, |contact, rows| contact.contact_step(rows, bodies, options, place)) }
    }
}
