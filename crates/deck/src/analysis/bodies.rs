//! Bodies: the connected parts of a mesh, each of one material.

use crate::Fault;
use crate::read::{Deck, Kind};
use fmc_contact::CellType;
use fmc_shapes::Mesh;
use fmc_solid::fem::{Cells, Error, Law, Material, Model, Part};

/// The bodies of a file with their places in it.
#[derive(Clone, Copy)]
pub(crate) struct Bodies<'a, const D: usize> {
    pub(crate) model: &'a Model<D>,
    pub(crate) places: &'a Places,
}

/// Which node and cell of the model is which of the file.
pub(crate) struct Places {
    /// Node of the model, by node of the file; none for nodes without elements.
    pub(crate) node_of: Vec<Option<usize>>,
    /// Body, by cell of the file.
    pub(crate) body_of: Vec<usize>,
    /// Node of the file, by node of the model.
    pub(crate) nodes: Vec<usize>,
    /// Cell of the file, by cell of the model.
    pub(crate) cells: Vec<usize>,
    /// Whether displacements are finite.
    pub(crate) is_finite: bool,
    /// Whether each body is a layer behind rigid faces.
    pub(crate) is_layer: Vec<bool>,
}

impl Places {
    /// The bodies of a file, and their places.
    pub(crate) fn with_model<const D: usize>(deck: &Deck, threads: usize) -> Result<(Self, Model<D>), Fault> {
        let is_finite = deck.steps.iter().any(|step| step.is_finite);
        let (component, count) = components(deck);
        let materials = materials(deck, is_finite)?;
        let all: Vec<(CellType, &[u32], u64, Option<i64>)> = deck.mesh.cells().collect();
        let body_of: Vec<usize> = all.iter().map(|(_, nodes, ..)| component[nodes[0] as usize]).collect();
        let mut of_body: Vec<Vec<usize>> = vec![Vec::new(); count];
        body_of.iter().enumerate().for_each(|(cell, &body)| of_body[body].push(cell));
        // The cells of a type stand together, that of the first cell first.
        for cells in &mut of_body {
            let types: Vec<CellType> = cells.iter().map(|&cell| all[cell].0).collect();
            let mut known = types.clone();
            known.dedup();
            let place = |cell: &usize| known.iter().position(|known| *known == all[*cell].0);
            cells.sort_by_key(|cell| (place(cell), *cell));
        }
        let mut used: Vec<Vec<usize>> = vec![Vec::new(); count];
        let is_used = {
            let mut is_used = vec![false; deck.mesh.points.len()];
            all.iter().flat_map(|(_, nodes, ..)| *nodes).for_each(|&node| is_used[node as usize] = true);
            is_used
        };
        (0..is_used.len()).filter(|node| is_used[*node]).for_each(|node| used[component[node]].push(node));
        let mut node_of = vec![None; deck.mesh.points.len()];
        let (mut nodes, mut parts, mut more) = (Vec::new(), Vec::new(), Vec::new());
        let mut names = Vec::new();
        for (body, cells) in of_body.iter().enumerate() {
            let name = name(deck, all[cells[0]].3, &mut names);
            let material = materials[cells[0]].0;
            let cell_type = all[cells[0]].0;
            for &cell in cells {
                if materials[cell].0 != material {
                    let is_plate = |material: &Material| material.law == Law::PlaneStress;
                    let what = match is_plate(&materials[cell].0) == is_plate(&material) {
                        true => "two materials: solved are bodies of one, or bodies that are tied",
                        false => "elements of plane strain together with elements of plane stress",
                    };
                    let message = format!("{name} has {what}");
                    return Err(Fault::new(materials[cell].1, message));
                }
            }
            let first = nodes.len();
            for &node in &used[body] {
                node_of[node] = Some(nodes.len());
                nodes.push(node);
            }
            let coords = used[body].iter().map(|&node| std::array::from_fn(|axis| deck.mesh.points[node][axis]));
            let local = |node: &u32| (node_of[*node as usize].unwrap_or(first) - first) as u32;
            let mut blocks = cells.chunk_by(|p, q| all[*p].0 == all[*q].0).map(|cells| {
                let conn = cells.iter().flat_map(|&cell| all[cell].1.iter().map(local)).collect();
                Cells { part: body, cell_type: all[cells[0]].0, conn }
            });
            let Some(Cells { conn, .. }) = blocks.next() else { continue };
            let mesh = Mesh { coords: coords.collect(), conn, nodes_per_cell: cell_type.node_count() };
            more.extend(blocks);
            parts.push(Part { name, cell_type, mesh, material });
        }
        check_radii(deck, &node_of)?;
        let model = match deck.is_axisymmetric() {
            true => Model::axisymmetric(parts, &more),
            false => Model::with_cells(parts, &more),
        };
        let model = model.and_then(|model| model.with_threads(threads)).map_err(|error| {
            let Error::InvertedCell { part, cell } = &error else { return Fault::new(1, error.to_string()) };
            let body = names.iter().position(|name| name == part).unwrap_or(0);
            let cell = of_body[body][*cell];
            let label = all[cell].2;
            Fault::new(deck.elements[cell].line, format!("{part}: element {label} is inverted or has no volume"))
        })?;
        let cells: Vec<usize> = of_body.into_iter().flatten().collect();
        let model = model.with_incompatible_modes(|cell| deck.elements[cells[cell]].has_modes());
        let mut is_layer = vec![false; count];
        body_of.iter().zip(&deck.elements).for_each(|(&body, row)| is_layer[body] |= row.is_rigid());
        Ok((Self { node_of, body_of, nodes, cells, is_finite, is_layer }, model))
    }
}

