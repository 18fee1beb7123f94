//! One way of many to solve a problem, and what it came to.

use super::Method;
use crate::case::{Case, FigureKind};
use crate::run::Motion;
use anyhow::{Context, Result};
use fmc_solid::dynamics::{Sample, Setup, Simulation};
use std::ops::ControlFlow;

/// A method with a law w = k Vᵐ, and how the impact went.
#[derive(Clone, Debug)]
pub struct Attempt {
    /// How overlap was measured.
    pub method: Method,
    /// Exponent m.
    pub exponent: f64,
    /// Stiffness k.
    pub stiffness: f64,
    /// Time and total energy by the initial one, at every step.
    pub energy: Vec<(f64, f64)>,
    /// What is worth comparing.
    pub outcome: Outcome,
    /// Why it ended before its time, if it did.
    pub failure: Option<String>,
}

/// Figures of an attempt. Forces by the largest force on the body, energies by the initial energy, velocities by the
/// initial velocity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome {
    /// Largest change of the total energy, with its sign.
    pub energy_drift: f64,
    /// ∫ force dt on the body against its initial velocity.
    pub impulse: f64,
    /// Largest |ΣF|.
    pub balance_max: f64,
    /// Median of |ΣF| over the steps in contact.
    pub balance_median: f64,
    /// Velocity across the initial one at the end.
    pub sideways: f64,
    /// Velocity against the initial one at the end, not divided.
    pub rebound: f64,
    /// Time of the last step, s.
    pub end: f64,
    /// Most crossings of one step.
    pub crossings: usize,
    /// Seconds per step.
    pub seconds_per_step: f64,
    /// Part of them spent in contact.
    pub contact_share: f64,
}

impl Attempt {
    /// Runs the setup of a case until `step_count`, or until it fails or `watch`, called after every step, stops it;
    /// then `None`.
    ///
    /// # Errors
    /// If the case cannot be started.
    pub(super) fn run<const D: usize>(
        method: Method,
        case: &Case,
        setup: Setup<D>,
        step_count: u64,
        watch: &mut dyn FnMut(u64) -> ControlFlow<()>,
    ) -> Result<Option<Self>> {
        let mut simulation = Simulation::start(setup)?;
        let motion = Motion::new(case, simulation.model().parts())?;
        let mut samples = vec![simulation.sample()];
        let mut failure = None;
        while simulation.state().step < step_count {
            match simulation.advance() {
                Ok(sample) => samples.push(sample),
                Err(error) => {
                    failure = Some(error.to_string());
                    break;
                }
            }
            if watch(simulation.state().step).is_break() {
                return Ok(None);
            }
        }
        let start = samples[0].total;
        Ok(Some(Self {
            method,
            exponent: case.contact.exponent,
            stiffness: case.contact.stiffness,
            energy: samples.iter().map(|sample| (sample.time, sample.total / start)).collect(),
            outcome: Outcome::of(&motion, &samples)?,
            failure,
        }))
    }

    /// Method and law in one word, as in `lines m=2`.
    pub fn name(&self) -> String {
        format!("{} m={}", self.method.name(), self.exponent)
    }
}

impl Outcome {
    fn of<const D: usize>(motion: &Motion<D>, samples: &[Sample<D>]) -> Result<Self> {
        let (first, last) = (&samples[0], &samples[samples.len() - 1]);
        let figures = motion.figures(FigureKind::Impact, samples);
        let figure = |name: &str| {
            let found = figures.iter().find(|figure| figure.name == name).and_then(|figure| figure.value);
            found.with_context(|| format!("the impact has no {name}"))
        };
        let speed = motion.velocity.iter().map(|v| v * v).sum::<f64>().sqrt();
        let drifts = samples.iter().map(|sample| sample.total / first.total - 1.0);
        let size = |sample: &Sample<D>| sample.bodies[motion.body].iter().map(|f| f * f).sum::<f64>().sqrt();
        let peak = samples.iter().map(size).fold(f64::MIN_POSITIVE, f64::max);
        let mut balances: Vec<f64> = samples.iter().filter(|s| s.overlap > 0.0).map(|s| s.balance / peak).collect();
        balances.sort_by(f64::total_cmp);
        let seconds: f64 = samples.iter().map(|sample| sample.seconds).sum();
        let contact_seconds: f64 = samples.iter().map(|sample| sample.contact_seconds).sum();
        Ok(Self {
            energy_drift: drifts.max_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap_or(0.0),
            impulse: figure("impulse")?,
            balance_max: balances.last().copied().unwrap_or(0.0),
            balance_median: balances.get(balances.len() / 2).copied().unwrap_or(0.0),
            sideways: figure("sideways")? / speed,
            rebound: figure("rebound")?,
            end: last.time,
            crossings: samples.iter().map(|sample| sample.crossings).max().unwrap_or(0),
            seconds_per_step: seconds / (samples.len() - 1).max(1) as f64,
            contact_share: contact_seconds / seconds.max(f64::MIN_POSITIVE),
        })
    }
}
