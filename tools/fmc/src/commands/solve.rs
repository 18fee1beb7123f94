//! `fmc solve`: an input file of Abaqus or CalculiX from its keywords to its results.

use super::interrupt;
use super::time_left::TimeLeft;
use crate::folder;
use anyhow::{Context, Result, anyhow};
use clap::value_parser;
use fmc_deck::{Analysis, Deck, Fault, SolveOptions, Solved, StepResult, frd_start, frd_step, step_table, vtu};
use fmc_mesh_io::write_whole;
use fmc_solid::statics::{Equilibrium, Iteration, LARGEST_TOLERANCE};
use std::io::Write;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering};

/// Solve an input file of Abaqus or CalculiX: bodies at rest, in contact, tied, with friction
///
/// Every step writes a VTU file for ParaView and a block of an FRD file for cgx; files of an earlier run are removed. Unsupported parts of
/// the file are named with their line. Ctrl-C stops it; steps that were solved stay.
#[derive(clap::Args, Clone, Debug)]
#[command(after_help = "Examples:\n  \
    fmc solve model.inp\n  \
    fmc solve model.inp --threads 4 --out results\n\n\
    Keywords: docs/solve.md.\n\
    Exit status: 0, 1 if a step has no equilibrium or none is found, 2 for bad usage or input, 130 if interrupted.")]
pub(crate) struct SolveArgs {
    /// The input file
    file: PathBuf,

    /// Folder of all files [default: out/ and the name of the file]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,

    /// Threads; the results do not depend on them
    #[arg(long, value_name = "T", default_value_t = 1, value_parser = value_parser!(u16).range(1..))]
    threads: u16,

    /// Residual by the forces at which a state counts as balanced, at most 0.01
    #[arg(long, value_name = "R", default_value_t = 1e-9, value_parser = tolerance)]
    tolerance: f64,

    /// Largest mean penetration of a node, a length [default: as small as the forces need it]
    #[arg(long, value_name = "LENGTH", value_parser = crate::estimator_args::positive)]
    penetration: Option<f64>,

    /// Print nothing but errors
    #[arg(long)]
    quiet: bool,
}

fn tolerance(text: &str) -> Result<f64, String> {
    match crate::estimator_args::positive(text)? {
        value if value <= LARGEST_TOLERANCE => Ok(value),
        _ => Err(format!("it must be at most {LARGEST_TOLERANCE}: larger forces out of balance are no equilibrium")),
    }
}

/// Solves the file.
pub(crate) fn run(args: &SolveArgs) -> Result<ExitCode> {
    let stop = interrupt::flag()?;
    let deck = Deck::read(&args.file).map_err(|message| anyhow!(message))?;
    match deck.dimension().map_err(|fault| anyhow!(deck.located(&fault)))? {
        2 => run_in::<2>(args, &deck, &stop),
        _ => run_in::<3>(args, &deck, &stop),
    }
}

fn run_in<const D: usize>(args: &SolveArgs, deck: &Deck, stop: &AtomicBool) -> Result<ExitCode> {
    let located = |fault: Fault| anyhow!(deck.located(&fault));
    let (threads, penetration) = (args.threads.into(), args.penetration.unwrap_or(0.0));
    let options = SolveOptions { threads, tolerance: args.tolerance, penetration };
    let analysis = Analysis::<D>::new(deck, options).map_err(located)?;
    let stem = args.file.file_stem().map_or("model".into(), |stem| stem.to_string_lossy().into_owned());
    let out = args.out.clone().unwrap_or_else(|| PathBuf::from("out").join(&stem));
    let _lock = folder::taken(&out)?;
    std::fs::create_dir_all(&out).with_context(|| format!("{} cannot be made", out.display()))?;
    no_old_steps(&out, &stem)?;
    if !args.quiet {
        for note in &analysis.notes {
            eprintln!("note: {}", deck.located(&Fault::new(note.line, note.message.as_str())));
        }
    }
    let order = analysis.order.clone();
    let mut time = TimeLeft::new(analysis.step_count());
    let mut watch = |step: usize, iteration: &Iteration| {
        if !args.quiet {
            eprintln!("step {step}  {iteration}{}", time.behind(iteration.load));
        }
        if stop.load(Ordering::SeqCst) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let mut frd = String::new();
    let mut reached = |at: &Equilibrium<D>, step: StepResult| -> Result<()> {
        let number = step.number;
        vtu(deck, &order, at, &step).write(&out.join(format!("step-{number}.vtu")))?;
        if frd.is_empty() {
            frd = frd_start(deck, &order, at.model());
        }
        frd += &frd_step(deck, &order, at, &step);
        write_whole(&out.join(format!("{stem}.frd")), format!("{frd} 9999\n"))?;
        match args.quiet {
            true => Ok(()),
            false => Ok(writeln!(std::io::stdout(), "{}", step_table(&step))?),
        }
    };
    match analysis.solve(&mut watch, &mut reached)? {
        Solved::Finished => {
            if !args.quiet {
                writeln!(std::io::stdout(), "Files: {}", out.display())?;
            }
            Ok(ExitCode::SUCCESS)
        }
        Solved::Interrupted(step) => {
            eprintln!("interrupted in step {step}; steps before it are in {}", out.display());
            Ok(ExitCode::from(130))
        }
        Solved::Failed(step, error) => {
            let line = deck.located(&Fault::new(deck.step_line(step), format!("step {step}: {error}")));
            eprintln!("error: {line}");
            Ok(ExitCode::from(1))
        }
    }
}

/// Takes away results of a run before, of which ParaView would show steps as if they were of this one.
fn no_old_steps(out: &Path, stem: &str) -> Result<()> {
    let is_step = |name: &str| {
        let number = name.strip_prefix("step-").and_then(|rest| rest.strip_suffix(".vtu"));
        number.is_some_and(|number| number.parse::<usize>().is_ok()) || name == format!("{stem}.frd")
    };
    let found = std::fs::read_dir(out).with_context(|| format!("{} cannot be read", out.display()))?;
    for entry in found {
        let path = entry?.path();
        if path.file_name().and_then(|name| name.to_str()).is_some_and(is_step) {
            std::fs::remove_file(&path).with_context(|| format!("{} cannot be removed", path.display()))?;
        }
    }
    Ok(())
}
