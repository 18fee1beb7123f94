//! What the template is filled with; `templates/report.html` says how it looks.

use crate::report::plan;
use crate::report::record::{Outcome, Record};
use askama::Template;

#[derive(Template)]
#[template(path = "report.html")]
pub(super) struct Page {
    /// `quick` or `full`.
    pub(super) size: &'static str,
    pub(super) date: String,
    pub(super) version: &'static str,
    pub(super) machine: String,
    /// The picture of the method, as a data URI.
    pub(super) method: String,
    pub(super) checks_held: usize,
    pub(super) checks: usize,
    /// Runs that ended with an error.
    pub(super) failed: usize,
    pub(super) left_out: usize,
    pub(super) run_count: usize,
    pub(super) example_count: usize,
    pub(super) seconds: String,
    pub(super) sections: Vec<Section>,
}

pub(super) struct Section {
    pub(super) section: plan::Section,
    pub(super) examples: Vec<Example>,
}

pub(super) struct Example {
    pub(super) id: String,
    pub(super) title: String,
    pub(super) paper: Option<String>,
    pub(super) source: String,
    pub(super) text: Option<String>,
    pub(super) verdict: Verdict,
    pub(super) summary: Vec<SummaryRow>,
    pub(super) comparison: Option<Comparison>,
    pub(super) runs: Vec<Run>,
}

pub(super) struct SummaryRow {
    pub(super) name: String,
    pub(super) id: String,
    pub(super) is_variant: bool,
    pub(super) what: String,
    pub(super) reference: String,
    pub(super) ours: String,
    pub(super) counts: String,
    pub(super) verdict: Verdict,
    pub(super) seconds: String,
    pub(super) contact: String,
}

/// A class of the style sheet, and a word for those who do not see its colour.
#[derive(Clone, Copy)]
pub(super) struct Verdict {
    pub(super) class: &'static str,
    pub(super) word: &'static str,
}

pub(super) struct Run {
    pub(super) id: String,
    /// The variant; none for the case itself.
    pub(super) variant: Option<String>,
    pub(super) about: String,
    pub(super) setting: String,
    pub(super) cost: String,
    /// Why there are no figures.
    pub(super) failure: Option<String>,
    pub(super) verdict: Verdict,
    pub(super) checks: Vec<Check>,
    pub(super) bodies: Vec<Picture>,
    pub(super) snapshots: Vec<Picture>,
    pub(super) charts: Vec<Picture>,
    /// The brightest colour, in words.
    pub(super) scale: Option<String>,
    pub(super) warnings: Vec<String>,
}

pub(super) struct Check {
    pub(super) figure: String,
    pub(super) ours: String,
    pub(super) reference: String,
    pub(super) off: String,
    pub(super) allowed: String,
    pub(super) verdict: Option<Verdict>,
    pub(super) source: String,
}

pub(super) struct Picture {
    /// Data URI.
    pub(super) uri: String,
    pub(super) caption: String,
    /// For those who do not see it.
    pub(super) alt: String,
}

/// Figures of others beside ours.
pub(super) struct Comparison {
    pub(super) columns: Vec<String>,
    pub(super) rows: Vec<ComparisonRow>,
}

pub(super) struct ComparisonRow {
    pub(super) who: String,
    pub(super) is_ours: bool,
    pub(super) cells: Vec<String>,
    pub(super) note: String,
}

impl Verdict {
    const PASS: Self = Self { class: "pass", word: "pass" };
    const FAIL: Self = Self { class: "fail", word: "FAIL" };
    const NONE: Self = Self { class: "none", word: "no check" };
    const LEFT_OUT: Self = Self { class: "none", word: "left out" };

    pub(super) fn check(ok: bool) -> Self {
        if ok { Self::PASS } else { Self::FAIL }
    }

    pub(super) fn of(record: &Record) -> Self {
        match record.outcome {
            Outcome::LeftOut(_) => Self::LEFT_OUT,
            Outcome::Finished if record.counts()[1] == 0 => Self::NONE,
            _ => Self::check(record.is_ok()),
        }
    }

    /// Of an example: passed if nothing failed and something was checked.
    pub(super) fn of_all(records: &[Record]) -> Self {
        if !records.iter().all(Record::is_ok) {
            return Self::FAIL;
        }
        let checked = records.iter().any(|record| record.counts()[1] > 0);
        if checked { Self::PASS } else { records.first().map_or(Self::NONE, Self::of) }
    }
}
