//! What rigid faces cannot be.

use super::Faces;
use crate::Fault;
use crate::layer::{Twist, Unfilled};
use crate::read::deck::Deck;
use crate::read::names::Kind;
use crate::read::rigid::{Members, RigidKind};

/// Every rigid element belongs to a rigid body.
pub(super) fn check_bodies(deck: &Deck, faces: &Faces, first: usize) -> Result<(), Fault> {
    let mut is_moved = vec![false; faces.fronts.len()];
    for row in deck.rigid.iter().filter(|row| matches!(row.kind, RigidKind::Follows(_))) {
        for instance in deck.names.instances_of(&row.scope) {
            for members in &row.members {
                let Members::Elements(set) = members else { continue };
                let cells = deck.names.find(Kind::Cell, instance, set, row.line)?;
                cells.into_iter().filter(|cell| *cell >= first).for_each(|cell| is_moved[cell - first] = true);
            }
        }
    }
    match is_moved.iter().position(|is_moved| !is_moved) {
        None => Ok(()),
        Some(face) => {
            let message = format!("{} is in no ELSET of a *RIGID BODY, which moves it", faces.name(face));
            Err(Fault::new(faces.rows[face].line, message))
        }
    }
}

/// No rigid element has a node of a solid.
pub(super) fn check_apart(deck: &Deck, faces: &Faces) -> Result<(), Fault> {
    let mut is_solid = vec![false; deck.mesh.points.len()];
    deck.mesh.cells().for_each(|(_, nodes, ..)| nodes.iter().for_each(|&node| is_solid[node as usize] = true));
    for (face, front) in faces.fronts.iter().enumerate() {
        if let Some(node) = front.corners.iter().find(|node| is_solid[**node]) {
            let (name, label) = (faces.name(face), deck.mesh.node_tags[*node]);
            let message =
                format!("{name} has node {label} of a solid: make the solid's nodes a rigid body by NSET instead");
            return Err(Fault::new(faces.rows[face].line, message));
        }
    }
    Ok(())
}

/// Why faces have no outside.
pub(super) fn twisted(faces: &Faces, twist: Twist) -> Fault {
    match twist {
        Twist::Opposite([a, b]) => {
            let message = format!(
                "{} and element {} look to opposite sides: turn one of them round by the order of its nodes, or name its other side",
                faces.name(a),
                faces.labels[b]
            );
            Fault::new(faces.rows[a].line, message)
        }
        Twist::Branched(all) => {
            let labels: Vec<String> = all.iter().map(|face| faces.labels[*face].to_string()).collect();
            let message = format!("rigid elements {} meet at one edge: known is an edge of two", labels.join(", "));
            Fault::new(faces.rows[all[0]].line, message)
        }
    }
}

/// Why faces have no layer.
pub(super) fn bare(deck: &Deck, faces: &Faces, unfilled: Unfilled) -> Fault {
    let (face, why) = match unfilled {
        Unfilled::Flat(face) => (face, "has no area, or is folded".to_owned()),
        Unfilled::Folded(node) => {
            let face = faces.fronts.iter().position(|front| front.corners.contains(&node)).unwrap_or_default();
            (face, format!("is folded at node {}", deck.mesh.node_tags[node]))
        }
    };
    Fault::new(faces.rows[face].line, format!("{} {why}: contact finds no inside behind it", faces.name(face)))
}
