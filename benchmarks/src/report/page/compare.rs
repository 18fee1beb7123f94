//! Our figures beside those of others.

use super::run::scale;
use super::template::{Comparison, ComparisonRow};
use crate::report::job::Example;
use crate::report::plan::{Plan, Said};
use crate::report::quantity::{digits, seconds};
use crate::report::record::{Outcome, Record};

/// Keys that are no figures of a case: what it cost.
const ITERATIONS: &str = "iterations";
const SECONDS: &str = "seconds";

/// A column for every figure that somebody else has, a row for the reference, for each of our runs, and for each of them;
/// none if there is nobody else.
pub(super) fn comparison(plan: &Plan, example: &Example, records: &[Record]) -> Option<Comparison> {
    let others = &example.entry.others;
    let finished = || example.jobs.iter().zip(records).filter(|(_, record)| record.outcome == Outcome::Finished);
    let (_, first) = finished().next()?;
    let is_said = |key: &str| others.iter().any(|other| other.figures.contains_key(key));
    let mut keys: Vec<&str> =
        first.figures.iter().map(|figure| figure.key.as_str()).filter(|key| is_said(key)).collect();
    keys.extend([ITERATIONS, SECONDS].into_iter().filter(|key| is_said(key)));
    if others.is_empty() {
        return None;
    }
    let show = |key: &str, value: f64| match key {
        ITERATIONS => digits(value, 3),
        SECONDS => seconds(value),
        _ if plan.is_percent(key) => scale(plan, first, key, &[Some(value)]).of_errors().with_unit(value),
        _ => scale(plan, first, key, &[Some(value)]).with_unit(value),
    };
    let row = |who: String, is_ours: bool, note: String, cell: &dyn Fn(&str) -> Option<String>| ComparisonRow {
        who,
        is_ours,
        cells: keys.iter().map(|key| cell(key).unwrap_or_else(|| "–".into())).collect(),
        note,
    };
    let mut rows = Vec::new();
    let reference = |key: &str| {
        let check = first.checks.iter().find(|check| check.key == key && check.tolerance.is_some())?;
        Some(show(key, check.reference))
    };
    if keys.iter().any(|key| reference(key).is_some()) {
        rows.push(row("reference".into(), false, "what is right; see the checks".into(), &reference));
    }
    for (job, record) in finished() {
        let ours = |key: &str| match key {
            ITERATIONS => Some(show(key, record.iterations as f64)),
            SECONDS => Some(show(key, record.seconds)),
            _ => record.figures.iter().find(|figure| figure.key == key)?.value.map(|value| show(key, value)),
        };
        let who = job.variant.as_ref().map_or_else(|| "here".into(), |variant| format!("here, {variant}"));
        rows.push(row(who, true, record.setting.clone(), &ours));
    }
    for other in others {
        let theirs = |key: &str| {
            other.figures.get(key).map(|said| match said {
                Said::Number(value) => show(key, *value),
                Said::Words(words) => words.clone(),
            })
        };
        rows.push(row(other.who.clone(), false, other.note.clone().unwrap_or_default(), &theirs));
    }
    let columns = keys.iter().map(|key| plan.figure_name(key)).collect();
    Some(Comparison { columns, rows })
}
