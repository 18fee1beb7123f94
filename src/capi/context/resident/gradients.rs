//! Derivatives.

use super::Resident;
use crate::capi::boundary::failure::Failure;
use crate::capi::structs::directions::fmc_directions;
use crate::capi::structs::gradients::{GradientLists, fmc_pair_gradient};
use crate::capi::structs::slip_row;
use crate::capi::structs::view::{check_node_count, fmc_coords};
use crate::contact::{Directions, GradientRequest};

impl<const D: usize> Resident<D> {
    /// The derivatives of `energy` times the energy and `adjoint` times the forces and `slip` times the elastic slip at the end of the step.
    pub(crate) unsafe fn vjp(
        &mut self,
        coords: &fmc_coords,
        (energy, adjoint, slip): (f64, Option<&fmc_coords>, &[f64]),
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
        let slip = slip_row::list(slip)?;
        // SAFETY: passed on to the caller.
        let found = unsafe {
            self.at(coords, index_base, |contact, rows| contact.vjp_of_step(rows, energy, adjoint, &slip, request))
        }?;
        let flat = |rows: &[[f64; D]]| rows.as_flattened().to_vec();
        let rotations = found.rotations.as_flattened().to_vec();
        Ok(GradientLists {
            by_place: [flat(&found.coords), flat(&found.reference), flat(&found.positions), rotations],
            pairs: found.pairs.iter().map(fmc_pair_gradient::from).collect(),
            slip: slip_row::rows(&found.slip),
        })
    }

    /// Rates of the energy and, in dense rows, of the forces.
    pub(crate) unsafe fn jvp(
        &mut self,
        coords: &fmc_coords,
        along: &fmc_directions,
        index_base: i32,
    ) -> Result<(f64, Vec<f64>), Failure> {
        let contact = self.held.contact();
        // SAFETY: passed on to the caller.
        let lists = unsafe { along.lists::<D>(contact.surface().unknown_count(), contact.obstacle_count()) }?;
        let directions = Directions {
            coords: lists.coords,
            positions: lists.positions,
            rotations: lists.rotations,
            stiffness: along.stiffness,
            gap_offset: along.gap_offset,
            friction: along.friction,
            pairs: &lists.pairs,
            slip: &lists.slip,
        };
        // SAFETY: passed on to the caller.
        let found = unsafe { self.at(coords, index_base, |contact, rows| contact.jvp(rows, &directions)) }?;
        Ok((found.energy, found.forces.into_flattened()))
    }
}
