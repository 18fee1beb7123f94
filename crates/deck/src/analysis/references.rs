//! Reference nodes, and the nodes that each moves or loads.

use super::Bodies;
use super::shares::shares;
use super::spread::{Faces, faces_of_row, keys_of_cell};
use super::surfaces::surface;
use crate::Fault;
use crate::read::{Deck, Kind, Members, RigidKind, RigidRow};
use fmc_solid::fem::Face;
use std::collections::{BTreeMap, BTreeSet};

/// A reference node.
pub(crate) struct Reference<const D: usize> {
    /// Its keyword and line.
    pub(crate) line: usize,
    pub(crate) keyword: &'static str,
    /// The node in the file, its label, and the node of the model that it is, too, if any.
    pub(crate) node: usize,
    pub(crate) label: u64,
    pub(crate) own: Option<usize>,
    /// The node of the file whose displacements are the rotations.
    pub(crate) rotating: Option<usize>,
    pub(crate) place: [f64; D],
    /// Nodes of the model that go with it, ascending, and their arms.
    pub(crate) nodes: Vec<usize>,
    pub(crate) arms: Vec<[f64; D]>,
    pub(crate) way: Way<D>,
}

/// What goes with a reference node.
#[derive(PartialEq)]
pub(crate) enum Way<const D: usize> {
    /// Motion, along these axes.
    Follows([bool; 3]),
    /// Loads: by degree of freedom of the reference node, the forces on its nodes for the value 1; none where it takes none.
    Shares([Option<Vec<[f64; D]>>; 6]),
    /// No nodes: it belongs to no element, and equations name it along these axes.
    Loose([bool; 3]),
    /// None: its displacements are the components of its only node along these axes.
    Local([[f64; D]; D]),
}

impl<const D: usize> Reference<D> {
    /// Whether it has a motion, and does not only load nodes.
    pub(crate) fn has_motion(&self) -> bool {
        !matches!(self.way, Way::Shares(_) | Way::Local(_))
    }

    /// A node of no element that an equation names along an axis.
    pub(super) fn loose(deck: &Deck, node: usize, line: usize, axis: usize) -> Self {
        Self {
            line,
            keyword: "*EQUATION",
            node,
            label: deck.mesh.node_tags[node],
            own: None,
            rotating: None,
            place: std::array::from_fn(|axis| deck.mesh.points[node][axis]),
            nodes: Vec::new(),
            arms: Vec::new(),
            way: Way::Loose(std::array::from_fn(|k| k == axis)),
        }
    }

    /// The components of a node, of the file and of the model, along axes of its own.
    pub(super) fn local((deck, line): (&Deck, usize), (node, own): (usize, usize), axes: [[f64; D]; D]) -> Self {
        let loose = Self::loose(deck, node, line, 0);
        Self { keyword: "*TRANSFORM", nodes: vec![own], way: Way::Local(axes), ..loose }
    }

    /// How messages call it.
    pub(crate) fn name(&self) -> String {
        format!("{} of line {}", self.keyword, self.line)
    }
}

/// A row with its second node, its nodes, and the faces that they are of, if it has any.
struct Found<'a> {
    row: &'a RigidRow,
    rotating: Option<usize>,
    nodes: BTreeSet<usize>,
    faces: Vec<Face>,
}

/// All reference nodes of a file: rows that name the same one are one.
pub(super) fn references<const D: usize>(
    deck: &Deck,
    bodies: Bodies<D>,
    all: &Faces,
) -> Result<Vec<Reference<D>>, Fault> {
    let mut found: BTreeMap<usize, Vec<Found>> = BTreeMap::new();
    let mut order = Vec::new();
    for row in &deck.rigid {
        for instance in deck.names.instances_of(&row.scope) {
            let node = single(deck, instance, &row.reference, row.line)?;
            let rotating = row.rotating.as_ref().map(|name| single(deck, instance, name, row.line)).transpose()?;
            if !found.contains_key(&node) {
                order.push(node);
            }
            let members = members(deck, bodies, all, (row, instance, node))?;
            found.entry(node).or_default().push(Found { rotating, ..members });
        }
    }
    let mut references: Vec<Reference<D>> = Vec::new();
    for node in order {
        let rows = found.remove(&node).unwrap_or_default();
        references.push(reference(deck, bodies, node, rows)?);
    }
    check_apart(deck, bodies, &references)?;
    Ok(references)
}

