//! `*ELEMENT` of rigid surfaces: lines and faces without an inside.

use super::names::{Kind, Names};
use super::scope::Scope;
use super::words::only;
use crate::Fault;
use fmc_mesh_io::inp::{Keyword, Lines, fields, label, rigid_corners};

/// Rigid elements under one keyword.
pub(super) struct RigidElements {
    pub(super) line: usize,
    pub(super) scope: Scope,
    /// Their type in upper case.
    pub(super) kind: String,
    /// The set that the keyword names.
    pub(super) set: Option<String>,
    /// Line, label and the labels of the nodes of each.
    pub(super) elements: Vec<(usize, u64, Vec<u64>)>,
}

impl RigidElements {
    /// Reads them; none if the type is another.
    pub(super) fn read(
        keyword: &Keyword,
        scope: &Scope,
        lines: &mut Lines,
        names: &mut Names,
    ) -> Result<Option<Self>, Fault> {
        let kind = keyword.required("TYPE")?.to_uppercase();
        let Some(count) = rigid_corners(&kind) else { return Ok(None) };
        only(keyword, &["TYPE", "ELSET", "INPUT"])?;
        let mut elements = Vec::new();
        while let Some((line, text)) = lines.data() {
            let numbers = fields(text).map(|field| label(line, field)).collect::<anyhow::Result<Vec<u64>>>()?;
            let [element, nodes @ ..] = &numbers[..] else { continue };
            if nodes.len() != count {
                let message = format!("element {element} has {} nodes; {kind} has {count}", nodes.len());
                return Err(Fault::new(line, message));
            }
            elements.push((line, *element, nodes.to_vec()));
        }
        let set = keyword.value("ELSET").filter(|set| !set.is_empty()).map(str::to_owned);
        if let Some(set) = &set {
            let labels: Vec<(u64, usize)> = elements.iter().map(|(line, label, _)| (*label, *line)).collect();
            names.put(Kind::Cell, scope, set, keyword.line, &labels);
        }
        Ok(Some(Self { line: keyword.line, scope: scope.clone(), kind, set, elements }))
    }
}
