//! `fmc verify`: overlap and its derivative against closed forms.

use crate::estimator_args::{EstimatorKind, LawKind, PatternKind, positive};
use anyhow::{Context, Result, ensure};
use clap::value_parser;
use fmc_benchmarks::verify::{Method, Row, SEEDS, Verification, table};
use fmc_contact::Resolution;
use fmc_mesh_io::write_whole;
use indicatif::{ProgressBar, ProgressStyle};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Compare overlaps and their derivatives with closed forms: the benchmarks of the paper
///
/// Prints a table with the worst θ of each case and draws the paper's figures.
#[derive(clap::Args, Clone, Debug)]
#[command(after_help = "Example:\n  fmc verify --estimator fibers --pattern lines --fibers 10000 --json -\n\n\
    Exit status: 0, 1 if lines or exact miss their bound, 2 for bad usage.")]
pub(crate) struct VerifyArgs {
    /// Only this estimator [default: both]
    #[arg(long, value_enum)]
    estimator: Option<EstimatorKind>,

    /// Only fibers, and only of this pattern [default: both, and exact]
    #[arg(long, value_enum)]
    pattern: Option<PatternKind>,

    /// As in the other commands; an overlap has no energy, so that it changes nothing here
    #[arg(long, value_enum, default_value_t)]
    law: LawKind,

    /// As in the other commands; it changes nothing here either
    #[arg(long, value_name = "M", default_value_t = 1.0, value_parser = positive)]
    m: f64,

    /// About this many fibers per case
    #[arg(long, value_name = "N", default_value_t = 27_000, value_parser = value_parser!(u32).range(1..))]
    fibers: u32,

    /// Distance between neighbouring fibers, in place of their number [length; the bodies are of size 1]
    #[arg(long, value_name = "H", conflicts_with = "fibers", value_parser = positive)]
    spacing: Option<f64>,

    /// Another seed is another random shift of the fibers
    #[arg(long, value_name = "S", default_value_t = 0)]
    seed: u64,

    /// Threads; the results do not depend on them
    #[arg(long, value_name = "T", default_value_t = 1, value_parser = value_parser!(u16).range(1..))]
    threads: u16,

    /// Write every row, at every θ, as a list of JSON objects; "-" is standard output, which then has nothing else
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,

    /// Directory of the pictures, PNG and SVG
    #[arg(long, value_name = "DIR", default_value = "out/verify")]
    out: PathBuf,

    /// Draw no pictures, which takes most of the time
    #[arg(long)]
    no_pictures: bool,
}

impl VerifyArgs {
    /// Which of isotropic, lines and exact `--estimator` and `--pattern` select.
    fn methods(&self) -> Result<Vec<Method>> {
        let exact = self.estimator == Some(EstimatorKind::Exact);
        ensure!(!exact || self.pattern.is_none(), "--pattern has no effect with --estimator exact");
        let wanted = |method: &Method| match method {
            Method::Exact => self.estimator != Some(EstimatorKind::Fibers) && self.pattern.is_none(),
            Method::Isotropic => !exact && self.pattern != Some(PatternKind::Lines),
            Method::Lines => !exact && self.pattern != Some(PatternKind::Isotropic),
        };
        Ok(Method::ALL.into_iter().filter(wanted).collect())
    }
}

/// Runs all cases; a failure status if a bound is missed.
pub(crate) fn run(args: &VerifyArgs) -> Result<ExitCode> {
    let json_only = args.json.as_deref() == Some(Path::new("-"));
    let mut verification = Verification {
        methods: args.methods()?,
        resolution: args.spacing.map_or(Resolution::Count(args.fibers as usize), Resolution::Spacing),
        seed: args.seed,
        threads: args.threads.into(),
        pictures: (!args.no_pictures).then(|| args.out.clone()),
        seeds: SEEDS,
        rows: Vec::new(),
        // Draws on standard error, and only if that is a terminal.
        progress: ProgressBar::new(0)
            .with_style(ProgressStyle::with_template("{bar:40} {pos}/{len} {eta} left {msg}")?),
    };
    if let Some(directory) = &verification.pictures {
        std::fs::create_dir_all(directory).with_context(|| format!("cannot create {}", directory.display()))?;
    }
    verification.all_cases()?;

    let rows = &verification.rows;
    if let Some(path) = &args.json {
        let text = serde_json::to_string_pretty(rows)?;
        if json_only {
            writeln!(std::io::stdout(), "{text}")?;
        } else {
            write_whole(path, text + "\n")?;
        }
    }
    if !json_only {
        writeln!(std::io::stdout(), "{}", table(rows))?;
        if let Some(directory) = &verification.pictures {
            writeln!(std::io::stdout(), "\nPictures: {}", directory.display())?;
        }
    }
    let failed: Vec<&Row> = rows.iter().filter(|row| !row.ok).collect();
    for row in &failed {
        let Row { case, form, theta, estimator, quantity, scaled_error, .. } = row;
        let bound = row.bound.unwrap_or(f64::INFINITY);
        eprintln!(
            "fails: {case} ({form}) at θ = {theta:.3}, {estimator}: error of the {quantity} {scaled_error:.2e}, bound {bound:.2e}"
        );
    }
    Ok(if failed.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
