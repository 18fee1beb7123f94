//! `*SOLID SECTION`: which elements are of which material.

use super::note::Note;
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
    /// Of a body of the plane.
    pub(crate) thickness: f64,
}

impl SectionRow {
    /// Reads it.
    pub(super) fn read(
        keyword: &Keyword,
        scope: &Scope,
        lines: &mut Lines,
        notes: &mut Vec<Note>,
    ) -> Result<Self, Fault> {
        only(keyword, &["ELSET", "MATERIAL", "ORIENTATION", "CONTROLS"])?;
        if keyword.value("ORIENTATION").is_some() {
            notes.push(Note::new(
                keyword.line,
                "ORIENTATION of *SOLID SECTION is not used: materials have no directions",
            ));
        }
        if keyword.value("CONTROLS").is_some() {
            notes.push(Note::new(
                keyword.line,
                "CONTROLS of *SOLID SECTION is not used: elements are integrated in full",
            ));
        }
        let (line, found) = optional_line(keyword, lines)?;
        // Without a thickness it is 1, as where it is 0.
        let thickness = found.first().copied().flatten().filter(|thickness| *thickness != 0.0).unwrap_or(1.0);
        if thickness < 0.0 || found.iter().skip(1).flatten().any(|value| *value != 0.0) {
            return Err(Fault::new(line, "*SOLID SECTION has one number, a thickness above 0"));
        }
        Ok(Self {
            line: keyword.line,
            scope: scope.clone(),
            set: keyword.required("ELSET")?.to_owned(),
            material: keyword.required("MATERIAL")?.to_owned(),
            thickness,
        })
    }
}
