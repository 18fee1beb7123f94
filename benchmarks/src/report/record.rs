//! What a run leaves for the page.

use super::stamp::Stamp;
use crate::run::Summary;
use anyhow::Result;
use fmc_mesh_io::write_whole;
use serde::{Deserialize, Serialize};
use std::fs;
use std::path::Path;

/// A run that came to an end.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// What it was computed from.
    pub stamp: Stamp,
    /// How it ended.
    pub outcome: Outcome,
    /// Law and estimator in a sentence.
    pub setting: String,
    /// Figures in the order of the case.
    pub figures: Vec<FigureRecord>,
    /// Figures that must come out right.
    pub checks: Vec<CheckRecord>,
    /// Steps, iterations or evaluations.
    pub iterations: u64,
    /// What is counted, in words.
    pub counted: String,
    /// Seconds of computing.
    pub seconds: f64,
    /// Seconds of these in contact, where they are measured apart.
    pub contact_seconds: Option<f64>,
    /// Nodes and cells, or cells alone.
    pub size: String,
    /// What the contact had to say.
    pub warnings: Vec<String>,
    /// Pictures in the order of the page.
    pub pictures: Vec<Picture>,
    /// Largest value of the colour scale, Pa.
    pub brightest: Option<f64>,
}

/// How a run ended.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Outcome {
    /// With figures.
    Finished,
    /// With an error.
    Failed(String),
    /// Not within the time that was granted, s.
    LeftOut(u64),
}

/// A figure.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FigureRecord {
    /// Its key.
    pub key: String,
    /// Its value.
    pub value: Option<f64>,
    /// Its unit.
    pub unit: String,
}

/// A figure beside what it should be.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CheckRecord {
    /// Key of the figure.
    pub key: String,
    /// What came out.
    pub value: Option<f64>,
    /// What should have, or what somebody else got.
    pub reference: f64,
    /// How far off it may be; none for a number to be read beside the figure.
    pub tolerance: Option<f64>,
    /// Whether it is not farther off.
    pub ok: bool,
    /// Who says so.
    pub source: String,
}

/// A picture in the folder of the run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Picture {
    /// Its file.
    pub file: String,
    /// What it shows.
    pub caption: String,
    /// How it stands on the page.
    pub kind: PictureKind,
}

/// How a picture stands on the page.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum PictureKind {
    /// Bodies; as wide as the text at most.
    Bodies,
    /// One of a row of snapshots.
    Snapshot,
    /// A chart.
    Chart,
}

/// Name of the record in the folder of its run.
const FILE: &str = "record.json";

impl Record {
    /// A run without figures.
    pub fn without_figures(stamp: Stamp, outcome: Outcome) -> Self {
        Self {
            stamp,
            outcome,
            setting: String::new(),
            figures: Vec::new(),
            checks: Vec::new(),
            iterations: 0,
            counted: "steps".into(),
            seconds: 0.0,
            contact_seconds: None,
            size: String::new(),
            warnings: Vec::new(),
            pictures: Vec::new(),
            brightest: None,
        }
    }

    /// What a summary says.
    pub fn of(stamp: Stamp, summary: &Summary) -> Self {
        let figures = summary.figures.iter().map(|figure| FigureRecord {
            key: figure.name.into(),
            value: figure.value,
            unit: figure.unit.into(),
        });
        let checks = summary.checks.iter().map(|check| CheckRecord {
            key: check.name.clone(),
            value: check.value,
            reference: check.reference,
            tolerance: Some(check.tolerance),
            ok: check.ok,
            source: check.source.clone(),
        });
        let beside = summary.references.iter().map(|reference| CheckRecord {
            key: reference.name.clone(),
            value: reference.value,
            reference: reference.reference,
            tolerance: None,
            ok: true,
            source: reference.source.clone(),
        });
        Self {
            setting: summary.setting(),
            figures: figures.collect(),
            checks: checks.chain(beside).collect(),
            iterations: summary.iterations,
            counted: if summary.residuals.is_empty() { "steps" } else { "iterations" }.into(),
            seconds: summary.seconds,
            contact_seconds: Some(summary.contact_seconds),
            warnings: summary.warnings.clone(),
            ..Self::without_figures(stamp, Outcome::Finished)
        }
    }

    /// Reads the record in a folder; `None` if there is none, or it is damaged or lacks a picture.
    pub fn load(folder: &Path) -> Option<Self> {
        let record: Self = serde_json::from_slice(&fs::read(folder.join(FILE)).ok()?).ok()?;
        record.pictures.iter().all(|picture| folder.join(&picture.file).is_file()).then_some(record)
    }

    /// Leaves the record in a folder, whole or not at all.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn save(&self, folder: &Path) -> Result<()> {
        write_whole(&folder.join(FILE), serde_json::to_string_pretty(self)? + "\n")
    }

    /// Whether it finished and every check holds.
    pub fn is_ok(&self) -> bool {
        !matches!(self.outcome, Outcome::Failed(_)) && self.checks.iter().all(|check| check.ok)
    }

    /// Checks that hold, and all checks.
    pub fn counts(&self) -> [usize; 2] {
        let checks = || self.checks.iter().filter(|check| check.tolerance.is_some());
        [checks().filter(|check| check.ok).count(), checks().count()]
    }
}
