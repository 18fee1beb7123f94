//! Which side of rigid elements presses.

use super::{Faces, front_face};
use crate::Fault;
use crate::read::deck::Deck;
use crate::read::names::Kind;
use std::collections::BTreeSet;

/// The sides that surfaces name.
pub(super) fn take_sides(deck: &mut Deck, faces: &mut Faces, (first, dimension): (usize, usize)) -> Result<(), Fault> {
    let mut named_by: Vec<usize> = vec![0; faces.fronts.len()];
    let mut is_rigid: BTreeSet<usize> = BTreeSet::new();
    for (scope, row) in deck.surfaces.rows() {
        for instance in deck.names.instances_of(scope) {
            // Sets that are not there matter where the surface is used.
            let Ok(cells) = deck.names.find(Kind::Cell, instance, &row.set, row.line) else { continue };
            for &cell in cells.iter().filter(|cell| **cell >= first) {
                let face = cell - first;
                if !faces.fronts[face].middles.is_empty() {
                    continue;
                }
                let is_out = match row.face.as_str() {
                    "SPOS" => true,
                    "SNEG" => false,
                    other => {
                        let found = if other.is_empty() { "none" } else { other };
                        let message = format!(
                            "{} presses with one side, SPOS or SNEG, and the surface names {found}",
                            faces.name(face)
                        );
                        return Err(Fault::new(row.line, message));
                    }
                };
                if faces.sides[face].is_some_and(|side| side != is_out) {
                    let message =
                        format!("{} has its other side in line {}: known is one", faces.name(face), named_by[face]);
                    return Err(Fault::new(row.line, message));
                }
                (faces.sides[face], named_by[face]) = (Some(is_out), row.line);
                if let Some(solid) = cells.iter().find(|cell| **cell < first) {
                    let label = deck.mesh.cell(*solid).map_or(0, |(_, _, label, _)| label);
                    let message = format!("{} and the solid {label} are in one set of a surface", faces.name(face));
                    return Err(Fault::new(row.line, message));
                }
                is_rigid.insert(row.line);
            }
        }
    }
    deck.surfaces.set_faces(&is_rigid, front_face(dimension));
    Ok(())
}
