//! `fmc run`: a case from its file to its figures.

use super::interrupt;
use super::time_left::TimeLeft;
use crate::estimator_args::{EstimatorKind, positive};
use crate::folder;
use anyhow::{Context, Result, bail};
use clap::{ValueEnum, value_parser};
use fmc_benchmarks::case::Document;
use fmc_benchmarks::run::{self, Ending, Progress, RunOptions, Summary};
use fmc_solid::statics::Iteration;
use indicatif::{ProgressBar, ProgressStyle};
use std::io::Write;
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering};

/// Run a case: history, fields for ParaView, pictures, figures and checks
///
/// Ctrl-C stops it after the current step; --resume goes on from there, with the same results bit for bit. A run that is
/// at its end stays as it is.
#[derive(clap::Args, Clone, Debug)]
#[command(after_help = "Examples:\n  \
    fmc run star\n  \
    fmc run star --variant smooth-lines --override contact.spacing=4e-5\n  \
    fmc run my_case.toml --override bodies.star.material.young=1e7 --override time.step=1e-6\n\n\
    Exit status: 0, 1 if a check fails, 2 for bad usage or input, 130 if interrupted.")]
pub(crate) struct RunArgs {
    /// Name of a case (see fmc list), or path of a case file
    case: String,

    /// A variant of the case: a named set of changes
    #[arg(long, value_name = "NAME")]
    variant: Option<String>,

    /// Run the case and then each of its variants, and print their figures side by side
    #[arg(long, conflicts_with_all = ["variant", "law", "out", "resume"])]
    all_variants: bool,

    /// How overlap is measured [default: as in the case]
    #[arg(long, value_enum)]
    estimator: Option<EstimatorKind>,

    /// Energy law [default: as in the case]; another law takes the stiffness of the case's variant of that name, or the
    /// one given by --override contact.stiffness=…
    #[arg(long, value_enum)]
    law: Option<LawChoice>,

    /// Another seed is another random shift of the fibers
    #[arg(long, value_name = "S")]
    seed: Option<u64>,

    /// Threads; the results do not depend on them
    #[arg(long, value_name = "T", default_value_t = 1, value_parser = value_parser!(u16).range(1..))]
    threads: u16,

    /// Time at which to end [s; default: as in the case]
    #[arg(long, value_name = "TIME", value_parser = positive)]
    end: Option<f64>,

    /// Change a value of the case, as in contact.exponent=2 or bodies.star.material.young=1e6; may be repeated
    #[arg(long = "override", value_name = "KEY=VALUE")]
    overrides: Vec<String>,

    /// Folder of all files [default: out/CASE, or out/CASE-VARIANT]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,

    /// Go on with a run that was interrupted; everything else must be as it was
    #[arg(long)]
    resume: bool,

    /// Print nothing but errors
    #[arg(long, conflicts_with = "json")]
    quiet: bool,

    /// Print the summary as JSON and nothing else
    #[arg(long)]
    json: bool,
}

/// `--law`
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
enum LawChoice {
    /// w = k V^m
    Volume,
    /// Pressure = k times penetration, line by line
    Fiber,
    /// Pressure = k times penetration, from the depth below both surfaces
    Depth,
}

impl RunArgs {
    /// The case file with all that the options change.
    fn document(&self) -> Result<Document> {
        let mut document = Document::open(&self.case)?;
        if let Some(variant) = &self.variant {
            document.choose(variant)?;
        }
        if let Some(law) = self.law {
            self.choose_law(&mut document, law.to_possible_value().map_or(String::new(), |v| v.get_name().to_owned()))?;
        }
        if let Some(estimator) = self.estimator {
            let name = if estimator == EstimatorKind::Exact { "exact" } else { "fibers" };
            document.override_with("--estimator", &format!("contact.estimator={name}"))?;
        }
        if let Some(seed) = self.seed {
            document.override_with("--seed", &format!("contact.seed={seed}"))?;
        }
        if let Some(end) = self.end {
            document.override_with("--end", &format!("time.end={end:?}"))?;
        }
        for assignment in &self.overrides {
            document.override_with("--override", assignment)?;
        }
        Ok(document)
    }

    /// A stiffness goes with its law: another law comes from the variant of its name, or with a stiffness of the user's.
    fn choose_law(&self, document: &mut Document, law: String) -> Result<()> {
        let is_now = document.value("contact.law").and_then(|value| value.as_str()) == Some(&law);
        let has_stiffness = |text: &String| text.trim_start().starts_with("contact.stiffness");
        if is_now {
            return Ok(());
        }
        if self.overrides.iter().any(has_stiffness) {
            return Ok(document.override_with("--law", &format!("contact.law={law}"))?);
        }
        let has_variant = document.value(&format!("variants.{law}")).is_some() && self.variant.is_none();
        if !has_variant {
            bail!(
                "--law {law}: another law needs another stiffness; give it with --override contact.stiffness=… \
                 (volume: energy / volume^m; fiber and depth: pressure / penetration)"
            );
        }
        Ok(document.choose(&law)?)
    }
}

