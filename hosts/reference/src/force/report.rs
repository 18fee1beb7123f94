//! The result as text and as JSON.

use fmc_contact::ContactForces;
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
    /// Nodes of its surface.
    nodes: usize,
}

#[derive(Serialize)]
struct PairReport {
    /// Index in `bodies`; equal to `b` for a body that overlaps itself.
    a: usize,
    b: usize,
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
    pub(super) fn new<const D: usize>(found: &ContactForces<D>, names: &[String], seconds: f64) -> Self {
        let index = |partner: Partner| match partner {
            Partner::Body(index) | Partner::Obstacle(index) => index,
        };
        let bodies = found.bodies.iter().zip(names).map(|(body, name)| BodyReport {
            name: name.clone(),
            force: body.force.to_vec(),
            moment: if D == 2 { vec![body.moment[2]] } else { body.moment.to_vec() },
            nodes: body.node_count,
        });
        let pairs = found.pairs.iter().map(|pair| PairReport {
            a: index(pair.a),
            b: index(pair.b),
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
            bodies: bodies.collect(),
            pairs: pairs.collect(),
            warnings: found.warnings.iter().map(|warning| named(&warning.to_string(), names)).collect(),
        }
    }

    /// The result as a person reads it.
    pub(super) fn text(&self) -> String {
        let mut text = String::new();
        self.write_text(&mut text).expect("writing into a string");
        text
    }

    fn write_text(&self, out: &mut String) -> std::fmt::Result {
        let (volume, area, force, moment) = match self.dim {
            2 => ("length²", "length", "K·length, N/m", "K·length², N"),
            _ => ("length³", "length²", "K·length², N", "K·length³, N·m"),
        };
        let error = format!("± {:.1e} (standard error)", self.volume_standard_error);
        let error = if self.volume_standard_error == 0.0 { "" } else { &error };
        writeln!(out, "overlap volume  {:>14.6e} {volume} {error}", self.volume)?;
        writeln!(out, "contact energy  {:>14.6e} K·{volume}", self.energy)?;
        writeln!(out, "contact area    {:>14.6e} {area}", self.contact_area)?;
        writeln!(out, "penetration     {:>14.6e} length", self.penetration)?;
        writeln!(out, "fibers          {:>14}", self.fibers)?;
        writeln!(out, "crossings       {:>14}", self.crossings)?;
        writeln!(out, "time            {:>14.6e} s\n", self.seconds)?;
        let width = self.bodies.iter().map(|body| body.name.chars().count()).fold(4, usize::max);
        let axes = if self.dim == 2 { ["x", "y"].as_slice() } else { &["x", "y", "z"] };
        let turns = if self.dim == 2 { ["z"].as_slice() } else { &["x", "y", "z"] };
        write!(out, "{:width$}", "body")?;
        axes.iter().try_for_each(|axis| write!(out, " {:>14}", format!("force {axis}")))?;
        turns.iter().try_for_each(|axis| write!(out, " {:>14}", format!("moment {axis}")))?;
        writeln!(out, " {:>8}", "nodes")?;
        for body in &self.bodies {
            write!(out, "{:width$}", body.name)?;
            body.force.iter().chain(&body.moment).try_for_each(|value| write!(out, " {value:>14.6e}"))?;
            writeln!(out, " {:>8}", body.nodes)?;
        }
        writeln!(out, "\nUnits for m = 1: forces {force} if K is in Pa and lengths in m; moments about the origin")?;
        writeln!(out, "{moment}; nodes: those on the surface.")?;
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
