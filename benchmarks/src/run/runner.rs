//! From the first step to the last file.

#[cfg(feature = "plots")]
use super::animation;
use super::figures::Motion;
use super::frames::Frames;
use super::history::History;
use super::summary::{Costs, Summary};
use super::{fields, plots};
use crate::case::{Case, Document, MOST_STEPS};
use anyhow::{Context, Result, bail, ensure};
use fmc_mesh_io::write_whole;
use fmc_solid::dynamics::{Sample, Simulation, Step};
use std::fs;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// How a case is carried out, beside what the case itself says.
#[derive(Clone, Debug)]
pub struct RunOptions {
    /// Folder of all files; made if it is not there.
    pub out: PathBuf,
    /// Threads; nothing but the seconds depends on them.
    pub threads: usize,
    /// Go on with the checkpoint in the folder.
    pub resume: bool,
}

/// Where a run stands.
#[derive(Clone, Copy, Debug)]
pub struct Progress {
    /// Steps made.
    pub step: u64,
    /// Steps in all.
    pub step_count: u64,
    /// Time, s.
    pub time: f64,
    /// Kinetic, strain, contact and total energy.
    pub energies: [f64; 4],
    /// Contact force on the body that the figures are about, against its initial velocity.
    pub force: f64,
    /// Steps per second since the start of this run.
    pub steps_per_second: f64,
}

/// How a run ended.
#[derive(Clone, Debug)]
pub enum Ending {
    /// At its end.
    Finished(Box<Summary>),
    /// At its end already when it was to be gone on with; nothing is written.
    FinishedBefore(Box<Summary>),
    /// Where it was asked to stop; it can be resumed.
    Interrupted {
        /// Steps made.
        step: u64,
        /// Time, s.
        time: f64,
    },
}

/// Carries out a case. `watch` is called after every step and may ask to stop.
///
/// # Errors
/// If the case makes no model, its step is not stable, a step fails, or a file cannot be written. What was computed
/// until then is in the folder.
pub fn run(
    document: &Document,
    case: &Case,
    options: &RunOptions,
    watch: &mut dyn FnMut(&Progress) -> ControlFlow<()>,
) -> Result<Ending> {
    match case.dimension {
        2 => run_in::<2>(document, case, options, watch),
        _ => run_in::<3>(document, case, options, watch),
    }
}

fn run_in<const D: usize>(
    document: &Document,
    case: &Case,
    options: &RunOptions,
    watch: &mut dyn FnMut(&Progress) -> ControlFlow<()>,
) -> Result<Ending> {
    let mut run = Run::<D>::start(document, case, options)?;
    if options.resume && run.simulation.state().step >= run.step_count && options.out.join(SUMMARY).is_file() {
        return Ok(Ending::FinishedBefore(Box::new(run.summary(document, case))));
    }
    let stopped = run.advance(watch);
    // Pictures show what there is, also of a run that was interrupted or failed.
    let closed_form = run.motion.closed_form(case);
    plots::draw(&run.out, &case.title, &run.names, run.direction, &run.history.samples, closed_form)?;
    match stopped? {
        ControlFlow::Break(()) => {
            run.save()?;
            let state = run.simulation.state();
            Ok(Ending::Interrupted { step: state.step, time: run.simulation.time() })
        }
        ControlFlow::Continue(()) => {
            #[cfg(feature = "plots")]
            if case.output.animation && D == 2 {
                let frames = run.frames.until(run.step_count).map(|(time, file)| (time, run.out.join(file)));
                animation::write(&run.out.join("animation.gif"), &case.title, run.simulation.model(), frames)?;
            }
            let summary = run.summary(document, case);
            let path = run.out.join(SUMMARY);
            write_whole(&path, serde_json::to_string_pretty(&summary)? + "\n")?;
            // The state stays, by which a run that is at its end is known; what it cost stands in the summary.
            let [state, costs] = CHECKPOINT;
            run.simulation.save(&run.out.join(state))?;
            remove(&run.out, &[costs])?;
            Ok(Ending::Finished(Box::new(summary)))
        }
    }
}

/// The state, and what it cost to get there.
const CHECKPOINT: [&str; 2] = ["checkpoint.state", "checkpoint.json"];

/// Figures and checks, of a run that came to its end.
const SUMMARY: &str = "summary.json";

/// What an earlier run may have left.
const RESULTS: [&str; 3] = [SUMMARY, "animation.gif", "fields.pvd"];

/// A run under way.
struct Run<const D: usize> {
    out: PathBuf,
    simulation: Simulation<D>,
    history: History<D>,
    frames: Frames,
    motion: Motion<D>,
    costs: Costs,
    step_count: u64,
    /// Names of bodies and obstacles.
    names: Vec<String>,
    /// Axis along which the body moves fastest.
    direction: usize,
}

