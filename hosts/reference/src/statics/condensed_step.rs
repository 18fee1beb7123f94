//! Steps to the equilibrium of the contact with bodies that are linear.

use super::equilibrium::Equilibrium;
use super::follower::Follower;
use fmc_contact::contact::TangentPart;
use fmc_contact::contact::equilibrium::{Answer, CondensedBodies, ContactStep, ContactStepOptions, ContactStepState};
use fmc_contact::sparse::Lower;
use fmc_contact::{Contact, Error};
use std::collections::BTreeSet;
use std::sync::Arc;

/// Times that contact may spread over more equations than are kept in one step.
const MOST_GROWTHS: usize = 8;

/// Equations on which contact acts, at most: what is left of the bodies is dense.
const MOST_KEPT: usize = 5000;

/// Equations that may stay kept from step to step: to factorise anew costs less than what is dense and larger.
const MOST_LASTING: usize = 2000;

/// Equations that may come to feel contact before any does, at most.
const MOST_EXPECTED: usize = 1500;

/// Part of the shortest edge by which what is kept may move before all of the bodies follow it, and not what is near alone.
const NEAR: f64 = 0.25;

/// A step that is asked for.
pub(super) struct Asked<'a> {
    pub(super) x: &'a [f64],
    pub(super) moved: &'a [f64],
    pub(super) forces: &'a [f64],
    pub(super) options: ContactStepOptions,
}

impl<const D: usize> Equilibrium<D> {
    /// The library's contact step with the bodies' factors.
    pub(super) fn condensed(&mut self, asked: &Asked) -> Answer {
        match self.condensed_step(asked) {
            Ok((step, found)) => {
                self.contact_iterations += found.iterations;
                self.evaluations += found.evaluations;
                let led_nowhere = found.residual >= found.residual_at_start;
                if found.state == ContactStepState::NotConverged && led_nowhere {
                    return Answer::Refused("the iterations of the contact led nowhere".into());
                }
                Answer::Step { step, is_definite: true }
            }
            Err(error) => Answer::Refused(error.to_string()),
        }
    }

    fn condensed_step(&mut self, asked: &Asked) -> Result<(Vec<f64>, ContactStep), Error> {
        let elastic = self.elastic();
        if self.matrices.condensed.count() > MOST_LASTING {
            self.matrices.condensed.forget();
        }
        self.keep_touching(asked.x)?;
        self.expect(asked.x, asked.moved);
        let driven = elastic.product(asked.moved);
        let right: Vec<f64> = asked.forces.iter().zip(driven).map(|(force, driven)| -force - driven).collect();
        let right = self.matrices.equations.gathered(&right);
        let mut growths = 0;
        loop {
            if self.matrices.condensed.count() > MOST_KEPT {
                return Err(Error::Unsupported { what: "a contact on so many equations that they fill the memory" });
            }
            let (step, found) = self.step_on_kept(asked, &elastic, &right)?;
            growths += 1;
            let ahead: Vec<f64> = asked.x.iter().zip(&step).map(|(x, step)| x + step).collect();
            let is_outside = found.state == ContactStepState::Outside;
            if !is_outside || growths > MOST_GROWTHS || !self.keep_touching(&ahead)? {
                return Ok((step, found));
            }
        }
    }

    /// Keeps the equations on which contact acts at a place; whether any of them is new.
    fn keep_touching(&mut self, x: &[f64]) -> Result<bool, Error> {
        let tangent = self.contact.tangent(&self.placed(&self.by_unknowns(x)), TangentPart::Semidefinite)?;
        let equations = &self.matrices.equations;
        let touched = equations.entries(equations.by_unknowns(tangent.triplets())).map(|(row, ..)| row);
        let touched: Vec<usize> = touched.collect();
        Ok(self.matrices.condensed.keep(touched))
    }

