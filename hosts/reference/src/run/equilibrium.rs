//! From a case of statics to its last file.

use super::hertz::HertzLine;
use super::runner::{Ending, RunOptions};
use super::summary::Summary;
use super::{Figure, fields, patch};
use crate::case::{Case, Document, FigureKind};
use crate::chart::{self, Axis, Mark, Panel, Series, Sign};
use crate::statics::{Equilibrium, Iteration, NewtonSettings, Path, StaticsError};
use anyhow::{Context, Result};
use fmc_contact::{EnergyLaw, FiberProfile};
use std::fmt::Write;
use std::fs;
use std::ops::ControlFlow;
use std::path::Path as Folder;
use std::time::Instant;

/// ε of the linear law at first, by the size of the bodies.
const FIRST_EPSILON: f64 = 1e-3;

/// Solves of the method of multipliers, at most.
const MOST_SOLVES: usize = 20;

/// A case of statics and its equilibrium.
pub struct Solved<const D: usize> {
    /// The equilibrium.
    pub equilibrium: Equilibrium<D>,
    /// The figures of the case.
    pub figures: Vec<Figure>,
    /// Pressures, where they are to be compared with Hertz'.
    pub hertz: Option<HertzLine>,
}

/// Solves a case of statics in `D` dimensions; `watch` is told of every iteration.
///
/// # Errors
/// If the case makes no problem, or no equilibrium is found.
pub fn solve<const D: usize>(
    folder: &Folder,
    case: &Case,
    threads: usize,
    watch: &mut dyn FnMut(&Iteration) -> ControlFlow<()>,
) -> Result<Solved<D>> {
    let (equilibrium, solved) = equilibrium::<D>(folder, case, threads, watch)?;
    solved?;
    Solved::new(case, equilibrium)
}

impl<const D: usize> Solved<D> {
    fn new(case: &Case, equilibrium: Equilibrium<D>) -> Result<Self> {
        let penetration = equilibrium.true_contact()?.penetration;
        let hertz = match case.figures.kind {
            FigureKind::Hertz => Some(HertzLine::new(case, &equilibrium)?),
            _ => None,
        };
        let figures = match &hertz {
            Some(hertz) => hertz.figures(penetration),
            None => patch::figures(case, &equilibrium, penetration)?,
        };
        Ok(Self { equilibrium, figures, hertz })
    }
}

/// Solves a case of statics in `D` dimensions and writes its files. `watch` is told of every iteration and may break off.
///
/// # Errors
/// Those of [`solve`], and if a file cannot be written.
pub fn run_at_rest<const D: usize>(
    document: &Document,
    case: &Case,
    options: &RunOptions,
    watch: &mut dyn FnMut(&Iteration) -> ControlFlow<()>,
) -> Result<Ending> {
    let out = &options.out;
    fs::create_dir_all(out).with_context(|| format!("{} cannot be made", out.display()))?;
    let clock = Instant::now();
    let mut log: Vec<Iteration> = Vec::new();
    let mut told = |iteration: &Iteration| {
        log.push(*iteration);
        watch(iteration)
    };
    let (equilibrium, solved) = equilibrium::<D>(&document.folder, case, options.threads, &mut told)?;
    let seconds = clock.elapsed().as_secs_f64();
    let write = |name: &str, text: &str| {
        let path = out.join(name);
        fs::write(&path, text).with_context(|| format!("{} cannot be written", path.display()))
    };
    write("iterations.csv", &table(&log))?;
    // What was found last is worth looking at, also where the way ended too early.
    fields::grid_at_rest(&equilibrium).write(&out.join("equilibrium.vtu"))?;
    match solved {
        Err(StaticsError::Interrupted) => {
            return Ok(Ending::Interrupted { step: log.len() as u64, time: equilibrium.load() });
        }
        solved => solved?,
    }
    let Solved { equilibrium, figures, hertz } = Solved::new(case, equilibrium)?;
    if let Some(hertz) = hertz {
        write("pressure.csv", &profile(&hertz))?;
        chart::draw(out, "pressure", &case.title, &[panel(&hertz)])?;
    }
    let contact = &equilibrium.balance().contact;
    let mut summary = Summary::new(document, case, figures, [0.0; 2]);
    summary.iterations = equilibrium.iterations as u64;
    (summary.seconds, summary.contact_seconds) = (seconds, equilibrium.contact_seconds);
    summary.crossings = contact.crossing_count;
    summary.residuals = log.iter().map(|iteration| iteration.residual).collect();
    summary.warnings = contact.warnings.iter().map(ToString::to_string).collect();
    write("summary.json", &(serde_json::to_string_pretty(&summary)? + "\n"))?;
    Ok(Ending::Finished(Box::new(summary)))
}

