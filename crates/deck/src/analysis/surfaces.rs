//! Surfaces of a file, and the faces that they name.

use crate::Fault;
use crate::read::{Deck, SurfaceRow, face_corners};

/// The instance of a surface, whether it is of nodes, and its rows.
pub(super) fn surface<'a>(
    deck: &'a Deck,
    line: usize,
    name: &str,
) -> Result<(Option<usize>, bool, &'a [SurfaceRow]), Fault> {
    let (instance, rest) = deck.names.split(name);
    let mut scopes = deck.names.scopes_of(instance).into_iter();
    match scopes.find_map(|scope| deck.surfaces.get(scope, rest)) {
        Some(surface) => Ok((instance, surface.is_of_nodes, &surface.rows)),
        None => Err(Fault::new(line, format!("there is no surface '{name}'"))),
    }
}

/// The number of a face `S1`, `S2`, … of a cell, from 0.
pub(super) fn face_number(deck: &Deck, cell: usize, row: &SurfaceRow) -> Result<usize, Fault> {
    let number = row.face.strip_prefix('S').and_then(|face| face.parse::<usize>().ok());
    let count = deck.mesh.cell(cell).map_or(0, |(cell_type, ..)| face_corners(cell_type).len());
    match number {
        Some(number @ 1..) if number <= count => Ok(number - 1),
        _ => Err(no_face(deck, cell, row.line, 'S', &row.face)),
    }
}

pub(super) fn no_face(deck: &Deck, cell: usize, line: usize, letter: char, face: &str) -> Fault {
    let count = deck.mesh.cell(cell).map_or(0, |(cell_type, ..)| face_corners(cell_type).len());
    let label = deck.mesh.cell(cell).map_or(0, |(_, _, label, _)| label);
    let kind = &deck.elements[cell].kind;
    Fault::new(
        line,
        format!("element {label} of type {kind} has no face {face}; its faces are {letter}1 to {letter}{count}"),
    )
}
