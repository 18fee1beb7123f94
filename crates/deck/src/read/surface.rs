//! `*SURFACE`: faces of elements, or nodes, or analytical.

use super::analytical::Analytical;
use super::scope::Scope;
use super::words::{one_of, only};
use crate::Fault;
use fmc_mesh_io::inp::{Keyword, Lines, fields};
use std::collections::{BTreeMap, BTreeSet};

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
    pub(super) analytical: Option<Analytical>,
}

/// All surfaces, by where they stand and their names in upper case.
#[derive(Clone, Debug, Default)]
pub(crate) struct Surfaces(BTreeMap<(Scope, String), Surface>);

impl Surfaces {
    /// Reads one.
    pub(super) fn read(&mut self, keyword: &Keyword, scope: &Scope, lines: &mut Lines) -> Result<(), Fault> {
        let name = keyword.required("NAME")?.to_uppercase();
        if let Some(analytical) = Analytical::read(keyword, lines)? {
            let surface = Surface { is_of_nodes: false, rows: Vec::new(), analytical: Some(analytical) };
            return self.insert(keyword.line, (scope, name), surface);
        }
        only(keyword, &["NAME", "TYPE", "INTERNAL"])?;
        one_of(keyword, "TYPE", &["ELEMENT", "NODE", "SEGMENTS", "CYLINDER", "REVOLUTION"])?;
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
        self.insert(keyword.line, (scope, name), Surface { is_of_nodes, rows, analytical: None })
    }

    fn insert(&mut self, line: usize, (scope, name): (&Scope, String), surface: Surface) -> Result<(), Fault> {
        match self.0.insert((scope.clone(), name.clone()), surface) {
            Some(_) => Err(Fault::new(line, format!("surface {name} is there twice"))),
            None => Ok(()),
        }
    }

    /// Gives analytical surfaces the faces `face` of the elements in the sets of their names, and returns their lines and names.
    pub(super) fn place_analytical(&mut self, face: &str, set: &dyn Fn(&str) -> String) -> Vec<(usize, String)> {
        let mut found = Vec::new();
        for ((_, name), Surface { rows, analytical, .. }) in &mut self.0 {
            let Some(Analytical { line, .. }) = analytical else { continue };
            *rows = vec![SurfaceRow { line: *line, set: set(name), face: face.to_owned() }];
            found.push((*line, name.clone()));
        }
        found
    }

    /// Sets the face of rows by their lines.
    pub(super) fn set_faces(&mut self, lines: &BTreeSet<usize>, face: &str) {
        let rows = self.0.values_mut().flat_map(|surface| &mut surface.rows);
        rows.filter(|row| lines.contains(&row.line)).for_each(|row| row.face = face.to_owned());
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
