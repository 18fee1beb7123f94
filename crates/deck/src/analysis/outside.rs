//! What presses outside the surfaces that contact pairs name: contact is between bodies, so other faces of the same two may touch.

use super::Bodies;
use super::facets::corner_count;
use super::spread::{Faces, keys_of};
use super::tied_parts::Part;
use crate::read::Deck;
use fmc_contact::CellType;
use fmc_contact::contact::{PointOfContact, SideOfPoint};
use fmc_contact::overlap::Partner;
use fmc_solid::fem::Face;
use fmc_solid::statics::{Equilibrium, StaticsError};
use std::collections::BTreeMap;

/// The faces of both bodies that contact pairs name, by the pair, with the line of the first.
pub(crate) type Named = BTreeMap<[usize; 2], (usize, Part)>;

/// Type, nodes, label and group of the cells of a file.
type Cells<'a> = Vec<(CellType, &'a [u32], u64, Option<i64>)>;

/// Normal force on faces, by their corners, and a cell of the model that has each.
type Pressed = BTreeMap<Vec<u32>, (f64, usize)>;

/// Part of the normal force of a pair that other faces may bear without a word: at the rim of a surface the neighbours of its faces are deep in
/// the other body by part of the penetration.
const RIM: f64 = 0.05;

/// Faces that are named in a sentence.
const MOST_NAMED: usize = 4;

/// A sentence for each pair of bodies that other faces press, too; forces are of a thickness.
pub(super) fn sentences<const D: usize>(
    (deck, bodies): (&Deck, Bodies<D>),
    all: &Faces,
    named: &Named,
    at: &Equilibrium<D>,
    thickness: f64,
) -> Result<Vec<String>, StaticsError> {
    if named.is_empty() {
        return Ok(Vec::new());
    }
    let coords = at.coords();
    let cells: Cells = deck.mesh.cells().collect();
    let mut forces: BTreeMap<[usize; 2], Pressed> = BTreeMap::new();
    for point in at.contact_points()? {
        let [Partner::Body(a), Partner::Body(b)] = point.partners else { continue };
        let pair = [a.min(b), a.max(b)];
        if !named.contains_key(&pair) {
            continue;
        }
        let Some((key, cell)) = pressed_face((&cells, bodies), all, &coords, &point) else { continue };
        let entry = forces.entry(pair).or_default().entry(key).or_insert((0.0, cell));
        entry.0 += point.pressure * point.area * thickness;
    }
    let mut said = Vec::new();
    for (pair, faces) in forces {
        let Some((line, part)) = named.get(&pair) else { continue };
        let total: f64 = faces.values().map(|(force, _)| force).sum();
        let mut other: Vec<(&Vec<u32>, &(f64, usize))> = faces.iter().filter(|(key, _)| !part.contains(*key)).collect();
        let outside: f64 = other.iter().map(|(_, (force, _))| force).sum();
        if outside <= RIM * total {
            continue;
        }
        other.retain(|(_, (force, _))| *force > RIM * outside);
        other.sort_by(|p, q| q.1.0.total_cmp(&p.1.0));
        let face = |(key, (force, cell)): &(&Vec<u32>, &(f64, usize))| {
            format!("{} {force:.4e}", face_name((&cells, bodies), *cell, key))
        };
        let listed: Vec<String> = other.iter().take(MOST_NAMED).map(face).collect();
        let more = if other.len() > MOST_NAMED { ", …" } else { "" };
        let [a, b] = pair.map(|body| bodies.model.parts()[body].name.as_str());
        said.push(format!(
            "'{a}' and '{b}' also press one another outside the surfaces of the contact pair of line {line}: with {outside:.4e} of a normal \
             force of {total:.4e}. Elements and faces with the largest part: {}{more}. In Abaqus and CalculiX these faces are in no contact",
            listed.join(", ")
        ));
    }
    Ok(said)
}

/// The face of the boundary on which a point of contact lies, with its cell of the model: of two sides one is a face, the other a place in a cell.
fn pressed_face<const D: usize>(
    (cells, bodies): (&Cells, Bodies<D>),
    all: &Faces,
    coords: &[[f64; D]],
    point: &PointOfContact<D>,
) -> Option<(Vec<u32>, usize)> {
    let [first, second] = &point.sides;
    let is_face = |side: &SideOfPoint<D>| {
        let mut key = side.nodes[..side.node_count].to_vec();
        key.sort_unstable();
        all.contains_key(&key)
    };
    // Points of divided faces of second order are none of the file: there a face has fewer than a cell.
    let is_second = match [first, second].map(is_face) {
        [false, true] => true,
        [true, false] => false,
        _ => second.node_count < first.node_count,
    };
    let cell = if is_second { second } else { first }.cell?;
    let sign = if is_second { -1.0 } else { 1.0 };
    let looks = |key: &Vec<u32>| -> f64 {
        let normal = all.get(key).map_or([0.0; D], |face| normal(coords, face));
        sign * (0..D).map(|k| normal[k] * point.normal[k]).sum::<f64>()
    };
    let (cell_type, nodes, ..) = cells[*bodies.places.cells.get(cell)?];
    let on_boundary = keys_of(bodies, cell_type, nodes).into_iter().filter(|key| all.contains_key(key));
    let key = on_boundary.max_by(|p, q| looks(p).total_cmp(&looks(q)))?;
    Some((key, cell))
}

/// Outward unit normal of a face between its corners.
fn normal<const D: usize>(coords: &[[f64; D]], face: &Face) -> [f64; D] {
    let corner = |k: usize| coords[face.nodes[k] as usize];
    let along = |p: usize, q: usize| -> [f64; 3] {
        let [p, q] = [corner(p), corner(q)];
        std::array::from_fn(|k| q.get(k).zip(p.get(k)).map_or(0.0, |(q, p)| q - p))
    };
    let [u, v] = match corner_count::<D>(face.nodes.len()) {
        2 => [along(0, 1), [0.0, 0.0, 1.0]],
        3 => [along(0, 1), along(0, 2)],
        _ => [along(0, 2), along(1, 3)],
    };
    let cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let length = cross.iter().map(|x| x * x).sum::<f64>().sqrt();
    std::array::from_fn(|k| cross[k] / length)
}

/// A face as files name it.
fn face_name<const D: usize>((cells, bodies): (&Cells, Bodies<D>), cell: usize, key: &[u32]) -> String {
    let (cell_type, nodes, label, _) = cells[bodies.places.cells[cell]];
    let number = keys_of(bodies, cell_type, nodes).iter().position(|known| known == key).map_or(0, |place| place + 1);
    format!("{label} S{number}")
}
