//! Loads on faces and volumes, as forces on nodes.

use super::Bodies;
use super::facets::corner_count;
use super::surfaces::{face_number, no_face, surface};
use crate::Fault;
use crate::read::{Deck, Kind, Load, LoadKind, SurfaceRow, face_corners};
use fmc_contact::CellType;
use fmc_solid::fem::Face;
use std::collections::BTreeMap;

/// Faces of the boundary of all bodies, by their corners, ascending.
pub(super) type Faces = BTreeMap<Vec<u32>, Face>;

/// A load on faces or volumes for the value 1.
pub(super) struct Spread<const D: usize> {
    /// Force on every node.
    pub(super) forces: Vec<[f64; D]>,
    /// Faces on which it acts, by their corners.
    pub(super) faces: Vec<Vec<u32>>,
}

/// All faces of the boundary.
pub(super) fn faces<const D: usize>(bodies: Bodies<D>) -> Faces {
    let all = (0..bodies.model.parts().len()).flat_map(|part| bodies.model.faces_where(part, |_| true));
    all.map(|face| (corners::<D>(&face.nodes), face)).collect()
}

fn corners<const D: usize>(nodes: &[u32]) -> Vec<u32> {
    let mut corners = nodes[..corner_count::<D>(nodes.len())].to_vec();
    corners.sort_unstable();
    corners
}

/// A load for the value 1.
pub(super) fn spread<const D: usize>(
    deck: &Deck,
    bodies: Bodies<D>,
    all: &Faces,
    load: &Load,
) -> Result<Spread<D>, Fault> {
    let keys = match &load.kind {
        LoadKind::Gravity(direction) => {
            return Ok(Spread { forces: gravity(deck, bodies, load, direction)?, faces: Vec::new() });
        }
        LoadKind::Pressure(face) => faces_of(deck, bodies, None, (&load.set, load.line), ('P', *face))?,
        _ => on_surface(deck, bodies, load)?,
    };
    let mut faces = Vec::with_capacity(keys.len());
    for key in &keys {
        let inside = || Fault::new(load.line, "the load acts on a face inside of a body");
        faces.push(all.get(key).cloned().ok_or_else(inside)?);
    }
    Ok(Spread { forces: bodies.model.surface_load(&faces, |_, normal| normal.map(|n| -n)), faces: keys })
}

/// Faces `face` of the cells of a set, by their corners; `letter` is what stands before their numbers.
fn faces_of<const D: usize>(
    deck: &Deck,
    bodies: Bodies<D>,
    instance: Option<usize>,
    (set, line): (&str, usize),
    (letter, face): (char, usize),
) -> Result<Vec<Vec<u32>>, Fault> {
    let all: Vec<_> = deck.mesh.cells().collect();
    let of = |cell: usize| {
        let (cell_type, nodes, ..) = all[cell];
        if letter == 'P' && deck.elements[cell].is_rigid() {
            let (label, kind) = (all[cell].2, &deck.elements[cell].kind);
            let message = format!("element {label} of type {kind} is rigid: put a force on its reference node");
            return Err(Fault::new(line, message));
        }
        let local = face_corners(cell_type).get(face);
        let local = local.ok_or_else(|| no_face(deck, cell, line, letter, &format!("{letter}{}", face + 1)))?;
        Ok(key(bodies, nodes, local))
    };
    deck.names.find(Kind::Cell, instance, set, line)?.into_iter().map(of).collect()
}

/// Faces that a row of a surface names, by their corners.
pub(super) fn faces_of_row<const D: usize>(
    deck: &Deck,
    bodies: Bodies<D>,
    instance: Option<usize>,
    row: &SurfaceRow,
) -> Result<Vec<Vec<u32>>, Fault> {
    let cells = deck.names.find(Kind::Cell, instance, &row.set, row.line)?;
    let face = face_number(deck, cells[0], row)?;
    faces_of(deck, bodies, instance, (&row.set, row.line), ('S', face))
}

