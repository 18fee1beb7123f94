//! Nodes, elements and element sets of one part, or of a file without parts.

use super::element_name::{Cell, Element};
use super::lines::{Keyword, Lines, fields, label, number};
use super::sets::Sets;
use anyhow::{Context, Result, anyhow, bail, ensure};
use std::collections::{HashMap, HashSet};

/// An element that is a cell.
pub(super) struct PartElement {
    pub(super) cell: Cell,
    /// Line of its label.
    line: usize,
    /// Where its nodes begin in those of all.
    start: usize,
}

/// What stands between `*PART` and `*END PART`.
#[derive(Default)]
pub(super) struct Part {
    pub(super) node_labels: Vec<u64>,
    pub(super) points: Vec<[f64; 3]>,
    node_index: HashMap<u64, u32>,
    pub(super) elements: Vec<PartElement>,
    pub(super) element_labels: Vec<u64>,
    known_labels: HashSet<u64>,
    /// Labels of the nodes of all elements.
    conn: Vec<u64>,
    pub(super) sets: Sets,
}

impl Part {
    /// Number of nodes of all elements, one after the other.
    pub(super) fn entry_count(&self) -> usize {
        self.conn.len()
    }

    /// Reads `*NODE`.
    pub(super) fn read_nodes(&mut self, keyword: &Keyword, lines: &mut Lines) -> Result<()> {
        let system = keyword.value("SYSTEM").unwrap_or("R");
        ensure!(
            system.eq_ignore_ascii_case("R"),
            "line {}: nodes in the coordinates SYSTEM={system} are not supported, only R",
            keyword.line
        );
        while let Some((line, text)) = lines.data() {
            let mut entries = fields(text);
            let node = label(line, entries.next().unwrap_or_default())?;
            let mut point = [0.0; 3];
            for (place, x) in (2..).zip(&mut point) {
                // Coordinates that are empty, or that a line does not reach, are 0.
                let Some(field) = entries.next() else { break };
                *x = number(line, field).map_err(|error| anyhow!("{error} in field {place} of node {node}"))?;
            }
            let index = u32::try_from(self.points.len()).context("more nodes than 32 bits can number")?;
            ensure!(self.node_index.insert(node, index).is_none(), "line {line}: node {node} is there twice");
            self.node_labels.push(node);
            self.points.push(point);
        }
        Ok(())
    }

    /// Reads `*ELEMENT`.
    pub(super) fn read_elements(&mut self, keyword: &Keyword, lines: &mut Lines) -> Result<()> {
        let Element::Cell(cell) = Element::of_name(keyword.line, keyword.required("TYPE")?)? else { return Ok(()) };
        let first = self.elements.len();
        let size = cell.cell_type.node_count();
        while let Some((line, text)) = lines.data() {
            let mut entries = fields(text);
            let element = label(line, entries.next().unwrap_or_default())?;
            ensure!(self.known_labels.insert(element), "line {line}: element {element} is there twice");
            let start = self.conn.len();
            self.read_row(line, entries)?;
            // The nodes of one element may take several lines.
            while self.conn.len() - start < size {
                let Some((line, text)) = lines.data() else {
                    let found = self.conn.len() - start;
                    bail!("line {line}: element {element} has {found} nodes; {:?} has {size}", cell.cell_type);
                };
                self.read_row(line, fields(text))?;
            }
            let found = self.conn.len() - start;
            ensure!(found == size, "line {line}: element {element} has {found} nodes; {:?} has {size}", cell.cell_type);
            self.elements.push(PartElement { cell, line, start });
            self.element_labels.push(element);
        }
        if let Some(set) = keyword.value("ELSET").filter(|name| !name.is_empty()) {
            self.sets.add_places(set, first..self.elements.len());
        }
        Ok(())
    }

    /// Passes over `*ELEMENT`; other sets may name its set all the same.
    pub(super) fn leave_elements(&mut self, keyword: &Keyword) {
        if let Some(set) = keyword.value("ELSET").filter(|name| !name.is_empty()) {
            self.sets.add_places(set, 0..0);
        }
    }

    fn read_row<'a>(&mut self, line: usize, entries: impl Iterator<Item = &'a str>) -> Result<()> {
        for entry in entries {
            self.conn.push(label(line, entry)?);
        }
        Ok(())
    }

    /// Places of the nodes of an element, in our order.
    pub(super) fn nodes(&self, place: usize) -> Result<Vec<u32>> {
        let PartElement { cell, line, start } = &self.elements[place];
        let node = |number| {
            let node = self.conn[start + cell.place(number)];
            let element = self.element_labels[place];
            let found = self.node_index.get(&node).copied();
            found.with_context(|| format!("line {line}: element {element} names node {node}, which does not exist"))
        };
        (0..cell.cell_type.node_count()).map(node).collect()
    }

    /// The line of an element.
    pub(super) fn line(&self, place: usize) -> usize {
        self.elements[place].line
    }
}
