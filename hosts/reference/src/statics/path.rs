//! Load steps.

use super::equilibrium::Equilibrium;
use super::error::StaticsError;
use super::report::Watch;
use super::search::Reached;

/// How the load is brought on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Path {
    /// Load steps that are tried first, of equal size.
    pub steps: usize,
    /// Times that a step which fails is halved.
    pub most_halvings: u32,
}

impl Default for Path {
    fn default() -> Self {
        Self { steps: 1, most_halvings: 8 }
    }
}

/// A step that needs no more iterations than these lets the next one be twice as long, up to the first ones' length.
const EASY: usize = 12;

impl<const D: usize> Equilibrium<D> {
    /// Goes to the full load: prescribed displacements and forces grow together. A step that fails is halved; what
    /// follows grows again. `watch` is called after every iteration and may stop the solver.
    ///
    /// # Errors
    /// Those of [`StaticsError`]; the last equilibrium is kept.
    pub fn follow(&mut self, path: Path, watch: Watch) -> Result<(), StaticsError> {
        self.follow_telling(path, watch, &mut |_| ())
    }

    /// The same; `reached` is called after every equilibrium on the way.
    ///
    /// # Errors
    /// Those of [`StaticsError`]; the last equilibrium is kept.
    pub fn follow_telling(
        &mut self,
        path: Path,
        watch: Watch,
        reached: &mut dyn FnMut(&Self),
    ) -> Result<(), StaticsError> {
        let longest = 1.0 / path.steps.max(1) as f64;
        let mut step = longest;
        while self.load < 1.0 {
            let load = if self.load + step > 1.0 - 1e-9 { 1.0 } else { self.load + step };
            let before = self.iterations;
            match self.search(&self.displacement.clone(), load, true, watch) {
                Ok(Reached { displacement, balance }) => {
                    self.accept(displacement, balance, load);
                    if load == 1.0 {
                        self.turn_patches(watch)?;
                    }
                    self.commit_step()?;
                    reached(self);
                    if self.iterations - before <= EASY {
                        step = longest.min(2.0 * step);
                    }
                }
                Err(error)
                    if error.may_yield_to_halving() && step > longest * 0.5f64.powi(path.most_halvings as i32) =>
                {
                    step *= 0.5;
                    self.halvings += 1;
                }
                Err(error) => return Err(error),
            }
        }
        self.too_soft(&self.balance).map_or(Ok(()), Err)
    }

    /// Accepts the last equilibrium as the end of a load step: its elastic slip is carried into the next.
    pub(super) fn commit_step(&mut self) -> Result<(), StaticsError> {
        if self.has_friction() {
            self.contact.commit_step(&self.coords())?;
        }
        Ok(())
    }
}

impl StaticsError {
    /// Whether a smaller load step may help.
    pub(super) fn may_yield_to_halving(&self) -> bool {
        matches!(self, Self::NotConverged { .. } | Self::Inverted { .. })
    }
}
