//! The contact as a function of the displacement of some degrees of freedom.

use super::Place;
use super::bodies::CondensedBodies;
use super::touching::{Touch, Touching};
use crate::Error;
use crate::contact::evaluation::Contact;
use crate::contact::evaluation::kernels;
use crate::contact::tangents::TangentPart;
use nalgebra::{DMatrix, DVector};

/// Where a degree of freedom is.
#[derive(Clone, Copy)]
enum Role {
    /// At this place in the list.
    Kept(usize),
    Held,
    Outside,
}

/// A contact of which only the degrees of freedom on a list move by themselves.
pub(super) struct Kept<'a, 'p, const D: usize> {
    contact: &'a Contact<D>,
    start: &'a [[f64; D]],
    dofs: &'a [usize],
    roles: Vec<Role>,
    place: Option<Place<'p, D>>,
    /// Where the nodes were put last: forces and tangents are asked for at the same displacement.
    last: Option<(DVector<f64>, Vec<[f64; D]>)>,
}

impl<'a, 'p, const D: usize> Kept<'a, 'p, D> {
    pub(super) fn new(
        contact: &'a Contact<D>,
        start: &'a [[f64; D]],
        bodies: &CondensedBodies<'a>,
        place: Option<Place<'p, D>>,
    ) -> Self {
        let mut roles = vec![Role::Outside; start.len() * D];
        bodies.held.iter().for_each(|&dof| roles[dof] = Role::Held);
        bodies.dofs.iter().enumerate().for_each(|(place, &dof)| roles[dof] = Role::Kept(place));
        Self { contact, start, dofs: bodies.dofs, roles, place, last: None }
    }

    fn placed(&mut self, displacement: &DVector<f64>) -> Result<Vec<[f64; D]>, Error> {
        if let Some((there, coords)) = &self.last
            && there == displacement
        {
            return Ok(coords.clone());
        }
        let mut coords = self.start.to_vec();
        for (&dof, by) in self.dofs.iter().zip(displacement.iter()) {
            coords[dof / D][dof % D] += by;
        }
        if let Some(place) = &mut self.place {
            place(displacement.as_slice(), &mut coords)?;
        }
        self.last = Some((displacement.clone(), coords.clone()));
        Ok(coords)
    }

    /// Place of a degree of freedom in the list.
    fn local(&self, dof: usize) -> Option<usize> {
        match self.roles.get(dof) {
            Some(Role::Kept(place)) => Some(*place),
            _ => None,
        }
    }

    /// Contact of some energy, with forces on all degrees of freedom.
    fn touch(&self, energy: f64, all: &[f64]) -> Touch {
        let (mut forces, mut outside) = (DVector::zeros(self.dofs.len()), Vec::new());
        for (role, force) in self.roles.iter().zip(all) {
            match role {
                Role::Kept(place) => forces[*place] = *force,
                Role::Outside if *force != 0.0 => outside.push(*force),
                _ => {}
            }
        }
        Touch { energy, forces, outside }
    }
}

impl<const D: usize> Touching for Kept<'_, '_, D> {
    fn at(&mut self, displacement: &DVector<f64>) -> Result<Touch, Error> {
        let coords = self.placed(displacement)?;
        let found = kernels::evaluate(self.contact, &coords)?;
        let energy = found.energy + found.friction.stored + found.friction.dissipated;
        Ok(self.touch(energy, found.forces.as_flattened()))
    }

    fn tangent(&mut self, displacement: &DVector<f64>, part: TangentPart) -> Result<DMatrix<f64>, Error> {
        let coords = self.placed(displacement)?;
        let tangent = kernels::tangent(self.contact, &coords, part)?;
        let count = self.dofs.len();
        let mut dense = DMatrix::zeros(count, count);
        for (row, col, value) in tangent.triplets() {
            if let (Some(row), Some(col)) = (self.local(row), self.local(col)) {
                dense[(row, col)] += value;
            }
        }
        for one in &tangent.rank_one {
            let entries = one.nodes.iter().zip(&one.vector).flat_map(|(&node, vector)| {
                vector.iter().enumerate().map(move |(axis, value)| (node as usize * D + axis, *value))
            });
            let entries: Vec<_> = entries.filter_map(|(dof, value)| Some((self.local(dof)?, value))).collect();
            for (col, other) in &entries {
                entries.iter().for_each(|(row, value)| dense[(*row, *col)] += one.factor * value * other);
            }
        }
        Ok(dense)
    }

    fn dof(&self, place: usize) -> usize {
        self.dofs[place]
    }

    fn node(&self, place: usize) -> usize {
        self.dofs[place] / D
    }

    fn start(&self, place: usize) -> f64 {
        let dof = self.dofs[place];
        self.start[dof / D][dof % D]
    }
}
