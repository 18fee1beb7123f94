//! Rigid elements and analytical surfaces in the mesh: each face is the front of a cell of a layer behind it.
//!
//! `elements` · `analytical` · `sides` (which of them press) · `faults` (what they cannot be)

mod analytical;
mod elements;
mod faults;
mod sides;

use super::deck::Deck;
use super::elements::ElementRow;
use super::note::Note;
use super::rigid_elements::RigidElements;
use crate::Fault;
use crate::layer::{Front, Layer, oriented, to_back};
use std::collections::BTreeMap;

/// The face of a cell behind a rigid face that is this face.
fn front_face(dimension: usize) -> &'static str {
    if dimension == 2 { "S1" } else { "S2" }
}

/// Faces with what they are in the file.
#[derive(Default)]
struct Faces {
    fronts: Vec<Front>,
    rows: Vec<ElementRow>,
    labels: Vec<u64>,
    groups: Vec<Option<i64>>,
    /// Whether they look outwards as they are.
    sides: Vec<Option<bool>>,
}

impl Faces {
    fn push(&mut self, front: Front, row: ElementRow, (label, group): (u64, Option<i64>), side: Option<bool>) {
        self.fronts.push(front);
        self.rows.push(row);
        self.labels.push(label);
        self.groups.push(group);
        self.sides.push(side);
    }

    /// A face as messages name it.
    fn name(&self, face: usize) -> String {
        format!("element {} of type {}", self.labels[face], self.rows[face].kind)
    }
}

/// Adds all of them.
pub(super) fn add(deck: &mut Deck, blocks: &[RigidElements]) -> Result<(), Fault> {
    let dimension = deck.mesh.cells().next().map_or(3, |(cell_type, ..)| cell_type.dimension());
    let first = deck.mesh.cell_count();
    let mut faces = Faces::default();
    for block in blocks {
        elements::add_elements(deck, &mut faces, block, (first, dimension))?;
    }
    analytical::add_analytical(deck, &mut faces, (first, dimension))?;
    if faces.fronts.is_empty() {
        return Ok(());
    }
    sides::take_sides(deck, &mut faces, (first, dimension))?;
    faults::check_bodies(deck, &faces, first)?;
    faults::check_apart(deck, &faces)?;
    let open =
        oriented(&mut faces.fronts, &faces.sides, &deck.mesh.points).map_err(|twist| faults::twisted(&faces, twist))?;
    let is_all = deck.pairs.iter().find(|row| row.surfaces[0].is_empty());
    for face in open {
        let (line, name) = (faces.rows[face].line, faces.name(face));
        if let Some(row) = is_all {
            let message = format!(
                "{name} has no side that presses: name SPOS or SNEG of it in a *SURFACE; line {} has ALL EXTERIOR",
                row.line
            );
            return Err(Fault::new(line, message));
        }
        deck.notes.push(Note::new(line, format!("no *SURFACE names a side of {name}, which is taken as SPOS")));
    }
    let back = to_back(&deck.mesh.points, &faces.fronts, deck.is_axisymmetric());
    let back = back.map_err(|unfilled| faults::bare(deck, &faces, unfilled))?;
    tell_thickness(deck, &faces, &back);
    let mut layer = Layer::new(&mut deck.mesh.points, &back);
    let cells: Vec<_> = faces.fronts.iter().map(|front| layer.cell(front)).collect();
    tag_nodes(deck);
    for ((cell_type, nodes), (label, group)) in cells.into_iter().zip(faces.labels.iter().zip(&faces.groups)) {
        deck.mesh.push(cell_type, nodes, *label, *group);
    }
    deck.elements.extend(faces.rows);
    Ok(())
}

/// Labels of nodes that are none of the file.
fn tag_nodes(deck: &mut Deck) {
    let last = deck.mesh.node_tags.iter().copied().max().unwrap_or(0);
    let missing = deck.mesh.points.len() - deck.mesh.node_tags.len();
    deck.mesh.node_tags.extend((1..=missing as u64).map(|number| last.saturating_add(number)));
}

/// The group of a name that bodies have it from.
fn group(deck: &mut Deck, name: &str) -> i64 {
    let known = deck.mesh.group_names.iter().find(|(_, known)| *known == name).map(|(group, _)| *group);
    known.unwrap_or_else(|| {
        let next = deck.mesh.group_names.last_key_value().map_or(1, |(last, _)| last + 1);
        deck.mesh.group_names.insert(next, name.to_owned());
        next
    })
}

/// Says of each keyword how thick the layer behind its faces is.
fn tell_thickness(deck: &mut Deck, faces: &Faces, back: &BTreeMap<usize, [f64; 3]>) {
    let mut least: BTreeMap<usize, [f64; 2]> = BTreeMap::new();
    for (front, row) in faces.fronts.iter().zip(&faces.rows) {
        for way in front.corners.iter().filter_map(|node| back.get(node)) {
            let thickness = way.iter().map(|x| x * x).sum::<f64>().sqrt();
            let [low, high] = least.entry(row.keyword).or_insert([f64::INFINITY, 0.0]);
            (*low, *high) = (low.min(thickness), high.max(thickness));
        }
    }
    for (line, [low, high]) in least {
        let message = format!(
            "rigid faces are the front of a layer of cells, {low:.3e} to {high:.3e} thick, which the results show"
        );
        deck.notes.push(Note::new(line, message));
    }
}
