//! What the library's search asks of the bodies.

use super::condensed_step::Asked;
use super::equilibrium::Equilibrium;
use super::joined::{led, own_diagonal};
use crate::fem::Law;
use fmc_contact::contact::TangentPart;
use fmc_contact::contact::equilibrium::{Answer, ContactStepOptions, Request};
use fmc_contact::sparse::{Entries, Lower};
use std::sync::Arc;

impl<const D: usize> Equilibrium<D> {
    /// An answer with the loads of a part of the full load.
    pub(super) fn answer(&mut self, request: &Request, load: f64) -> Answer {
        match request {
            Request::Forces { x, matrix } => {
                if *matrix {
                    self.linearised_at.clone_from(x);
                }
                self.evaluations += 1;
                let (forces, energy) = self.bodies_at(x, load);
                match energy.is_finite() {
                    true => Answer::Forces { forces, energy: Some(energy) },
                    false => Answer::Refused("a cell is inverted".into()),
                }
            }
            Request::Product { vector, magnitudes } => Answer::Vector(match magnitudes {
                false => self.elastic().product(vector),
                true => self.magnitudes().product(vector),
            }),
            Request::Diagonal => Answer::Vector(self.diagonal()),
            Request::Solve { x, part, shift, right } => match self.solved((x, *part, *shift), right) {
                Ok(Some(step)) => Answer::Vector(step),
                Ok(None) => Answer::Refused("the matrix is singular".into()),
                Err(error) => Answer::Refused(error.to_string()),
            },
            Request::Condensed { x, moved, forces, tolerance, absolute_tolerance } => {
                // Linear bodies are in equilibrium after the step, and others are not anyway.
                let absolute_tolerance = if self.is_linear() { 0.0 } else { *absolute_tolerance };
                let (tolerance, soft_start) = (*tolerance, true);
                let options =
                    ContactStepOptions { tolerance, absolute_tolerance, soft_start, ..ContactStepOptions::default() };
                self.condensed(&Asked { x, moved, forces, options })
            }
        }
    }

    /// Internal less external forces, and their energy. Linearised contact counts as a part of the bodies.
    fn bodies_at(&self, x: &[f64], load: f64) -> (Vec<f64>, f64) {
        let u = self.by_unknowns(x);
        let mut forces = vec![[0.0; D]; u.len()];
        let mut energy = self.problem.model.internal(&u, &mut forces);
        for (node, (force, u)) in forces.iter_mut().zip(&u).enumerate() {
            let dead = self.dead_load(node, load);
            for axis in 0..D {
                force[axis] -= dead[axis];
                energy -= dead[axis] * u[axis];
            }
        }
        if let Some(linearised) = &self.problem.linearised {
            energy += linearised.add_forces(&mut forces, &self.problem.contact.law, &u);
        }
        (self.matrices.equations.led(forces.into_flattened()), energy)
    }

    /// Whether the bodies' forces are linear in their displacement.
    pub(super) fn is_linear(&self) -> bool {
        let is_linear = self.problem.model.parts().iter().all(|part| part.material.law != Law::NeoHookean);
        is_linear && self.problem.linearised.is_none()
    }

    /// The bodies' matrix, of all degrees of freedom, where it was last asked for. That of linear bodies is computed once.
    pub(super) fn elastic(&mut self) -> Arc<Lower> {
        let is_linear = self.is_linear();
        if let Some((elastic, at)) = &self.matrices.elastic
            && (is_linear || *at == self.linearised_at)
        {
            return Arc::clone(elastic);
        }
        let u = self.by_unknowns(&self.linearised_at);
        let bodies = self.problem.model.tangent(&u);
        let touching = self.problem.linearised.iter().flat_map(|l| l.tangent(&self.problem.contact.law, &u));
        let entries = bodies.iter().chain(touching);
        let elastic = Arc::new(match self.matrices.equations.has_joined() {
            true => Lower::new(u.len() * D, led(&self.matrices.equations, entries).into_iter()),
            false => Lower::new(u.len() * D, entries),
        });
        self.matrices.elastic = Some((Arc::clone(&elastic), self.linearised_at.clone()));
        elastic
    }

    /// Its diagonal; of what is joined, the sum of that of every degree of freedom alone.
    fn diagonal(&mut self) -> Vec<f64> {
        if self.matrices.equations.has_joined() {
            let bodies = self.problem.model.tangent(&self.by_unknowns(&self.linearised_at));
            return own_diagonal(&self.matrices.equations, bodies.iter());
        }
        let mut diagonal = vec![0.0; self.problem.model.node_count() * D];
        let elastic = self.elastic();
        elastic.entries().filter(|(row, column, _)| row == column).for_each(|(row, _, k)| diagonal[row] = k);
        diagonal
    }

    /// The same with the magnitudes of all entries.
    fn magnitudes(&mut self) -> Lower {
        let equations = &self.matrices.equations;
        if equations.has_joined() {
            let bodies = self.problem.model.tangent(&self.by_unknowns(&self.linearised_at));
            let by_unknowns = equations.by_unknowns(bodies.iter());
            return Lower::new(bodies.size, by_unknowns.map(|(row, column, value)| (row, column, value.abs())));
        }
        let elastic = self.elastic();
        Lower::new(elastic.size(), elastic.entries().map(|(row, column, value)| (row, column, value.abs())))
    }

    /// Solution of a system of the bodies with a part of the contact's tangent, and a part of the diagonal.
    fn solved(
        &mut self,
        (x, part, shift): (&[f64], TangentPart, f64),
        right: &[f64],
    ) -> Result<Option<Vec<f64>>, fmc_contact::Error> {
        let of = (x.to_vec(), part, shift);
        let right = self.matrices.equations.gathered(right);
        let spread = |this: &Self, step: Vec<f64>| this.matrices.equations.spread(&step);
        if let Some(step) = self.matrices.known(&of, &right) {
            return Ok(Some(spread(self, step)));
        }
        let elastic = self.elastic();
        let tangent = self.contact.tangent(&self.placed(&self.by_unknowns(x)), part)?;
        let equations = &self.matrices.equations;
        let mut touching: Entries = equations.entries(equations.by_unknowns(tangent.triplets())).collect();
        if shift != 0.0 && self.matrices.equations.has_joined() {
            // A rigid body has nothing on the diagonal of which a part could be taken.
            let equations = &self.matrices.equations;
            let own = self.problem.model.tangent(&self.by_unknowns(&self.linearised_at));
            let own = own_diagonal(equations, own.iter());
            let leads = |&equation: &usize| equations.leads(equations.freedom(equation));
            touching.extend((0..equations.count()).filter(leads).map(|e| (e, e, shift * own[equations.freedom(e)])));
        }
        let is_symmetric = part != TangentPart::Full || !self.has_friction();
        let found = self.matrices.solve((&elastic, touching), of, is_symmetric, &right);
        let is_finite = |step: &Vec<f64>| step.iter().all(|entry| entry.is_finite());
        Ok(found.filter(is_finite).map(|step| spread(self, step)))
    }
}
