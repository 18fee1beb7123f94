//! `fmc study`: a problem solved in several ways, side by side.

use crate::estimator_args::positive;
use anyhow::Result;
use clap::{Args, Subcommand, value_parser};
use fmc_reference::case::Document;
use fmc_reference::study::{self, Impact, Method};
use indicatif::{ProgressBar, ProgressStyle};
use std::io::Write;
use std::ops::ControlFlow;
use std::path::PathBuf;

/// Solve a problem in several ways and compare
#[derive(Args, Clone, Debug)]
pub(crate) struct StudyArgs {
    #[command(subcommand)]
    study: Study,
}

#[derive(Subcommand, Clone, Debug)]
enum Study {
    Impact(ImpactArgs),
}

/// An impact measured by isotropic fibers as in the paper, by lines and exactly, with w = k V and w = k V²
///
/// Prints energy drift, impulse, balance of the forces, rebound, sideways velocity and cost; writes tables and a picture
/// of the total energy.
#[derive(Args, Clone, Debug)]
#[command(after_help = "Example:\n  fmc study impact --quick\n\nExit status: 0, also if a method fails on the way, \
    which the table says; 2 for bad usage or input.")]
struct ImpactArgs {
    /// Name of a case (see fmc list), or path of a case file; an impact in 2D with w = k V
    #[arg(long, default_value = "star")]
    case: String,

    /// Stiffness k of w = k V²; a softer contact jumps less, but the impulse grows (by 1.2 % here) [Pa/m²]
    #[arg(long, value_name = "K", default_value_t = 2e10, value_parser = positive)]
    quadratic_stiffness: f64,

    /// Isotropic fibers, new ones at every step; the default has as many crossings as the lines
    #[arg(long, value_name = "N", default_value_t = 40_000, value_parser = value_parser!(u32).range(1..))]
    segments: u32,

    /// Distance between lines [m]
    #[arg(long, value_name = "H", default_value_t = 2e-5, value_parser = positive)]
    spacing: f64,

    /// Evaluations of the contact in every step; 1 is the paper's scheme [default: as the case says]
    #[arg(long, value_name = "N", value_parser = value_parser!(u32).range(1..))]
    contact_substeps: Option<u32>,

    /// Only some 0.6 ms of the impact
    #[arg(long)]
    quick: bool,

    /// Change a value of the case, as in time.step=1e-6; may be repeated
    #[arg(long = "override", value_name = "KEY=VALUE")]
    overrides: Vec<String>,

    /// Threads; the results do not depend on them
    #[arg(long, value_name = "T", default_value_t = 1, value_parser = value_parser!(u16).range(1..))]
    threads: u16,

    /// Folder of tables and pictures
    #[arg(long, value_name = "DIR", default_value = "out/study-impact")]
    out: PathBuf,
}

/// Steps of `--quick`.
const QUICK_STEPS: u64 = 150;

/// Makes the study.
pub(crate) fn run(args: &StudyArgs) -> Result<()> {
    let Study::Impact(args) = &args.study;
    let mut document = Document::open(&args.case)?;
    if let Some(count) = args.contact_substeps {
        document.override_with("--contact-substeps", &format!("time.contact_substeps={count}"))?;
    }
    for assignment in &args.overrides {
        document.override_with("--override", assignment)?;
    }
    let impact = Impact {
        case: document.case()?,
        folder: document.folder.clone(),
        methods: Method::ALL.to_vec(),
        quadratic_stiffness: args.quadratic_stiffness,
        segments: args.segments as usize,
        spacing: Some(args.spacing),
        step_count: args.quick.then_some(QUICK_STEPS),
        threads: args.threads.into(),
    };
    // Draws on standard error, and only if that is a terminal.
    let bar = ProgressBar::new(1).with_style(ProgressStyle::with_template("{bar:40} {pos}/{len} {msg} {eta}")?);
    let attempts = impact.run(&mut |progress| {
        bar.set_length(progress.step_count);
        bar.set_position(progress.step);
        if bar.message() != progress.name {
            bar.set_message(progress.name.clone());
        }
        ControlFlow::Continue(())
    })?;
    bar.finish_and_clear();
    study::write(&args.out, &impact.case.title, &attempts)?;
    let mut stdout = std::io::stdout();
    writeln!(stdout, "{}\n\n{}\n", impact.case.title, study::table(&attempts, document.name == "star"))?;
    writeln!(stdout, "|ΣF| by the largest force. Files: {}", args.out.display())?;
    for attempt in &attempts {
        if let Some(failure) = &attempt.failure {
            writeln!(stdout, "{} failed: {failure}", attempt.name())?;
        }
    }
    Ok(())
}