fn reference<const D: usize>(
    deck: &Deck,
    bodies: Bodies<D>,
    node: usize,
    rows: Vec<Found>,
) -> Result<Reference<D>, Fault> {
    let (first, rotating) = (rows[0].row, rows[0].rotating);
    let label = deck.mesh.node_tags[node];
    if let Some(other) = rows.iter().find(|found| found.row.kind != first.kind) {
        let message = format!("node {label} is the reference node of line {} in another way", first.line);
        return Err(Fault::new(other.row.line, message));
    }
    if let (2, Some(row)) = (D, rows.iter().find(|found| found.rotating.is_some())) {
        return Err(Fault::new(row.row.line, "ROT NODE is not known in 2D: degree of freedom 6 of REF NODE turns"));
    }
    let all: BTreeSet<usize> = rows.iter().flat_map(|found| found.nodes.iter().copied()).collect();
    let nodes: Vec<usize> = all.into_iter().collect();
    if nodes.is_empty() {
        return Err(Fault::new(first.line, format!("{} has no node of an element", first.keyword)));
    }
    let own = bodies.places.node_of[node];
    if own.is_some_and(|own| first.kind != RigidKind::Follows([true; 3]) || nodes.binary_search(&own).is_err()) {
        let message =
            format!("the reference node {label} belongs to an element: known is a node of none, or of the rigid body");
        return Err(Fault::new(first.line, message));
    }
    if bodies.model.is_axisymmetric() && matches!(first.kind, RigidKind::Shares(_)) {
        let message = "*DISTRIBUTING is not known for bodies of revolution: load nodes or faces of the ring";
        return Err(Fault::new(first.line, message));
    }
    let place: [f64; D] = std::array::from_fn(|axis| deck.mesh.points[node][axis]);
    let arm = |node: &usize| -> [f64; D] { std::array::from_fn(|k| bodies.model.coords()[*node][k] - place[k]) };
    let arms: Vec<[f64; D]> = nodes.iter().map(arm).collect();
    let way = match first.kind {
        RigidKind::Shares(moments) => {
            let weights = weights(bodies, &nodes, rows.iter().flat_map(|found| &found.faces));
            let forces = shares(&arms, &weights, moments);
            Way::Shares(forces.ok_or_else(|| {
                let message =
                    "the nodes of *DISTRIBUTING lie on one line or at one place, and take no moments about it";
                Fault::new(first.line, message)
            })?)
        }
        RigidKind::Follows(axes) => Way::Follows(axes),
        RigidKind::Unknown => return Err(Fault::new(first.line, "this *COUPLING has no kind")),
    };
    let (line, keyword) = (first.line, first.keyword);
    Ok(Reference { line, keyword, node, label, own, rotating, place, nodes, arms, way })
}

/// Areas of the nodes of faces, or 1 for each node where there are none.
fn weights<'a, const D: usize>(bodies: Bodies<D>, nodes: &[usize], faces: impl Iterator<Item = &'a Face>) -> Vec<f64> {
    let faces: Vec<Face> = faces.cloned().collect();
    if faces.is_empty() {
        return vec![1.0; nodes.len()];
    }
    let areas = bodies.model.surface_load(&faces, |_, _| std::array::from_fn(|axis| if axis == 0 { 1.0 } else { 0.0 }));
    nodes.iter().map(|&node| areas[node][0]).collect()
}

