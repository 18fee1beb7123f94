//! From a case of statics to its last file.

use super::driven::Drive;
use super::hertz::HertzLine;
use super::runner::{Ending, RunOptions};
use super::summary::Summary;
use super::way::{LoadStep, Way};
use super::{Figure, Profile, fibers, fields, forces, indentation, patch, sliding};
use crate::case::{Case, Document, FigureKind};
use crate::chart::{self, Axis, Mark, Panel, Series};
use anyhow::{Context, Result};
use fmc_mesh_io::{fiber_grid, write_whole};
use fmc_solid::statics::{Equilibrium, Iteration, StaticsError};
use std::fmt::Write;
use std::fs;
use std::ops::ControlFlow;
use std::path::Path as Folder;
use std::time::Instant;

/// A case of statics and its equilibrium.
pub struct Solved<const D: usize> {
    /// The equilibrium.
    pub equilibrium: Equilibrium<D>,
    /// The equilibria on the way, the last one too.
    pub steps: Vec<LoadStep>,
    /// The figures of the case.
    pub figures: Vec<Figure>,
    /// Pressures, where they are to be compared with something.
    pub profile: Option<Profile>,
}

/// Solves a case of statics in `D` dimensions; `watch` is called after every iteration.
///
/// # Errors
/// If the case makes no problem, or no equilibrium is found.
pub fn solve<const D: usize>(
    folder: &Folder,
    case: &Case,
    threads: usize,
    watch: &mut dyn FnMut(&Iteration) -> ControlFlow<()>,
) -> Result<Solved<D>> {
    let Way { equilibrium, steps, end } = Way::go(folder, case, threads, watch, &mut |_| ())?;
    end?;
    Solved::new(case, equilibrium, steps)
}

impl<const D: usize> Solved<D> {
    fn new(case: &Case, equilibrium: Equilibrium<D>, steps: Vec<LoadStep>) -> Result<Self> {
        let (figures, profile) = figures_of(case, &equilibrium, &steps)?;
        Ok(Self { equilibrium, steps, figures, profile })
    }
}

/// The figures of a case, and pressures to draw.
fn figures_of<const D: usize>(
    case: &Case,
    equilibrium: &Equilibrium<D>,
    steps: &[LoadStep],
) -> Result<(Vec<Figure>, Option<Profile>)> {
    let penetration = equilibrium.true_contact()?.penetration;
    Ok(match case.figures.kind {
        FigureKind::Forces => (forces::figures(case, steps), None),
        FigureKind::Hertz => {
            let hertz = HertzLine::new(case, equilibrium)?;
            (hertz.figures(penetration), Some(hertz.drawn()))
        }
        FigureKind::Driven => (Drive::of(case)?.figures(case, equilibrium, steps), None),
        FigureKind::Sliding => (sliding::figures(case, equilibrium, steps), None),
        FigureKind::Patch => (patch::figures(case, equilibrium, penetration)?, None),
        _ => indentation::figures(case, equilibrium, steps, penetration)?,
    })
}

