//! `fmc study`: a problem solved in several ways, side by side.

use crate::estimator_args::positive;
use crate::folder;
use anyhow::Result;
use clap::{Args, Subcommand, value_parser};
use fmc_benchmarks::case::{Case, Document};
use fmc_benchmarks::study::{self, Convergence, Impact, Method, Refined, Solution, SolverStudy};
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
    Newton(NewtonArgs),
    Convergence(ConvergenceArgs),
}

/// An impact measured by isotropic fibers as in the paper, by lines and exactly, with w = k V and w = k V²
///
/// Prints energy drift, impulse, balance of the forces, rebound, sideways velocity and cost; writes tables and a picture
/// of the total energy.
#[derive(Args, Clone, Debug)]
#[command(after_help = "Example:\n  fmc study impact --quick\n\nExit status: 0, also if a method fails on the way \
    (see the table); 2 for bad usage or input.")]
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

    /// Evaluations of the contact in every step; 1 is the paper's scheme [default: as in the case]
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

/// Newton's method on the fiber law compared with the paper's fixed-point loop (Algorithm 2), on one equilibrium
///
/// The loop runs with w = k V, w = k V² and the fiber law, exactly and on lines. It has no contact stiffness and cannot
/// hold a body by contact alone: the loaded nodes are held where Newton's method has led them.
#[derive(Args, Clone, Debug)]
struct NewtonArgs {
    /// Name of a case (see fmc list), or path of a case file; statics in 2D with the law fiber
    #[arg(default_value = "hertz")]
    case: String,

    /// Iterations of the loop, at most
    #[arg(long, value_name = "N", default_value_t = 300, value_parser = value_parser!(u32).range(1..))]
    iterations: u32,

    /// Relaxation factor of a step of the loop; 1 is the paper's algorithm as printed; may be repeated
    #[arg(long, value_name = "R", value_parser = positive, default_values_t = [1.0, 0.1])]
    relaxation: Vec<f64>,

    /// Change a value of the case; may be repeated
    #[arg(long = "override", value_name = "KEY=VALUE")]
    overrides: Vec<String>,

    /// Threads; the results do not depend on them
    #[arg(long, value_name = "T", default_value_t = 1, value_parser = value_parser!(u16).range(1..))]
    threads: u16,

    /// Folder of tables and pictures
    #[arg(long, value_name = "DIR", default_value = "out/study-newton")]
    out: PathBuf,
}

/// Errors of an equilibrium over mesh size, with exact overlap, and over fibers
#[derive(Args, Clone, Debug)]
struct ConvergenceArgs {
    /// Name of a case (see fmc list), or path of a case file; statics
    case: String,

    /// Factors of the mesh size
    #[arg(long, value_name = "F", value_parser = positive, default_values_t = [4.0, 2.0, 1.0])]
    meshes: Vec<f64>,

    /// Factors of the distance between fibers
    #[arg(long, value_name = "F", value_parser = positive, default_values_t = [16.0, 8.0, 4.0, 2.0, 1.0])]
    fibers: Vec<f64>,

    /// Change a value of the case; may be repeated
    #[arg(long = "override", value_name = "KEY=VALUE")]
    overrides: Vec<String>,

    /// Threads; the results do not depend on them
    #[arg(long, value_name = "T", default_value_t = 1, value_parser = value_parser!(u16).range(1..))]
    threads: u16,

    /// Folder of tables and pictures
    #[arg(long, value_name = "DIR", default_value = "out/study-convergence")]
    out: PathBuf,
}

/// Steps of `--quick`.
const QUICK_STEPS: u64 = 150;

/// Makes the study.
pub(crate) fn run(args: &StudyArgs) -> Result<()> {
    match &args.study {
        Study::Impact(args) => impact(args),
        Study::Newton(args) => newton(args),
        Study::Convergence(args) => convergence(args),
    }
}

/// The case of a study with the user's changes, and the folder of its files.
fn case(name: &str, overrides: &[String]) -> Result<(Case, PathBuf)> {
    let mut document = Document::open(name)?;
    for assignment in overrides {
        document.override_with("--override", assignment)?;
    }
    Ok((document.case()?, document.folder))
}

/// Prints the running method, and the time for the rest of `count` solutions, on a terminal.
fn solutions_bar(count: usize) -> Result<ProgressBar> {
    let style = ProgressStyle::with_template("{spinner} {pos}/{len} {msg} {elapsed}, {eta} left")?;
    let bar = ProgressBar::new(count as u64).with_style(style);
    bar.enable_steady_tick(std::time::Duration::from_millis(200));
    Ok(bar)
}

/// The next solution of a study.
fn next(bar: &ProgressBar, what: &str) {
    // The first is on its way, none is done.
    if !bar.message().is_empty() {
        bar.inc(1);
    }
    bar.set_message(what.to_owned());
}

fn newton(args: &NewtonArgs) -> Result<()> {
    let (case, folder) = case(&args.case, &args.overrides)?;
    let _lock = folder::taken(&args.out)?;
    let title = case.title.clone();
    let (most_iterations, relaxations) = (args.iterations as usize, args.relaxation.clone());
    let study = SolverStudy { case, folder, most_iterations, relaxations, threads: args.threads.into() };
    let bar = solutions_bar(study.solution_count())?;
    let solutions = study.run(&mut |what| next(&bar, what))?;
    bar.finish_and_clear();
    Solution::write(&args.out, &title, &solutions)?;
    let table = Solution::table(&solutions);
    writeln!(std::io::stdout(), "{title}\n\n{table}\n\nFiles: {}", args.out.display())?;
    Ok(())
}

fn convergence(args: &ConvergenceArgs) -> Result<()> {
    let (case, folder) = case(&args.case, &args.overrides)?;
    let _lock = folder::taken(&args.out)?;
    let title = case.title.clone();
    let (meshes, fibers) = (args.meshes.clone(), args.fibers.clone());
    let study = Convergence { case, folder, meshes, fibers, threads: args.threads.into() };
    let bar = solutions_bar(study.meshes.len() + 1 + study.fibers.len())?;
    let rows = study.run(&mut |what| next(&bar, what))?;
    bar.finish_and_clear();
    Refined::write(&args.out, &title, &rows)?;
    writeln!(std::io::stdout(), "{title}\n\n{}\n\nFiles: {}", Refined::table(&rows), args.out.display())?;
    Ok(())
}

fn impact(args: &ImpactArgs) -> Result<()> {
    let mut document = Document::open(&args.case)?;
    if let Some(count) = args.contact_substeps {
        document.override_with("--contact-substeps", &format!("time.contact_substeps={count}"))?;
    }
    for assignment in &args.overrides {
        document.override_with("--override", assignment)?;
    }
    let _lock = folder::taken(&args.out)?;
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
    let bar = ProgressBar::new(1).with_style(ProgressStyle::with_template("{bar:40} {pos}/{len} {eta} left {msg}")?);
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