/// The only node of a set or label.
fn single(deck: &Deck, instance: Option<usize>, name: &str, line: usize) -> Result<usize, Fault> {
    match deck.names.find(Kind::Node, instance, name, line)?[..] {
        [node] => Ok(node),
        _ => Err(Fault::new(line, format!("'{name}' is more than one node, and no reference node"))),
    }
}

fn members<'a, const D: usize>(
    deck: &Deck,
    bodies: Bodies<D>,
    all: &Faces,
    (row, instance, reference): (&'a RigidRow, Option<usize>, usize),
) -> Result<Found<'a>, Fault> {
    let mut found = Found { row, rotating: None, nodes: BTreeSet::new(), faces: Vec::new() };
    let cells: Vec<_> = deck.mesh.cells().collect();
    let mut add = |node: usize, line: usize| match bodies.places.node_of[node] {
        None if node != reference => {
            Err(Fault::new(line, format!("node {} belongs to no element", deck.mesh.node_tags[node])))
        }
        own => {
            found.nodes.extend(own);
            Ok(())
        }
    };
    for members in &row.members {
        match members {
            Members::Elements(set) => {
                for cell in deck.names.find(Kind::Cell, instance, set, row.line)? {
                    cells[cell].1.iter().try_for_each(|&node| add(node as usize, row.line))?;
                }
            }
            // The reader has made elements of it.
            Members::Analytical(_) => {}
            Members::Nodes(set) => {
                let nodes = deck.names.find(Kind::Node, instance, set, row.line)?;
                nodes.into_iter().try_for_each(|node| add(node, row.line))?;
            }
            Members::Surface(name) => {
                let (instance, is_of_nodes, rows) = surface(deck, row.line, name)?;
                let mut keys = BTreeSet::new();
                for of_surface in rows {
                    if is_of_nodes {
                        let nodes = deck.names.find(Kind::Node, instance, &of_surface.set, of_surface.line)?;
                        nodes.into_iter().try_for_each(|node| add(node, of_surface.line))?;
                    } else if of_surface.face.is_empty() {
                        let cells = deck.names.find(Kind::Cell, instance, &of_surface.set, of_surface.line)?;
                        let free = cells.iter().flat_map(|&cell| keys_of_cell(deck, bodies, cell));
                        keys.extend(free.filter(|key| all.contains_key(key)));
                    } else {
                        keys.extend(faces_of_row(deck, bodies, instance, of_surface)?);
                    }
                }
                for key in keys {
                    let inside = || Fault::new(row.line, format!("a face of '{name}' lies inside of a body"));
                    found.faces.push(all.get(&key).cloned().ok_or_else(inside)?);
                }
            }
        }
    }
    found.nodes.extend(found.faces.iter().flat_map(|face| face.nodes.iter().map(|&node| node as usize)));
    Ok(found)
}

/// No node follows two reference nodes, and none follows itself.
fn check_apart<const D: usize>(deck: &Deck, bodies: Bodies<D>, references: &[Reference<D>]) -> Result<(), Fault> {
    let mut taken: BTreeMap<usize, &Reference<D>> = BTreeMap::new();
    for reference in references.iter().filter(|reference| reference.has_motion()) {
        for &node in &reference.nodes {
            if let Some(other) = taken.insert(node, reference) {
                let label = deck.mesh.node_tags[bodies.places.nodes[node]];
                let message = format!("node {label} follows the reference node of {} already", other.name());
                return Err(Fault::new(reference.line, message));
            }
        }
    }
    let mut rotating: BTreeMap<usize, usize> = BTreeMap::new();
    for reference in references {
        for node in [Some(reference.node), reference.rotating].into_iter().flatten() {
            let is_twice = rotating.insert(node, reference.line).is_some();
            let is_of_body = reference.rotating == Some(node) && bodies.places.node_of[node].is_some();
            if is_twice || is_of_body {
                let label = deck.mesh.node_tags[node];
                let message = format!("node {label} cannot be a REF NODE or ROT NODE and something else, too");
                return Err(Fault::new(reference.line, message));
            }
        }
    }
    Ok(())
}
