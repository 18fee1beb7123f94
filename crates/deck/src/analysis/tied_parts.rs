//! Which faces of which bodies a tie or a contact pair names.

use super::Bodies;
use super::spread::{Faces, faces_of_row, keys_of_cell};
use super::surfaces::surface;
use crate::Fault;
use crate::read::{Deck, Kind, Note, SurfaceRow};
use std::collections::{BTreeMap, BTreeSet};

/// Faces by their corners, ascending.
pub(super) type Part = BTreeSet<Vec<u32>>;

/// What a surface has of the boundary of each body, which `all` lists; `line` is that of the tie.
pub(super) fn parts_of<const D: usize>(
    deck: &Deck,
    bodies: Bodies<D>,
    all: &Faces,
    (line, name): (usize, &str),
    notes: &mut Vec<Note>,
) -> Result<BTreeMap<usize, Part>, Fault> {
    let (instance, is_of_nodes, rows) = surface(deck, line, name)?;
    let (part, left_out) = match is_of_nodes {
        true => between_nodes(deck, bodies, all, (instance, rows))?,
        false => of_elements(deck, bodies, all, (instance, rows))?,
    };
    match left_out {
        Some(what) if part.is_empty() => Err(Fault::new(line, format!("'{name}' ties nothing: {what}"))),
        Some(what) => {
            notes.push(Note { line, message: format!("not all of '{name}' is tied: {what}") });
            Ok(by_body(all, part))
        }
        None => Ok(by_body(all, part)),
    }
}

/// Faces of the boundary that a surface names, of all bodies.
pub(super) fn named_faces<const D: usize>(
    deck: &Deck,
    bodies: Bodies<D>,
    all: &Faces,
    (line, name): (usize, &str),
) -> Result<Part, Fault> {
    let (instance, is_of_nodes, rows) = surface(deck, line, name)?;
    if is_of_nodes {
        // A node in contact presses all faces around it.
        let nodes = nodes_of(deck, bodies, (instance, rows))?;
        return Ok(all.keys().filter(|key| key.iter().any(|node| nodes.contains(node))).cloned().collect());
    }
    Ok(of_elements(deck, bodies, all, (instance, rows))?.0)
}

/// Nodes of a surface of nodes.
fn nodes_of<const D: usize>(
    deck: &Deck,
    bodies: Bodies<D>,
    (instance, rows): (Option<usize>, &[SurfaceRow]),
) -> Result<BTreeSet<u32>, Fault> {
    let mut nodes: BTreeSet<u32> = BTreeSet::new();
    for row in rows {
        for node in deck.names.find(Kind::Node, instance, &row.set, row.line)? {
            let label = deck.mesh.node_tags[node];
            let of_none = || Fault::new(row.line, format!("node {label} belongs to no element"));
            nodes.insert(bodies.places.node_of[node].ok_or_else(of_none)? as u32);
        }
    }
    Ok(nodes)
}

fn by_body(all: &Faces, part: Part) -> BTreeMap<usize, Part> {
    let mut found: BTreeMap<usize, Part> = BTreeMap::new();
    for key in part {
        found.entry(all[&key].part).or_default().insert(key);
    }
    found
}

/// Faces all of whose corners are nodes of a surface, and a sentence about a node that none of them has.
fn between_nodes<const D: usize>(
    deck: &Deck,
    bodies: Bodies<D>,
    all: &Faces,
    (instance, rows): (Option<usize>, &[SurfaceRow]),
) -> Result<(Part, Option<String>), Fault> {
    let nodes = nodes_of(deck, bodies, (instance, rows))?;
    let part: Part = all.keys().filter(|key| key.iter().all(|node| nodes.contains(node))).cloned().collect();
    let covered: BTreeSet<u32> = part.iter().flat_map(|key| all[key].nodes.iter().copied()).collect();
    let of_none = nodes.difference(&covered).next().map(|node| {
        let label = deck.mesh.node_tags[bodies.places.nodes[*node as usize]];
        format!("no face with node {label} has all of its corners in this surface of nodes")
    });
    Ok((part, of_none))
}

/// Faces that elements name, or all of their free ones where they name none, and a sentence about those that are not free.
fn of_elements<const D: usize>(
    deck: &Deck,
    bodies: Bodies<D>,
    all: &Faces,
    (instance, rows): (Option<usize>, &[SurfaceRow]),
) -> Result<(Part, Option<String>), Fault> {
    let (mut part, mut inside) = (Part::new(), 0);
    for row in rows {
        if row.face.is_empty() {
            let cells = deck.names.find(Kind::Cell, instance, &row.set, row.line)?;
            let keys = cells.iter().flat_map(|&cell| keys_of_cell(deck, bodies, cell));
            part.extend(keys.filter(|key| all.contains_key(key)));
            continue;
        }
        for key in faces_of_row(deck, bodies, instance, row)? {
            inside += usize::from(!all.contains_key(&key));
            part.extend(Some(key).filter(|key| all.contains_key(key)));
        }
    }
    let told = (inside > 0 || part.is_empty()).then(|| format!("{inside} of its faces lie inside of a body"));
    Ok((part, told))
}
