//! Iterations as they are reported.

use super::error::StaticsError;
use super::iteration::Iteration;
use fmc_contact::contact::equilibrium::Answer;
use std::ops::ControlFlow;

/// What a solver is watched by; it may break off.
pub(super) type Watch<'a> = &'a mut dyn FnMut(&Iteration) -> ControlFlow<()>;

/// The iterations of a search. One is told when it is known where its step has led.
pub(super) struct Report {
    count: usize,
    last: Option<Step>,
}

/// A step under way.
struct Step {
    told: Iteration,
    from: Vec<f64>,
    /// None as long as it was not answered.
    by: Option<Vec<f64>>,
}

impl Report {
    pub(super) fn new() -> Self {
        Self { count: 0, last: None }
    }

    /// Iterations so far.
    pub(super) fn count(&self) -> usize {
        self.count
    }

    /// A step from a place is asked for.
    pub(super) fn asked(&mut self, told: Iteration, x: &[f64], watch: Watch) -> Result<(), StaticsError> {
        self.flush(x, watch)?;
        self.count += 1;
        self.last = Some(Step { told, from: x.to_vec(), by: None });
        Ok(())
    }

    /// What was answered last, with this many iterations of the contact.
    pub(super) fn answered(&mut self, answer: &Answer, contact_iterations: usize) {
        let Some(last) = self.last.as_mut().filter(|last| last.by.is_none()) else { return };
        let by = match answer {
            Answer::Step { step, .. } | Answer::Vector(step) => step.clone(),
            _ => Vec::new(),
        };
        (last.by, last.told.contact_iterations) = (Some(by), contact_iterations);
    }

    /// The search has ended at a place.
    pub(super) fn ended(&mut self, told: Iteration, x: &[f64], watch: Watch) -> Result<(), StaticsError> {
        self.flush(x, watch)?;
        tell(&told, watch)
    }

    fn flush(&mut self, x: &[f64], watch: Watch) -> Result<(), StaticsError> {
        let Some(Step { mut told, from, by }) = self.last.take() else { return Ok(()) };
        told.length = by.map_or(0.0, |by| length(&from, &by, x));
        tell(&told, watch)
    }
}

/// The part of a step that was taken, by where it has led.
fn length(from: &[f64], by: &[f64], to: &[f64]) -> f64 {
    let square: f64 = by.iter().map(|by| by * by).sum();
    if square == 0.0 {
        return 0.0;
    }
    let is_whole = from.iter().zip(by).zip(to).all(|((from, by), to)| from + by == *to);
    let along: f64 = from.iter().zip(by).zip(to).map(|((from, by), to)| (to - from) * by).sum();
    if is_whole { 1.0 } else { along / square }
}

/// Reports to `watch`.
pub(super) fn tell(iteration: &Iteration, watch: Watch) -> Result<(), StaticsError> {
    if watch(iteration).is_break() { Err(StaticsError::Interrupted) } else { Ok(()) }
}
