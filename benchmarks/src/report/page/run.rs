//! A run in words.

use super::data_uri;
use super::template::{Check, Picture, Run, Verdict};
use crate::report::job::{Example, Job};
use crate::report::plan::Plan;
use crate::report::quantity::{Scale, count, digits, seconds};
use crate::report::record::{self, CheckRecord, FigureRecord, Outcome, PictureKind, Record};
use anyhow::{Context, Result};
use std::path::Path;

/// The part of the page about a run; its pictures lie in `folder`.
pub(super) fn view(plan: &Plan, example: &Example, job: &Job, record: &Record, folder: &Path) -> Result<Run> {
    let pictures = |kind: PictureKind| -> Result<Vec<Picture>> {
        let of_kind = record.pictures.iter().filter(|picture| picture.kind == kind);
        of_kind.map(|picture| picture_view(example, job, picture, folder)).collect()
    };
    let mut checks: Vec<Check> = Vec::new();
    for figure in &record.figures {
        let of_figure: Vec<&CheckRecord> = record.checks.iter().filter(|check| check.key == figure.key).collect();
        checks.extend(of_figure.iter().map(|check| check_view(plan, record, check)));
        if of_figure.is_empty() {
            checks.push(unchecked(plan, record, figure));
        }
    }
    Ok(Run {
        id: job.id.clone(),
        variant: job.variant.clone(),
        about: job.about.clone(),
        setting: record.setting.clone(),
        cost: cost(record),
        failure: match &record.outcome {
            Outcome::Finished => None,
            Outcome::Failed(why) => Some(why.clone()),
            Outcome::LeftOut(granted) => {
                Some(format!("not finished after {granted} s; the full size runs it to its end"))
            }
        },
        verdict: Verdict::of(record),
        checks,
        bodies: pictures(PictureKind::Bodies)?,
        snapshots: pictures(PictureKind::Snapshot)?,
        charts: pictures(PictureKind::Chart)?,
        scale: record.brightest.map(|brightest| Scale::of(brightest, "Pa", false).with_unit(brightest)),
        warnings: record.warnings.clone(),
    })
}

/// A figure that nobody says anything about.
pub(super) fn unchecked(plan: &Plan, record: &Record, figure: &FigureRecord) -> Check {
    let scale = scale(plan, record, &figure.key, &[figure.value]);
    let scale = if plan.is_percent(&figure.key) { scale.of_errors() } else { scale };
    let ours = figure.value.map_or_else(|| "none".into(), |value| scale.with_unit(value));
    let [reference, off, allowed, source] = Default::default();
    Check { figure: plan.figure_name(&figure.key), ours, reference, off, allowed, verdict: None, source }
}

/// A check in the unit of its figure, in which all of its numbers read well.
pub(super) fn check_view(plan: &Plan, record: &Record, check: &CheckRecord) -> Check {
    let scale = scale(plan, record, &check.key, &[check.value, Some(check.reference), check.tolerance]);
    let scale = if check.reference == 0.0 { scale.of_errors() } else { scale };
    let off = check.value.filter(|_| check.reference != 0.0).map(|value| {
        let percent = 100.0 * (value - check.reference) / check.reference.abs();
        let text = digits(percent, 2);
        format!("{}{text}\u{a0}%", if percent > 0.0 { "+" } else { "" })
    });
    Check {
        figure: plan.figure_name(&check.key),
        ours: check.value.map_or_else(|| "none".into(), |value| scale.with_unit(value)),
        reference: scale.with_unit(check.reference),
        off: off.unwrap_or_default(),
        allowed: check.tolerance.map_or_else(String::new, |tolerance| format!("±\u{a0}{}", scale.with_unit(tolerance))),
        verdict: check.tolerance.map(|_| Verdict::check(check.ok)),
        source: check.source.clone(),
    }
}

/// The scale of a figure for some of its numbers.
pub(super) fn scale(plan: &Plan, record: &Record, key: &str, numbers: &[Option<f64>]) -> Scale {
    let unit = record.figures.iter().find(|figure| figure.key == key).map_or("", |figure| &figure.unit);
    let largest = numbers.iter().flatten().map(|number| number.abs()).fold(0.0, f64::max);
    Scale::of(largest, unit, plan.is_percent(key))
}

/// Share of the contact in the time, in per cent.
pub(super) fn contact_share(record: &Record) -> Option<String> {
    let share = record.contact_seconds.filter(|_| record.seconds > 0.0)? / record.seconds;
    Some(format!("{:.0}\u{a0}%", 100.0 * share))
}

fn cost(record: &Record) -> String {
    if record.outcome != Outcome::Finished {
        return String::new();
    }
    let share = contact_share(record).map_or_else(String::new, |share| format!(", contact {share} of it"));
    let Record { size, iterations, counted, seconds: time, .. } = record;
    format!("{size} · {} {counted} in {}{share}", count(*iterations), seconds(*time))
}

fn picture_view(example: &Example, job: &Job, picture: &record::Picture, folder: &Path) -> Result<Picture> {
    let path = folder.join(&picture.file);
    let bytes = std::fs::read(&path).with_context(|| format!("{} cannot be read", path.display()))?;
    let media_type = match path.extension().and_then(|ending| ending.to_str()) {
        Some("svg") => "image/svg+xml",
        Some("gif") => "image/gif",
        _ => "image/png",
    };
    let variant = job.variant.as_ref().map_or_else(String::new, |variant| format!(", {variant}"));
    Ok(Picture {
        uri: data_uri(media_type, &bytes),
        caption: picture.caption.clone(),
        alt: format!("{}{variant}: {}", example.title, picture.caption),
    })
}
