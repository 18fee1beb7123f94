//! Cases from file to figures: what a mistake is told, what a run leaves, and that an interruption leaves no trace.

mod command;
mod files;
mod mistakes;
mod short_runs;

use fmc_reference::case::{Case, CaseError, Document};
use fmc_reference::run::{Ending, Progress, RunOptions, Summary, run};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

/// A folder of its own, gone with the value.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("fmc-cases-{}-{name}", std::process::id()));
        let _ = std::fs::remove_dir_all(&path);
        Self(path)
    }

    fn text(&self, name: &str) -> String {
        std::fs::read_to_string(self.0.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

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
        Ending::Finished(summary) => *summary,
        Ending::Interrupted { step, .. } => panic!("interrupted at step {step}"),
    }
}
