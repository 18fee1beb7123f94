//! All instances as one mesh.

use super::motion::Motion;
use super::part::Part;
use super::{Deck, Instance, Mesh};
use anyhow::{Result, bail, ensure};

/// Nodes, or nodes of cells, that instances may come to in a file however small: beyond it they may be as many as the file has bytes.
const MOST: usize = 10_000_000;

/// Something that is put into the mesh: nodes and elements at a place.
struct Piece<'a> {
    part: &'a Part,
    motion: Option<&'a Motion>,
    /// Number of its instance.
    instance: Option<usize>,
}

impl Deck {
    /// The pieces, and the names of the instances.
    fn pieces(&self) -> (Vec<Piece<'_>>, Vec<String>) {
        let mut pieces = Vec::new();
        let mut names: Vec<String> = Vec::new();
        for placed in &self.instances {
            let parts = placed.part.map(|number| &self.parts[number]).into_iter().chain([&placed.own]);
            pieces.extend(parts.map(|part| Piece { part, motion: Some(&placed.motion), instance: Some(names.len()) }));
            names.push(placed.name.clone());
        }
        let rest = [(&self.model, "model"), (&self.assembly, "assembly")];
        let rest: Vec<_> = rest.into_iter().filter(|(part, _)| !part.points.is_empty()).collect();
        let is_all = names.is_empty() && rest.len() == 1;
        for (part, name) in rest {
            pieces.push(Piece { part, motion: None, instance: (!is_all).then_some(names.len()) });
            if !is_all {
                names.push(name.to_owned());
            }
        }
        (pieces, names)
    }

    /// The mesh of a file of so many bytes.
    pub(super) fn mesh(&self, size: usize) -> Result<Mesh> {
        let unused = self.instances.is_empty() && !self.parts.is_empty();
        ensure!(!unused, "it has parts, but no *INSTANCE of any in an *ASSEMBLY");
        let (pieces, names) = self.pieces();
        let motions =
            self.instances.iter().map(|placed| placed.motion.clone()).chain(std::iter::repeat_with(Motion::default));
        let total = |count: fn(&Part) -> usize| pieces.iter().map(|piece| count(piece.part)).sum::<usize>();
        let most = total(|part| part.points.len()).max(total(Part::entry_count));
        ensure!(most <= MOST.max(size), "its instances have {most} nodes of cells, too many for one mesh");
        let mut mesh = Mesh::default();
        let dimensions =
            pieces.iter().flat_map(|piece| &piece.part.elements).map(|element| element.cell.cell_type.dimension());
        let highest = dimensions.max().unwrap_or(0);
        for piece in &pieces {
            take(&mut mesh, piece, highest)?;
        }
        if !names.is_empty() {
            mesh.group_names = (1..).zip(names.iter().cloned()).collect();
            mesh.instances =
                names.into_iter().zip(motions).map(|(name, motion)| Instance { name, nodes: 0..0, motion }).collect();
            let mut first = 0;
            for piece in &pieces {
                let instance = &mut mesh.instances[piece.instance.unwrap_or(0)];
                let end = first + piece.part.points.len();
                // An instance's own nodes follow those of its part.
                instance.nodes = if instance.nodes.is_empty() { first..end } else { instance.nodes.start..end };
                first = end;
            }
        }
        Ok(mesh)
    }
}

/// Adds the nodes and cells of a piece.
fn take(mesh: &mut Mesh, piece: &Piece, highest: usize) -> Result<()> {
    let Piece { part, motion, instance } = piece;
    let first = mesh.points.len() as u32;
    mesh.node_tags.extend(&part.node_labels);
    mesh.points.extend(part.points.iter().map(|&x| motion.map_or(x, |motion| motion.place(x))));
    let sets = if instance.is_none() { part.sets.of_elements(&part.element_labels) } else { Vec::new() };
    for (place, element) in part.elements.iter().enumerate() {
        let (cell, label) = (element.cell, part.element_labels[place]);
        if cell.cell_type.dimension() < highest {
            if cell.is_shell {
                let line = part.line(place);
                bail!(
                    "line {line}: element {label} is a shell in a mesh with solids, which is not supported: a tool or \
                     a body needs an inside, of solid elements"
                );
            }
            continue;
        }
        let set = sets.get(place).copied().flatten();
        let group = instance.or(set).map(|number| number as i64 + 1);
        if let (Some(set), Some(group)) = (set, group) {
            mesh.group_names.entry(group).or_insert_with(|| part.sets.name(set).to_owned());
        }
        let nodes = part.nodes(place)?;
        mesh.push(cell.cell_type, nodes.into_iter().map(|node| first + node), label, group);
    }
    Ok(())
}