/// Solves a case of statics and writes its files. `watch` is called after every iteration and may stop the solver.
///
/// # Errors
/// Those of [`solve`], and if a file cannot be written.
pub fn run_at_rest(
    document: &Document,
    case: &Case,
    options: &RunOptions,
    watch: &mut dyn FnMut(&Iteration) -> ControlFlow<()>,
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
    watch: &mut dyn FnMut(&Iteration) -> ControlFlow<()>,
) -> Result<Ending> {
    let out = &options.out;
    fs::create_dir_all(out.join("fields")).with_context(|| format!("{} cannot be made", out.display()))?;
    let clock = Instant::now();
    let mut log: Vec<Iteration> = Vec::new();
    let mut told = |iteration: &Iteration| {
        log.push(*iteration);
        watch(iteration)
    };
    let mut writing = 0.0;
    let mut series = FieldSeries::default();
    let mut reached = |at: &Equilibrium<D>| {
        let clock = Instant::now();
        series.add(out, at, case.output.frames > 0);
        writing += clock.elapsed().as_secs_f64();
    };
    let way = Way::go(&document.folder, case, options.threads, &mut told, &mut reached)?;
    let seconds = clock.elapsed().as_secs_f64() - writing;
    let write = |name: &str, text: &str| {
        let path = out.join(name);
        write_whole(&path, text)
    };
    write("iterations.csv", &table(&log))?;
    write("load_steps.csv", &way.table())?;
    series.finish(out)?;
    // What was found last is worth looking at, also where the way ended too early.
    fields::grid_at_rest(&way.equilibrium).write(&out.join("equilibrium.vtu"))?;
    if let Err(StaticsError::Interrupted) = way.end {
        return Ok(Ending::Interrupted { step: log.len() as u64, time: way.equilibrium.load() });
    }
    let Way { equilibrium, steps, end } = way;
    end?;
    // An equilibrium that lacks what its figures need is one: its files and its other numbers stay.
    let (figures, profile, lacking) = match figures_of(case, &equilibrium, &steps) {
        Ok((figures, profile)) => (figures, profile, None),
        Err(error) => {
            let none = |&name: &&'static str| Figure { name, value: None, unit: "" };
            (case.figures.kind.keys().iter().map(none).collect(), None, Some(error))
        }
    };
    let traces = if case.output.fibers > 0 { fibers::traces(case, &equilibrium)? } else { Vec::new() };
    if !traces.is_empty() {
        fiber_grid(&traces, case.output.fibers).write(&out.join("fibers.vtu"))?;
    }
    if let Some(profile) = profile {
        write("pressure.csv", &profile.table())?;
        chart::draw(out, "pressure", &case.title, &profile.panels())?;
    }
    if steps.len() > 1 {
        let panel = match case.figures.kind {
            FigureKind::Driven => Drive::of(case)?.panel::<D>(&steps),
            _ => reactions::<D>(&steps),
        };
        let title = format!("{}: contact force on {}", case.title, case.bodies[case.figured()].name);
        chart::draw(out, "reactions", &title, &[panel])?;
    }
    let contact = &equilibrium.balance().contact;
    let mut summary = Summary::new(document, case, figures, [0.0; 2]);
    summary.iterations = equilibrium.iterations as u64;
    summary.contact_iterations = equilibrium.contact_iterations as u64;
    summary.factorisations = equilibrium.factorisations();
    summary.updates = case.load_steps.as_ref().and_then(|plan| plan.penetration).map(|_| equilibrium.updates);
    summary.nodal_penetration = equilibrium.nodal_penetration().ok();
    (summary.seconds, summary.contact_seconds) = (seconds, equilibrium.contact_seconds);
    summary.crossings = contact.crossing_count;
    summary.residuals = log.iter().map(|iteration| iteration.residual).collect();
    summary.warnings = contact.warnings.iter().map(ToString::to_string).collect();
    summary.warnings.extend(lacking.map(|error| format!("there are no figures: {error:#}")));
    summary.warnings.extend(equilibrium.unturned().map(|residual| {
        let stalled = equilibrium.stalled_turn();
        let stalled = stalled.map(|at| format!(", and turning them came to a halt at {at:.1e}")).unwrap_or_default();
        format!(
            "the equilibrium is one along contact normals of its way; along those found where it is, the residual is \
             {residual:.1e}{stalled}"
        )
    }));
    write("summary.json", &(serde_json::to_string_pretty(&summary)? + "\n"))?;
    Ok(Ending::Finished(Box::new(summary)))
}

/// Fields of every equilibrium on the way.
#[derive(Default)]
struct FieldSeries {
    count: usize,
    failed: Option<anyhow::Error>,
}

impl FieldSeries {
    fn file(number: usize) -> String {
        format!("fields/{number:04}.vtu")
    }

    fn add<const D: usize>(&mut self, out: &Folder, at: &Equilibrium<D>, wanted: bool) {
        if wanted && self.failed.is_none() {
            self.failed = fields::grid_at_rest(at).write(&out.join(Self::file(self.count))).err();
            self.count += 1;
        }
    }

    /// The list that ParaView opens.
    fn finish(self, out: &Folder) -> Result<()> {
        if let Some(error) = self.failed {
            return Err(error);
        }
        let mut text = "<?xml version=\"1.0\"?>\n\
            <VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n<Collection>\n"
            .to_owned();
        for number in 0..self.count {
            let file = Self::file(number);
            writeln!(text, "<DataSet timestep=\"{}\" group=\"\" part=\"0\" file=\"{file}\"/>", number + 1)?;
        }
        text += "</Collection>\n</VTKFile>\n";
        let path = out.join("fields.pvd");
        write_whole(&path, text)
    }
}

/// Forces over the load steps, stage after stage.
fn reactions<const D: usize>(steps: &[LoadStep]) -> Panel {
    const COLORS: [(u8, u8, u8); 3] = [(0, 114, 178), (213, 94, 0), (0, 158, 115)];
    let series = (0..D).map(|axis| {
        let points = steps.iter().map(|step| (step.stage as f64 + step.load, step.force[axis])).collect();
        Series { mark: Mark::LineAndPoints, ..Series::line(["x", "y", "z"][axis], COLORS[axis], points) }
    });
    let unit = if D == 2 { "N/m" } else { "N" };
    Panel {
        x: Axis::linear("stage and part of its load".to_owned()),
        y: Axis::linear(format!("contact force, {unit}")),
        series: series.collect(),
    }
}

/// All iterations, a line for each.
fn table(log: &[Iteration]) -> String {
    let mut text = "load,iteration,residual,energy,facets,penetration,tangent,length,contact_iterations\n".to_owned();
    for Iteration { load, iteration, residual, energy, facets, penetration, tangent, length, contact_iterations } in log
    {
        let tangent = tangent.map_or(String::new(), |tangent| tangent.to_string());
        writeln!(text, "{load:?},{iteration},{residual:?},{energy:?},{facets},{penetration:?},{tangent},{length:?},{contact_iterations}")
            .expect("writing into a string");
    }
    text
}