    /// Keeps what may come to touch when what is prescribed moves: nodes that are nearer to a partner than anything moves, the nearest first.
    fn expect(&mut self, x: &[f64], moved: &[f64]) {
        let squares = moved.chunks_exact(D).map(|by| by.iter().map(|d| d * d).sum::<f64>());
        let way = squares.fold(0.0, f64::max).sqrt();
        if way == 0.0 {
            return;
        }
        let Ok(gaps) = self.contact.gap_constraints(&self.placed(&self.by_unknowns(x)), way) else { return };
        let mean = |row: usize| gaps.gaps[row] / gaps.areas[row];
        let mut rows: Vec<usize> = (0..gaps.gaps.len()).filter(|&row| gaps.gaps[row] < way * gaps.areas[row]).collect();
        rows.sort_by(|&p, &q| mean(p).total_cmp(&mean(q)).then(p.cmp(&q)));
        let mut found = BTreeSet::new();
        for row in rows {
            let nodes = &gaps.columns[gaps.row_starts[row]..gaps.row_starts[row + 1]];
            let freedoms = nodes.iter().flat_map(|&node| (0..D).map(move |axis| node as usize * D + axis));
            found.extend(freedoms.filter_map(|freedom| self.matrices.equations.of(freedom)));
            if found.len() >= MOST_EXPECTED {
                break;
            }
        }
        self.matrices.condensed.keep(found);
    }

    /// The step with the equations that are kept now.
    fn step_on_kept(
        &mut self,
        asked: &Asked,
        elastic: &Arc<Lower>,
        right: &[f64],
    ) -> Result<(Vec<f64>, ContactStep), Error> {
        let near = NEAR * self.shortest_edge;
        let coords = self.placed(&self.by_unknowns(asked.x));
        let equations = &self.matrices.equations;
        let (dofs, held) = (self.matrices.condensed.freedoms(equations), equations.held());
        self.matrices.condensed.factors_of(elastic, equations)?;
        let stiffness = std::mem::take(&mut self.matrices.condensed.stiffness);
        let factors = self.matrices.condensed.factors_of(elastic, equations)?;
        let mut bodies = Follower::new(factors, right, dofs.len(), near).ok_or(Error::NotFactorised)?;
        let placed = |values: &[f64]| -> Vec<[f64; D]> {
            let step = equations.spread(values);
            let moved = asked.moved.iter().zip(&step).map(|(moved, step)| moved + step);
            let mut all = coords.clone();
            all.as_flattened_mut().iter_mut().zip(moved).for_each(|(x, by)| *x += by);
            all
        };
        let residual: Vec<f64> = bodies.condensed.kept.iter().map(|force| -force).collect();
        let start = placed(&bodies.followed);
        if asked.moved.iter().any(|by| *by != 0.0) && self.problem.contact.law.is_fiber() {
            // Where what is prescribed has moved, and not where nothing may have touched yet: without, forces would have no energy.
            self.contact.keep_patches(&start)?;
        }
        let found = step_of(
            &self.contact,
            &start,
            &CondensedBodies { dofs: &dofs, held: &held, stiffness: &stiffness, residual: &residual },
            &asked.options,
            |kept, coords| {
                *coords = placed(&bodies.near(kept).ok_or(Error::NotFactorised)?);
                Ok(())
            },
        );
        let ended = found.and_then(|found| {
            let step = bodies.all(&found.displacement).ok_or(Error::NotFactorised)?;
            let step = equations.spread(step);
            Ok((asked.moved.iter().zip(step).map(|(moved, step)| moved + step).collect(), found))
        });
        self.matrices.condensed.stiffness = stiffness;
        ended
    }
}

/// Takes the library's step, with coordinates that are put in their place as a whole.
fn step_of<const D: usize>(
    contact: &Contact<D>,
    start: &[[f64; D]],
    bodies: &CondensedBodies,
    options: &ContactStepOptions,
    mut place: impl FnMut(&[f64], &mut Vec<[f64; D]>) -> Result<(), Error>,
) -> Result<ContactStep, Error> {
    let mut all = start.to_vec();
    let mut put = |kept: &[f64], coords: &mut [[f64; D]]| {
        place(kept, &mut all)?;
        coords.copy_from_slice(&all);
        Ok(())
    };
    contact.contact_step(start, bodies, options, Some(&mut put))
}
