//! What is taken in another sense than a file may mean, and what it must not mean.

use crate::Fault;
use crate::read::{Deck, LoadKind, Note};

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
    notes.sort_by_key(|note| note.line);
    Ok(notes)
}
