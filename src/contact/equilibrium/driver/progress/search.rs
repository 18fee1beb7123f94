//! One load step under way.

use super::balance::{Balance, Verdict};
use super::breaking::breaking;
use super::falling::Falling;
use super::patches::Patches;
use super::state::State;
use super::stood::Former;
use super::updates::Updates;
use crate::Error;
use crate::contact::changes::friction_steps::freeze_after;
use crate::contact::cohesive::Breaking;
use crate::contact::equilibrium::driver::asking::assembly::Assembly;
use crate::contact::equilibrium::driver::asking::host::Host;
use crate::contact::equilibrium::driver::asking::options::DriverOptions;
use crate::contact::equilibrium::driver::asking::trouble::{Trouble, Unheld};
use crate::contact::equilibrium::driver::bodies::limit::{is_short, limit};
use crate::contact::equilibrium::driver::bodies::motions::Motions;
use crate::contact::friction::Duals;
use std::sync::Arc;

/// What the parts of a search share.
pub(crate) struct Search<const D: usize> {
    pub(crate) host: Host<D>,
    pub(crate) assembly: Arc<Assembly<D>>,
    pub(crate) motions: Motions,
    pub(crate) balance: Balance,
    pub(crate) updates: Updates,
    /// Those of the law `fiber`, where the search looks after them.
    pub(crate) patches: Option<Patches>,
    pub(crate) options: DriverOptions,
    pub(crate) has_friction: bool,
    /// Where obstacles stood before.
    pub(crate) former: Former<D>,
    /// Where the load of the step before is gone.
    pub(crate) unloaded: Option<Unloaded>,
    /// Where the load is a part of that of the step before, and nothing has moved yet.
    pub(crate) falling: Option<Falling<D>>,
    /// Cohesive interfaces in the last state in which damage grew.
    pub(crate) broken: Vec<Breaking>,
    /// Bodies that nothing holds where they have come to rest.
    pub(crate) free: Vec<Unheld>,
    /// What the user should know.
    pub(crate) warnings: Vec<String>,
}

/// What is known where a load is gone.
#[derive(Clone, Copy)]
pub(crate) struct Unloaded {
    /// The residual that matters to nobody, by the forces of the equilibrium where a step begins, which was another.
    pub(crate) enough: f64,
    /// How far bodies may be moved out of one another.
    pub(crate) farthest: f64,
}

impl<const D: usize> Search<D> {
    /// Whether another linear solve may be made.
    pub(crate) fn may_go_on(&self) -> bool {
        self.host.solves() < self.options.max_solves
    }

    /// Whether steps go to the equilibrium of the contact with linear bodies.
    pub(crate) fn is_condensed(&self) -> bool {
        let options = &self.options;
        let is_held = self.motions.is_empty()
            || options.is_condensed_on_contact
            || (options.is_condensed_first && !self.motions.are_free);
        options.is_condensed && is_held && !options.is_lagged
    }

    /// Whether loose bodies are in equilibrium where they are: rounding alone would move them.
    pub(crate) async fn is_at_rest(&mut self, x: &[f64]) -> Result<bool, Trouble> {
        if self.motions.is_empty() {
            return Ok(true);
        }
        let state = State::at(&self.host, x.to_vec(), true).await?;
        self.is_balanced(&state).await
    }

    /// Whether a state is an equilibrium, without a record of it.
    pub(crate) async fn is_balanced(&mut self, state: &State<D>) -> Result<bool, Trouble> {
        self.balance.again();
        let verdict = self.balance.judge(&self.host, &self.assembly, state).await?;
        self.balance.history.pop();
        Ok(verdict != Verdict::Not)
    }

    /// Another way from the same start.
    pub(crate) fn begin_attempt(&mut self) {
        self.balance.again();
        if let Some(patches) = &mut self.patches {
            patches.begin();
        }
    }

    /// How nearly a state is in equilibrium, with surfaces moved out where it is near one.
    pub(crate) async fn judged(&mut self, mut state: State<D>) -> Result<(State<D>, Verdict), Trouble> {
        let broken = breaking(&self.host, &state.x).await?;
        self.broken = if broken.is_empty() { std::mem::take(&mut self.broken) } else { broken };
        let mut verdict = self.balance.judge(&self.host, &self.assembly, &state).await?;
        let relative = self.balance.relative();
        if let Some(patches) = &mut self.patches
            && patches.found(&self.host, &state, relative).await?
        {
            state = state.again(&self.host).await?;
            verdict = self.balance.judge(&self.host, &self.assembly, &state).await?;
        }
        let relative = self.balance.relative();
        if !self.updates.made(&self.host, &state, verdict, relative).await? {
            return Ok((state, verdict));
        }
        let state = state.again(&self.host).await?;
        self.balance.again();
        let verdict = self.balance.judge(&self.host, &self.assembly, &state).await?;
        Ok((state, verdict))
    }

    /// The same where a residual by the forces is enough, and surfaces stay where they are.
    pub(crate) async fn roughly_judged(
        &mut self,
        state: State<D>,
        enough: f64,
    ) -> Result<(State<D>, Verdict), Trouble> {
        let verdict = self.balance.judge(&self.host, &self.assembly, &state).await?;
        let is_enough = verdict != Verdict::Not || self.balance.relative() <= enough;
        Ok((state, if is_enough { Verdict::Balanced } else { Verdict::Not }))
    }

    /// The part of a step that may be taken.
    pub(crate) async fn allowed(&self, x: &[f64], step: &[f64]) -> Result<f64, Trouble> {
        let (assembly, coords) = (Arc::clone(&self.assembly), self.host.unknowns.coords(x));
        let step = self.host.unknowns.spread(step);
        if is_short(&assembly, &step) {
            return Ok(1.0);
        }
        let found = self.host.contact(move |contact| limit(contact, &assembly, &coords, &step)).await?;
        Ok(found.part)
    }

    /// The state with its friction frozen there, with the tractions that the last step asked for, or as if there had been none.
    pub(crate) async fn frozen_at(
        &self,
        state: State<D>,
        duals: &mut Duals<D>,
        are_used: bool,
    ) -> Result<State<D>, Trouble> {
        let (coords, mut taken) = (self.host.unknowns.coords(&state.x), std::mem::take(duals));
        let frozen = self.host.contact(move |contact| {
            freeze_after(contact, &coords, &mut taken, are_used)?;
            Ok::<_, Error>(taken)
        });
        *duals = frozen.await?;
        state.again(&self.host).await
    }

    pub(crate) fn warn(&mut self, text: String) {
        if !self.warnings.contains(&text) {
            self.warnings.push(text);
        }
    }
}