/// The equilibrium of a case, or the last state on the way to it and why there is none.
fn equilibrium<const D: usize>(
    folder: &Folder,
    case: &Case,
    threads: usize,
    watch: &mut dyn FnMut(&Iteration) -> ControlFlow<()>,
) -> Result<(Equilibrium<D>, Result<(), StaticsError>)> {
    let steps = case.load_steps.unwrap_or_default();
    let mut equilibrium = Equilibrium::new(case.problem::<D>(folder, threads)?)?;
    let (tolerance, most_iterations) = (steps.tolerance, steps.most_iterations);
    equilibrium.settings = NewtonSettings { tolerance, most_iterations, ..Default::default() };
    let path = Path { steps: steps.count, ..Default::default() };
    let mut way = || match equilibrium.problem().contact.law {
        EnergyLaw::Fiber { k, profile: FiberProfile::Linear { epsilon } } => {
            let first = epsilon.max(FIRST_EPSILON * equilibrium.size());
            equilibrium.set_law(EnergyLaw::Fiber { k, profile: FiberProfile::Linear { epsilon: first } })?;
            equilibrium.follow(path, watch)?;
            equilibrium.continue_epsilon(epsilon, watch)
        }
        _ => {
            equilibrium.follow(path, watch)?;
            steps.penetration.map_or(Ok(()), |target| equilibrium.augment(target, MOST_SOLVES, watch).map(|_| ()))
        }
    };
    let solved = way();
    Ok((equilibrium, solved))
}

/// All iterations, a line for each.
fn table(log: &[Iteration]) -> String {
    let mut text = "load,iteration,residual,energy,facets,penetration,tangent,length\n".to_owned();
    for Iteration { load, iteration, residual, energy, facets, penetration, tangent, length } in log {
        let tangent = tangent.map_or(String::new(), |tangent| tangent.to_string());
        writeln!(text, "{load:?},{iteration},{residual:?},{energy:?},{facets},{penetration:?},{tangent},{length:?}")
            .expect("writing into a string");
    }
    text
}

/// Nodal pressures beside the closed form.
fn profile(hertz: &HertzLine) -> String {
    let lines = hertz.profile.iter().map(|(x, p)| format!("{x:?},{p:?},{:?}\n", hertz.closed_form(*x)));
    std::iter::once("x,pressure,hertz\n".to_owned()).chain(lines).collect()
}

fn panel(hertz: &HertzLine) -> Panel {
    let reach = hertz.profile.iter().map(|(x, _)| x.abs()).fold(0.0, f64::max);
    let curve = (-400..=400).map(|k| f64::from(k) / 400.0 * reach).map(|x| (x, hertz.closed_form(x))).collect();
    let nodes = Series {
        mark: Mark::Points,
        sign: Sign::Circle,
        ..Series::line("nodal pressure", (213, 94, 0), hertz.profile.clone())
    };
    Panel {
        x: Axis::linear("place across the contact, m".to_owned()),
        y: Axis::linear("contact pressure, Pa".to_owned()),
        series: vec![nodes, Series::line("Hertz", (30, 30, 30), curve)],
    }
}
