//! `*CONTACT`: contact of all bodies, or of pairs of surfaces, without a keyword for each.

use super::interaction::PairRow;
use super::words::{no_more, only};
use crate::Fault;
use fmc_mesh_io::inp::{Keyword, Lines, fields};

/// General contact.
#[derive(Clone, Debug)]
pub(super) struct GeneralRow {
    pub(super) line: usize,
    is_all: bool,
    /// Surfaces that are included, with their lines.
    included: Vec<(usize, [String; 2])>,
    interaction: Option<String>,
}

impl GeneralRow {
    /// Reads `*CONTACT`.
    pub(super) fn begin(keyword: &Keyword) -> Result<Self, Fault> {
        only(keyword, &[])?;
        Ok(Self { line: keyword.line, is_all: false, included: Vec::new(), interaction: None })
    }

    /// Reads what belongs to it.
    pub(super) fn read(&mut self, keyword: &Keyword, lines: &mut Lines) -> Result<(), Fault> {
        if keyword.name == "CONTACT INCLUSIONS" {
            only(keyword, &["ALL EXTERIOR"])?;
            if keyword.value("ALL EXTERIOR").is_some() {
                self.is_all = true;
                return no_more(keyword, lines);
            }
            while let Some((line, text)) = lines.data() {
                let names: Vec<&str> = fields(text).map(|name| name.trim_matches('"')).collect();
                let [a, b] = match names[..] {
                    [a] | [a, ""] => [a, a],
                    [a, b] => [a, b],
                    _ => return Err(Fault::new(line, "expected the names of two surfaces")),
                };
                if a.is_empty() {
                    return Err(Fault::new(
                        line,
                        "expected the name of a surface, or ALL EXTERIOR of *CONTACT INCLUSIONS",
                    ));
                }
                self.included.push((line, [a, b].map(str::to_owned)));
            }
            return Ok(());
        }
        only(keyword, &[])?;
        while let Some((line, text)) = lines.data() {
            let names: Vec<&str> = fields(text).collect();
            match names[..] {
                ["", "", name] if self.interaction.is_none() => self.interaction = Some(name.to_uppercase()),
                _ => {
                    let message = "*CONTACT PROPERTY ASSIGNMENT is known with one interaction of all, ', , NAME': name others by *CONTACT PAIR";
                    return Err(Fault::new(line, message));
                }
            }
        }
        Ok(())
    }

    /// Its pairs; that of all bodies has no names.
    pub(super) fn pairs(self) -> Result<Vec<PairRow>, Fault> {
        let Some(interaction) = self.interaction else {
            return Err(Fault::new(
                self.line,
                "*CONTACT has no *CONTACT PROPERTY ASSIGNMENT with an interaction of all",
            ));
        };
        if !self.is_all && self.included.is_empty() {
            return Err(Fault::new(self.line, "*CONTACT includes nothing: *CONTACT INCLUSIONS says what"));
        }
        let all = self.is_all.then(|| (self.line, [String::new(), String::new()]));
        let rows = all.into_iter().chain(self.included);
        let pair = |(line, surfaces)| PairRow { line, surfaces, interaction: interaction.clone(), adjust: None };
        Ok(rows.map(pair).collect())
    }
}
