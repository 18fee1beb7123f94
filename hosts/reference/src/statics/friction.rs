//! Friction in a load step.
//!
//! Coulomb friction has no energy: its limit follows the pressure. With facets and limits held as they are at an iterate
//! it has one, the convex potential of stick and slip, and all that finds a least energy finds that equilibrium as well.
//! So friction is frozen, the equilibrium found, and frozen there anew, until what is frozen is what is found. Where the
//! pressure grows with friction, by α, each solve leaves the part μα of the error of the one before.

use super::equilibrium::Equilibrium;
use super::error::StaticsError;
use super::newton::{State, Watch};
use super::newton_settings::{FrictionPressure, NewtonSettings};

/// Times, at most, that friction is frozen in a load step: at μα = ½ the error falls by 10⁻¹² in 40.
const MOST_FREEZES: usize = 40;

/// Part of the residual at which friction was frozen that a solve may leave: the next one starts from it.
const LEFT_OVER: f64 = 1e-3;

impl<const D: usize> Equilibrium<D> {
    /// Whether contact resists sliding.
    pub(super) fn has_friction(&self) -> bool {
        self.problem.contact.friction.is_active()
    }

    /// Accepts the last equilibrium as the end of a load step: its elastic slip is carried into the next.
    pub(super) fn commit_step(&mut self) -> Result<(), StaticsError> {
        if self.has_friction() {
            let coords = self.placed(&self.displacement);
            self.contact.commit_step(&coords)?;
        }
        Ok(())
    }

    /// Equilibrium with friction; nothing is committed, and nothing left frozen.
    pub(super) fn with_friction(
        &mut self,
        start: Vec<[f64; D]>,
        load: f64,
        watch: Watch,
    ) -> Result<State<D>, StaticsError> {
        let NewtonSettings { tolerance, full_below, friction, .. } = self.settings;
        if friction == FrictionPressure::Lagged {
            return self.with_lagged_pressure(start, load, tolerance, watch);
        }
        let near = self.with_lagged_pressure(start, load, full_below.max(tolerance), watch)?;
        if near.1.relative() <= tolerance {
            return Ok(near);
        }
        match self.with_current_pressure(near.0.clone(), load, watch) {
            Err(error) if error.may_yield_to_halving() => self.with_lagged_pressure(near.0, load, tolerance, watch),
            ended => ended,
        }
    }

    /// Freezes and solves until the residual by the pressure of now is at most `goal`.
    fn with_lagged_pressure(
        &mut self,
        start: Vec<[f64; D]>,
        load: f64,
        goal: f64,
        watch: Watch,
    ) -> Result<State<D>, StaticsError> {
        let settings = self.settings;
        let found = self.frozen_and_again(start, load, goal, watch);
        self.settings = settings;
        self.contact.release_friction();
        found
    }

    fn frozen_and_again(
        &mut self,
        start: Vec<[f64; D]>,
        load: f64,
        goal: f64,
        watch: Watch,
    ) -> Result<State<D>, StaticsError> {
        let (mut u, before) = (start, self.iterations);
        let mut residual = f64::INFINITY;
        for _ in 0..MOST_FREEZES {
            self.keep_patches(&u)?;
            self.contact.freeze_friction(&self.placed(&u))?;
            let balance = self.evaluate(&u, load)?;
            residual = balance.relative();
            if residual <= goal {
                return Ok((u, balance));
            }
            self.settings.tolerance = goal.max(LEFT_OVER * residual);
            let (found, balance) = self.least_energy(u.clone(), load, watch)?;
            // What cannot be brought nearer is as near as rounding lets it.
            if found == u {
                return Ok((found, balance));
            }
            u = found;
        }
        let iterations = self.iterations - before;
        Err(StaticsError::NotConverged { load, iterations, residual })
    }
}
