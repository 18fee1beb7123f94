//! An impact with every method and law.

use super::{Attempt, Method};
use crate::case::Case;
use anyhow::{Result, ensure};
use std::ops::ControlFlow;
use std::path::PathBuf;

/// Settings of the study.
#[derive(Clone, Debug)]
pub struct Impact {
    /// The impact, 2D; its own law is w = k V.
    pub case: Case,
    /// Folder that its mesh files are looked for in.
    pub folder: PathBuf,
    /// Methods to compare.
    pub methods: Vec<Method>,
    /// Stiffness of w = k V², Pa/m².
    pub quadratic_stiffness: f64,
    /// Isotropic fibers at every step.
    pub segments: usize,
    /// Distance between lines, m; `None` for that of the case.
    pub spacing: Option<f64>,
    /// Steps, at most; `None` for all of the case.
    pub step_count: Option<u64>,
    /// Threads; nothing but the seconds depends on them.
    pub threads: usize,
}

/// Where a study stands.
#[derive(Clone, Debug)]
pub struct Progress {
    /// What runs, as in `lines m=2`.
    pub name: String,
    /// Steps made in all attempts.
    pub step: u64,
    /// Steps in all attempts.
    pub step_count: u64,
}

impl Impact {
    /// Makes all attempts, those with w = k V first; `watch` is called after every step and may stop the study. An
    /// attempt that fails is a result.
    ///
    /// # Errors
    /// If the case is no impact in 2D, or cannot be started.
    pub fn run(&self, watch: &mut dyn FnMut(&Progress) -> ControlFlow<()>) -> Result<Vec<Attempt>> {
        ensure!(self.case.dimension == 2, "the study is made for an impact in 2D");
        ensure!(self.case.contact.exponent == 1.0, "the case must have the law w = k V, m = 1");
        let step = self.case.time.step;
        let all = step.map(|step| self.case.time.steps(step));
        ensure!(all.is_some(), "the case must name its time step");
        let steps = self.step_count.unwrap_or(u64::MAX).min(all.unwrap_or(0));
        let laws = [(self.case.contact.stiffness, 1.0), (self.quadratic_stiffness, 2.0)];
        let pairs: Vec<_> = laws.iter().flat_map(|law| self.methods.iter().map(|method| (*law, *method))).collect();
        let mut attempts = Vec::new();
        for (law, method) in &pairs {
            let contact = method.contact(&self.case.contact, *law, self.segments, self.spacing);
            let case = Case { contact, ..self.case.clone() };
            let before = attempts.len() as u64 * steps;
            let name = format!("{} m={}", method.name(), law.1);
            let mut progress = Progress { name, step: 0, step_count: pairs.len() as u64 * steps };
            let mut told = |step: u64| {
                progress.step = before + step;
                watch(&progress)
            };
            match Attempt::run(*method, &case, case.setup::<2>(&self.folder, self.threads)?, steps, &mut told)? {
                Some(attempt) => attempts.push(attempt),
                None => break,
            }
        }
        Ok(attempts)
    }
}