/// Runs the case, or it and all its variants.
pub(crate) fn run(args: &RunArgs) -> Result<ExitCode> {
    let stop = interrupt::flag()?;
    let document = args.document()?;
    if !args.all_variants {
        let outcome = run_one(args, &document, &stop)?;
        return Ok(ExitCode::from(outcome.status()));
    }
    let variants: Vec<String> = document.case()?.variants.keys().cloned().collect();
    let (mut summaries, mut status) = (Vec::new(), 0);
    for variant in std::iter::once(None).chain(variants.into_iter().map(Some)) {
        let outcome = run_one(args, &RunArgs { variant, ..args.clone() }.document()?, &stop)?;
        status = outcome.status().max(status);
        match outcome {
            Outcome::Finished(summary) => summaries.push(*summary),
            Outcome::Interrupted => return Ok(ExitCode::from(status)),
        }
    }
    if args.json {
        writeln!(std::io::stdout(), "{}", serde_json::to_string_pretty(&summaries)?)?;
    } else if !args.quiet {
        writeln!(std::io::stdout(), "{}", Summary::side_by_side(&summaries))?;
    }
    Ok(ExitCode::from(status))
}

/// Results of a run for the report.
enum Outcome {
    Finished(Box<Summary>),
    Interrupted,
}

impl Outcome {
    /// Exit status.
    fn status(&self) -> u8 {
        match self {
            Outcome::Finished(summary) => u8::from(!summary.is_ok()),
            Outcome::Interrupted => 130,
        }
    }
}

/// Runs one variant and reports it.
fn run_one(args: &RunArgs, document: &Document, stop: &AtomicBool) -> Result<Outcome> {
    let case = document.case()?;
    if args.resume && case.load_steps.is_some() && !args.quiet {
        eprintln!("an equilibrium is not gone on with: it is sought from the start");
    }
    let name = document.variant.as_ref().map_or(document.name.clone(), |v| format!("{}-{v}", document.name));
    let out = args.out.clone().unwrap_or_else(|| PathBuf::from("out").join(&name));
    let _lock = folder::taken(&out)?;
    let options = RunOptions { out: out.clone(), threads: args.threads.into(), resume: args.resume };
    let bar = if args.quiet { ProgressBar::hidden() } else { ProgressBar::new(1) };
    bar.set_style(ProgressStyle::with_template("{bar:24} {pos}/{len} {eta} left | {msg}")?);
    let dimension = case.dimension;
    if let Some(load_steps) = &case.load_steps {
        let mut time = TimeLeft::new(1 + load_steps.then.len());
        let mut watch = |iteration: &Iteration| {
            if !args.quiet && !args.json {
                eprintln!("{iteration}{}", time.behind(iteration.load));
            }
            if stop.load(Ordering::SeqCst) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let ending = run::run_at_rest(document, &case, &options, &mut watch);
        return report(args, &case.title, &out, ending.with_context(|| name)?);
    }
    let mut watch = |progress: &Progress| {
        bar.set_length(progress.step_count);
        bar.set_position(progress.step);
        // The bar draws some times a second; a message for every step would cost more than small steps do.
        if progress.step.is_multiple_of(16) {
            bar.set_message(message(progress, dimension));
        }
        if stop.load(Ordering::SeqCst) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let ending = run::run(document, &case, &options, &mut watch);
    bar.finish_and_clear();
    report(args, &case.title, &out, ending.with_context(|| name)?)
}

/// Prints how a run ended.
fn report(args: &RunArgs, title: &str, out: &std::path::Path, ending: Ending) -> Result<Outcome> {
    match ending {
        Ending::Interrupted { step, time } => {
            if !args.quiet {
                eprintln!(
                    "interrupted after step {step}, at {time:.4e} s; results so far are in {0}\nRun the same command \
                     with --resume to continue.",
                    out.display()
                );
            }
            Ok(Outcome::Interrupted)
        }
        Ending::FinishedBefore(summary) => {
            if !args.quiet {
                eprintln!("this run is complete already");
            }
            print(args, title, out, &summary)?;
            Ok(Outcome::Finished(summary))
        }
        Ending::Finished(summary) => {
            print(args, title, out, &summary)?;
            Ok(Outcome::Finished(summary))
        }
    }
}

/// Text of a progress bar next to its steps.
fn message(progress: &Progress, dimension: usize) -> String {
    let Progress { time, energies: [kinetic, strain, contact, total], force, steps_per_second, .. } = progress;
    let (joule, newton) = if dimension == 2 { ("J/m", "N/m") } else { ("J", "N") };
    format!(
        "t {time:.3e} s | kinetic {kinetic:.4e} strain {strain:.4e} contact {contact:.3e} total {total:.5e} {joule} \
         | force {force:.3e} {newton} | {steps_per_second:.0} steps/s"
    )
}

/// Table, costs and files.
fn print(args: &RunArgs, title: &str, out: &std::path::Path, summary: &Summary) -> Result<()> {
    let mut stdout = std::io::stdout();
    if args.json && !args.all_variants {
        writeln!(stdout, "{}", serde_json::to_string_pretty(summary)?)?;
    } else if !args.quiet && !args.json {
        writeln!(stdout, "{title}\n{}\n\n{}\n", summary.setting(), summary.table())?;
        writeln!(stdout, "{}", summary.costs())?;
        for warning in &summary.warnings {
            writeln!(stdout, "warning: {warning}")?;
        }
        writeln!(stdout, "Files: {}", out.display())?;
    }
    for check in summary.checks.iter().filter(|check| !check.ok) {
        let value = check.value.map_or("none".into(), |value| format!("{value:.6e}"));
        eprintln!("fails: {} is {value}, not {:.6e} ± {:.2e}", check.name, check.reference, check.tolerance);
    }
    Ok(())
}
