//! The page: records in words, tables and pictures, one file.

mod compare;
mod run;
mod template;

use super::job::{Example, Size};
use super::plan::Plan;
use super::record::{Outcome, Record};
use anyhow::{Context, Result};
use askama::Template;
use fmc_mesh_io::write_whole;
use std::path::Path;

use template::{Example as ExampleView, Page, Section as SectionView, SummaryRow, Verdict};

/// The picture of the method.
const FIBERS: &[u8] = include_bytes!("../../../docs/fibers.svg");

/// Writes the page. `records[e][j]` is the record of job `j` of example `e`; `runs` is the folder that holds a folder
/// for each job.
///
/// # Errors
/// If a picture cannot be read or the page cannot be written.
pub fn write(
    path: &Path,
    plan: &Plan,
    size: Size,
    examples: &[Example],
    records: &[Vec<Record>],
    runs: &Path,
) -> Result<()> {
    let all = || records.iter().flatten();
    let mut sections = Vec::new();
    for section in &plan.sections {
        let mut views = Vec::new();
        for (example, records) in examples.iter().zip(records).filter(|(e, _)| e.entry.section == section.id) {
            views.push(example_view(plan, example, records, runs)?);
        }
        if !views.is_empty() {
            sections.push(SectionView { section: section.clone(), examples: views });
        }
    }
    let counts = all().map(Record::counts).fold([0, 0], |sum, [ok, of]| [sum[0] + ok, sum[1] + of]);
    let failed = all().filter(|record| matches!(record.outcome, Outcome::Failed(_))).count();
    let page = Page {
        size: if size == Size::Quick { "quick" } else { "full" },
        date: jiff::Timestamp::now().strftime("%-d %B %Y, %H:%M UTC").to_string(),
        version: env!("CARGO_PKG_VERSION"),
        machine: machine(),
        method: data_uri("image/svg+xml", FIBERS),
        checks_held: counts[0],
        checks: counts[1],
        failed,
        left_out: all().filter(|record| matches!(record.outcome, Outcome::LeftOut(_))).count(),
        run_count: all().count(),
        example_count: examples.len(),
        seconds: super::quantity::seconds(all().map(|record| record.seconds).sum()),
        sections,
    };
    let text = page.render().context("the page cannot be made")?;
    write_whole(path, text)
}

fn example_view(plan: &Plan, example: &Example, records: &[Record], runs: &Path) -> Result<ExampleView> {
    let mut views = Vec::new();
    for (job, record) in example.jobs.iter().zip(records) {
        views.push(run::view(plan, example, job, record, &runs.join(&job.id))?);
    }
    let summary = example.jobs.iter().zip(records).map(|(job, record)| summary_row(plan, example, job, record));
    Ok(ExampleView {
        id: example.id.clone(),
        title: example.title.clone(),
        paper: example.entry.paper.clone(),
        source: example.source.clone(),
        text: example.entry.text.clone(),
        verdict: Verdict::of_all(records),
        summary: summary.collect(),
        comparison: compare::comparison(plan, example, records),
        runs: views,
    })
}

/// The line of a run in the table at the top: the figure that stands for the example, or else its first check.
fn summary_row(plan: &Plan, example: &Example, job: &super::job::Job, record: &Record) -> SummaryRow {
    let checks = || record.checks.iter().filter(|check| check.tolerance.is_some());
    let headline = example.entry.headline.as_deref();
    let check = checks().find(|check| headline.is_some_and(|key| check.key.starts_with(key))).or(checks().next());
    let words = match check {
        Some(check) => {
            let words = run::check_view(plan, record, check);
            // Of an error one wants to know how large it may be.
            let should = if check.reference == 0.0 { words.allowed.replace('±', "≤") } else { words.reference };
            Some((words.figure, should, words.ours))
        }
        None => (record.figures.iter().find(|figure| headline.is_none_or(|key| figure.key == key)))
            .map(|figure| run::unchecked(plan, record, figure))
            .map(|words| (words.figure, words.reference, words.ours)),
    };
    let (what, reference, ours) = words.unwrap_or_default();
    let [held, all] = record.counts();
    let is_first = example.jobs.first().is_some_and(|first| first.id == job.id);
    SummaryRow {
        name: match &job.variant {
            None => example.title.clone(),
            Some(variant) if is_first => format!("{}, {variant}", example.title),
            Some(variant) => format!("– {variant}"),
        },
        // The first run has no heading of its own.
        id: if is_first { example.id.clone() } else { job.id.clone() },
        is_variant: !is_first,
        what,
        reference,
        ours,
        counts: if all == 0 { "–".into() } else { format!("{held}/{all}") },
        verdict: Verdict::of(record),
        seconds: super::quantity::seconds(record.seconds),
        contact: run::contact_share(record).unwrap_or_else(|| "–".into()),
    }
}

/// A file as part of the page.
fn data_uri(media_type: &str, bytes: &[u8]) -> String {
    use base64::Engine;
    format!("data:{media_type};base64,{}", base64::engine::general_purpose::STANDARD.encode(bytes))
}

/// The processor, as far as the system reports it.
fn machine() -> String {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let name = std::fs::read_to_string("/proc/cpuinfo").ok().and_then(|text| {
        let line = text.lines().find(|line| line.starts_with("model name"))?;
        Some(line.split_once(':')?.1.trim().to_owned())
    });
    let name = name.unwrap_or_else(|| std::env::consts::ARCH.to_owned());
    format!("{name}, {cores} core{}", if cores == 1 { "" } else { "s" })
}
