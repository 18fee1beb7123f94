//! Kernel checks: overlap and its derivative against closed forms.

mod pictures;

use super::job::Size;
use super::quantity::count;
use super::record::{CheckRecord, FigureRecord, Outcome, Picture, PictureKind, Record};
use super::setting::Setting;
use super::stamp::Stamp;
use crate::verify::{self, Method, Row, Verification};
use anyhow::Result;
use fmc_contact::Resolution;
use std::path::Path;
use std::time::Instant;

/// Fibers of a measurement, as in `fmc verify`.
const FIBERS: usize = 27_000;

/// Seeds over which errors are averaged in the quick size; the curves are less smooth.
const QUICK_SEEDS: u64 = 2;

/// Runs a kernel check and turns its worst rows into checks.
pub(super) fn run(name: &'static str, stamp: Stamp, folder: &Path, setting: &Setting) -> Result<Record> {
    let clock = Instant::now();
    let mut verification = Verification {
        methods: Method::ALL.to_vec(),
        resolution: Resolution::Count(FIBERS),
        seed: 0,
        threads: setting.threads,
        pictures: Some(folder.to_owned()),
        seeds: if setting.size == Size::Quick { QUICK_SEEDS } else { verify::SEEDS },
        rows: Vec::new(),
        progress: setting.bar.clone(),
    };
    verification.case(name)?;
    let rows = verification.rows;
    let mut pictures = pictures::draw(name, folder)?;
    let caption = match name {
        "disc" | "sphere" => "Error over the number of fibers: of the value, and of its derivative",
        _ => "The overlap over θ, and its derivative, beside the closed form",
    };
    pictures.push(Picture { file: format!("{name}.svg"), caption: caption.into(), kind: PictureKind::Chart });
    let worst = worst(&rows);
    let figures =
        worst.iter().map(|row| FigureRecord { key: key(row), value: Some(row.scaled_error), unit: String::new() });
    let checks = worst.iter().filter_map(|row| {
        Some(CheckRecord {
            key: key(row),
            value: Some(row.scaled_error),
            reference: 0.0,
            tolerance: Some(row.bound?),
            ok: row.ok,
            source: source(row),
        })
    });
    Ok(Record {
        setting: format!("{} fibers; largest error over θ at {}", count(FIBERS as u64), thetas(&rows)),
        figures: figures.collect(),
        checks: checks.collect(),
        iterations: rows.len() as u64 / 2,
        counted: "overlaps".into(),
        seconds: clock.elapsed().as_secs_f64(),
        size: format!("{} cells", count(rows.iter().map(|row| row.cells).max().unwrap_or(0) as u64)),
        pictures,
        ..Record::without_figures(stamp, Outcome::Finished)
    })
}

/// Of every form, estimator and quantity the row with the largest error; estimators that have a bound first.
fn worst(rows: &[Row]) -> Vec<&Row> {
    let mut worst: Vec<&Row> = Vec::new();
    for row in rows {
        match worst.iter_mut().find(|other| key(other) == key(row)) {
            Some(other) if other.scaled_error < row.scaled_error => *other = row,
            Some(_) => {}
            None => worst.push(row),
        }
    }
    worst.sort_by_key(|row| (row.bound.is_none(), row.estimator != "lines", row.form != "mesh"));
    worst
}

/// What stands in the table, as a key of its own.
fn key(row: &Row) -> String {
    format!("{} error: {}, {}", row.quantity, row.estimator, row.form)
}

fn source(row: &Row) -> String {
    let of = if row.estimator == "exact" { "the mesh itself" } else { "the smooth shape" };
    let bound = match row.case {
        _ if row.estimator == "exact" => "rounding",
        "disc" | "sphere" => "the paper’s largest error",
        _ => "what one could see in the paper’s curves",
    };
    format!("closed form of {of}; allowed: {bound}")
}

/// Values of θ in words.
fn thetas(rows: &[Row]) -> String {
    let mut thetas: Vec<f64> = rows.iter().map(|row| row.theta).collect();
    thetas.sort_by(f64::total_cmp);
    thetas.dedup();
    if thetas.len() == 1 { "one value".into() } else { format!("{} values", thetas.len()) }
}
