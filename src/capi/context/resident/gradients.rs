//! Derivatives.

use super::Resident;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::index::IndexSize;
use crate::capi::boundary::pointer::slice;
use crate::capi::structs::directions::fmc_directions;
use crate::capi::structs::equilibrium::fmc_equilibrium_problem;
use crate::capi::structs::gradients::GradientLists;
use crate::capi::structs::slip_row;
use crate::capi::structs::view::{check_node_count, fmc_coords};
use crate::contact::equilibrium::Goal;
use crate::contact::{Directions, GradientRequest};

impl<const D: usize> Resident<D> {
    /// The derivatives of `energy` times the energy and `adjoint` times the forces and `slip` times the elastic slip at the end of the
    /// step.
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
        Ok(found.into())
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

    /// The right side and the derivatives of an adjoint.
    pub(crate) unsafe fn adjoint(
        &mut self,
        (problem, size, index_base): (&fmc_equilibrium_problem, IndexSize, i32),
        (by_x, by_forces): (&[f64], *const f64),
        balance: Option<&[f64]>,
        request: &GradientRequest,
    ) -> Result<(Vec<f64>, GradientLists), Failure> {
        let contact = self.contact_mut()?;
        // SAFETY: passed on to the caller.
        let (unknowns, x, _) = unsafe { problem.read::<D>(size, index_base) }?;
        let by_forces = match by_forces.is_null() {
            true => None,
            // SAFETY: passed on to the caller.
            false => Some(unsafe { slice("by_forces", by_forces, problem.row_count, D) }?.as_chunks().0),
        };
        let found = contact.adjoint(&unknowns, &x, &Goal { by_x, by_forces }, balance, request)?;
        Ok((found.right, found.gradients.into()))
    }
}
