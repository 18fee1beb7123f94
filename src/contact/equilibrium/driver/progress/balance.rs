//! When bodies and contact are in equilibrium.

use super::state::{Rounding, State};
use crate::contact::equilibrium::driver::asking::assembly::Assembly;
use crate::contact::equilibrium::driver::asking::host::Host;
use crate::contact::equilibrium::driver::asking::trouble::Trouble;
use crate::contact::equilibrium::driver::asking::unknowns::norm;

/// Part of the forces above which rounding is never taken for an answer.
const TOO_MUCH: f64 = 1e-3;

/// A residual of which more than this part is left by an iteration hardly falls.
const HARDLY: f64 = 0.5;

/// Iterations that hardly fall, one after the other, before rounding of coordinates counts.
const STALLED: usize = 2;

/// Residual by the forces below which a start is an equilibrium itself.
const BALANCED: f64 = 1e-2;

/// How nearly a state is in equilibrium.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Verdict {
    Balanced,
    /// As far as the rounding of the host's own forces lets it be.
    Rounded,
    Not,
}

/// What a search judges its states by.
pub(crate) struct Balance {
    tolerance: f64,
    /// Stiffness of contact and interfaces by area, row by row of coordinates.
    pressed: Vec<f64>,
    /// Forces at the start, if it was an equilibrium, of this load or another.
    at_start: f64,
    /// Forces by which the last state was judged.
    scale: f64,
    last: f64,
    stalled: usize,
    rounded: [f64; 2],
    /// Residual by the forces, state by state.
    pub(crate) history: Vec<f64>,
}

impl Balance {
    pub(crate) fn new(tolerance: f64, pressed: Vec<f64>) -> Self {
        Self {
            tolerance,
            pressed,
            at_start: 0.0,
            scale: 0.0,
            last: f64::INFINITY,
            stalled: 0,
            rounded: [0.0; 2],
            history: Vec::new(),
        }
    }

    /// The scale of a step that begins in equilibrium is that of the forces there: an unloaded end has none of its own.
    pub(crate) async fn begin<const D: usize>(
        &mut self,
        host: &Host<D>,
        assembly: &Assembly<D>,
        start: &State<D>,
    ) -> Result<(), Trouble> {
        let rounding = self.rounding(host, assembly, start).await?;
        let scale = start.scale(&rounding.of_state);
        // Forces no larger than the rounding of coordinates are no load to measure by.
        let is_loaded = start.scale(&rounding.of_coordinates) > 0.0;
        if is_loaded && start.beyond(host, &rounding.of_state) <= BALANCED * scale {
            self.at_start = scale;
        }
        Ok(())
    }

    /// What rounding may leave of the residual of a state.
    pub(crate) async fn rounding<const D: usize>(
        &self,
        host: &Host<D>,
        assembly: &Assembly<D>,
        state: &State<D>,
    ) -> Result<Rounding, Trouble> {
        state.rounding(host, assembly, &self.pressed).await
    }

    /// Residuals count by forces of this size at least.
    pub(crate) fn measured_by(&mut self, forces: f64) {
        self.at_start = self.at_start.max(forces);
    }

    /// Forces at the start, as far as residuals are measured by them.
    pub(crate) fn at_start(&self) -> f64 {
        self.at_start
    }

    /// What rounding may leave of the residual of the last state that was judged: of displacements as they are, and of coordinates.
    pub(crate) fn rounded(&self) -> [f64; 2] {
        self.rounded
    }

    /// Forces by which the last state was judged.
    pub(crate) fn scale(&self) -> f64 {
        self.scale
    }

    /// Another attempt begins.
    pub(crate) fn again(&mut self) {
        (self.last, self.stalled) = (f64::INFINITY, 0);
    }

    /// Relative residual of the last state that was judged.
    pub(crate) fn relative(&self) -> f64 {
        self.history.last().copied().unwrap_or(f64::NAN)
    }

    pub(crate) async fn judge<const D: usize>(
        &mut self,
        host: &Host<D>,
        assembly: &Assembly<D>,
        state: &State<D>,
    ) -> Result<Verdict, Trouble> {
        let rounding = self.rounding(host, assembly, state).await?;
        self.rounded = [norm(&rounding.of_state), norm(&rounding.of_coordinates)];
        let scale = state.scale(&rounding.of_state).max(self.at_start);
        self.scale = scale;
        let beyond = state.beyond(host, &rounding.of_state);
        self.history.push(if beyond > 0.0 { beyond / scale.max(f64::MIN_POSITIVE) } else { 0.0 });
        self.stalled = if beyond > HARDLY * self.last { self.stalled + 1 } else { 0 };
        self.last = beyond;
        if beyond <= self.tolerance * scale {
            return Ok(Verdict::Balanced);
        }
        // Where no force is more than what coordinates are rounded to, there is no load.
        let is_unloaded = state.scale(&rounding.of_coordinates).max(self.at_start) == 0.0;
        let left = state.beyond(host, &rounding.of_coordinates);
        let may_be = is_unloaded || (self.stalled >= STALLED && state.norm(host) <= TOO_MUCH * scale);
        if !may_be || left > self.tolerance * scale {
            return Ok(Verdict::Not);
        }
        if is_unloaded && let Some(last) = self.history.last_mut() {
            // A part of nothing.
            *last = 0.0;
        }
        Ok(Verdict::Rounded)
    }
}
