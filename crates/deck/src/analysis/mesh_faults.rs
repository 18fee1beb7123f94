//! What is wrong with a mesh, in the labels of its file.

use super::Places;
use crate::Fault;
use crate::read::Deck;
use fmc_contact::Error;

/// A fault of cells, at the line of the last of them.
pub(super) fn labelled(error: &Error, deck: &Deck, places: &Places) -> Option<Fault> {
    let label = |cell: usize| deck.mesh.cell(places.cells[cell]).map_or(0, |(_, _, label, _)| label);
    let named = |cells: &[usize]| cells.iter().map(|&cell| label(cell).to_string()).collect::<Vec<_>>().join(", ");
    let (cells, what) = match error {
        Error::RepeatedCell { cells: [one, other] } => {
            let text = format!(
                "elements {} and {} have the same nodes: one of them is a duplicate",
                label(*one),
                label(*other)
            );
            (vec![*one, *other], text)
        }
        Error::NonConforming { cells: [one, other] } => {
            let text = format!(
                "elements {} and {} do not conform: an edge or a face has a node in its middle in only one of them, or they have different nodes \
                 there",
                label(*one),
                label(*other)
            );
            (vec![*one, *other], text)
        }
        Error::InvertedCell { cell } | Error::FoldedCell { cell, .. } => {
            (vec![*cell], format!("element {} is inverted", label(*cell)))
        }
        Error::InvertedCells { cells, .. } => (cells.clone(), format!("elements are inverted: {}", named(cells))),
        Error::ZeroMeasure { cell } => (vec![*cell], format!("element {} has no volume", label(*cell))),
        _ => return None,
    };
    let lines = cells.iter().filter_map(|&cell| Some(deck.elements.get(*places.cells.get(cell)?)?.line));
    Some(Fault::new(lines.max()?, what))
}
