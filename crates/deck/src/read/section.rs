//! `*SOLID SECTION`: which elements are of which material.

use super::scope::Scope;
use super::words::{only, optional_line};
use crate::Fault;
use fmc_mesh_io::inp::{Keyword, Lines};

/// A section.
#[derive(Clone, Debug)]
pub(crate) struct SectionRow {
    pub(crate) line: usize,
    pub(crate) scope: Scope,
    pub(crate) set: String,
    pub(crate) material: String,
}

impl SectionRow {
    /// Reads it.
    pub(super) fn read(keyword: &Keyword, scope: &Scope, lines: &mut Lines) -> Result<Self, Fault> {
        only(keyword, &["ELSET", "MATERIAL"])?;
        let (line, found) = optional_line(keyword, lines)?;
        if let Some(thickness) = found.iter().flatten().find(|value| **value != 1.0 && **value != 0.0) {
            let message = format!("a thickness of {thickness} is not known: 2D is per unit thickness");
            return Err(Fault::new(line, message));
        }
        Ok(Self {
            line: keyword.line,
            scope: scope.clone(),
            set: keyword.required("ELSET")?.to_owned(),
            material: keyword.required("MATERIAL")?.to_owned(),
        })
    }
}
