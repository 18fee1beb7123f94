//! `fmc report`: every example on one page.

use super::interrupt;
use crate::folder;
use anyhow::{Context, Result};
use clap::value_parser;
use fmc_benchmarks::report::{self, Example, Outcome, Plan, Record, Setting, Size, Stamp};
use indicatif::{ProgressBar, ProgressStyle};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};

/// Run every example and write one page: pictures, plots, and figures compared with all references
///
/// The page is OUT/report.html and needs no other file; the results of the runs are in OUT/runs. Ctrl-C stops after the current
/// step; the same command resumes there. A finished run is not repeated unless its case or the program has changed.
#[derive(clap::Args, Clone, Debug)]
#[command(after_help = "Examples:\n  \
    fmc report --quick\n  \
    fmc report star hertz\n  \
    fmc report kernel my_case.toml --out /tmp/report\n\n\
    Exit status: 0, 1 if a check fails, 2 for bad usage or input, 130 if interrupted.")]
pub(crate) struct ReportArgs {
    /// Only these: cases (see fmc list), kernel checks (disc, sphere, …), chapters (kernel, statics, …) or case files
    /// [default: all]
    #[arg(value_name = "EXAMPLE")]
    examples: Vec<String>,

    /// Every example, but few variants, and no run longer than a limit: less than a minute
    #[arg(long)]
    quick: bool,

    /// Longest time of one run; a longer run is left out of the page [s; default: 45 with --quick, else none]
    #[arg(long, value_name = "SECONDS", value_parser = value_parser!(u64).range(1..))]
    limit: Option<u64>,

    /// Threads; the figures do not depend on them
    #[arg(long, value_name = "T", default_value_t = 1, value_parser = value_parser!(u16).range(1..))]
    threads: u16,

    /// Folder of the page and of the runs
    #[arg(long, value_name = "DIR", default_value = "out/report")]
    out: PathBuf,
}

/// Longest run of the quick size, s.
const QUICK_LIMIT: u64 = 45;

/// Runs missing cases and writes the page.
pub(crate) fn run(args: &ReportArgs) -> Result<ExitCode> {
    let stop = interrupt::flag()?;
    let plan = Plan::built_in()?;
    let size = if args.quick { Size::Quick } else { Size::Full };
    let examples = report::examples(&plan, size, &args.examples)?;
    let _lock = folder::taken(&args.out)?;
    let folder = args.out.join("runs");
    std::fs::create_dir_all(&folder).with_context(|| format!("{} cannot be made", folder.display()))?;
    // Draws on standard error, and only if that is a terminal.
    let bar = ProgressBar::new(1).with_style(ProgressStyle::with_template("  {prefix} {bar:24} {eta} left {msg}")?);
    let limit = args.limit.or(args.quick.then_some(QUICK_LIMIT)).map(Duration::from_secs);
    let setting = Setting { size, threads: args.threads.into(), limit, bar: &bar, stop: &stop };
    let Some(records) = records(&examples, &folder, &setting)? else {
        eprintln!("interrupted; run the same command again to resume");
        return Ok(ExitCode::from(130));
    };
    let page = args.out.join("report.html");
    report::write(&page, &plan, size, &examples, &records, &folder)?;
    eprintln!("{}", page.display());
    let is_ok = records.iter().flatten().all(Record::is_ok);
    Ok(if is_ok { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// The records of all jobs, by example: read where they are up to date, computed where not; `None` if interrupted.
fn records(examples: &[Example], folder: &Path, setting: &Setting) -> Result<Option<Vec<Vec<Record>>>> {
    let program = report::program()?;
    let count: usize = examples.iter().map(|example| example.jobs.len()).sum();
    let (mut number, mut records) = (0, Vec::new());
    for example in examples {
        let mut of_example = Vec::new();
        for job in &example.jobs {
            number += 1;
            let folder = folder.join(&job.id);
            let camera = example.entry.camera;
            let stamp = Stamp::of(job, setting.size, camera, &program)?;
            let line = |what: String| {
                setting.bar.suspend(|| eprintln!("{number:>3}/{count}  {:<22} {what}", job.id));
            };
            let old = Record::load(&folder);
            if let Some(old) = old.filter(|old| up_to_date(old, &stamp, setting, &line)) {
                line(format!("{}, computed before", in_words(&old)));
                of_example.push(old);
                continue;
            }
            setting.bar.reset();
            setting.bar.set_prefix(format!("{number}/{count} {}", job.id));
            let clock = Instant::now();
            let Some(record) = report::carry_out(job, camera, &stamp, &folder, setting)? else {
                setting.bar.finish_and_clear();
                return Ok(None);
            };
            line(format!("{}, {:.1} s", in_words(&record), clock.elapsed().as_secs_f64()));
            of_example.push(record);
            if setting.stop.load(Ordering::SeqCst) && number < count {
                setting.bar.finish_and_clear();
                return Ok(None);
            }
        }
        records.push(of_example);
    }
    setting.bar.finish_and_clear();
    Ok(Some(records))
}

/// Whether a record may be shown on the page; if not, the reason.
fn up_to_date(record: &Record, stamp: &Stamp, setting: &Setting, line: &dyn Fn(String)) -> bool {
    let granted = setting.limit.map_or(u64::MAX, |limit| limit.as_secs());
    let why = match record {
        Record { outcome: Outcome::LeftOut(seconds), .. } if granted > *seconds => "left out before",
        Record { outcome: Outcome::Failed(_), .. } => "failed before",
        Record { stamp: old, .. } if old.program != stamp.program => "the program has changed",
        Record { stamp: old, .. } if old.case != stamp.case => "the case has changed",
        _ => return true,
    };
    line(format!("{why}: runs again"));
    false
}

/// Checks and costs of a run.
fn in_words(record: &Record) -> String {
    let [held, all] = record.counts();
    match &record.outcome {
        Outcome::Failed(why) => format!("FAILS: {why}"),
        Outcome::LeftOut(granted) => format!("left out, as it takes longer than {granted} s"),
        Outcome::Finished if held < all => format!("{held} of {all} checks, FAILS"),
        Outcome::Finished => format!("{held} of {all} checks"),
    }
}
