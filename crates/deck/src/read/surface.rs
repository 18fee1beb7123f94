//! `*SURFACE`: faces of elements, or nodes.

use super::scope::Scope;
use super::words::{one_of, only};
use crate::Fault;
use fmc_mesh_io::inp::{Keyword, Lines, fields};
use std::collections::BTreeMap;

/// One line of a surface: a set or label, and a face if it names one.
#[derive(Clone, Debug)]
pub(crate) struct SurfaceRow {
    pub(crate) line: usize,
    pub(crate) set: String,
    pub(crate) face: String,
}

/// A surface.
#[derive(Clone, Debug)]
pub(crate) struct Surface {
    pub(crate) is_of_nodes: bool,
    pub(crate) rows: Vec<SurfaceRow>,
}

/// All surfaces, by where they stand and their names in upper case.
#[derive(Clone, Debug, Default)]
pub(crate) struct Surfaces(BTreeMap<(Scope, String), Surface>);

impl Surfaces {
    /// Reads one.
    pub(super) fn read(&mut self, keyword: &Keyword, scope: &Scope, lines: &mut Lines) -> Result<(), Fault> {
        only(keyword, &["NAME", "TYPE", "INTERNAL"])?;
        one_of(keyword, "TYPE", &["ELEMENT", "NODE"])?;
        let name = keyword.required("NAME")?.to_uppercase();
        let is_of_nodes = keyword.value("TYPE").is_some_and(|kind| kind.eq_ignore_ascii_case("NODE"));
        let mut rows = Vec::new();
        while let Some((line, text)) = lines.data() {
            let mut entries = fields(text);
            let set = entries.next().unwrap_or_default().trim_matches('"').to_owned();
            let face = entries.next().unwrap_or_default().to_uppercase();
            if entries.next().is_some_and(|more| !more.is_empty()) {
                return Err(Fault::new(line, "expected a set or label and a face"));
            }
            // The second field of a surface of nodes is an area.
            rows.push(SurfaceRow { line, set, face: if is_of_nodes { String::new() } else { face } });
        }
        if rows.is_empty() {
            return Err(Fault::new(keyword.line, format!("surface {name} is empty")));
        }
        let surface = Surface { is_of_nodes, rows };
        match self.0.insert((scope.clone(), name.clone()), surface) {
            Some(_) => Err(Fault::new(keyword.line, format!("surface {name} is there twice"))),
            None => Ok(()),
        }
    }

    /// The rows of all surfaces of elements.
    pub(crate) fn rows(&self) -> impl Iterator<Item = (&Scope, &SurfaceRow)> {
        let of_elements = self.0.iter().filter(|(_, surface)| !surface.is_of_nodes);
        of_elements.flat_map(|((scope, _), surface)| surface.rows.iter().map(move |row| (scope, row)))
    }

    /// A surface of a scope.
    pub(crate) fn get(&self, scope: Scope, name: &str) -> Option<&Surface> {
        self.0.get(&(scope, name.to_uppercase()))
    }
}
