//! Elements that are solved in another way than their type says.

use super::Bodies;
use crate::read::{Deck, ElementRow, Note};
use fmc_solid::fem::Law;

/// Of each type that is a variant, the first element at the line of its keyword, and how it is solved.
pub(super) fn notes<const D: usize>(deck: &Deck, bodies: Bodies<D>) -> Vec<Note> {
    let mut known: Vec<(&str, bool)> = Vec::new();
    let mut notes = Vec::new();
    for (row, &body) in deck.elements.iter().zip(&bodies.places.body_of) {
        let is_linear = bodies.model.parts()[body].material.law != Law::NeoHookean;
        if row.is_rigid() || known.contains(&(row.kind.as_str(), is_linear)) {
            continue;
        }
        known.push((&row.kind, is_linear));
        notes.extend(solved_as(row, is_linear).map(|message| Note { line: row.keyword, message }));
    }
    notes
}

/// How a variant is solved, where that is not what its type says.
fn solved_as(row: &ElementRow, is_linear: bool) -> Option<String> {
    let (stem, letters) = row.stem();
    let kind = &row.kind;
    // Of second order, with the corners of the same faces.
    let bending = match stem {
        "C3D8" => "C3D20R",
        "CPE4" => "CPE8R",
        "CPS4" => "CPS8R",
        "CAX4" => "CAX8R",
        _ if letters.is_empty() => return None,
        _ => return Some(format!("{kind}: integrated in full, as without its last letters")),
    };
    match (row.has_modes(), is_linear) {
        (true, true) => None,
        (true, false) => Some(format!(
            "{kind} has its incompatible modes for *ELASTIC without NLGEOM alone: here it is solved as {stem} and LOCKS in bending, so that \
             thin parts are several times too stiff. Take {bending}"
        )),
        _ if letters.contains(['R', 'I']) => {
            let other = if stem == "CAX4" { String::new() } else { format!(", or, without NLGEOM, {stem}I") };
            Some(format!(
                "{kind} is integrated in full, as {stem}, and LOCKS in bending: thin parts are several times too stiff. Take {bending}{other}"
            ))
        }
        _ if letters.is_empty() => None,
        _ => Some(format!("{kind}: integrated in full, as without its last letters")),
    }
}
