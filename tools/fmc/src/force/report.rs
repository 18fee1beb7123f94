//! The result as text and as JSON.

use super::unit::Units;
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
    /// Force of `a` on `b`, `dim` numbers; 0 for a body that overlaps itself.
    force: Vec<f64>,
    /// Moment of that force about the origin.
    moment: Vec<f64>,
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
        let turns = |moment: &[f64; 3]| if D == 2 { vec![moment[2]] } else { moment.to_vec() };
        let part = |resultant: &Resultant<D>, name: &str| BodyReport {
            name: name.to_owned(),
            force: resultant.force.to_vec(),
            moment: turns(&resultant.moment),
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
            force: pair.force[..D].to_vec(),
            moment: turns(&pair.moment),
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
    pub(super) fn text(&self, units: &Units) -> String {
        let mut text = String::new();
        self.write_text(&mut text, units).expect("writing into a string");
        text
    }

    fn write_text(&self, out: &mut String, units: &Units) -> std::fmt::Result {
        let Units { length, area, volume, force, moment, energy, in_words } = units;
        let error = format!("± {:.1e}, its standard error", self.volume_standard_error);
        let error = if self.volume_standard_error == 0.0 { "" } else { &error };
        writeln!(out, "overlap volume  {:>14.6e} {volume} {error}", self.volume)?;
        writeln!(out, "contact energy  {:>14.6e} {energy}", self.energy)?;
        writeln!(out, "contact area    {:>14.6e} {area}", self.contact_area)?;
        writeln!(out, "penetration     {:>14.6e} {length}", self.penetration)?;
        writeln!(out, "fibers          {:>14}", self.fibers)?;
        writeln!(out, "crossings       {:>14}", self.crossings)?;
        writeln!(out, "evaluation      {:>14.3} ms\n", 1e3 * self.seconds)?;
        let rows: Vec<Row> = self.bodies.iter().chain(&self.obstacles).map(BodyReport::row).collect();
        self.write_rows(out, "body", [force, moment], &rows, Some("nodes"))?;
        if !self.pairs.is_empty() {
            let rows: Vec<Row> = self.pairs.iter().map(|pair| self.pair_row(pair)).collect();
            writeln!(out)?;
            self.write_rows(out, "force of on", [force, moment], &rows, None)?;
        }
        writeln!(out, "\nUnits: {in_words}. Moments: about the origin.")?;
        writeln!(out, "Nodes: those on the surface, and middles of faces of second order that have none.")?;
        self.warnings.iter().try_for_each(|warning| writeln!(out, "\nwarning: {warning}"))
    }

    /// What the first side of a pair does to the second.
    fn pair_row(&self, pair: &PairReport) -> Row {
        let name = |index: usize| self.bodies[index].name.as_str();
        let second = if pair.obstacle { self.obstacles[pair.b].name.as_str() } else { name(pair.b) };
        let title = if !pair.obstacle && pair.a == pair.b {
            format!("{} on itself", name(pair.a))
        } else {
            format!("{} on {second}", name(pair.a))
        };
        Row { title, force: pair.force.clone(), moment: pair.moment.clone(), nodes: None }
    }

    /// Forces and moments, a line each.
    fn write_rows(
        &self,
        out: &mut String,
        head: &str,
        [force, moment]: [&str; 2],
        rows: &[Row],
        last: Option<&str>,
    ) -> std::fmt::Result {
        let width = rows.iter().map(|row| row.title.chars().count()).fold(head.len(), usize::max);
        let axes = if self.dim == 2 { ["x", "y"].as_slice() } else { &["x", "y", "z"] };
        let turns = if self.dim == 2 { ["z"].as_slice() } else { &["x", "y", "z"] };
        write!(out, "{head:width$}")?;
        axes.iter().try_for_each(|axis| write!(out, " {:>14}", format!("force {axis}, {force}")))?;
        turns.iter().try_for_each(|axis| write!(out, " {:>15}", format!("moment {axis}, {moment}")))?;
        last.iter().try_for_each(|last| write!(out, " {last:>8}"))?;
        writeln!(out)?;
        for row in rows {
            write!(out, "{:width$}", row.title)?;
            row.force.iter().try_for_each(|value| write!(out, " {value:>14.6e}"))?;
            row.moment.iter().try_for_each(|value| write!(out, " {value:>15.6e}"))?;
            row.nodes.iter().try_for_each(|nodes| write!(out, " {nodes:>8}"))?;
            writeln!(out)?;
        }
        Ok(())
    }
}

/// A line of a table of forces.
struct Row {
    title: String,
    force: Vec<f64>,
    moment: Vec<f64>,
    nodes: Option<usize>,
}

impl BodyReport {
    fn row(&self) -> Row {
        let BodyReport { name, force, moment, nodes } = self;
        Row { title: name.clone(), force: force.clone(), moment: moment.clone(), nodes: Some(*nodes) }
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
