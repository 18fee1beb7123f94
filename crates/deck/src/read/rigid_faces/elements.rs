//! Rigid elements.

use super::{Faces, group};
use crate::Fault;
use crate::layer::Front;
use crate::read::deck::Deck;
use crate::read::elements::{ElementRow, is_ring};
use crate::read::rigid_elements::RigidElements;

/// Adds the elements of a block; cells of layers are numbered from `first`.
pub(super) fn add_elements(
    deck: &mut Deck,
    faces: &mut Faces,
    block: &RigidElements,
    (first, dimension): (usize, usize),
) -> Result<(), Fault> {
    let kind = &block.kind;
    if kind.starts_with("R3D") != (dimension == 3) {
        return Err(Fault::new(block.line, format!("elements of type {kind} together with {dimension}D elements")));
    }
    let ring = deck.elements.iter().find(|row| is_ring(&row.kind) != (kind == "RAX2"));
    if let Some(other) = ring.filter(|_| dimension == 2) {
        let message = format!("elements of type {kind} together with {}: axisymmetric and plane bodies", other.kind);
        return Err(Fault::new(block.line, message));
    }
    for instance in deck.names.instances_of(&block.scope) {
        let of_set = || block.set.as_ref().map(|set| group(deck, set));
        let of_body = instance.map(|number| number as i64 + 1).or_else(of_set);
        for (line, label, nodes) in &block.elements {
            let of = |node: &u64| {
                let found = deck.names.node(instance, *node);
                found.ok_or_else(|| {
                    Fault::new(*line, format!("element {label} names node {node}, which does not exist"))
                })
            };
            let corners: Vec<usize> = nodes.iter().map(of).collect::<Result<_, _>>()?;
            let cell = first + faces.fronts.len();
            if !deck.names.add_cell(instance, *label, cell, &corners) {
                return Err(Fault::new(*line, format!("element {label} is there twice")));
            }
            let row = ElementRow { line: *line, keyword: block.line, kind: kind.clone() };
            faces.push(Front { corners, middles: Vec::new() }, row, (*label, of_body), None);
        }
    }
    Ok(())
}
