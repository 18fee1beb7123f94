//! `*MATERIAL` and what belongs to it.

use super::note::Note;
use super::words::{at_most, one_of, only, only_line, present};
use crate::Fault;
use fmc_mesh_io::inp::{Keyword, Lines};
use fmc_solid::fem::{Law, Material};

/// A material of the file.
#[derive(Clone, Debug)]
pub(crate) struct MaterialRow {
    pub(crate) name: String,
    pub(crate) line: usize,
    /// Law, E and ν.
    law: Option<(Law, f64, f64)>,
    pub(crate) density: Option<f64>,
}

impl MaterialRow {
    /// Reads `*MATERIAL`.
    pub(super) fn begin(keyword: &Keyword) -> Result<Self, Fault> {
        only(keyword, &["NAME"])?;
        Ok(Self { name: keyword.required("NAME")?.to_owned(), line: keyword.line, law: None, density: None })
    }

    /// Reads a keyword that belongs to the material; `false` if it does not.
    pub(super) fn read(&mut self, keyword: &Keyword, lines: &mut Lines, notes: &mut Vec<Note>) -> Result<bool, Fault> {
        match keyword.name.as_str() {
            "ELASTIC" => {
                only(keyword, &["TYPE"])?;
                one_of(keyword, "TYPE", &["ISO", "ISOTROPIC"])?;
                let (line, found) = only_line(keyword, lines, "Young's modulus and Poisson's ratio")?;
                at_most(keyword, &found, 3, "its constants may not depend on the temperature")?;
                // One line holds at all temperatures, whichever it names.
                if found.get(2).copied().flatten().is_some_and(|temperature| temperature != 0.0) {
                    notes.push(Note::new(line, "the temperature of *ELASTIC is not used: its one line holds at all"));
                }
                let young = present(line, &found, 1, "Young's modulus")?;
                let poisson = present(line, &found, 2, "Poisson's ratio")?;
                self.set(line, Law::LinearElastic, young, poisson)?;
            }
            "HYPERELASTIC" => {
                only(keyword, &["NEO HOOKE"])?;
                if keyword.value("NEO HOOKE").is_none() {
                    return Err(Fault::new(keyword.line, "*HYPERELASTIC is known with NEO HOOKE only"));
                }
                let (line, found) = only_line(keyword, lines, "C10 and D1")?;
                at_most(keyword, &found, 2, "its constants may not depend on the temperature")?;
                let (c10, d1) = (present(line, &found, 1, "C10")?, present(line, &found, 2, "D1")?);
                if !(d1 > 0.0 && c10 > 0.0) {
                    let message = "*HYPERELASTIC needs C10 and D1 above 0: incompressible bodies are not solved";
                    return Err(Fault::new(line, message));
                }
                // W = C10 (I₁ − 3) + (J − 1)²/D1: G = 2 C10 and K = 2/D1.
                let (shear, bulk) = (2.0 * c10, 2.0 / d1);
                let young = 9.0 * bulk * shear / (3.0 * bulk + shear);
                let poisson = (3.0 * bulk - 2.0 * shear) / (2.0 * (3.0 * bulk + shear));
                self.set(line, Law::NeoHookean, young, poisson)?;
            }
            "DENSITY" => {
                only(keyword, &[])?;
                let (line, found) = only_line(keyword, lines, "a density")?;
                at_most(keyword, &found, 1, "it may not depend on the temperature")?;
                let density = present(line, &found, 1, "the density")?;
                if density <= 0.0 {
                    return Err(Fault::new(line, format!("a density of {density} is not above 0")));
                }
                if self.density.replace(density).is_some() {
                    return Err(Fault::new(keyword.line, format!("material {} has a density already", self.name)));
                }
            }
            // *TEMPERATURE and *INITIAL CONDITIONS are refused.
            "EXPANSION" | "CONDUCTIVITY" | "SPECIFIC HEAT" => {
                while lines.data().is_some() {}
                let message =
                    format!("*{} of material {} is not used: there are no temperatures", keyword.name, self.name);
                notes.push(Note::new(keyword.line, message));
            }
            "DEPVAR" | "USER MATERIAL" => return Err(Fault::new(keyword.line, "user materials are not known")),
            _ => return Ok(false),
        }
        Ok(true)
    }

    fn set(&mut self, line: usize, law: Law, young: f64, poisson: f64) -> Result<(), Fault> {
        if self.law.is_some() {
            return Err(Fault::new(line, format!("material {} has a law already", self.name)));
        }
        if !(young > 0.0 && young.is_finite() && poisson > -1.0 && poisson < 0.5) {
            let message = format!("E = {young} and ν = {poisson} are not a material: E > 0, −1 < ν < 0.5");
            return Err(Fault::new(line, message));
        }
        self.law = Some((law, young, poisson));
        Ok(())
    }

    /// The material, as bodies have it; `is_finite` for large displacements.
    pub(crate) fn material(&self, is_finite: bool) -> Result<Material, Fault> {
        let Some((law, young, poisson)) = self.law else {
            let message = format!("material {} has neither *ELASTIC nor *HYPERELASTIC", self.name);
            return Err(Fault::new(self.line, message));
        };
        let law = if is_finite { Law::NeoHookean } else { law };
        // Without loads by mass the density means nothing.
        Ok(Material { law, young, poisson, density: self.density.unwrap_or(1.0) })
    }

    /// Whether it is linear in the file.
    pub(crate) fn is_linear(&self) -> bool {
        self.law.is_some_and(|(law, ..)| law == Law::LinearElastic)
    }
}
