//! What happens between surfaces: contact pairs with their friction, and ties.

use super::material::optional_line;
use super::note::Note;
use super::words::{numbers, one_of, only, only_line};
use crate::Fault;
use fmc_mesh_io::inp::{Keyword, Lines, fields};

/// How surfaces press and rub.
#[derive(Clone, Debug, Default)]
pub(crate) struct Interaction {
    pub(crate) name: String,
    /// Pressure by penetration; none: chosen by the solver.
    pub(crate) stiffness: Option<f64>,
    pub(crate) friction: f64,
}

/// A contact pair, by the names of its surfaces.
#[derive(Clone, Debug)]
pub(crate) struct PairRow {
    pub(crate) line: usize,
    pub(crate) surfaces: [String; 2],
    pub(crate) interaction: String,
}

/// Tied surfaces.
#[derive(Clone, Debug)]
pub(crate) struct TieRow {
    pub(crate) line: usize,
    pub(crate) surfaces: [String; 2],
    /// A length; 0: chosen by the library.
    pub(crate) reach: f64,
}

impl Interaction {
    /// Reads `*SURFACE INTERACTION`.
    pub(super) fn begin(keyword: &Keyword, lines: &mut Lines) -> Result<Self, Fault> {
        only(keyword, &["NAME"])?;
        let found = optional_line(keyword, lines)?;
        if found.iter().flatten().any(|value| *value != 1.0 && *value != 0.0) {
            return Err(Fault::new(keyword.line, "an out-of-plane thickness other than 1 is not known"));
        }
        Ok(Self { name: keyword.required("NAME")?.to_uppercase(), ..Self::default() })
    }

    /// Reads a keyword that belongs to it; `false` if it does not.
    pub(super) fn read(&mut self, keyword: &Keyword, lines: &mut Lines, notes: &mut Vec<Note>) -> Result<bool, Fault> {
        match keyword.name.as_str() {
            "FRICTION" => {
                only(keyword, &[])?;
                let found = only_line(keyword, lines, "a coefficient")?;
                self.friction = found.first().copied().flatten().unwrap_or(0.0);
                if !(self.friction >= 0.0 && self.friction.is_finite()) {
                    let message = format!("a coefficient of friction of {} is none", self.friction);
                    return Err(Fault::new(keyword.line, message));
                }
                if found.iter().skip(1).flatten().any(|value| *value != 0.0) {
                    notes
                        .push(Note::new(keyword.line, "the stick slope of *FRICTION is that of the contact stiffness"));
                }
            }
            "SURFACE BEHAVIOR" => {
                only(keyword, &["PRESSURE-OVERCLOSURE"])?;
                one_of(keyword, "PRESSURE-OVERCLOSURE", &["HARD", "LINEAR"])?;
                let kind = keyword.value("PRESSURE-OVERCLOSURE").unwrap_or("HARD");
                let found = optional_line(keyword, lines)?;
                if kind.eq_ignore_ascii_case("LINEAR") {
                    let slope = found.first().copied().flatten().unwrap_or(0.0);
                    if !(slope > 0.0 && slope.is_finite()) {
                        return Err(Fault::new(keyword.line, "a linear overclosure needs a slope above 0"));
                    }
                    if found.len() > 1 {
                        notes.push(Note::new(keyword.line, "of *SURFACE BEHAVIOR only the slope is used"));
                    }
                    self.stiffness = Some(slope);
                }
            }
            _ => return Ok(false),
        }
        Ok(true)
    }
}

impl PairRow {
    /// Reads `*CONTACT PAIR`.
    pub(super) fn read(keyword: &Keyword, lines: &mut Lines, notes: &mut Vec<Note>) -> Result<Vec<Self>, Fault> {
        only(keyword, &["INTERACTION", "TYPE", "SMALL SLIDING"])?;
        one_of(keyword, "TYPE", &["NODE TO SURFACE", "SURFACE TO SURFACE"])?;
        if keyword.value("SMALL SLIDING").is_some() {
            notes.push(Note::new(keyword.line, "sliding is finite also with SMALL SLIDING"));
        }
        let interaction = keyword.required("INTERACTION")?.to_uppercase();
        let rows = rows(keyword, lines)?;
        Ok(rows.into_iter().map(|(line, surfaces)| Self { line, surfaces, interaction: interaction.clone() }).collect())
    }
}

impl TieRow {
    /// Reads `*TIE`.
    pub(super) fn read(keyword: &Keyword, lines: &mut Lines, notes: &mut Vec<Note>) -> Result<Vec<Self>, Fault> {
        only(keyword, &["NAME", "POSITION TOLERANCE", "ADJUST", "TYPE"])?;
        one_of(keyword, "ADJUST", &["YES", "NO"])?;
        one_of(keyword, "TYPE", &["SURFACE TO SURFACE", "NODE TO SURFACE"])?;
        let reach = match keyword.value("POSITION TOLERANCE") {
            Some(text) => numbers(keyword.line, text)?.first().copied().flatten().unwrap_or(0.0),
            None => 0.0,
        };
        if !(reach >= 0.0 && reach.is_finite()) {
            return Err(Fault::new(keyword.line, "POSITION TOLERANCE is not a length"));
        }
        // Abaqus moves nodes unless it is told not to.
        if keyword.value("ADJUST").is_some_and(|adjust| adjust.eq_ignore_ascii_case("YES")) {
            notes.push(Note::new(keyword.line, "*TIE keeps gaps as they are also with ADJUST=YES"));
        }
        let rows = rows(keyword, lines)?;
        Ok(rows.into_iter().map(|(line, surfaces)| Self { line, surfaces, reach }).collect())
    }
}

/// Pairs of names.
fn rows(keyword: &Keyword, lines: &mut Lines) -> Result<Vec<(usize, [String; 2])>, Fault> {
    let mut rows = Vec::new();
    while let Some((line, text)) = lines.data() {
        let names: Vec<String> = fields(text).map(|name| name.trim_matches('"').to_owned()).collect();
        match names.as_slice() {
            [a, b] => rows.push((line, [a.clone(), b.clone()])),
            [a] if keyword.name == "CONTACT PAIR" => rows.push((line, [a.clone(), a.clone()])),
            _ => return Err(Fault::new(line, format!("*{} needs the names of two surfaces", keyword.name))),
        }
    }
    match rows.is_empty() {
        true => Err(Fault::new(keyword.line, format!("*{} names no surfaces", keyword.name))),
        false => Ok(rows),
    }
}
