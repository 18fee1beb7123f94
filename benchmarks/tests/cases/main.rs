//! Cases from file to figures: what a mistake is told, what a run leaves, and that an interruption leaves no trace.

#[path = "../folder/folder.rs"]
mod folder;

mod driven;
mod files;
mod friction;
mod mistakes;
mod mutated;
mod short_runs;

use fmc_benchmarks::case::{Case, CaseError, Document};
use fmc_benchmarks::run::{Ending, Progress, RunOptions, Summary, run};
use folder::Folder;
use std::ops::ControlFlow;
use std::path::Path;

/// A built-in case with overrides.
fn document(name: &str, overrides: &[&str]) -> Document {
    let mut document = Document::open(name).unwrap();
    overrides.iter().for_each(|change| document.override_with("--override", change).unwrap());
    document
}

/// Runs a case of two or three dimensions.
fn carry_out(
    document: &Document,
    out: &Path,
    (threads, resume): (usize, bool),
    watch: &mut dyn FnMut(&Progress) -> ControlFlow<()>,
) -> Ending {
    let case: Case = document.case().unwrap_or_else(|error: CaseError| panic!("{error}"));
    let options = RunOptions { out: out.to_owned(), threads, resume };
    run(document, &case, &options, watch).unwrap_or_else(|error| panic!("{error:#}"))
}

/// Runs a case to its end.
fn finish(document: &Document, out: &Path) -> Summary {
    match carry_out(document, out, (1, false), &mut |_| ControlFlow::Continue(())) {
        Ending::Finished(summary) | Ending::FinishedBefore(summary) => *summary,
        Ending::Interrupted { step, .. } => panic!("interrupted at step {step}"),
    }
}