/// All faces of a cell of the file, by their corners.
pub(super) fn keys_of_cell<const D: usize>(deck: &Deck, bodies: Bodies<D>, cell: usize) -> Vec<Vec<u32>> {
    deck.mesh.cell(cell).map_or(Vec::new(), |(cell_type, nodes, ..)| keys_of(bodies, cell_type, nodes))
}

/// All faces of a cell with these nodes of the file, by their corners.
pub(super) fn keys_of<const D: usize>(bodies: Bodies<D>, cell_type: CellType, nodes: &[u32]) -> Vec<Vec<u32>> {
    face_corners(cell_type).iter().map(|local| key(bodies, nodes, local)).collect()
}

/// A face by its corners, of a cell with these nodes of the file.
fn key<const D: usize>(bodies: Bodies<D>, nodes: &[u32], local: &[usize]) -> Vec<u32> {
    let node = |corner: &usize| bodies.places.node_of[nodes[*corner] as usize].unwrap_or_default() as u32;
    let mut key: Vec<u32> = local.iter().map(node).collect();
    key.sort_unstable();
    key
}

fn on_surface<const D: usize>(deck: &Deck, bodies: Bodies<D>, load: &Load) -> Result<Vec<Vec<u32>>, Fault> {
    let (instance, is_of_nodes, rows) = surface(deck, load.line, &load.set)?;
    if is_of_nodes {
        return Err(Fault::new(load.line, format!("'{}' is a surface of nodes and has no faces", load.set)));
    }
    let mut keys = Vec::new();
    for row in rows {
        if row.face.is_empty() {
            return Err(Fault::new(row.line, "a load needs faces S1, S2, …, and this names none"));
        }
        keys.extend(faces_of_row(deck, bodies, instance, row)?);
    }
    // Rows of a surface may share faces: each is there once.
    keys.sort_unstable();
    keys.dedup();
    Ok(keys)
}

/// The weight of bodies for an acceleration of 1.
fn gravity<const D: usize>(
    deck: &Deck,
    bodies: Bodies<D>,
    load: &Load,
    direction: &[f64; 3],
) -> Result<Vec<[f64; D]>, Fault> {
    if bodies.model.is_axisymmetric() && direction[0] != 0.0 {
        return Err(Fault::new(load.line, "GRAV acts along the axis of bodies of revolution, the second coordinate"));
    }
    let length = direction.iter().map(|x| x * x).sum::<f64>().sqrt();
    if !(length > 0.0 && length.is_finite()) {
        return Err(Fault::new(load.line, "GRAV needs a direction"));
    }
    let cells = match load.set.is_empty() {
        true => (0..deck.mesh.cell_count()).collect(),
        false => deck.names.find(Kind::Cell, None, &load.set, load.line)?,
    };
    let mut counts = vec![[0; 2]; bodies.model.parts().len()];
    cells.iter().for_each(|&cell| counts[bodies.places.body_of[cell]][0] += 1);
    bodies.places.body_of.iter().for_each(|&body| counts[body][1] += 1);
    let mut forces = vec![[0.0; D]; bodies.model.node_count()];
    // Rigid surfaces have no weight.
    let with_weight = |body: usize, counts: &[i32; 2]| counts[0] > 0 && !bodies.places.is_layer[body];
    for (body, [of_set, of_body]) in counts.into_iter().enumerate().filter(|(body, counts)| with_weight(*body, counts))
    {
        let part = &bodies.model.parts()[body];
        if of_set < of_body {
            return Err(Fault::new(
                load.line,
                format!("GRAV on a part of {} is not known, only on all of it", part.name),
            ));
        }
        let density = part.material.density;
        let force = bodies.model.body_load(body, std::array::from_fn(|axis| density * direction[axis] / length));
        forces.iter_mut().zip(force).for_each(|(sum, f)| (0..D).for_each(|axis| sum[axis] += f[axis]));
    }
    Ok(forces)
}
