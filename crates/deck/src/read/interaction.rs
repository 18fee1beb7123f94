//! What happens between surfaces: contact pairs with their friction, and ties.

use super::note::Note;
use super::words::{length, one_of, only, only_line, optional_line, present};
use crate::Fault;
use fmc_mesh_io::inp::{Keyword, Lines, fields};

/// How surfaces press and rub.
#[derive(Clone, Debug, Default)]
pub(crate) struct Interaction {
    pub(crate) name: String,
    /// Pressure by penetration; none: chosen by the solver.
    pub(crate) stiffness: Option<f64>,
    /// A coefficient, once there is one.
    pub(crate) friction: Option<f64>,
    /// Joined for good, as by `*TIE`.
    pub(crate) is_tied: bool,
    /// Lines that said how surfaces press, and how they rub.
    pressed_by: Option<usize>,
}

/// A contact pair, by the names of its surfaces; without names of all bodies, each with itself, too.
#[derive(Clone, Debug)]
pub(crate) struct PairRow {
    pub(crate) line: usize,
    pub(crate) surfaces: [String; 2],
    pub(crate) interaction: String,
    /// Gaps up to this length are closed and overlaps removed, without strain.
    pub(crate) adjust: Option<f64>,
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
        let (line, found) = optional_line(keyword, lines)?;
        if found.iter().flatten().any(|value| *value != 1.0 && *value != 0.0) {
            return Err(Fault::new(line, "an out-of-plane thickness other than 1 is not known"));
        }
        Ok(Self { name: keyword.required("NAME")?.to_uppercase(), ..Self::default() })
    }

    /// Reads a keyword that belongs to it; `false` if it does not.
    pub(super) fn read(&mut self, keyword: &Keyword, lines: &mut Lines, notes: &mut Vec<Note>) -> Result<bool, Fault> {
        match keyword.name.as_str() {
            "FRICTION" => self.read_friction(keyword, lines, notes)?,
            "SURFACE BEHAVIOR" => self.read_behavior(keyword, lines, notes)?,
            _ => return Ok(false),
        }
        Ok(true)
    }

    fn read_friction(&mut self, keyword: &Keyword, lines: &mut Lines, notes: &mut Vec<Note>) -> Result<(), Fault> {
        only(keyword, &["SLIP TOLERANCE"])?;
        let (line, found) = only_line(keyword, lines, "a coefficient")?;
        let coefficient = present(line, &found, 1, "the coefficient")?;
        if coefficient < 0.0 {
            return Err(Fault::new(line, format!("a coefficient of friction of {coefficient} is below 0")));
        }
        if self.friction.replace(coefficient).is_some() {
            return Err(Fault::new(keyword.line, format!("*SURFACE INTERACTION {} has two *FRICTION", self.name)));
        }
        // Abaqus has rates, pressures and temperatures in these fields, CalculiX the stick slope in the second.
        if found.iter().skip(2).flatten().any(|value| *value != 0.0) {
            return Err(Fault::new(line, "the coefficient of *FRICTION may not depend on anything"));
        }
        if found.get(1).copied().flatten().is_some_and(|slope| slope != 0.0) {
            notes.push(Note::new(line, "the stick slope of *FRICTION is taken from the contact stiffness"));
        }
        if keyword.value("SLIP TOLERANCE").is_some() {
            notes.push(Note::new(keyword.line, "*FRICTION sticks without a SLIP TOLERANCE"));
        }
        Ok(())
    }

    fn read_behavior(&mut self, keyword: &Keyword, lines: &mut Lines, notes: &mut Vec<Note>) -> Result<(), Fault> {
        only(keyword, &["PRESSURE-OVERCLOSURE"])?;
        one_of(keyword, "PRESSURE-OVERCLOSURE", &["HARD", "LINEAR", "EXPONENTIAL", "TIED"])?;
        if self.pressed_by.replace(keyword.line).is_some() {
            let message = format!("*SURFACE INTERACTION {} has two *SURFACE BEHAVIOR", self.name);
            return Err(Fault::new(keyword.line, message));
        }
        let kind = keyword.value("PRESSURE-OVERCLOSURE").unwrap_or("HARD").to_uppercase();
        let (line, found) = optional_line(keyword, lines)?;
        let is_used = |count: usize| found.iter().skip(count).flatten().all(|value| *value == 0.0);
        match kind.as_str() {
            "LINEAR" => {
                let slope = present(line, &found, 1, "the slope of a linear overclosure")?;
                if slope <= 0.0 {
                    return Err(Fault::new(line, "a linear overclosure needs a slope above 0"));
                }
                if !is_used(1) {
                    notes.push(Note::new(line, "of *SURFACE BEHAVIOR only the slope is used"));
                }
                self.stiffness = Some(slope);
            }
            "TIED" => {
                notes.push(Note::new(keyword.line, "TIED joins surfaces without a stiffness, as *TIE does"));
                self.is_tied = true;
            }
            "EXPONENTIAL" => notes
                .push(Note::new(line, "EXPONENTIAL is taken as HARD: surfaces press when they touch, and not before")),
            _ if !is_used(0) => notes.push(Note::new(line, "*SURFACE BEHAVIOR uses no number with HARD")),
            _ => {}
        }
        Ok(())
    }
}

impl PairRow {
    /// Reads `*CONTACT PAIR`.
    pub(super) fn read(keyword: &Keyword, lines: &mut Lines, notes: &mut Vec<Note>) -> Result<Vec<Self>, Fault> {
        // Solids have no thickness of shells, and do not turn.
        only(keyword, &["INTERACTION", "TYPE", "SMALL SLIDING", "ADJUST", "NO THICKNESS"])?;
        let mortar = ["MORTAR", "LINMORTAR", "PGLINMORTAR"];
        one_of(keyword, "TYPE", &["NODE TO SURFACE", "SURFACE TO SURFACE", mortar[0], mortar[1], mortar[2]])?;
        let adjust = match keyword.value("ADJUST") {
            Some(text) if text.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_') => {
                let message = format!("*CONTACT PAIR, ADJUST={text} is not known: only a length, not a set of nodes");
                return Err(Fault::new(keyword.line, message));
            }
            _ => length(keyword, "ADJUST")?,
        };
        if keyword.value("SMALL SLIDING").is_some() {
            notes.push(Note::new(keyword.line, "sliding is finite also with SMALL SLIDING"));
        }
        let interaction = keyword.required("INTERACTION")?.to_uppercase();
        let rows = rows(keyword, lines)?;
        let row = |(line, surfaces)| Self { line, surfaces, interaction: interaction.clone(), adjust };
        Ok(rows.into_iter().map(row).collect())
    }
}

impl TieRow {
    /// Reads `*TIE`.
    pub(super) fn read(keyword: &Keyword, lines: &mut Lines, notes: &mut Vec<Note>) -> Result<Vec<Self>, Fault> {
        only(keyword, &["NAME", "POSITION TOLERANCE", "ADJUST", "TYPE", "NO ROTATION", "NO THICKNESS"])?;
        one_of(keyword, "ADJUST", &["YES", "NO"])?;
        one_of(keyword, "TYPE", &["SURFACE TO SURFACE", "NODE TO SURFACE"])?;
        let reach = length(keyword, "POSITION TOLERANCE")?;
        if reach == Some(0.0) {
            notes.push(Note::new(keyword.line, "POSITION TOLERANCE=0 is taken as none: the table names the reach"));
        }
        let reach = reach.unwrap_or(0.0);
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