impl<const D: usize> Run<D> {
    fn start(document: &Document, case: &Case, options: &RunOptions) -> Result<Self> {
        let out = options.out.clone();
        let folder = out.join("fields");
        fs::create_dir_all(&folder).with_context(|| format!("{} cannot be made", folder.display()))?;
        let mut setup = case.setup::<D>(&document.folder, options.threads)?;
        if let Some(fraction) = case.time.fraction {
            let limit = Simulation::start(case.setup::<D>(&document.folder, options.threads)?)?.limit();
            setup.step = Step::Fixed(fraction * limit.step());
        }
        let motion = Motion::new(case, setup.model.parts())?;
        let bodies: Vec<String> = case.bodies.iter().map(|body| body.name.clone()).collect();
        let obstacles: Vec<String> = case.obstacles.iter().map(|obstacle| obstacle.name.clone()).collect();
        let names = [&bodies[..], &obstacles[..]].concat();
        let [state, costs] = CHECKPOINT.map(|name| out.join(name));
        let table = out.join("history.csv");
        let (simulation, history, costs) = if options.resume {
            if !state.exists() {
                bail!("{} holds no checkpoint to resume from", out.display());
            }
            let simulation = Simulation::resume(setup, &state)?;
            let history = History::resume(&table, &bodies, &obstacles, simulation.state().step)?;
            let read = |path: &Path| fs::read_to_string(path).ok().and_then(|text| serde_json::from_str(&text).ok());
            let costs = read(&costs).or_else(|| read(&out.join(SUMMARY)));
            (simulation, history, costs.unwrap_or_default())
        } else {
            let simulation = Simulation::start(setup)?;
            clear(&out)?;
            let mut history = History::create(&table, &bodies, &obstacles)?;
            history.push(simulation.sample())?;
            (simulation, history, Costs::default())
        };
        let step_count = case.time.steps(simulation.step_size());
        ensure!(
            step_count as f64 <= MOST_STEPS,
            "steps of {:.3e} s reach time.end after {step_count}; at most {MOST_STEPS:.0e} are made",
            simulation.step_size()
        );
        let costs = Costs { step_count: Some(costs.step_count.unwrap_or(step_count)), ..costs };
        if let Some(count) = costs.step_count.filter(|count| *count != step_count) {
            let end = count as f64 * simulation.step_size();
            bail!(
                "the run in {} goes to time.end = {end:.6e} s, and its fields are spaced by that: resume it with this end, or \
                 run anew without --resume to another",
                out.display()
            );
        }
        let fastest = (0..D).max_by(|a, b| motion.velocity[*a].abs().total_cmp(&motion.velocity[*b].abs()));
        let frames = Frames::new(case.output.frames, step_count, simulation.step_size());
        let direction = fastest.unwrap_or(0);
        let run = Self { out, simulation, history, frames, motion, costs, step_count, names, direction };
        if !options.resume {
            run.write_frame()?;
        }
        Ok(run)
    }

    /// Makes the remaining steps.
    fn advance(&mut self, watch: &mut dyn FnMut(&Progress) -> ControlFlow<()>) -> Result<ControlFlow<()>> {
        let (clock, first) = (Instant::now(), self.simulation.state().step);
        while self.simulation.state().step < self.step_count {
            let sample = self.simulation.advance()?;
            self.account(&sample);
            let progress = Progress {
                step: sample.step,
                step_count: self.step_count,
                time: sample.time,
                energies: [sample.kinetic, sample.strain, sample.contact, sample.total],
                force: self.motion.against(&sample.bodies[self.motion.body]),
                steps_per_second: (sample.step - first) as f64 / clock.elapsed().as_secs_f64(),
            };
            self.history.push(sample)?;
            self.write_frame()?;
            if watch(&progress).is_break() && progress.step < self.step_count {
                return Ok(ControlFlow::Break(()));
            }
        }
        Ok(ControlFlow::Continue(()))
    }

    fn account(&mut self, sample: &Sample<D>) {
        self.costs.seconds += sample.seconds;
        self.costs.contact_seconds += sample.contact_seconds;
        for warning in &sample.warnings {
            // Once per kind: the same sentence with other numbers says nothing new.
            let kind = |text: &str| text.chars().filter(|c| c.is_alphabetic()).collect::<String>();
            if !self.costs.warnings.iter().any(|known| kind(known) == kind(warning)) {
                self.costs.warnings.push(format!("{warning} (first at step {})", sample.step));
            }
        }
    }

    /// Writes the fields, if this step is to have any, and a checkpoint with them.
    fn write_frame(&self) -> Result<()> {
        let step = self.simulation.state().step;
        if let Some(number) = self.frames.at(step) {
            fields::grid(&self.simulation).write(&self.out.join(Frames::file(number)))?;
            self.frames.write_list(&self.out, step)?;
            self.save()?;
        }
        Ok(())
    }

    fn save(&self) -> Result<()> {
        let [state, costs] = CHECKPOINT.map(|name| self.out.join(name));
        self.simulation.save(&state)?;
        write_whole(&costs, serde_json::to_string(&self.costs)?)
    }

    fn summary(&self, document: &Document, case: &Case) -> Summary {
        let samples = &self.history.samples;
        let figures = self.motion.figures(case.figures.kind, samples);
        let steps = [self.simulation.step_size(), self.simulation.limit().step()];
        Summary {
            iterations: self.step_count,
            seconds: self.costs.seconds,
            contact_seconds: self.costs.contact_seconds,
            crossings: samples.iter().map(|sample| sample.crossings).max().unwrap_or(0),
            warnings: self.costs.warnings.clone(),
            ..Summary::new(document, case, figures, steps)
        }
    }
}

/// Removes what an earlier run left, so that nothing of it is taken for the new one's.
fn clear(out: &Path) -> Result<()> {
    remove(out, &CHECKPOINT)?;
    remove(out, &RESULTS)?;
    let folder = out.join("fields");
    for entry in fs::read_dir(&folder).with_context(|| format!("{} cannot be read", folder.display()))? {
        let name = entry?.file_name();
        let text = name.to_string_lossy();
        if text.strip_suffix(".vtu").is_some_and(|number| number.len() >= 4 && number.parse::<u64>().is_ok()) {
            remove(&folder, &[&text])?;
        }
    }
    Ok(())
}

fn remove(folder: &Path, names: &[&str]) -> Result<()> {
    for path in names.iter().map(|name| folder.join(name)).filter(|path| path.exists()) {
        fs::remove_file(&path).with_context(|| format!("{} cannot be removed", path.display()))?;
    }
    Ok(())
}