/// Bodies of revolution lie on one side of their axis.
fn check_radii(deck: &Deck, node_of: &[Option<usize>]) -> Result<(), Fault> {
    let mut nodes = (0..node_of.len()).filter(|&node| deck.is_axisymmetric() && node_of[node].is_some());
    match nodes.find(|&node| deck.mesh.points[node][0] < 0.0) {
        None => Ok(()),
        Some(node) => {
            let line = deck.elements.first().map_or(1, |row| row.line);
            let (label, radius) = (deck.mesh.node_tags[node], deck.mesh.points[node][0]);
            Err(Fault::new(
                line,
                format!("node {label} lies at r = {radius}: the first coordinate of CAX elements is a radius"),
            ))
        }
    }
}

/// The component of every node, counted in the order of their first nodes with cells.
fn components(deck: &Deck) -> (Vec<usize>, usize) {
    let mut parent: Vec<usize> = (0..deck.mesh.points.len()).collect();
    fn root(parent: &mut [usize], mut node: usize) -> usize {
        while parent[node] != node {
            parent[node] = parent[parent[node]];
            node = parent[node];
        }
        node
    }
    let mut order = Vec::new();
    for (_, nodes, ..) in deck.mesh.cells() {
        order.push(nodes[0] as usize);
        let first = root(&mut parent, nodes[0] as usize);
        for &node in &nodes[1..] {
            let other = root(&mut parent, node as usize);
            parent[other] = first;
        }
    }
    let mut number = vec![usize::MAX; parent.len()];
    let mut count = 0;
    for node in order {
        let root = root(&mut parent, node);
        if number[root] == usize::MAX {
            number[root] = count;
            count += 1;
        }
    }
    let of = (0..parent.len()).map(|node| number[root(&mut parent, node)]).collect();
    (of, count)
}

/// Material and line of the section of every cell.
fn materials(deck: &Deck, is_finite: bool) -> Result<Vec<(Material, usize)>, Fault> {
    let mut found: Vec<Option<(Material, usize)>> = vec![None; deck.mesh.cell_count()];
    for section in &deck.sections {
        let row = deck.materials.get(&section.material.to_uppercase());
        let row =
            row.ok_or_else(|| Fault::new(section.line, format!("there is no material '{}'", section.material)))?;
        let material = row.material(is_finite)?;
        for instance in deck.names.instances_of(&section.scope) {
            for cell in deck.names.find(Kind::Cell, instance, &section.set, section.line)? {
                let before = found[cell].replace((material, section.line));
                if let Some((_, line)) = before.filter(|(other, _)| *other != material) {
                    let label = deck.mesh.cell(cell).map_or(0, |(_, _, label, _)| label);
                    let message = format!("element {label} has another material by the section of line {line}");
                    return Err(Fault::new(section.line, message));
                }
            }
        }
    }
    // Rigid surfaces have no section: of their stiffness nothing is felt, and the contact stiffness takes that of the stiffest body.
    let young = |material: &Material| material.young;
    let stiffest = found.iter().flatten().map(|(material, _)| *material).max_by(|p, q| young(p).total_cmp(&young(q)));
    for (row, found) in deck.elements.iter().zip(&mut found).filter(|(row, _)| row.is_rigid()) {
        let law = if is_finite { Law::NeoHookean } else { Law::LinearElastic };
        let material = stiffest.map(|stiffest| Material { law, poisson: 0.0, density: 1.0, ..stiffest });
        *found = found.take().or_else(|| Some((material?, row.line)));
    }
    for (row, (found, (_, _, label, _))) in deck.elements.iter().zip(found.iter_mut().zip(deck.mesh.cells())) {
        let Some((material, _)) = found.as_mut().filter(|_| row.kind.starts_with("CPS")) else { continue };
        if material.law != Law::LinearElastic {
            let message = format!(
                "element {label} of type {} has plane stress, which is known for *ELASTIC without NLGEOM",
                row.kind
            );
            return Err(Fault::new(row.line, message));
        }
        material.law = Law::PlaneStress;
    }
    let labels = deck.mesh.cells().map(|(_, _, label, _)| label);
    let missing = |label: u64, line: usize| Fault::new(line, format!("element {label} has no *SOLID SECTION"));
    let lines = deck.elements.iter().map(|row| row.line);
    let all = found.into_iter().zip(labels.zip(lines));
    all.map(|(found, (label, line))| found.ok_or_else(|| missing(label, line))).collect()
}

/// A name that no other body has: that of the group of its first cell, or its number.
fn name(deck: &Deck, group: Option<i64>, names: &mut Vec<String>) -> String {
    let group = group.and_then(|group| deck.mesh.group_names.get(&group));
    let stem = group.cloned().unwrap_or_else(|| format!("body {}", names.len() + 1));
    let numbered = (2..).map(|number| format!("{stem} {number}"));
    let name = std::iter::once(stem.clone()).chain(numbered).find(|name| !names.contains(name)).unwrap_or(stem);
    names.push(name.clone());
    name
}
