//! Rows of nodes and elements, which the mesh has.

use super::elements::ElementRow;
use super::names::{Kind, Names};
use super::scope::Scope;
use super::words::only;
use crate::Fault;
use fmc_mesh_io::inp::{Keyword, Lines, fields, label};

/// Elements under one keyword: where they and it stand, their type, and their labels with their lines.
pub(super) struct Rows {
    pub(super) scope: Scope,
    pub(super) line: usize,
    pub(super) kind: String,
    pub(super) labels: Vec<(u64, usize)>,
}

/// Passes over rows of nodes, or of elements of `size` fields, which the mesh has, and puts their labels into the set that the keyword names. Returns
/// the labels with their lines.
pub(super) fn take_rows(
    names: &mut Names,
    (kind, size): (Kind, usize),
    keyword: &Keyword,
    scope: &Scope,
    lines: &mut Lines,
) -> Result<Vec<(u64, usize)>, Fault> {
    let (parameter, known): (_, &[&str]) = match kind {
        Kind::Node => ("NSET", &["NSET", "SYSTEM", "INPUT"]),
        Kind::Cell => ("ELSET", &["TYPE", "ELSET", "INPUT"]),
    };
    only(keyword, known)?;
    let mut labels = Vec::new();
    while let Some((line, text)) = lines.data() {
        let mut count = fields(text).count();
        labels.push((label(line, fields(text).next().unwrap_or_default())?, line));
        // An element may take several lines.
        while count < size && kind == Kind::Cell {
            let Some((_, more)) = lines.data() else { break };
            count += fields(more).count();
        }
    }
    if let Some(set) = keyword.value(parameter) {
        names.put(kind, scope, set, keyword.line, &labels);
    }
    Ok(labels)
}

/// Line and type of every element.
pub(super) fn element_rows(names: &Names, count: usize, blocks: &[Rows]) -> Vec<ElementRow> {
    let mut found = vec![ElementRow { line: 1, keyword: 1, kind: String::new() }; count];
    for Rows { scope, line: keyword, kind, labels } in blocks {
        for instance in names.instances_of(scope) {
            for &(label, line) in labels {
                if let Some(cell) = names.cell(instance, label) {
                    found[cell] = ElementRow { line, keyword: *keyword, kind: kind.clone() };
                }
            }
        }
    }
    found
}
