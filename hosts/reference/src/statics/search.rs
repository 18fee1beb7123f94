//! The library's search for an equilibrium, with the bodies as its host.

use super::balance::Balance;
use super::equilibrium::Equilibrium;
use super::error::StaticsError;
use super::iteration::{Iteration, Tangent};
use super::newton_settings::FrictionPressure;
use super::report::{Report, Watch};
use fmc_contact::contact::TangentPart;
use fmc_contact::contact::equilibrium::{
    DriverOptions, Equilibrium as Search, Found, Next, Refusal, Request, Unknowns,
};
use std::time::Instant;

/// Part of the size of the bodies by which a force that is rounding moves a node alone, at most.
const ROUNDED: f64 = 1e-9;

/// What a search has found.
pub(super) struct Reached<const D: usize> {
    pub(super) displacement: Vec<[f64; D]>,
    pub(super) balance: Balance<D>,
}

impl<const D: usize> Equilibrium<D> {
    /// Equilibrium at a load, from a displacement; nothing is accepted, and no step committed. After an error the contact is what it was.
    pub(super) fn search(
        &mut self,
        start: &[[f64; D]],
        load: f64,
        finds_patches: bool,
        watch: Watch,
    ) -> Result<Reached<D>, StaticsError> {
        if self.settings.most_iterations == 0 {
            let why = "no iteration is allowed".to_owned();
            return Err(StaticsError::NotConverged { load, iterations: 0, residual: f64::NAN, why });
        }
        if !self.is_linear() {
            self.matrices.condensed.forget();
        }
        let mut target = start.to_vec();
        self.prescribe(&mut target, load);
        let (start, target) = (self.unknowns_at(start), self.unknowns_at(&target));
        let before = self.contact.multipliers();
        let options = self.options(finds_patches);
        let mut search = Search::new(&self.contact, self.unknowns(), &start, Some(&target), options)?;
        let (mut answer, mut report) = (None, Report::new());
        loop {
            let clock = Instant::now();
            let next = search.next(&mut self.contact, answer)?;
            self.contact_seconds += clock.elapsed().as_secs_f64();
            let request = match next {
                Next::Asked(request) => request,
                Next::Found(found) => return self.found(found.clone(), load, report, watch),
                Next::Refused(refusal) => return Err(self.refused(refusal, load)),
            };
            let told = self.tell(request, load, &mut report, watch);
            if let Err(error) = told {
                self.contact.release_friction();
                self.contact.set_multipliers(&before)?;
                return Err(error);
            }
            let iterations = self.contact_iterations;
            let answered = self.answer(request, load);
            report.answered(&answered, self.contact_iterations - iterations);
            answer = Some(answered);
        }
    }

    fn options(&self, finds_patches: bool) -> DriverOptions {
        let settings = &self.settings;
        DriverOptions {
            tolerance: settings.tolerance,
            max_solves: settings.most_iterations,
            is_condensed: self.problem.linearised.is_none() && !self.matrices.equations.has_joined(),
            is_condensed_first: true,
            is_condensed_on_contact: true,
            penetration: settings.penetration,
            max_updates: settings.most_updates,
            finds_patches: finds_patches && self.problem.contact.law.is_fiber(),
            is_lagged: settings.friction == FrictionPressure::Lagged && self.has_friction(),
            ..DriverOptions::default()
        }
    }

    fn unknowns(&self) -> Unknowns<D> {
        let (count, equations) = (self.problem.model.node_count() * D, &self.matrices.equations);
        let mut base = self.problem.model.coords().to_vec();
        base.as_flattened_mut().iter_mut().enumerate().for_each(|(freedom, x)| *x += self.apart(freedom));
        let of_coordinate = (0..count).map(|freedom| Some(equations.leader(freedom))).collect();
        Unknowns { count, of_coordinate, weighted: equations.followed().clone(), base, free: equations.free() }
    }

    /// Reports a step that is asked for.
    fn tell(&mut self, request: &Request, load: f64, report: &mut Report, watch: Watch) -> Result<(), StaticsError> {
        let (x, tangent) = match request {
            Request::Condensed { x, .. } => (x, Tangent::Contact),
            Request::Solve { x, part: TangentPart::Full, .. } => (x, Tangent::Full),
            Request::Solve { x, part: TangentPart::Semidefinite, .. } => (x, Tangent::Semidefinite),
            _ => return Ok(()),
        };
        self.iterations += 1;
        let balance = self.evaluate(&self.by_unknowns(x), load)?;
        let told = Iteration { tangent: Some(tangent), ..Iteration::at(&balance, load, report.count()) };
        report.asked(told, x, watch)
    }

    fn found(
        &mut self,
        found: Found<D>,
        load: f64,
        mut report: Report,
        watch: Watch,
    ) -> Result<Reached<D>, StaticsError> {
        self.updates += found.updates;
        self.warnings = found.warnings;
        self.problem.contact.law = self.contact.options().law;
        let displacement = self.by_unknowns(&found.x);
        let balance = self.evaluate(&displacement, load)?;
        let residual = found.residuals.last().copied().unwrap_or(0.0);
        report.ended(Iteration { residual, ..Iteration::at(&balance, load, report.count()) }, &found.x, watch)?;
        if let Some(free) = found.free.iter().find(|free| self.is_pressed(&balance, free.body as usize)) {
            let (body, motion) = self.motion_of(free);
            return Err(StaticsError::Unsupported { body, motion });
        }
        Ok(Reached { displacement, balance })
    }

    /// Whether contact acts on a body by more than what rounding leaves: what nothing presses on stays where it is, and anything else
    /// would be pushed off by the smallest force.
    fn is_pressed(&mut self, balance: &Balance<D>, body: usize) -> bool {
        let forces = &balance.contact.forces[self.problem.model.nodes_of(body)];
        let most = forces.as_flattened().iter().fold(0.0, |most: f64, force| most.max(force.abs()));
        let stiffest = self.elastic().entries().fold(0.0, |most: f64, (.., k)| most.max(k.abs()));
        most > ROUNDED * stiffest * self.size()
    }

    fn refused(&self, refusal: &Refusal, load: f64) -> StaticsError {
        if let Some(unheld) = &refusal.unheld {
            let (body, motion) = self.motion_of(unheld);
            return StaticsError::Adrift { body, motion, has_friction: self.has_friction() };
        }
        match &refusal.error {
            Some(fmc_contact::Error::InvertedCell { cell, .. } | fmc_contact::Error::FoldedCell { cell, .. }) => {
                StaticsError::Inverted { load, cell: Some(*cell) }
            }
            Some(error) => StaticsError::Contact(error.clone()),
            None => {
                let (iterations, why) = (refusal.solves, refusal.text.clone());
                let residual = refusal.residuals.last().copied().unwrap_or(f64::NAN);
                StaticsError::NotConverged { load, iterations, residual, why }
            }
        }
    }
}
