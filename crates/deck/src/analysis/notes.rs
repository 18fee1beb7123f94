//! What is taken in another sense than a file may mean, and what it must not mean.

use crate::Fault;
use crate::read::{Deck, LoadKind, Note};
use std::collections::BTreeSet;

/// Notes of the reader and of the analysis, by their lines.
pub(super) fn notes(deck: &Deck, of_pairs: &[Note], is_finite: bool) -> Result<Vec<Note>, Fault> {
    let mut notes = deck.notes.clone();
    notes.extend_from_slice(of_pairs);
    let loads = || deck.steps.iter().flat_map(|step| &step.loads);
    if is_finite {
        if let Some(row) = deck.materials.values().find(|row| row.is_linear()) {
            let message = format!("with NLGEOM, {} is a neo-Hookean solid of the same constants", row.name);
            notes.push(Note { line: row.line, message });
        }
        let is_pressure = |kind: &LoadKind| matches!(kind, LoadKind::Pressure(_) | LoadKind::OnSurface);
        if let Some(load) = loads().find(|load| is_pressure(&load.kind)) {
            let message = "pressure keeps the direction and area of the undeformed face".to_owned();
            notes.push(Note { line: load.line, message });
        }
    }
    if let Some(late) = deck.steps.iter().skip(1).find(|step| step.is_finite && !deck.steps[0].is_finite) {
        return Err(Fault::new(late.line, "NLGEOM from a later step on is not known: it holds for all or for none"));
    }
    let is_weight = |kind: &LoadKind| matches!(kind, LoadKind::Gravity(_));
    if let (Some(load), Some(row)) =
        (loads().find(|load| is_weight(&load.kind)), deck.materials.values().find(|row| row.density.is_none()))
    {
        return Err(Fault::new(load.line, format!("GRAV needs a *DENSITY of material {}", row.name)));
    }
    notes.extend(peaks(deck));
    notes.sort_by_key(|note| note.line);
    Ok(notes)
}

/// Of each amplitude that a step names, the first peak within a step: results are those of the ends of steps.
fn peaks(deck: &Deck) -> Vec<Note> {
    let (mut notes, mut told, mut begun) = (Vec::new(), BTreeSet::new(), 0.0);
    for (number, step) in deck.steps.iter().enumerate() {
        let supports = step.boundaries.iter().map(|row| (row.line, &row.amplitude));
        let rows = supports.chain(step.loads.iter().map(|load| (load.line, &load.amplitude)));
        for (line, name) in rows.filter_map(|(line, name)| Some((line, name.as_ref()?))) {
            let Some(amplitude) = deck.amplitudes.get(name) else { continue };
            let start = if amplitude.is_total { begun } else { 0.0 };
            if let Some([time, factor]) = amplitude.peak(start, start + step.period).filter(|_| told.insert(name)) {
                let message = format!(
                    "AMPLITUDE={name} is {factor} at time {time}, and {} at the end of step {}: results are those of the ends of steps. To \
                     see them there, end a step there",
                    amplitude.at(start + step.period),
                    number + 1
                );
                notes.push(Note { line, message });
            }
        }
        begun += step.period;
    }
    notes
}
