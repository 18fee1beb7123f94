//! The result as text and as JSON.

use fmc_contact::ContactForces;
use fmc_contact::contact::Resultant;
use fmc_contact::overlap::Partner;
use serde::Serialize;
use std::fmt::Write;

/// What `--json` writes; the names of the fields are the keys.
#[derive(Serialize)]
pub(super) struct Report {
    dim: usize,
    volume: f64,
    volume_standard_error: f64,
    energy: f64,
    contact_area: f64,
    penetration: f64,
    fibers: usize,
    crossings: usize,
    /// Of the evaluation alone, without reading and writing.
    seconds: f64,
    /// In the order of the files.
    bodies: Vec<BodyReport>,
    /// In the order of the command line.
    obstacles: Vec<BodyReport>,
    pairs: Vec<PairReport>,
    warnings: Vec<String>,
}

#[derive(Serialize)]
struct BodyReport {
    name: String,
    /// Sum of the contact forces, `dim` numbers.
    force: Vec<f64>,
    /// Moment about the origin: 3 numbers in 3D, 1 in 2D.
    moment: Vec<f64>,
    /// Nodes of its surface, and middles of its faces of second order that have none; 0 for an obstacle.
    nodes: usize,
}

#[derive(Serialize)]
struct PairReport {
    /// Index in `bodies`.
    a: usize,
    /// Index in `bodies`, equal to `a` for a body that overlaps itself; or in `obstacles`.
    b: usize,
    /// Whether `b` is an obstacle.
    obstacle: bool,
    volume: f64,
    volume_standard_error: f64,
    energy: f64,
    /// Traction dw/dV.
    pressure: f64,
    contact_area: f64,
    penetration: f64,
    /// Spacing of the fibers; 0 for exact.
    spacing: f64,
}

impl Report {
    /// `names` are those of the bodies, in the order of their ids.
    pub(super) fn new<const D: usize>(
        found: &ContactForces<D>,
        names: &[String],
        obstacles: &[&str],
        seconds: f64,
    ) -> Self {
        let index = |partner: Partner| match partner {
            Partner::Body(index) | Partner::Obstacle(index) => index,
        };
        let part = |resultant: &Resultant<D>, name: &str| BodyReport {
            name: name.to_owned(),
            force: resultant.force.to_vec(),
            moment: if D == 2 { vec![resultant.moment[2]] } else { resultant.moment.to_vec() },
            nodes: resultant.node_count,
        };
        let pairs = found.pairs.iter().map(|pair| PairReport {
            a: index(pair.a),
            b: index(pair.b),
            obstacle: matches!(pair.b, Partner::Obstacle(_)),
            volume: pair.volume,
            volume_standard_error: pair.standard_error,
            energy: pair.energy,
            pressure: pair.pressure,
            contact_area: pair.contact_area,
            penetration: pair.penetration,
            spacing: pair.spacing,
        });
        Self {
            dim: D,
            volume: found.volume,
            volume_standard_error: found.standard_error,
            energy: found.energy,
            contact_area: found.contact_area,
            penetration: found.penetration,
            fibers: found.fiber_count,
            crossings: found.crossing_count,
            seconds,
            bodies: found.bodies.iter().zip(names).map(|(body, name)| part(body, name)).collect(),
            obstacles: found.obstacles.iter().zip(obstacles).map(|(body, name)| part(body, name)).collect(),
            pairs: pairs.collect(),
            warnings: found.warnings.iter().map(|warning| named(&warning.to_string(), names)).collect(),
        }
    }

    /// Adds a warning.
    pub(super) fn warn(&mut self, sentence: &str) {
        self.warnings.push(sentence.to_owned());
    }

    /// The result as a person reads it.
    pub(super) fn text(&self) -> String {
        let mut text = String::new();
        self.write_text(&mut text).expect("writing into a string");
        text
    }

    fn write_text(&self, out: &mut String) -> std::fmt::Result {
        let [volume, energy, area, force, moment] = match self.dim {
            2 => ["m²", "J/m", "m", "N/m", "N"],
            _ => ["m³", "J", "m²", "N", "N·m"],
        };
        let error = format!("± {:.1e}, its standard error", self.volume_standard_error);
        let error = if self.volume_standard_error == 0.0 { "" } else { &error };
        writeln!(out, "overlap volume  {:>14.6e} {volume} {error}", self.volume)?;
        writeln!(out, "contact energy  {:>14.6e} {energy}", self.energy)?;
        writeln!(out, "contact area    {:>14.6e} {area}", self.contact_area)?;
        writeln!(out, "penetration     {:>14.6e} m", self.penetration)?;
        writeln!(out, "fibers          {:>14}", self.fibers)?;
        writeln!(out, "crossings       {:>14}", self.crossings)?;
        writeln!(out, "evaluation      {:>14.3} ms\n", 1e3 * self.seconds)?;
        let width = self.bodies.iter().chain(&self.obstacles).map(|b| b.name.chars().count()).fold(4, usize::max);
        let axes = if self.dim == 2 { ["x", "y"].as_slice() } else { &["x", "y", "z"] };
        let turns = if self.dim == 2 { ["z"].as_slice() } else { &["x", "y", "z"] };
        write!(out, "{:width$}", "body")?;
        axes.iter().try_for_each(|axis| write!(out, " {:>14}", format!("force {axis}, {force}")))?;
        turns.iter().try_for_each(|axis| write!(out, " {:>15}", format!("moment {axis}, {moment}")))?;
        writeln!(out, " {:>8}", "nodes")?;
        for body in self.bodies.iter().chain(&self.obstacles) {
            write!(out, "{:width$}", body.name)?;
            body.force.iter().try_for_each(|value| write!(out, " {value:>14.6e}"))?;
            body.moment.iter().try_for_each(|value| write!(out, " {value:>15.6e}"))?;
            writeln!(out, " {:>8}", body.nodes)?;
        }
        writeln!(
            out,
            "\nUnits: for lengths in m and K in Pa/m (law volume, exponent 1: in Pa). Moments: about the origin."
        )?;
        writeln!(out, "Nodes: those on the surface, and middles of faces of second order that have none.")?;
        self.warnings.iter().try_for_each(|warning| writeln!(out, "\nwarning: {warning}"))
    }
}

/// A sentence of the module with its bodies called by name instead of by index.
fn named(sentence: &str, names: &[String]) -> String {
    let mut words = Vec::new();
    let mut rest = sentence.split(' ').peekable();
    while let Some(word) = rest.next() {
        let next = rest.peek().copied().unwrap_or_default();
        let digits = next.trim_end_matches(|c: char| !c.is_ascii_digit());
        match digits.parse().ok().and_then(|index: usize| names.get(index)) {
            Some(name) if word == "body" => {
                words.push(name.clone() + &next[digits.len()..]);
                rest.next();
            }
            _ => words.push(word.to_owned()),
        }
    }
    words.join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bodies_are_called_by_name() {
        let names = ["star.msh", "a body 0.msh"].map(String::from);
        let found = named("body 1 and body 0: body 7 of 1", &names);
        assert_eq!(found, "a body 0.msh and star.msh: body 7 of 1");
    }
}
